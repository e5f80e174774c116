// Which element is under the pointer: near a corner the vertex, at a line the edge, beside it
// the half-edge, else the face.

import { Vector3, type Ray } from 'three';
import type { Element, Mesh } from '../model/mesh';
import type { Surface } from './shapes';

const NEAR_CORNER = 0.82;
const ON_LINE = 0.055;
const BESIDE_LINE = 0.2;

function nearestTriangle(surface: Surface, ray: Ray): { triangle: number; at: Vector3 } | null {
  const [a, b, c, hit] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
  const at = new Vector3();
  let nearest = Infinity;
  let triangle = -1;
  for (let t = 0; t < surface.faces.length; ++t) {
    a.fromArray(surface.positions, 9 * t);
    b.fromArray(surface.positions, 9 * t + 3);
    c.fromArray(surface.positions, 9 * t + 6);
    if (!ray.intersectTriangle(a, b, c, false, hit)) continue;
    const distance = hit.distanceToSquared(ray.origin);
    if (distance >= nearest) continue;
    nearest = distance;
    triangle = t;
    at.copy(hit);
  }
  return triangle < 0 ? null : { triangle, at };
}

/** The shares of the three corners in a point of a triangle. */
function shares(surface: Surface, t: number, at: Vector3): [number, number, number] {
  const corner = (i: number): Vector3 => new Vector3().fromArray(surface.positions, 9 * t + 3 * i);
  const [a, b, c] = [corner(0), corner(1), corner(2)];
  const area = (p: Vector3, q: Vector3, r: Vector3): number =>
    q.clone().sub(p).cross(r.clone().sub(p)).length();
  const whole = area(a, b, c) || 1;
  return [area(at, b, c) / whole, area(a, at, c) / whole, area(a, b, at) / whole];
}

export function pick(mesh: Mesh, surface: Surface, ray: Ray): Element | null {
  const hit = nearestTriangle(surface, ray);
  if (!hit) return null;
  const weights = shares(surface, hit.triangle, hit.at);
  const corner = weights.findIndex((w) => w > NEAR_CORNER);
  if (corner >= 0) return { kind: 'v', index: surface.corners[3 * hit.triangle + corner]! };
  const least = weights.indexOf(Math.min(...weights));
  // The side across from corner i begins at corner i + 1.
  const h = surface.sides[3 * hit.triangle + ((least + 1) % 3)]!;
  if (h >= 0 && weights[least]! < BESIDE_LINE) {
    const edge = mesh.edge(h);
    if (weights[least]! < ON_LINE && edge >= 0) return { kind: 'e', index: edge };
    return { kind: 'h', index: h };
  }
  return { kind: 'f', index: surface.faces[hit.triangle]! };
}
