// Several meshes beside each other, seen by one camera.

import { el, replace } from '../dom';
import { MeshView, type ViewSetup } from './mesh_view';
import { ballOf } from './shapes';
import type { Viewpoint } from './viewpoint';
import type { Mesh } from '../model/mesh';
import type { Marks, ViewOptions } from './mesh_view';

export interface GridCell {
  caption: string;
  /** What the picture shows, for those who do not see it. */
  text: string;
  mesh: Mesh;
  marks: Marks;
  colors: (string | null)[] | null;
  normals?: Float32Array | null;
}

const CAPTION = 30;

/** How many stand beside each other, so that they come out as large as possible. */
export function bestColumns(count: number, width: number, height: number): number {
  let best = 1;
  let largest = 0;
  for (let columns = 1; columns <= count; ++columns) {
    const side = Math.min(width / columns, height / Math.ceil(count / columns) - CAPTION);
    if (side > largest) {
      largest = side;
      best = columns;
    }
  }
  return best;
}

export class MeshGrid {
  readonly element = el('div', { class: 'mesh-grid' });
  private views: MeshView[] = [];

  /** The grid takes all of `width` and `height`, in pixels, of the page that it is part of. */
  show(cells: GridCell[], width: number, height: number, options: Partial<ViewOptions>, setup: ViewSetup = {}): void {
    this.clear();
    const columns = bestColumns(cells.length, width, height);
    this.element.style.gridTemplateColumns = `repeat(${columns}, minmax(0, 1fr))`;
    const stages = cells.map(() => el('div', { class: 'stage' }));
    replace(this.element, ...cells.map((cell, i) => el('figure', { class: 'grid-cell' },
      cell.caption !== '' && el('figcaption', {}, cell.caption),
      el('div', { class: 'stage-holder' }, stages[i]!))));
    const ball = ballOf(cells[0]!.mesh);
    this.views = cells.map((cell, i) => {
      const view = new MeshView(stages[i]!, setup);
      Object.assign(view.options, options);
      view.canvas.setAttribute('aria-label', cell.text);
      view.resize();
      view.colorVertices(cell.colors);
      view.show(cell.mesh, cell.marks, false, cell.normals ?? null);
      view.eye.lookAtBall(ball);
      return view;
    });
    const eyes = this.views.map((view) => view.eye);
    for (const eye of eyes) eye.leads(eyes.filter((other) => other !== eye));
  }

  /** Angles in degrees, the distance in radii of the first mesh. */
  lookFrom(azimuth: number, elevation: number, distance: number): void {
    for (const view of this.views) view.eye.lookFromAngles(azimuth, elevation, distance);
  }

  /** The one that moves all; null if nothing is shown. */
  get eye(): Viewpoint | null {
    return this.views[0]?.eye ?? null;
  }

  /** All of them with their captions, as one picture. */
  snapshot(): HTMLCanvasElement {
    const all = document.createElement('canvas');
    const whole = this.element.getBoundingClientRect();
    const ratio = Math.min(2, window.devicePixelRatio);
    all.width = whole.width * ratio;
    all.height = whole.height * ratio;
    const context = all.getContext('2d')!;
    const style = getComputedStyle(this.element);
    context.scale(ratio, ratio);
    context.fillStyle = style.backgroundColor;
    context.fillRect(0, 0, whole.width, whole.height);
    context.fillStyle = style.color;
    context.font = `600 14px ${style.fontFamily}`;
    context.textAlign = 'center';
    for (const view of this.views) {
      const box = view.canvas.getBoundingClientRect();
      context.drawImage(view.snapshot(), box.left - whole.left, box.top - whole.top, box.width, box.height);
      const caption = view.canvas.closest('.grid-cell')?.querySelector('figcaption')?.textContent ?? '';
      context.fillText(caption, box.left - whole.left + box.width / 2, box.top - whole.top - 10);
    }
    return all;
  }

  renderNow(): void {
    for (const view of this.views) view.renderNow();
  }

  clear(): void {
    for (const view of this.views) view.dispose();
    this.views = [];
    this.element.replaceChildren();
  }
}
