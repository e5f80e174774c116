// A half-edge mesh as the grader wrote it down. Pointers are numbers; a broken one is as good a
// number as any. Nothing here says whether a mesh is right: the grader does.

/** Flat lists, as the grader's JSON has them. */
export interface MeshJson {
  h: ArrayLike<number>;
  v: ArrayLike<number>;
  p: ArrayLike<number | null>;
  e: ArrayLike<number>;
  f: ArrayLike<number>;
  b: ArrayLike<number>;
}

export type Kind = 'h' | 'v' | 'e' | 'f' | 'b';
export interface Element {
  kind: Kind;
  index: number;
}

const UNSET = 0xffffffff;
const PAST_END = 0xfffffffe;
const FOREIGN = 0xfffffffd;
const DELETED = 0x80000000;
const BOUNDARY = 0x40000000;

const KIND_NAMES: Record<Kind, string> = {
  h: 'Half-edge',
  v: 'Vertex',
  e: 'Edge',
  f: 'Face',
  b: 'Boundary loop',
};

export const kindName = (kind: Kind): string => KIND_NAMES[kind];
export const nameOf = (element: Element): string => element.kind + element.index;
export const sameElement = (a: Element | null, b: Element | null): boolean =>
  a?.kind === b?.kind && a?.index === b?.index;

/** The element that a name begins with: "h12", "h12 (ca)", "h12.next". */
export function parseElement(text: string): Element | null {
  const match = /^\s*([hvefb])(\d+)\b/.exec(text);
  return match ? { kind: match[1] as Kind, index: Number(match[2]) } : null;
}

/** "h12.next" as its element and the name of its pointer. */
export function parsePointer(text: string): { element: Element; pointer: string } | null {
  const match = /^\s*([hvefb])(\d+)\.(next|twin|vertex|edge|face|halfedge)\b/.exec(text);
  if (!match) return null;
  return { element: { kind: match[1] as Kind, index: Number(match[2]) }, pointer: match[3]! };
}

export interface Pointer {
  name: string;
  /** Where it leads: a name, or in words what it leads to instead. */
  text: string;
  /** The element it leads to, if that is there to be shown. */
  target: Element | null;
}

function faceElement(ref: number): Element {
  return ref & BOUNDARY ? { kind: 'b', index: ref & ~BOUNDARY } : { kind: 'f', index: ref };
}

function describe(ref: number, kind: Kind): string {
  if (ref === UNSET) return 'unset';
  if (ref === PAST_END) return 'past the end';
  if (ref === FOREIGN) return 'no element of this mesh';
  const plain = (ref & ~DELETED) >>> 0;
  const element = kind === 'f' ? faceElement(plain) : { kind, index: plain };
  return nameOf(element) + (ref >= DELETED ? ' (deleted)' : '');
}

/** The corners of a face in the order of `next`, or how far the walk came. */
export interface FaceWalk {
  face: Element;
  halfedges: number[];
  closed: boolean;
}

/** A walk that is longer than all half-edges of its face, and than this, does not close. */
const LONG_WALK = 64;

export class Mesh {
  readonly halfedgeCount: number;
  readonly vertexCount: number;
  readonly edgeCount: number;
  readonly faceCount: number;
  readonly boundaryCount: number;
  /** Made when they are asked for: not every mesh that comes is looked at. */
  private walks: FaceWalk[] | null = null;
  private own: Uint32Array | null = null;

  constructor(private readonly data: MeshJson) {
    this.halfedgeCount = data.h.length / 6;
    this.vertexCount = data.v.length / 2;
    this.edgeCount = data.e.length / 2;
    this.faceCount = data.f.length / 3;
    this.boundaryCount = data.b.length / 3;
  }

  size(kind: Kind): number {
    switch (kind) {
      case 'h': return this.halfedgeCount;
      case 'v': return this.vertexCount;
      case 'e': return this.edgeCount;
      case 'f': return this.faceCount;
      case 'b': return this.boundaryCount;
    }
  }

  isLive({ kind, index }: Element): boolean {
    return this.lives(kind, index);
  }

  private lives(kind: Kind, index: number): boolean {
    if (index >= this.size(kind)) return false;
    const place = kind === 'h' ? 6 * index + 5 : kind === 'v' || kind === 'e' ? 2 * index + 1 : 3 * index + 1;
    return this.data[kind][place] !== 0;
  }

  countLive(kind: Kind): number {
    let count = 0;
    for (let index = 0; index < this.size(kind); ++index) {
      if (this.lives(kind, index)) ++count;
    }
    return count;
  }

  /** A pointer of a half-edge as the number of what it leads to; -1 if that is not there. */
  private follow(h: number, place: number, kind: Kind): number {
    const ref = this.data.h[6 * h + place]!;
    return ref < DELETED && this.lives(kind, ref) ? ref : -1;
  }
  next(h: number): number {
    return this.follow(h, 0, 'h');
  }
  twin(h: number): number {
    return this.follow(h, 1, 'h');
  }
  vertex(h: number): number {
    return this.follow(h, 2, 'v');
  }
  edge(h: number): number {
    return this.follow(h, 3, 'e');
  }
  /** The face or boundary loop of a half-edge. */
  face(h: number): Element | null {
    const ref = this.data.h[6 * h + 4]!;
    if (ref >= DELETED) return null;
    const element = faceElement(ref);
    return this.isLive(element) ? element : null;
  }
  /** The half-edge of any other element; -1 if it is not there. */
  halfedge(element: Element): number {
    if (element.kind === 'h') return element.index;
    if (!this.isLive(element)) return -1;
    const stride = element.kind === 'v' || element.kind === 'e' ? 2 : 3;
    const ref = this.data[element.kind][stride * element.index]!;
    return ref < DELETED && this.lives('h', ref) ? ref : -1;
  }

  /** The vertex where a half-edge ends: that of its next, or of its twin if next is broken. */
  end(h: number): number {
    const next = this.next(h);
    const byNext = next < 0 ? -1 : this.vertex(next);
    const twin = this.twin(h);
    const byTwin = twin < 0 ? -1 : this.vertex(twin);
    const start = this.vertex(h);
    return byTwin >= 0 && byTwin !== start ? byTwin : byNext;
  }

  /** x, y, z of a vertex; 0 for what is no finite number. */
  position(v: number): [number, number, number] {
    return [this.coordinate(v, 0), this.coordinate(v, 1), this.coordinate(v, 2)];
  }
  coordinate(v: number, axis: number): number {
    const x = this.data.p[3 * v + axis];
    return Number.isFinite(x) ? x! : 0;
  }

  pointers(element: Element): Pointer[] {
    const { kind, index } = element;
    const make = (name: string, ref: number, to: Kind): Pointer => {
      const target = to === 'f' ? faceElement(ref) : { kind: to, index: ref };
      const there = ref < DELETED && this.isLive(target);
      return { name, text: describe(ref, to), target: there ? target : null };
    };
    if (index >= this.size(kind)) return [];
    if (kind !== 'h') {
      const stride = kind === 'v' || kind === 'e' ? 2 : 3;
      return [make('halfedge', this.data[kind][stride * index]!, 'h')];
    }
    const at = (place: number): number => this.data.h[6 * index + place]!;
    return [
      make('next', at(0), 'h'),
      make('twin', at(1), 'h'),
      make('vertex', at(2), 'v'),
      make('edge', at(3), 'e'),
      make('face', at(4), 'f'),
    ];
  }

  /** The walks around all live faces. */
  faces(): FaceWalk[] {
    return (this.walks ??= this.walkFaces());
  }

  private walkFaces(): FaceWalk[] {
    const walks: FaceWalk[] = [];
    for (let index = 0; index < this.faceCount; ++index) {
      const face: Element = { kind: 'f', index };
      if (this.isLive(face)) walks.push(this.walk(face));
    }
    return walks;
  }

  /** Follows next from the half-edge of a face until it comes back or cannot go on. */
  walk(face: Element): FaceWalk {
    const start = this.halfedge(face);
    const halfedges: number[] = [];
    const seen = new Set<number>();
    const mayGoOn = (n: number): boolean => n < LONG_WALK || n < this.ownHalfedges(face);
    let h = start;
    while (h >= 0 && mayGoOn(seen.size) && this.vertex(h) >= 0 && !seen.has(h)) {
      halfedges.push(h);
      seen.add(h);
      h = this.next(h);
    }
    return { face, halfedges, closed: start >= 0 && h === start && halfedges.length >= 3 };
  }

  /** How many half-edges say that they lie in a face. */
  private ownHalfedges({ kind, index }: Element): number {
    if (kind !== 'f') return this.halfedgeCount;
    if (!this.own) {
      this.own = new Uint32Array(this.faceCount);
      for (let h = 0; h < this.halfedgeCount; ++h) {
        const face = this.face(h);
        if (face?.kind === 'f') ++this.own[face.index]!;
      }
    }
    return this.own[index] ?? 0;
  }

  counts(): string {
    const count = (kind: Kind): number => this.countLive(kind);
    const [v, e, f] = [count('v'), count('e'), count('f')];
    return `${v} vertices, ${e} edges, ${f} faces`;
  }
}
