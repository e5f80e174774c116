// The ids of all elements of a small mesh.

import { nameOf, sameElement, type Element, type Mesh } from '../model/mesh';
import type { Label } from './labels';
import { placeOf, sub, type ArrowMaker, type Vec } from './shapes';

/** With more half-edges than this there are no ids. */
const MOST_LABELS = 400;
const STYLES = { f: 'face', h: 'halfedge', v: 'vertex' } as const;

/** @param centre  of the mesh: from there, what is on the far side is told well enough */
export function idLabels(mesh: Mesh, maker: ArrowMaker, selected: Element | null, centre: Vec): Label[] {
  if (mesh.halfedgeCount > MOST_LABELS) return [];
  // The back of a surface with a boundary can be seen, so nothing of it is hidden.
  const open = mesh.countLive('b') > 0;
  const labels: Label[] = [];
  for (const kind of ['f', 'h', 'v'] as const) {
    for (let index = 0; index < mesh.size(kind); ++index) {
      const element: Element = { kind, index };
      if (!mesh.isLive(element) || sameElement(element, selected)) continue;
      const place = placeOf(mesh, maker, element);
      if (!place) continue;
      const normal: Vec = open ? [0, 0, 0] : kind === 'v' ? sub(place.centre, centre) : place.normal;
      labels.push({ text: nameOf(element), at: place.centre, normal, style: STYLES[kind] });
    }
  }
  return labels;
}
