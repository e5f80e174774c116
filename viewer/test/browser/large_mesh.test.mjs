// Meshes of more than 20,000 triangles reach the page as bytes, and stay usable.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { Viewer, homework, savedFile, scratch } from './harness.mjs';
import { torusObj } from './made_meshes.mjs';

function torusFile(side) {
  const file = join(scratch, `torus_${side}.obj`);
  writeFileSync(file, torusObj(side, side));
  return file;
}

/** What the page saves as OBJ: its own idea of the mesh. */
const savedObj = (page) => savedFile(page, 'Save OBJ');

/** The types of the answers that hold a mesh, as they come. */
function watchTypes(page) {
  const types = [];
  page.on('response', (response) => {
    if (/\/(state|step|go|open)(\?|$)/.test(response.url())) types.push(response.headers()['content-type']);
  });
  return types;
}

const numbers = (obj) => obj.match(/-?[\d.]+(e-?\d+)?/g).map(Number);

for (const [side, type] of [[90, 'application/json'], [120, 'application/octet-stream']]) {
  test(`${2 * side * side} triangles come as ${type} and are the mesh of the file`, async () => {
    const viewer = await Viewer.start(homework(`large ${side}`), torusFile(side));
    const { page } = viewer;
    const types = watchTypes(page);
    await page.reload();
    await viewer.steps(1);
    assert.deepEqual([...new Set(types)], [type]);
    assert.match(await viewer.counts(),
      new RegExp(`${side * side} vertices, ${3 * side * side} edges, ${2 * side * side} faces`));
    const saved = await savedObj(page);
    const given = torusObj(side, side);
    const positions = (obj) => obj.split('\n').filter((line) => line.startsWith('v ')).flatMap(numbers);
    const faces = (obj) => obj.split('\n').filter((line) => line.startsWith('f ')).length;
    // The file's vertices are numbered as its faces name them: compare the sets.
    const sorted = (obj) => Float64Array.from(positions(obj)).sort();
    assert.deepEqual(sorted(saved), sorted(given));
    assert.equal(faces(saved), faces(given));
    await viewer.stop();
  });
}

/** The last step has passed; else the test says what the page does. */
async function expectPassed(page) {
  const stop = page.locator('.stop');
  assert.equal(await stop.count() && await stop.first().textContent(), 0);
  await page.locator('.timeline .sign.good').waitFor();
}

test('A large mesh is flipped, undone, and a small one opened after it', async () => {
  const viewer = await Viewer.start(homework('large steps'), torusFile(120));
  const { page } = viewer;
  const before = await savedObj(page);
  await viewer.select('e5000');
  await page.keyboard.press('f');
  await viewer.steps(2);
  await expectPassed(page);
  assert.notEqual(await savedObj(page), before);
  await page.keyboard.press('z');
  await page.waitForFunction(() => document.querySelector('[aria-current]').textContent === 'start');
  assert.equal(await savedObj(page), before);
  const types = watchTypes(page);
  await page.setInputFiles('input[type=file]', { name: 'mine.obj', mimeType: 'text/plain',
    buffer: Buffer.from('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2\n') });
  await page.getByText('About mine.obj').waitFor();
  await page.getByText('left out 1 face with fewer than 3 corners, at line 5').waitFor();
  assert.match(await viewer.counts(), /3 vertices, 3 edges, 1 faces/);
  assert.deepEqual(types, ['application/json']);
  await viewer.stop();
});

test('A subdivision that makes a mesh large is shown and passes', async () => {
  const viewer = await Viewer.start(homework('large subdivision'), torusFile(60));
  const { page } = viewer;
  await page.keyboard.press('u');
  await viewer.steps(2, 120000);
  await expectPassed(page);
  assert.match(await viewer.counts(), /14400 vertices, 43200 edges, 28800 faces/);
  await viewer.stop();
});

test('A click on a large mesh selects what is under the pointer', async () => {
  const viewer = await Viewer.start(homework('large pick'), torusFile(120));
  const { page } = viewer;
  const box = await page.locator('.stage canvas').first().boundingBox();
  await page.mouse.click(box.x + 0.4 * box.width, box.y + 0.62 * box.height);
  await page.getByText(/(Vertex|Edge|Half-edge|Face) [vehf]\d+ selected/).waitFor();
  await page.mouse.click(box.x + 2, box.y + 2);
  await page.waitForFunction(() => document.querySelector('.status').textContent === '');
  await viewer.stop();
});
