// Nothing but a picture, for `meshgrade view --screenshot`. It is drawn while the page is
// loaded, in the size that was asked for: whoever takes the picture need not wait.

import { el, replace } from '../dom';
import type { PictureData } from '../model/types';
import { legend } from '../panels/legend';
import { MeshGrid } from '../scene/mesh_grid';
import { hasWebGL } from '../scene/webgl';
import { levelCell } from './levels';

export function showPicture(app: HTMLElement, data: PictureData): void {
  const { request, panels } = data;
  document.title = data.title;
  const page = el('main', { class: 'picture' });
  page.style.width = `${request.width}px`;
  page.style.height = `${request.height}px`;
  replace(app, page);
  if (!hasWebGL()) {
    replace(page, el('p', { class: 'no-webgl' }, 'This browser has no WebGL.'));
    return;
  }
  const grid = new MeshGrid();
  const deviation = panels.at(-1)!.state.deviation;
  page.append(grid.element);
  if (request.compare && deviation) page.append(legend(deviation, null));
  const options = { wireframe: request.wireframe, ids: request.ids, edgeIds: request.ids, arrows: request.ids,
    smooth: request.smooth, edges: !request.smooth || request.wireframe, normalLines: request.normals };
  const cells = panels.map((p) => ({ ...levelCell(p.caption, p.state, request.compare),
    normals: p.normals ? Float32Array.from(p.normals.map((x) => x ?? NaN)) : null }));
  grid.show(cells, request.width, grid.element.clientHeight, options, { fine: true });
  const { azimuth, elevation, distance } = request.camera;
  grid.lookFrom(azimuth, elevation, distance);
  grid.renderNow();
}
