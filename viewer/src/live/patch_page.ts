// A Bezier surface as the student's evaluate gives it, with its control net.

import { button, el, keyButton, replace } from '../dom';
import { saveFile, savePicture } from '../model/export';
import { Mesh } from '../model/mesh';
import { meshOfPolygons } from '../model/polygons';
import { KeyHelp, type KeyRow } from '../panels/key_help';
import { MeshView } from '../scene/mesh_view';
import { hasWebGL } from '../scene/webgl';
import type { SurfaceHit } from '../scene/picking';
import type { IsocurvesAnswer, PatchAnswer, Point3 } from './answers';
import type { Connection } from './connection';
import { Isocurves } from './isocurves';
import { NetEditor } from './net_editor';
import { BezierShell, verdict } from './shell';

const DENSITIES = [4, 8, 16, 32, 64];
const PATCH_KEYS: KeyRow[] = [
  ['B, V', 'the control net; the lines along u and v'],
  ['K', 'the curves at one u and one v'],
  ['P, Shift P', 'the next point of the net, the one before'],
  ['arrow keys', 'move the chosen point; without one, turn the view'],
  ['Page up, down', 'move the chosen point away and towards you'],
  ['+, -, Space', 'nearer, further, reset'],
  ['Z, Y', 'undo, redo'],
  ['Esc', 'choose no point'],
];
type Grid = (Point3 | null)[][];

/** The lines of a grid in both directions, as pairs of ends. */
function gridLines(grid: Grid, every: number): number[] {
  const lines: number[] = [];
  const join = (a: Point3 | null | undefined, b: Point3 | null | undefined): void => {
    if (a && b) lines.push(...a, ...b);
  };
  grid.forEach((row, j) => row.forEach((p, i) => {
    if (j % every === 0) join(p, row[i + 1]);
    if (i % every === 0) join(p, grid[j + 1]?.[i]);
  }));
  return lines;
}

export class PatchPage {
  private readonly shell: BezierShell;
  private readonly view: MeshView | null = null;
  private readonly editor: NetEditor;
  private readonly isocurves: Isocurves;
  private density = 16;
  private shown = { net: true, lines: true, iso: false };
  private answers: PatchAnswer[] = [];
  private isoAnswer: IsocurvesAnswer | null = null;
  /** Patches whose answer is not that of what is asked now. */
  private stale: Set<number>;
  private fit = true;

  constructor(app: HTMLElement, private readonly connection: Connection, private readonly name: string,
    nets: Point3[][][]) {
    this.shell = new BezierShell(app, connection, name);
    const stage = el('div', { class: 'stage' });
    this.shell.stage.append(stage);
    if (hasWebGL()) {
      this.view = new MeshView(stage, { upright: 'z' });
      Object.assign(this.view.options, { ids: false, arrows: false, edges: false });
      this.view.onSurface = (hit) => this.point(hit);
    } else {
      stage.append(el('p', { class: 'quiet no-webgl' }, 'This browser has no WebGL, so there is no 3D view.'));
    }
    this.editor = new NetEditor(nets, this.view, (text) => this.shell.say(text), (patches) => this.changed(patches));
    this.isocurves = new Isocurves(nets.length, () => this.askForCurves());
    this.stale = new Set(nets.keys());
    this.fillFoot();
    this.shell.files.append(button('Save .bez', () => this.save()),
      button('Save picture', () => this.savePicture()), new KeyHelp(PATCH_KEYS).button);
    document.addEventListener('keydown', (event) => this.onKey(event));
    this.shell.listen(() => {
      this.stale = new Set(nets.keys());
      return this.ask();
    });
    void this.shell.run(() => this.ask());
  }

  private fillFoot(): void {
    const choose = el('select', { 'aria-label': 'Sampling density' },
      ...DENSITIES.map((d) => el('option', { value: d, selected: d === this.density }, `${d} × ${d}`)));
    choose.addEventListener('change', () => {
      this.density = Number(choose.value);
      this.changed(this.editor.nets.map((_, patch) => patch));
    });
    const toggle = (text: string, key: string, what: 'net' | 'lines' | 'iso'): HTMLButtonElement =>
      keyButton(text, key, () => this.toggle(what), { 'data-shown': what, 'aria-pressed': String(this.shown[what]) });
    this.shell.foot.append(el('label', {}, 'Samples ', choose),
      toggle('Control net', 'B', 'net'),
      toggle('u and v lines', 'V', 'lines'),
      keyButton('Next point', 'P', () => this.editor.next(1)),
      keyButton('Undo', 'Z', () => this.editor.turnBack('undo')),
      keyButton('Redo', 'Y', () => this.editor.turnBack('redo')),
      button('Reset', () => this.view?.eye.reset()),
      toggle('Curves at', 'K', 'iso'), this.isocurves.tools);
  }

  private toggle(what: 'net' | 'lines' | 'iso', on = !this.shown[what]): void {
    this.shown[what] = on;
    this.shell.foot.querySelector(`[data-shown=${what}]`)?.setAttribute('aria-pressed', String(on));
    this.editor.shown = this.shown.net;
    if (what === 'iso' && on) this.askForCurves();
    else this.draw();
  }

  private onKey(event: KeyboardEvent): void {
    const target = event.target as Element;
    if (event.ctrlKey || event.metaKey || event.altKey || target.closest('input, select')) return;
    if (!this.editor.onKey(event) && !this.doKey(event, target)) return;
    event.preventDefault();
  }

  private doKey(event: KeyboardEvent, target: Element): boolean {
    const acts: Record<string, () => void> = {
      b: () => this.toggle('net'),
      v: () => this.toggle('lines'),
      k: () => this.toggle('iso'),
      p: () => this.editor.next(event.shiftKey ? -1 : 1),
      z: () => this.editor.turnBack(event.shiftKey ? 'redo' : 'undo'),
      y: () => this.editor.turnBack('redo'),
      '+': () => this.view?.eye.zoom(0.88),
      '-': () => this.view?.eye.zoom(1.14),
      ArrowLeft: () => this.view?.eye.orbit(-0.12, 0),
      ArrowRight: () => this.view?.eye.orbit(0.12, 0),
      ArrowUp: () => this.view?.eye.orbit(0, 0.12),
      ArrowDown: () => this.view?.eye.orbit(0, -0.12),
    };
    if (!target.closest('button')) acts[' '] = () => this.view?.eye.reset();
    const act = acts[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    act?.();
    return act !== undefined;
  }

  /** Patches that are not as they were. */
  private changed(patches: number[]): void {
    for (const patch of patches) this.stale.add(patch);
    this.draw();
    void this.shell.run(() => this.ask());
  }

  private async ask(): Promise<void> {
    const { density } = this;
    for (const patch of [...this.stale]) {
      this.stale.delete(patch);
      this.answers[patch] = await this.connection.patch(this.editor.nets[patch]!, density);
    }
    await this.fetchCurves();
    this.draw();
  }

  private askForCurves(): void {
    if (!this.shown.iso) {
      this.toggle('iso', true);
      return;
    }
    void this.shell.run(() => this.ask());
  }

  private async fetchCurves(): Promise<void> {
    if (!this.shown.iso) return;
    const { patch, u, v } = this.isocurves;
    this.isoAnswer = await this.connection.isocurves(this.editor.nets[patch]!, u, v);
  }

  /** The pointer is somewhere on the surface. */
  private point(hit: SurfaceHit | null): void {
    if (!hit || !this.shown.iso) return;
    const n = this.density + 1;
    const patch = Math.floor(hit.vertices[0] / (n * n));
    const mixed = (of: (k: number) => number): number =>
      hit.vertices.reduce((sum, vertex, i) => sum + hit.shares[i]! * of(vertex % (n * n)), 0) / this.density;
    this.isocurves.moveTo(patch, mixed((k) => k % n), mixed((k) => Math.floor(k / n)));
  }

  private savePicture(): void {
    if (this.view) savePicture(`${this.name.replace(/\.[^.]*$/, '')}.png`, this.view.snapshot());
  }

  private save(): void {
    const numbers = (net: Point3[][]): string =>
      `${net.length} ${net[0]!.length}\n${net.map((row) => row.map((p) => p.join(' ')).join('  ')).join('\n')}`;
    const { nets } = this.editor;
    saveFile(this.name, `${nets.length}\n${nets.map(numbers).join('\n')}\n`);
  }

  /** The grids as one mesh of quads, and the lines along u and v. */
  private surface(): { mesh: Mesh; lines: number[] } {
    const positions: Point3[] = [];
    const polygons: number[][] = [];
    const lines: number[] = [];
    const n = this.density + 1;
    for (const answer of this.answers) {
      // One patch may still have the density before.
      const grid: (Point3 | null)[] = answer?.grid.length === n * n ? answer.grid : new Array(n * n).fill(null);
      const rows: Grid = Array.from({ length: n }, (_, j) => grid.slice(j * n, (j + 1) * n));
      if (this.shown.lines) lines.push(...gridLines(rows, Math.max(1, Math.round(this.density / 8))));
      const first = positions.length;
      positions.push(...grid.map((p): Point3 => p ?? [0, 0, 0]));
      for (let c = 0; c + n + 1 < grid.length; ++c) {
        const corners = [c, c + 1, c + n + 1, c + n];
        if (c % n < n - 1 && corners.every((k) => grid[k])) polygons.push(corners.map((k) => first + k));
      }
    }
    return { mesh: new Mesh(meshOfPolygons(positions, polygons)), lines };
  }

  private showCurves(view: MeshView): void {
    view.curves = [];
    if (!this.shown.iso || !this.isoAnswer) return;
    const there = (curve: (Point3 | null)[]): Point3[] => curve.filter((p) => p !== null);
    view.curves.push({ points: there(this.isoAnswer.along_u), color: 'next' },
      { points: there(this.isoAnswer.along_v), color: 'twin' });
  }

  private draw(): void {
    const answers = this.answers.filter(Boolean);
    const told = answers.find((a) => a.told.verdict !== 'passed') ?? answers[0];
    if (told) replace(this.shell.told, ...verdict(told.told, 'BezierPatch::evaluate'));
    if (!this.view) return;
    const { mesh, lines } = this.surface();
    const { nets } = this.editor;
    this.view.lines = [
      { points: Float32Array.from(lines), color: 'line' },
      { points: Float32Array.from(this.shown.net ? nets.flatMap((net) => gridLines(net, 1)) : []), color: 'selected' },
    ];
    this.showCurves(this.view);
    const there = mesh.faceCount > 0;
    this.view.show(mesh, { arcs: [], changed: new Set() }, this.fit && there);
    this.fit &&= !there;
    this.editor.draw();
    const given = answers.reduce((sum, a) => sum + a.grid.length, 0);
    this.view.canvas.setAttribute('aria-label', `Surface of ${nets.length} patches, ${given} points by your evaluate`);
  }
}
