// Reads what the server answers with a large mesh: JSON, and the arrays of its meshes as bytes.
// grader/view/page_answer.h explains the form.

import type { MeshJson } from '../model/mesh';
import type { LiveState } from './answers';

/** What stands for a mesh in the JSON. */
interface PackedMesh {
  at: number;
  h: number;
  v: number;
  e: number;
  f: number;
  b: number;
}

const MARK = 0x314d474d; // "MGM1"

function meshAt(buffer: ArrayBuffer, first: number, packed: PackedMesh): MeshJson {
  let at = first + packed.at;
  const p = new Float64Array(buffer, at, 3 * packed.v);
  at += p.byteLength;
  const list = (length: number): Uint32Array => {
    const numbers = new Uint32Array(buffer, at, length);
    at += numbers.byteLength;
    return numbers;
  };
  return {
    p, h: list(6 * packed.h), v: list(2 * packed.v), e: list(2 * packed.e),
    f: list(3 * packed.f), b: list(3 * packed.b),
  };
}

/** @throws Error if these are no such bytes */
export function unpackLive(buffer: ArrayBuffer): LiveState {
  const [mark, size] = new Uint32Array(buffer, 0, 2);
  if (mark !== MARK) throw new Error('meshgrade view answers in another form: load the page again');
  const first = 8 + size!;
  const live = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 8, size))) as LiveState;
  const unpack = (holder: object | undefined, name: string): void => {
    const meshes = holder as Record<string, unknown> | undefined;
    if (meshes?.[name]) meshes[name] = meshAt(buffer, first, meshes[name] as PackedMesh);
  };
  for (const name of ['mesh', 'before', 'expected']) unpack(live.state, name);
  unpack(live.stopped, 'mesh');
  return live;
}
