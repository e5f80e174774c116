// A half-edge mesh of polygons, for surfaces that come without one. It has no edges and no
// boundary loops: only faces and corners are drawn.

import type { MeshJson } from './mesh';

const UNSET = 0xffffffff;

export function meshOfPolygons(positions: [number, number, number][], polygons: number[][]): MeshJson {
  const [h, v, f]: [number[], number[], number[]] = [[], [], []];
  positions.forEach(() => v.push(UNSET, 1));
  polygons.forEach((polygon, face) => {
    const first = h.length / 6;
    f.push(first, 1, 0);
    polygon.forEach((vertex, i) => {
      h.push(first + ((i + 1) % polygon.length), UNSET, vertex, UNSET, face, 1);
    });
  });
  return { h, v, p: positions.flat(), e: [], f, b: [] };
}
