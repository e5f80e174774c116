// The page's own logic: walking a mesh whatever its pointers are, and files.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from './load.mjs';

const { Mesh, parseElement, parsePointer } = await load('model/mesh.ts');
const { toObj, toGlb } = await load('model/export.ts');

const UNSET = 0xffffffff;
const BOUNDARY = 0x40000000;

/** One triangle v0 v1 v2 with the boundary loop around it. */
function triangle() {
  const half = (next, twin, vertex, edge, face) => [next, twin, vertex, edge, face, 1];
  return {
    h: [
      ...half(1, 3, 0, 0, 0), ...half(2, 4, 1, 1, 0), ...half(0, 5, 2, 2, 0),
      ...half(5, 0, 1, 0, BOUNDARY), ...half(3, 1, 2, 1, BOUNDARY), ...half(4, 2, 0, 2, BOUNDARY),
    ],
    v: [0, 1, 1, 1, 2, 1],
    p: [0, 0, 0, 1, 0, 0, 0, 1, 0],
    e: [0, 1, 1, 1, 2, 1],
    f: [0, 1, 0],
    b: [3, 1, 1],
  };
}

test('A face closes when its walk comes back', () => {
  const [walk] = new Mesh(triangle()).faces();
  assert.deepEqual(walk.halfedges, [0, 1, 2]);
  assert.equal(walk.closed, true);
});

test('Whatever one pointer is, the mesh is read to its end and the face is open or closed', () => {
  const bad = [UNSET, 0xfffffffe, 0xfffffffd, 0x80000001, 0x40000007, 77, 0, 1, 2, 3, 4, 5];
  for (let place = 0; place < 36; ++place) {
    if (place % 6 === 5) continue;
    for (const ref of bad) {
      const data = triangle();
      data.h[place] = ref;
      const mesh = new Mesh(data);
      for (const kind of ['h', 'v', 'e', 'f', 'b']) {
        for (let index = 0; index < mesh.size(kind); ++index) {
          for (const pointer of mesh.pointers({ kind, index })) {
            assert.notEqual(pointer.text, '');
            assert.ok(pointer.target === null || mesh.isLive(pointer.target));
          }
        }
      }
      for (let h = 0; h < 6; ++h) assert.ok(mesh.end(h) < 3);
      if (place === 6 && ref !== 2) assert.equal(mesh.faces()[0].closed, false);
    }
  }
});

test('Special pointers are told in words', () => {
  const data = triangle();
  data.h[0] = UNSET;
  data.h[1] = 0x80000002;
  const pointers = new Mesh(data).pointers({ kind: 'h', index: 0 });
  assert.deepEqual(pointers.map((p) => p.text), ['unset', 'h2 (deleted)', 'v0', 'e0', 'f0']);
  assert.deepEqual(pointers.map((p) => p.target !== null), [false, false, true, true, true]);
});

test('Names of elements and pointers are read, other text is not', () => {
  assert.deepEqual(parseElement('h12 (ca)'), { kind: 'h', index: 12 });
  assert.deepEqual(parsePointer('v3.halfedge'), { element: { kind: 'v', index: 3 }, pointer: 'halfedge' });
  for (const text of ['', 'unset', 'the mesh', 'x3', 'h', 'h12x']) assert.equal(parseElement(text), null);
});

test('OBJ has the vertices and faces, counted from 1', () => {
  assert.equal(toObj(new Mesh(triangle())), 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n');
});

test('GLB is a whole file with the bounds of the mesh', () => {
  const bytes = toGlb(new Mesh(triangle()));
  const view = new DataView(bytes.buffer);
  assert.equal(view.getUint32(0, true), 0x46546c67);
  assert.equal(view.getUint32(8, true), bytes.length);
  const size = view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + size)));
  assert.deepEqual(json.accessors[0].max, [1, 1, 0]);
  assert.equal(json.buffers[0].byteLength, bytes.length - 28 - size);
  const indices = new Uint32Array(bytes.slice(28 + size + 36).buffer);
  assert.deepEqual([...indices], [0, 1, 2]);
});
