// Faces with any number of corners: walking, cutting and naming what is to be done with them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from './load.mjs';

const { Mesh } = await load('model/mesh.ts');
const { meshOfPolygons } = await load('model/polygons.ts');
const { surfaceOf } = await load('scene/shapes.ts');
const { keyName, meaning, picksText, wordOfKey, wordsOf } = await load('model/verbs.ts');

/** One polygon around these points of a plane. */
const polygon = (points) => new Mesh(meshOfPolygons(points.map(([x, y]) => [x, y, 0]), [points.map((_, i) => i)]));

const circle = (n) => Array.from({ length: n }, (_, i) =>
  [Math.cos((2 * Math.PI * i) / n), Math.sin((2 * Math.PI * i) / n)]);

/** The signed areas of the triangles that a surface is cut into. */
function areas({ positions, corners, faces }) {
  const at = (k) => [positions[3 * corners[k]], positions[3 * corners[k] + 1]];
  return Array.from(faces, (_, t) => {
    const [[ax, ay], [bx, by], [cx, cy]] = [at(3 * t), at(3 * t + 1), at(3 * t + 2)];
    return ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2;
  });
}

test('A face closes however many corners it has', () => {
  for (const n of [3, 4, 64, 65, 300]) {
    const mesh = polygon(circle(n));
    const [walk] = mesh.faces();
    assert.equal(walk.closed, true, `${n} corners`);
    assert.equal(surfaceOf(mesh).faces.length, n - 2);
  }
});

test('A long ring that does not come back to its start is open, and the walk ends', () => {
  const data = meshOfPolygons(circle(200).map(([x, y]) => [x, y, 0]), [circle(200).map((_, i) => i)]);
  data.h[6 * 199] = 100;
  const [walk] = new Mesh(data).faces();
  assert.equal(walk.closed, false);
  assert.equal(walk.halfedges.length, 200);
});

test('A polygon that is bent in is covered once, by triangles wound like it', () => {
  const bent = [
    [[0, 0], [4, 0], [4, 4], [2, 1], [0, 4]],
    [[1, 0], [4, 0], [4, 4], [0, 4], [0, 3], [3, 3], [3, 1], [1, 1]],
    [[2, 1], [0, 4], [0, 0], [4, 0], [4, 4]],
  ];
  for (const points of bent) {
    const whole = points.reduce((sum, [x, y], i) => {
      const [nx, ny] = points[(i + 1) % points.length];
      return sum + (x * ny - nx * y) / 2;
    }, 0);
    const cut = areas(surfaceOf(polygon(points)));
    assert.ok(cut.every((area) => area >= 0), JSON.stringify(points));
    assert.ok(Math.abs(cut.reduce((a, b) => a + b) - whole) < 1e-9);
  }
});

test('Each side of a polygon belongs to one triangle, and lines inside are no half-edges', () => {
  for (const points of [circle(7), [[0, 0], [4, 0], [4, 4], [2, 1], [0, 4]]]) {
    const surface = surfaceOf(polygon(points));
    const sides = [...surface.sides].filter((h) => h >= 0).sort((a, b) => a - b);
    assert.deepEqual(sides, points.map((_, i) => i));
    surface.sides.forEach((h, place) => h < 0 || assert.equal(surface.corners[place], h));
  }
});

const verb = (word, keys, picks, picked = 1) => ({ word, keys, picks, picked, subdivides: false });
const verbs = [verb('collapse', 'c', 'edge'), verb('dissolve', 'D', 'edge'), verb('dissolve', 'D', 'vertex'),
  verb('collapse', 'c', 'face'), verb('weld', 'W', 'edge', 2), verb('subdivide', 'ul', '', 0)];

test('A word means the function for what is selected', () => {
  const words = wordsOf(verbs);
  assert.deepEqual(words.map((w) => w.word), ['collapse', 'dissolve', 'weld', 'subdivide']);
  const [collapse, dissolve, , subdivide] = words;
  assert.equal(meaning(collapse, { kind: 'f', index: 2 }, undefined).verb, verbs[3]);
  assert.equal(meaning(dissolve, { kind: 'v', index: 2 }, undefined).picked, 2);
  assert.equal(meaning(dissolve, { kind: 'f', index: 2 }, undefined).verb, null);
  assert.equal(meaning(dissolve, null, undefined).verb, null);
  assert.equal(meaning(subdivide, null, undefined).verb, verbs[5]);
  assert.equal(picksText(dissolve), 'an edge or a vertex');
});

test('An upper-case key is that with Shift, and no other', () => {
  const words = wordsOf(verbs);
  assert.equal(wordOfKey(words, 'D', true)?.word, 'dissolve');
  assert.equal(wordOfKey(words, 'd', false), undefined);
  assert.equal(wordOfKey(words, 'C', false)?.word, 'collapse');
  assert.equal(wordOfKey(words, 'l', false)?.word, 'subdivide');
  assert.equal(keyName('D'), 'Shift+D');
  assert.equal(keyName('c'), 'C');
});
