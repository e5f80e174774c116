// Moves the control points of a surface, by pointer and by keys, with undo.

import { History } from '../model/history';
import { controlPoints, movePoint, type ControlPoint, type Net } from '../model/nets';
import type { Handles } from '../scene/handles';
import type { MeshView } from '../scene/mesh_view';

/** Of the distance of the camera, for each press of a key. */
const STEP = 0.01;

export class NetEditor {
  nets: Net[];
  shown = true;
  private points: ControlPoint[];
  private chosen = -1;
  private readonly handles: Handles | null;
  private readonly history = new History<Net[]>();

  /**
   * @param say     tells the user something
   * @param change  is called after each change, with the patches that are not as they were
   */
  constructor(nets: Net[], private readonly view: MeshView | null, private readonly say: (text: string) => void,
    private readonly change: (patches: number[]) => void) {
    this.nets = nets;
    this.points = controlPoints(nets);
    this.handles = view?.addHandles() ?? null;
    if (!this.handles || !view) return;
    this.handles.onChoose = (i) => this.choose(i);
    this.handles.onGrab = () => this.history.keep(this.nets);
    this.handles.onMove = (i, to) => this.move(i, to);
    view.onRestyle = () => this.draw();
  }

  draw(): void {
    if (!this.view) return;
    const { selected, wrong, ground } = this.view.palette();
    this.handles?.show(this.shown ? this.points.map((p) => p.at) : [], this.shown ? this.chosen : -1,
      { fill: selected, chosen: wrong, rim: ground });
  }

  turnBack(which: 'undo' | 'redo'): void {
    const then = this.history[which](this.nets);
    if (!then) {
      this.say(`There is nothing to ${which}.`);
      return;
    }
    this.nets = then;
    this.points = controlPoints(then);
    if (this.chosen >= this.points.length) this.chosen = -1;
    this.say(which === 'undo' ? 'The last change is undone.' : 'The change is there again.');
    this.change(then.map((_, patch) => patch));
  }

  next(by: number): void {
    const count = this.points.length;
    this.choose(this.chosen < 0 ? (by > 0 ? 0 : count - 1) : (this.chosen + by + count) % count);
  }

  /** @returns whether the key moves or leaves a point */
  onKey(event: KeyboardEvent): boolean {
    if (this.chosen < 0 || !this.shown) return false;
    const ways: Record<string, [number, number, number]> = {
      ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowUp: [0, 1, 0], ArrowDown: [0, -1, 0],
      PageUp: [0, 0, 1], PageDown: [0, 0, -1],
    };
    const way = ways[event.key];
    if (event.key === 'Escape') this.choose(-1);
    else if (!way) return false;
    else {
      // A key that is held down is one change.
      if (!event.repeat) this.history.keep(this.nets);
      const [right, up, away] = way.map((x) => x * STEP * (event.shiftKey ? 5 : 1));
      this.handles?.step(right!, up!, away!);
    }
    return true;
  }

  private choose(i: number): void {
    this.chosen = i;
    this.say(i < 0 ? '' : `Control point ${i + 1} of ${this.points.length}${this.place()}`);
    this.draw();
  }

  private place(): string {
    return ` at (${this.points[this.chosen]!.at.map((x) => Math.round(x * 1e4) / 1e4).join(', ')})`;
  }

  private move(i: number, to: [number, number, number]): void {
    const patches = movePoint(this.nets, this.points[i]!, to);
    this.say(`Control point ${i + 1} of ${this.points.length}${this.place()}`);
    this.change(patches);
  }
}
