// Which element is under the pointer: near a corner the vertex, at a line the edge, beside it
// the half-edge, else the face.

import { Vector3, type Ray } from 'three';
import type { Element, Mesh } from '../model/mesh';
import type { Surface } from './shapes';

const NEAR_CORNER = 0.82;
const ON_LINE = 0.055;
const BESIDE_LINE = 0.2;

function nearestTriangle(surface: Surface, ray: Ray): { triangle: number; at: Vector3 } | null {
  const { positions, corners } = surface;
  const [a, b, c, hit] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
  const at = new Vector3();
  let nearest = Infinity;
  let triangle = -1;
  for (let t = 0; t < surface.faces.length; ++t) {
    a.fromArray(positions, 3 * corners[3 * t]!);
    b.fromArray(positions, 3 * corners[3 * t + 1]!);
    c.fromArray(positions, 3 * corners[3 * t + 2]!);
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
  const corner = (i: number): Vector3 => new Vector3().fromArray(surface.positions, 3 * surface.corners[3 * t + i]!);
  const [a, b, c] = [corner(0), corner(1), corner(2)];
  const area = (p: Vector3, q: Vector3, r: Vector3): number =>
    q.clone().sub(p).cross(r.clone().sub(p)).length();
  const whole = area(a, b, c) || 1;
  return [area(at, b, c) / whole, area(a, at, c) / whole, area(a, b, at) / whole];
}

/** A point of a surface: its triangle's vertices, and the share that each has in it. */
export interface SurfaceHit {
  vertices: [number, number, number];
  shares: [number, number, number];
}

export function hitSurface(surface: Surface, ray: Ray): SurfaceHit | null {
  const hit = nearestTriangle(surface, ray);
  if (!hit) return null;
  const [a, b, c] = surface.corners.subarray(3 * hit.triangle, 3 * hit.triangle + 3);
  return { vertices: [a!, b!, c!], shares: shares(surface, hit.triangle, hit.at) };
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
