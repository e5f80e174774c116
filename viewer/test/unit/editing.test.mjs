// Undo, control points that several patches share, and meshes that come as bytes.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from './load.mjs';

const { History } = await load('model/history.ts');
const { controlPoints, movePoint } = await load('model/nets.ts');
const { unpackLive } = await load('live/unpack.ts');
const { Mesh } = await load('model/mesh.ts');

test('Undo and redo give back every state, whatever happens to the one that was kept', () => {
  const history = new History();
  let now = [[0]];
  for (let i = 1; i <= 4; ++i) {
    history.keep(now);
    now[0][0] = i;
  }
  for (let i = 3; i >= 0; --i) assert.deepEqual((now = history.undo(now)), [[i]]);
  assert.equal(history.undo(now), null);
  for (let i = 1; i <= 4; ++i) assert.deepEqual((now = history.redo(now)), [[i]]);
  assert.equal(history.redo(now), null);
});

test('A change after an undo ends what could be done again', () => {
  const history = new History();
  history.keep(1);
  assert.equal(history.undo(2), 1);
  history.keep(1);
  assert.equal(history.redo(3), null);
  assert.equal(history.undo(3), 1);
});

test('A point that two patches share moves in both', () => {
  const left = [[[0, 0, 0], [1, 0, 0]], [[0, 1, 0], [1, 1, 0]]];
  const right = [[[1, 0, 0], [2, 0, 0]], [[1, 1, 0], [2, 1, 0]]];
  const nets = [left, right];
  const points = controlPoints(nets);
  assert.equal(points.length, 6);
  const shared = points.find((p) => p.of.length === 2);
  assert.deepEqual(movePoint(nets, shared, [5, 6, 7]).sort(), [0, 1]);
  for (const { patch, row, col } of shared.of) assert.deepEqual(nets[patch][row][col], [5, 6, 7]);
  assert.equal(nets.flat(2).filter((p) => p[0] === 5).length, 2);
});

/** One triangle as the server packs it. */
function packed() {
  const p = [0, 0, 0, 1, 0, 0, 0, NaN, 0.1];
  const lists = [
    [1, 3, 0, 0, 0, 1, 2, 4, 1, 1, 0, 1, 0, 5, 2, 2, 0, 1,
      5, 0, 1, 0, 0x40000000, 1, 3, 1, 2, 1, 0x40000000, 1, 4, 2, 0, 2, 0x40000000, 1],
    [0, 1, 1, 1, 2, 1], [0, 1, 1, 1, 2, 1], [0, 1, 0], [3, 1, 1],
  ];
  const sizes = { at: 0, h: 6, v: 3, e: 3, f: 1, b: 1 };
  let text = JSON.stringify({ state: { mesh: sizes, before: sizes }, mesh: 'triangle' });
  text = text.padEnd(Math.ceil(text.length / 8) * 8);
  const numbers = Uint32Array.from(lists.flat());
  const bytes = new Uint8Array(8 + text.length + 8 * p.length + 4 * numbers.length);
  bytes.set(new TextEncoder().encode('MGM1'));
  new DataView(bytes.buffer).setUint32(4, text.length, true);
  bytes.set(new TextEncoder().encode(text), 8);
  bytes.set(new Uint8Array(Float64Array.from(p).buffer), 8 + text.length);
  bytes.set(new Uint8Array(numbers.buffer), 8 + text.length + 8 * p.length);
  return bytes.buffer;
}

test('A mesh from bytes is a mesh like any other, and what is no number is 0', () => {
  const live = unpackLive(packed());
  assert.equal(live.mesh, 'triangle');
  for (const data of [live.state.mesh, live.state.before]) {
    const mesh = new Mesh(data);
    assert.equal(mesh.counts(), '3 vertices, 3 edges, 1 faces');
    assert.deepEqual(mesh.faces()[0].halfedges, [0, 1, 2]);
    assert.deepEqual(mesh.position(2), [0, 0, 0.1]);
    assert.deepEqual(mesh.face(4), { kind: 'b', index: 0 });
  }
});

test('Bytes of another form are refused in words', () => {
  const other = packed();
  new Uint8Array(other)[3] = 0x32;
  assert.throws(() => unpackLive(other), /load the page again/);
});
