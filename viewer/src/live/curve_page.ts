// A Bezier curve: its control points, and the levels of de Casteljau's algorithm as the
// student's function gives them.

import { button, el, followPointer, keyButton, replace } from '../dom';
import { saveFile, saveSvg } from '../model/export';
import { History } from '../model/history';
import { KeyHelp, type KeyRow } from '../panels/key_help';
import type { CurveAnswer, Point2 } from './answers';
import type { Connection } from './connection';
import { BezierShell, verdict } from './shell';

const SVG = 'http://www.w3.org/2000/svg';
const CURVE_KEYS: KeyRow[] = [
  ['E', 'one more level of de Casteljau, then none again'],
  ['C', 'the whole curve'],
  ['A, Delete', 'add a point, remove the chosen one'],
  ['arrow keys', 'move the chosen point, with Shift further'],
  ['Z, Y', 'undo, redo'],
  ['wheel', 'change t'],
  ['P', 'save the picture'],
];
const WIDTH = 1000;
const HEIGHT = 700;

function shape(tag: string, attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS(SVG, tag) as SVGElement;
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  return element;
}

export class CurvePage {
  private readonly shell: BezierShell;
  private readonly picture = shape('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: 'curve', role: 'group',
    'aria-label': 'Bezier curve with its control points' });
  private readonly slider = el('input', { type: 'range', min: 0, max: 1, step: 0.01, 'aria-label': 't' });
  private readonly shownT = el('output', { class: 'mono' });
  private t = 0.5;
  private level = 0;
  private whole = false;
  private chosen = 0;
  private readonly history = new History<Point2[]>();
  private answer: CurveAnswer | null = null;
  private readonly scale: number;
  private readonly low: Point2;

  constructor(app: HTMLElement, private readonly connection: Connection, private readonly name: string,
    private points: Point2[]) {
    const [x, y] = [points.map((p) => p[0]), points.map((p) => p[1])];
    const reach = (axis: number[]): [number, number] => [Math.min(...axis), Math.max(...axis)];
    const [[x0, x1], [y0, y1]] = [reach(x), reach(y)];
    this.scale = (0.72 * WIDTH) / Math.max(x1 - x0, 1.4 * (y1 - y0), 1e-6);
    this.low = [(x0 + x1) / 2 - WIDTH / 2 / this.scale, (y0 + y1) / 2 - HEIGHT / 2 / this.scale];
    this.shell = new BezierShell(app, connection, name);
    this.shell.stage.append(this.picture);
    this.fillFoot();
    this.shell.files.append(button('Save .bzc', () => this.save()),
      keyButton('Save picture', 'P', () => this.savePicture()), new KeyHelp(CURVE_KEYS).button);
    this.picture.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.setT(this.t - Math.sign((event as WheelEvent).deltaY) * 0.01);
    }, { passive: false });
    document.addEventListener('keydown', (event) => this.onKey(event));
    this.shell.listen(() => this.ask());
    this.setT(0.5);
  }

  private fillFoot(): void {
    this.slider.addEventListener('input', () => this.setT(Number(this.slider.value)));
    this.shell.foot.append(
      el('label', { class: 'slider' }, 't ', this.slider, this.shownT),
      keyButton('Next level', 'E', () => this.nextLevel()),
      keyButton('Whole curve', 'C', () => this.toggleWhole()),
      keyButton('Add point', 'A', () => this.addPoint()),
      keyButton('Remove point', 'Delete', () => this.removePoint()),
      keyButton('Undo', 'Z', () => this.turnBack('undo')),
      keyButton('Redo', 'Y', () => this.turnBack('redo')));
  }

  private onKey(event: KeyboardEvent): void {
    const target = event.target as Element;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const acts: Record<string, () => void> = {
      e: () => this.nextLevel(),
      c: () => this.toggleWhole(),
      a: () => this.addPoint(),
      Delete: () => this.removePoint(),
      z: () => this.turnBack(event.shiftKey ? 'redo' : 'undo'),
      y: () => this.turnBack('redo'),
      p: () => this.savePicture(),
    };
    const act = acts[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (act) act();
    else if (!target.matches('.control') || !this.moveByKey(event)) return;
    event.preventDefault();
  }

  private moveByKey(event: KeyboardEvent): boolean {
    const step = (event.shiftKey ? 40 : 8) / this.scale;
    const ways: Record<string, Point2> = {
      ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
    };
    const way = ways[event.key];
    if (!way) return false;
    // A key that is held down is one change.
    if (!event.repeat) this.keep();
    const [x, y] = this.points[this.chosen]!;
    this.move(this.chosen, [x + way[0] * step, y + way[1] * step]);
    return true;
  }

  private setT(t: number): void {
    this.t = Math.round(Math.max(0, Math.min(1, t)) * 100) / 100;
    this.slider.value = String(this.t);
    this.shownT.textContent = this.t.toFixed(2);
    void this.shell.run(() => this.ask());
  }

  private nextLevel(): void {
    this.level = (this.level + 1) % this.points.length;
    this.draw();
  }

  private toggleWhole(): void {
    this.whole = !this.whole;
    this.draw();
  }

  /** A new point in the middle between the chosen one and its neighbour. */
  private addPoint(): void {
    const left = Math.min(this.chosen, this.points.length - 2);
    const [a, b] = [this.points[left]!, this.points[left + 1]!];
    this.keep();
    this.points.splice(left + 1, 0, [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]);
    this.chosen = left + 1;
    this.changed();
  }

  private removePoint(): void {
    if (this.points.length <= 2) {
      this.shell.say('A curve has at least two control points.');
      return;
    }
    this.keep();
    this.points.splice(this.chosen, 1);
    this.chosen = Math.min(this.chosen, this.points.length - 1);
    this.changed();
  }

  private keep(): void {
    this.history.keep(this.points);
  }

  private turnBack(which: 'undo' | 'redo'): void {
    const then = this.history[which](this.points);
    if (!then) {
      this.shell.say(`There is nothing to ${which}.`);
      return;
    }
    this.points = then;
    this.chosen = Math.min(this.chosen, then.length - 1);
    this.shell.say(which === 'undo' ? 'The last change is undone.' : 'The change is there again.');
    this.changed();
  }

  private move(i: number, to: Point2): void {
    this.points[i] = to;
    this.changed();
  }

  private changed(): void {
    this.level = Math.min(this.level, this.points.length - 1);
    this.answer = null;
    this.draw();
    void this.shell.run(() => this.ask());
  }

  private async ask(): Promise<void> {
    this.answer = await this.connection.curve(this.points, this.t);
    this.draw();
  }

  private save(): void {
    const lines = this.points.map(([x, y]) => `${x} ${y}`);
    saveFile(this.name, `${this.points.length}\n${lines.join('\n')}\n`);
  }

  private savePicture(): void {
    saveSvg(`${this.name.replace(/\.[^.]*$/, '')}.svg`, this.picture);
  }

  private place([x, y]: Point2): Point2 {
    return [(x - this.low[0]) * this.scale, HEIGHT - (y - this.low[1]) * this.scale];
  }

  private path(points: (Point2 | null)[], name: string): SVGElement {
    let text = '';
    let pen = false;
    for (const p of points) {
      if (p) text += `${pen ? 'L' : 'M'}${this.place(p).map((x) => x.toFixed(2)).join(' ')}`;
      pen = p !== null;
    }
    return shape('path', { d: text, class: name });
  }

  private draw(): void {
    const focused = document.activeElement?.matches('.control') === true;
    const parts: SVGElement[] = [];
    if (this.answer) parts.push(this.path(this.answer.exact, 'exact'));
    parts.push(this.path(this.points, 'polygon'));
    const levels = this.answer?.levels ?? [];
    levels.slice(0, this.level).forEach((points, i) => parts.push(...this.drawLevel(points, i, levels.length)));
    if (this.answer && this.whole) parts.push(this.path(this.answer.curve, 'yours'));
    this.points.forEach((p, i) => parts.push(this.control(p, i)));
    this.picture.replaceChildren(...parts);
    if (focused) this.picture.querySelectorAll<SVGElement>('.control')[this.chosen]?.focus();
    if (this.answer) this.describe(this.answer);
  }

  private drawLevel(points: Point2[], i: number, count: number): SVGElement[] {
    const last = i === count - 1 && points.length === 1;
    const dots = points.map((p) => {
      const [cx, cy] = this.place(p);
      return shape('circle', { cx, cy, r: last ? 10 : 5, class: last ? 'result' : `level level-${i % 3}` });
    });
    return [this.path(points, `level level-${i % 3}`), ...dots];
  }

  private control(p: Point2, i: number): SVGElement {
    const [cx, cy] = this.place(p);
    const name = `Control point ${i} at ${p.map((x) => Math.round(x * 1000) / 1000).join(', ')}`;
    const dot = shape('circle', { cx, cy, r: 11, class: i === this.chosen ? 'control chosen' : 'control',
      tabindex: 0, role: 'button', 'aria-label': name });
    dot.addEventListener('focus', () => (this.chosen = i));
    dot.addEventListener('pointerdown', (event) => this.drag(event as PointerEvent, i));
    return dot;
  }

  private drag(event: PointerEvent, i: number): void {
    event.preventDefault();
    this.chosen = i;
    const svg = this.picture as unknown as SVGSVGElement;
    followPointer((now, first) => {
      if (first) this.keep();
      const at = new DOMPoint(now.clientX, now.clientY).matrixTransform(svg.getScreenCTM()!.inverse());
      this.move(i, [at.x / this.scale + this.low[0], (HEIGHT - at.y) / this.scale + this.low[1]]);
    });
  }

  private describe(answer: CurveAnswer): void {
    replace(this.shell.told, ...verdict(answer.told, `evaluateStep at t = ${this.t.toFixed(2)}`));
    const short = (p: Point2): string => `(${p.map((x) => Math.round(x * 1e4) / 1e4).join(', ')})`;
    const rows = [this.points, ...answer.levels].map((points, i) =>
      el('tr', { class: i === this.level ? 'current' : undefined },
        el('th', { scope: 'row' }, i === 0 ? 'control' : `level ${i}`),
        el('td', { class: 'mono' }, points.map(short).join(' '))));
    replace(this.shell.lists, el('h3', {}, 'Levels'), el('table', { class: 'levels' }, el('tbody', {}, ...rows)));
  }
}
