// A Bezier surface as the student's evaluate gives it, with its control net.

import { button, el, replace } from '../dom';
import { saveFile } from '../model/export';
import { Mesh } from '../model/mesh';
import { meshOfPolygons } from '../model/polygons';
import { MeshView } from '../scene/mesh_view';
import { hasWebGL } from '../scene/webgl';
import type { Connection, PatchAnswer, Point3 } from './connection';
import { BezierShell, verdict } from './shell';

const DENSITIES = [4, 8, 16, 32, 64];
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
  private density = 16;
  private lines = true;
  private net = true;
  private answers: PatchAnswer[] = [];
  private fit = true;

  constructor(app: HTMLElement, private readonly connection: Connection, private readonly name: string,
    private readonly nets: Point3[][][]) {
    this.shell = new BezierShell(app, connection, name);
    const stage = el('div', { class: 'stage' });
    this.shell.stage.append(stage);
    if (hasWebGL()) {
      this.view = new MeshView(stage);
      Object.assign(this.view.options, { ids: false, arrows: false, edges: false });
    } else {
      stage.append(el('p', { class: 'quiet no-webgl' }, 'This browser has no WebGL, so there is no 3D view.'));
    }
    this.fillFoot();
    this.shell.files.append(button('Save .bez', () => this.save()));
    document.addEventListener('keydown', (event) => this.onKey(event));
    this.shell.listen(() => this.ask());
    void this.shell.run(() => this.ask());
  }

  private fillFoot(): void {
    const choose = el('select', { 'aria-label': 'Sampling density' },
      ...DENSITIES.map((d) => el('option', { value: d, selected: d === this.density }, `${d} × ${d}`)));
    choose.addEventListener('change', () => {
      this.density = Number(choose.value);
      void this.shell.run(() => this.ask());
    });
    const toggle = (text: string, key: string, act: () => void): HTMLButtonElement => {
      const made = button(text, act, { 'data-key': key, 'aria-keyshortcuts': key, 'aria-pressed': 'true' });
      made.append(' ', el('kbd', {}, key));
      return made;
    };
    this.shell.foot.append(el('label', {}, 'Samples ', choose),
      toggle('Control net', 'B', () => this.toggle('net')),
      toggle('u and v lines', 'V', () => this.toggle('lines')),
      button('Reset', () => this.view?.reset()));
  }

  private toggle(what: 'net' | 'lines'): void {
    this[what] = !this[what];
    const key = what === 'net' ? 'B' : 'V';
    this.shell.foot.querySelector(`[data-key=${key}]`)?.setAttribute('aria-pressed', String(this[what]));
    this.draw();
  }

  private onKey(event: KeyboardEvent): void {
    const target = event.target as Element;
    if (event.ctrlKey || event.metaKey || event.altKey || target.closest('input, select')) return;
    const turns: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1],
    };
    const turn = turns[event.key];
    const key = event.key.toLowerCase();
    if (key === 'b') this.toggle('net');
    else if (key === 'v') this.toggle('lines');
    else if (key === ' ' && !target.closest('button')) this.view?.reset();
    else if (key === '+') this.view?.zoom(0.88);
    else if (key === '-') this.view?.zoom(1.14);
    else if (turn) this.view?.orbit(0.12 * turn[0], 0.12 * turn[1]);
    else return;
    event.preventDefault();
  }

  private async ask(): Promise<void> {
    const answers: PatchAnswer[] = [];
    for (const net of this.nets) answers.push(await this.connection.patch(net, this.density));
    this.answers = answers;
    this.draw();
  }

  private save(): void {
    const numbers = (net: Point3[][]): string =>
      `${net.length} ${net[0]!.length}\n${net.map((row) => row.map((p) => p.join(' ')).join('  ')).join('\n')}`;
    saveFile(this.name, `${this.nets.length}\n${this.nets.map(numbers).join('\n')}\n`);
  }

  /** The grids as one mesh of quads, and the lines along u and v. */
  private surface(): { mesh: Mesh; lines: number[] } {
    const positions: Point3[] = [];
    const polygons: number[][] = [];
    const lines: number[] = [];
    const n = this.density + 1;
    for (const { grid } of this.answers) {
      const rows: Grid = Array.from({ length: n }, (_, j) => grid.slice(j * n, (j + 1) * n));
      if (this.lines) lines.push(...gridLines(rows, Math.max(1, Math.round(this.density / 8))));
      const first = positions.length;
      positions.push(...grid.map((p): Point3 => p ?? [0, 0, 0]));
      for (let c = 0; c + n + 1 < grid.length; ++c) {
        const corners = [c, c + 1, c + n + 1, c + n];
        if (c % n < n - 1 && corners.every((k) => grid[k])) polygons.push(corners.map((k) => first + k));
      }
    }
    return { mesh: new Mesh(meshOfPolygons(positions, polygons)), lines };
  }

  private draw(): void {
    const told = this.answers.find((a) => a.told.verdict !== 'passed') ?? this.answers[0];
    if (told) replace(this.shell.told, ...verdict(told.told, 'BezierPatch::evaluate'));
    if (!this.view) return;
    const { mesh, lines } = this.surface();
    this.view.lines = [
      { points: Float32Array.from(lines), color: 'line' },
      { points: Float32Array.from(this.net ? this.nets.flatMap((net) => gridLines(net, 1)) : []), color: 'selected' },
    ];
    const there = mesh.faceCount > 0;
    this.view.show(mesh, { arcs: [], changed: new Set() }, this.fit && there);
    this.fit &&= !there;
    const given = this.answers.reduce((sum, a) => sum + a.grid.length, 0);
    this.view.canvas.setAttribute('aria-label', `Surface of ${this.nets.length} patches, ${given} points by your evaluate`);
  }
}
