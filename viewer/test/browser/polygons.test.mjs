// The live viewer on meshes of polygons: every function by its key, on faces, vertices and edges.
import assert from 'node:assert/strict';
import { cpSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { Viewer, accessibilityProblems, scratch, snap, source } from './harness.mjs';

/** The reference of the second assignment, with one text in a file exchanged. */
function polygonHomework(name, file, was, becomes) {
  const folder = join(scratch, name);
  cpSync(join(source, 'reference/polygon_meshes'), folder, { recursive: true });
  if (file) {
    const text = readFileSync(join(folder, file), 'utf8');
    assert.ok(text.includes(was), was);
    writeFileSync(join(folder, file), text.replace(was, becomes));
  }
  return folder;
}

test('Faces, vertices and edges of polygons are edited by keys, and two edges are welded', async () => {
  const viewer = await Viewer.start(polygonHomework('polygons'), 'quad_grid_3x3.obj');
  const { page } = viewer;
  let steps = 1;
  for (const [element, key, label] of [['v5', 'b', 'bevel v5'], ['f0', 'Shift+I', 'inset f0'],
    ['e3', 'c', 'collapse e3'], ['f8', 'r', 'remove f8']]) {
    await viewer.select(element);
    await page.keyboard.press(key);
    await viewer.steps(++steps);
    await page.locator('.timeline').getByText(label).first().waitFor();
  }
  assert.equal(await page.locator('.timeline .sign.good').count(), 4);
  await viewer.select('e0');
  await page.keyboard.press('Shift+W');
  await page.getByText('Weld e0 with which edge?').waitFor();
  await page.keyboard.press('Shift+W');
  await viewer.steps(++steps);
  await page.getByText(/^refused, as it must be/).waitFor();
  await viewer.select('f4');
  await page.keyboard.press('Shift+D');
  await page.getByText('Select an edge or a vertex to dissolve.').waitFor();
  await page.keyboard.press('Shift+C');
  await viewer.steps(++steps);
  await page.keyboard.press('d');
  await page.getByText(/Catmull and Clark's rules/).waitFor();
  assert.equal(await page.locator('[data-option=smooth]').isVisible(), false);
  assert.deepEqual(await accessibilityProblems(page), []);
  await viewer.stop();
});

test('An inset that forgets one pointer: the open ring, the broken rules and the faces are named', async () => {
  const folder = polygonHomework('one forgotten', 'vertex_inset.cpp', 'sides[i]->next() = inward[i];',
    'if (i + 1 < n) sides[i]->next() = inward[i];');
  const viewer = await Viewer.start(folder, 'prism_5.obj');
  const { page } = viewer;
  await viewer.select('f0');
  await page.keyboard.press('Shift+I');
  await viewer.steps(2);
  assert.equal(await page.locator('.timeline .sign.good').count(), 0);
  assert.match(await viewer.counts(), /Open faces: f\d/);
  await page.getByText('next-permutation').first().waitFor();
  await page.keyboard.press('Escape');
  await page.keyboard.press('Space');
  await snap(page, 'viewer_polygons_broken');
  assert.deepEqual(await accessibilityProblems(page), []);
  cpSync(join(source, 'reference/polygon_meshes/vertex_inset.cpp'), join(folder, 'vertex_inset.cpp'));
  await page.waitForFunction(() => document.querySelectorAll('.timeline .sign.good').length === 1, null,
    { timeout: 60000 });
  await viewer.stop();
});
