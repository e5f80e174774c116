// Turns a mesh into what is drawn: triangles, lines and the arrows of half-edges.

import { ShapeUtils, Vector2 } from 'three';
import type { Element, FaceWalk, Mesh } from '../model/mesh';

export type Vec = [number, number, number];

export const add = (a: Vec, b: Vec): Vec => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a: Vec, b: Vec): Vec => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec, s: number): Vec => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a: Vec, b: Vec): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a: Vec): number => Math.hypot(a[0], a[1], a[2]);
export const cross = (a: Vec, b: Vec): Vec => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const unit = (a: Vec): Vec => {
  const size = length(a);
  return size > 0 ? scale(a, 1 / size) : [0, 0, 1];
};
export const mix = (a: Vec, b: Vec, t: number): Vec => add(scale(a, 1 - t), scale(b, t));

export interface Surface {
  /** Of all vertices, also of those that no triangle has. */
  positions: Float32Array;
  /** The vertex of each corner. */
  corners: Uint32Array;
  /** The face and the three half-edges (-1: a line inside a polygon) of each triangle. */
  faces: Uint32Array;
  sides: Int32Array;
}

/** A fan from the first corner. */
function fanOf(count: number): number[][] {
  return Array.from({ length: count - 2 }, (_, i) => [0, i + 1, i + 2]);
}

/** Triangles between the corners of a polygon, which may be bent in and not quite flat. */
function cutPolygon(points: Vec[], normal: Vec): number[][] {
  const right = unit(sub(points[1]!, points[0]!));
  const up = cross(normal, right);
  const turns = points.map((p, i) => {
    const [a, b] = [points.at(i - 1)!, points[(i + 1) % points.length]!];
    return dot(cross(sub(p, a), sub(b, p)), normal);
  });
  if (turns.every((turn) => turn >= 0)) return fanOf(points.length);
  const flat = points.map((p) => new Vector2(dot(p, right), dot(p, up)));
  // In ascending order they are wound like the polygon.
  const cut = ShapeUtils.triangulateShape(flat, []).map((t) => t.sort((a, b) => a - b));
  // Corners in the same place are left out there: then anything is as good.
  return cut.length === points.length - 2 ? cut : fanOf(points.length);
}

function trianglesOf(mesh: Mesh, walk: FaceWalk): number[][] {
  const { halfedges } = walk;
  const plane = halfedges.length > 3 ? planeOf(mesh, walk) : null;
  if (!plane) return fanOf(halfedges.length);
  return cutPolygon(halfedges.map((h) => mesh.position(mesh.vertex(h))), plane.normal);
}

/** The faces that close, cut into triangles. */
export function surfaceOf(mesh: Mesh): Surface {
  const closed = mesh.faces().filter((walk) => walk.closed);
  const count = closed.reduce((sum, walk) => sum + walk.halfedges.length - 2, 0);
  const corners = new Uint32Array(3 * count);
  const faces = new Uint32Array(count);
  const sides = new Int32Array(3 * count);
  let t = 0;
  for (const walk of closed) {
    const { face, halfedges: h } = walk;
    for (const triangle of trianglesOf(mesh, walk)) {
      faces[t] = face.index;
      triangle.forEach((k, corner) => {
        corners[3 * t + corner] = mesh.vertex(h[k]!);
        const follows = triangle[(corner + 1) % 3] === (k + 1) % h.length;
        sides[3 * t + corner] = follows ? h[k]! : -1;
      });
      ++t;
    }
  }
  const positions = new Float32Array(3 * mesh.vertexCount);
  for (let v = 0; v < mesh.vertexCount; ++v) {
    for (let axis = 0; axis < 3; ++axis) positions[3 * v + axis] = mesh.coordinate(v, axis);
  }
  return { positions, corners, faces, sides };
}

/** The median length of the sides of some triangles, spread over the surface. */
export function usualEdge({ positions, corners, faces }: Surface): number {
  const lengths: number[] = [];
  const every = Math.max(1, Math.floor(faces.length / 200));
  const corner = (k: number): Vec => [...positions.subarray(3 * corners[k]!, 3 * corners[k]! + 3)] as Vec;
  for (let t = 0; t < faces.length; t += every) {
    for (let k = 0; k < 3; ++k) lengths.push(length(sub(corner(3 * t + k), corner(3 * t + ((k + 1) % 3)))));
  }
  return lengths.sort((a, b) => a - b)[lengths.length >> 1] ?? 0;
}

/**
 * The two ends of every line between vertices that some half-edge runs along, as numbers of
 * vertices, once.
 */
export function linesOf(mesh: Mesh): Uint32Array {
  const seen = new Set<number>();
  const ends: number[] = [];
  for (let h = 0; h < mesh.halfedgeCount; ++h) {
    if (!mesh.isLive({ kind: 'h', index: h })) continue;
    const [a, b] = [mesh.vertex(h), mesh.end(h)];
    if (a < 0 || b < 0 || a === b) continue;
    // A whole pair of twins, as nearly all are: the first of them is drawn.
    const twin = mesh.twin(h);
    if (twin >= 0 && mesh.twin(twin) === h && mesh.vertex(twin) === b && mesh.end(twin) === a) {
      if (h < twin) ends.push(a, b);
      continue;
    }
    const key = Math.min(a, b) * mesh.vertexCount + Math.max(a, b);
    if (seen.has(key)) continue;
    seen.add(key);
    ends.push(a, b);
  }
  return Uint32Array.from(ends);
}

/** The middle and the normal of a face, from the corners that its walk came by. */
export interface Plane {
  centre: Vec;
  normal: Vec;
}

export function planeOf(mesh: Mesh, walk: FaceWalk): Plane | null {
  const points = walk.halfedges.map((h) => mesh.position(mesh.vertex(h)));
  const last = walk.halfedges.at(-1);
  if (!walk.closed && points.length < 3 && last !== undefined && mesh.end(last) >= 0) {
    points.push(mesh.position(mesh.end(last)));
  }
  if (points.length < 3) return null;
  const centre = scale(points.reduce(add, [0, 0, 0]), 1 / points.length);
  let normal: Vec = [0, 0, 0];
  points.forEach((p, i) => {
    const q = points[(i + 1) % points.length]!;
    normal = add(normal, cross(sub(p, centre), sub(q, centre)));
  });
  return { centre, normal: unit(normal) };
}

export interface Arrow {
  halfedge: number;
  from: Vec;
  to: Vec;
  /** Into the face, in its plane. */
  inward: Vec;
  normal: Vec;
  width: number;
}

/** Where half-edges are drawn: beside their edge, inside their face. */
export class ArrowMaker {
  private readonly planes = new Map<number, Plane | null>();
  private own: Map<number, number[]> | null = null;

  constructor(private readonly mesh: Mesh) {}

  private findPlane(face: Element): Plane | null {
    if (!this.mesh.isLive(face)) return null;
    const walk = this.mesh.walk(face);
    if (walk.closed) return planeOf(this.mesh, walk);
    this.own ??= this.halfedgesByFace();
    const around = { ...walk, halfedges: this.own.get(face.index) ?? [] };
    return planeOf(this.mesh, around) ?? planeOf(this.mesh, walk);
  }

  /** The half-edges that say they lie in a face that does not close. */
  private halfedgesByFace(): Map<number, number[]> {
    const { mesh } = this;
    const own = new Map<number, number[]>();
    for (const walk of mesh.faces()) if (!walk.closed) own.set(walk.face.index, []);
    if (own.size === 0) return own;
    for (let h = 0; h < mesh.halfedgeCount; ++h) {
      const face = mesh.isLive({ kind: 'h', index: h }) ? mesh.face(h) : null;
      if (face?.kind === 'f' && mesh.vertex(h) >= 0) own.get(face.index)?.push(h);
    }
    return own;
  }

  plane(face: Element | null): Plane | null {
    if (face?.kind !== 'f') return null;
    let plane = this.planes.get(face.index);
    if (plane === undefined) {
      plane = this.findPlane(face);
      this.planes.set(face.index, plane);
    }
    return plane;
  }

  /** The arrow of a half-edge; null if it has no two ends. */
  make(h: number): Arrow | null {
    const { mesh } = this;
    const [v, w] = [mesh.vertex(h), mesh.end(h)];
    if (!mesh.isLive({ kind: 'h', index: h }) || v < 0 || w < 0 || v === w) return null;
    const [a, b] = [mesh.position(v), mesh.position(w)];
    const along = sub(b, a);
    const size = length(along);
    if (size === 0) return null;
    const direction = scale(along, 1 / size);
    const side = this.side(h, mix(a, b, 0.5), direction);
    const gap = Math.min(0.1 * size, 0.22 * side.room);
    const shift = scale(side.inward, gap);
    const trim = Math.min(0.17, (1.9 * gap) / size);
    return {
      halfedge: h,
      from: add(mix(a, b, trim), shift),
      to: add(mix(b, a, trim), shift),
      inward: side.inward,
      normal: side.normal,
      width: Math.min(0.022 * size, 0.25 * gap),
    };
  }

  private side(h: number, middle: Vec, direction: Vec) {
    const own = this.plane(this.mesh.face(h));
    const twin = this.mesh.twin(h);
    const other = own ? null : this.plane(twin < 0 ? null : this.mesh.face(twin));
    const plane = own ?? other;
    const towards: Vec = plane ? sub(plane.centre, middle) : [0.31, 0.77, 0.55];
    const flat = sub(towards, scale(direction, dot(towards, direction)));
    const inward = scale(unit(flat), own || !other ? 1 : -1);
    return { inward, normal: plane?.normal ?? cross(direction, inward), room: length(flat) };
  }
}

/** Six triangles: a shaft and a head on its outer side, as half-edges are drawn in books. */
export function arrowTriangles(arrow: Arrow, grow = 1): Vec[] {
  const { from, to, inward } = arrow;
  const w = arrow.width * grow;
  const direction = unit(sub(to, from));
  const head = Math.min(5 * w, 0.35 * length(sub(to, from)));
  const neck = sub(to, scale(direction, head));
  const left = scale(inward, w / 2);
  const wide = scale(inward, 2 * w);
  return [
    sub(from, left), sub(neck, left), add(neck, left),
    sub(from, left), add(neck, left), add(from, left),
    sub(neck, left), to, add(neck, wide),
  ];
}

/** The middle of an element, and the direction that it faces; null if it has no place. */
export function placeOf(mesh: Mesh, maker: ArrowMaker, element: Element): Plane | null {
  if (element.kind === 'v') {
    return { centre: mesh.position(element.index), normal: [0, 0, 0] };
  }
  if (element.kind === 'f') return maker.plane(element);
  const h = mesh.halfedge(element);
  if (h < 0) return null;
  if (element.kind === 'h' || element.kind === 'b') {
    const arrow = maker.make(h);
    return arrow && { centre: mix(arrow.from, arrow.to, 0.5), normal: arrow.normal };
  }
  const [a, b] = [mesh.vertex(h), mesh.end(h)];
  if (a < 0 || b < 0) return null;
  return { centre: mix(mesh.position(a), mesh.position(b), 0.5), normal: [0, 0, 0] };
}

/** The planes of the closed faces around each vertex. */
export function planesAround(mesh: Mesh, maker: ArrowMaker): Map<number, Plane[]> {
  const around = new Map<number, Plane[]>();
  for (const walk of mesh.faces()) {
    const plane = walk.closed ? maker.plane(walk.face) : null;
    if (!plane) continue;
    for (const h of walk.halfedges) {
      const v = mesh.vertex(h);
      around.set(v, [...(around.get(v) ?? []), plane]);
    }
  }
  return around;
}

/** The planes of the two faces beside an edge, as far as there are any. */
export function planesBeside(mesh: Mesh, maker: ArrowMaker, edge: Element): Plane[] {
  const h = mesh.halfedge(edge);
  if (h < 0) return [];
  return [h, mesh.twin(h)].flatMap((side) => (side < 0 ? [] : (maker.plane(mesh.face(side)) ?? [])));
}

/** The box around all live vertices, as its middle and half its diagonal. */
export function ballOf(mesh: Mesh): { centre: Vec; radius: number } {
  const low: Vec = [Infinity, Infinity, Infinity];
  const high: Vec = [-Infinity, -Infinity, -Infinity];
  for (let v = 0; v < mesh.vertexCount; ++v) {
    if (!mesh.isLive({ kind: 'v', index: v })) continue;
    mesh.position(v).forEach((x, axis) => {
      low[axis] = Math.min(low[axis]!, x);
      high[axis] = Math.max(high[axis]!, x);
    });
  }
  if (!(low[0] <= high[0])) return { centre: [0, 0, 0], radius: 1 };
  return { centre: mix(low, high, 0.5), radius: length(sub(high, low)) / 2 || 1 };
}
