// The levels of subdivision beside each other, in place of the one mesh.

import { el } from '../dom';
import { Mesh } from '../model/mesh';
import type { StateJson } from '../model/types';
import { marksOf } from '../panels/marks';
import { MeshGrid, type GridCell } from '../scene/mesh_grid';
import type { ViewOptions } from '../scene/mesh_view';
import type { Viewpoint } from '../scene/viewpoint';

/** @param compare  colour it by its distance from OpenSubdiv's answer, where that is known */
export function levelCell(caption: string, state: StateJson, compare: boolean): GridCell {
  const mesh = new Mesh(state.mesh);
  const wrong = state.told?.findings.find((f) => f.pointers)?.pointers?.wrong ?? [];
  const deviation = (compare && state.deviation) || null;
  const shown = { label: caption, mesh, broken: state.broken, changes: state.changes ?? [], wrong };
  const told = deviation ? ` Coloured by the distance from OpenSubdiv. ${deviation.text}` : '';
  return {
    caption,
    text: `${caption}: ${mesh.counts()}.${told}`,
    mesh,
    marks: marksOf(shown, deviation),
    colors: deviation?.colors ?? null,
  };
}

export class LevelsCover {
  readonly element = el('div', { class: 'levels-holder', hidden: true });
  private readonly grid = new MeshGrid();

  constructor() {
    this.element.append(this.grid.element);
  }

  get shown(): boolean {
    return !this.element.hidden;
  }

  /** That of the levels; null if they are not shown. */
  get eye(): Viewpoint | null {
    return this.grid.eye;
  }

  show(levels: { label: string; state: StateJson }[], options: ViewOptions): void {
    this.element.hidden = false;
    const cells = levels.map(({ label, state }) =>
      levelCell(`${label}: ${new Mesh(state.mesh).countLive('v')} vertices`, state, options.compare));
    this.grid.show(cells, this.element.clientWidth, this.element.clientHeight,
      { ids: false, arrows: false, wireframe: options.wireframe });
  }

  /** What is shown; null if nothing is. */
  snapshot(): HTMLCanvasElement | null {
    return this.shown ? this.grid.snapshot() : null;
  }

  hide(): void {
    this.element.hidden = true;
    this.grid.clear();
  }
}
