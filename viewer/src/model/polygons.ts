// A half-edge mesh of polygons, for surfaces that come without one. It has no edges and no
// boundary loops: only faces and corners are drawn.

import type { MeshJson } from './mesh';

const UNSET = 0xffffffff;

export function meshOfPolygons(positions: [number, number, number][], polygons: number[][]): MeshJson {
  const mesh: MeshJson = { h: [], v: [], p: positions.flat(), e: [], f: [], b: [] };
  positions.forEach(() => mesh.v.push(UNSET, 1));
  polygons.forEach((polygon, face) => {
    const first = mesh.h.length / 6;
    mesh.f.push(first, 1, 0);
    polygon.forEach((vertex, i) => {
      mesh.h.push(first + ((i + 1) % polygon.length), UNSET, vertex, UNSET, face, 1);
    });
  });
  return mesh;
}
