// The ids of all elements of a small mesh.

import { nameOf, sameElement, type Element, type Mesh } from '../model/mesh';
import type { Label } from './labels';
import { mix, placeOf, planesAround, planesBeside, type ArrowMaker, type Plane } from './shapes';

/** With more half-edges than this there are no ids. */
const MOST_LABELS = 400;
const STYLES = { f: 'face', h: 'halfedge', e: 'edge', v: 'vertex' } as const;
type Kind = keyof typeof STYLES;

export function idLabels(mesh: Mesh, maker: ArrowMaker, kinds: Kind[], selected: Element | null): Label[] {
  if (mesh.halfedgeCount > MOST_LABELS) return [];
  const around = planesAround(mesh, maker);
  const labels: Label[] = [];
  for (const kind of kinds) {
    for (let index = 0; index < mesh.size(kind); ++index) {
      const element = { kind, index };
      if (!mesh.isLive(element) || sameElement(element, selected)) continue;
      const label = labelOf(mesh, maker, element, around);
      if (label) labels.push(label);
    }
  }
  return labels;
}

function labelOf(
  mesh: Mesh, maker: ArrowMaker, element: { kind: Kind; index: number }, around: Map<number, Plane[]>,
): Label | null {
  const place = placeOf(mesh, maker, element);
  if (!place) return null;
  const { kind, index } = element;
  const label: Label = { text: nameOf(element), at: place.centre, normal: [0, 0, 0], style: STYLES[kind] };
  if (kind === 'e') {
    // Aside of the middle, where the names of its half-edges are.
    const h = mesh.halfedge(element);
    label.at = mix(mesh.position(mesh.vertex(h)), mesh.position(mesh.end(h)), 0.3);
  }
  // The back of a surface with a boundary can be seen, so nothing of it is hidden.
  if (mesh.countLive('b') > 0) return label;
  if (kind === 'v') label.planes = around.get(index) ?? [];
  else if (kind === 'e') label.planes = planesBeside(mesh, maker, element);
  else label.normal = place.normal;
  return label;
}
