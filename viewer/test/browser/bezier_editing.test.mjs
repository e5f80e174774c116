// Curves and surfaces are edited by pointer and by keys, and every change can be undone.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Viewer, accessibilityProblems, homework, savedFile, snap } from './harness.mjs';

const labels = (page) => page.locator('.control').evaluateAll((all) => all.map((c) => c.ariaLabel));

async function drag(page, from, by) {
  await page.mouse.move(...from);
  await page.mouse.down();
  await page.mouse.move(from[0] + by[0], from[1] + by[1], { steps: 4 });
  await page.mouse.up();
}

test('Each change of a curve is undone and done again, by keys alone', async () => {
  const viewer = await Viewer.start(homework('curve undo'), 'arch_4.bzc');
  const { page } = viewer;
  await page.getByText('evaluateStep at t = 0.50').waitFor();
  const states = [await labels(page)];
  const keep = async () => states.push(await labels(page));
  await page.locator('.control').nth(1).focus();
  await page.keyboard.press('ArrowUp');
  await keep();
  await page.keyboard.press('a');
  await keep();
  await page.locator('.control').nth(3).focus();
  await page.keyboard.press('Delete');
  await keep();
  // In one go: the points are drawn anew with every answer.
  const centre = await page.evaluate(() => {
    const { left, top, width, height } = document.querySelector('.control').getBoundingClientRect();
    return [left + width / 2, top + height / 2];
  });
  await drag(page, centre, [60, -40]);
  await keep();
  assert.equal(new Set(states.map(String)).size, states.length);
  for (let i = states.length - 2; i >= 0; --i) {
    await page.keyboard.press('z');
    assert.deepEqual(await labels(page), states[i]);
  }
  await page.keyboard.press('z');
  await page.getByText('There is nothing to undo.').waitFor();
  for (let i = 1; i < states.length; ++i) {
    await page.keyboard.press(i % 2 ? 'y' : 'Shift+Z');
    assert.deepEqual(await labels(page), states[i]);
  }
  // The student's own levels follow.
  await page.locator('.told .tag.good').waitFor();
  assert.deepEqual(await accessibilityProblems(page), []);
  await viewer.stop();
});

test('A change after an undo forgets what was undone', async () => {
  const viewer = await Viewer.start(homework('curve forget'), 'arch_4.bzc');
  const { page } = viewer;
  await page.keyboard.press('a');
  await page.getByRole('button', { name: /Undo/ }).click();
  await page.locator('.control').nth(0).focus();
  await page.keyboard.press('ArrowLeft');
  const now = await labels(page);
  await page.getByRole('button', { name: /Redo/ }).click();
  await page.getByText('There is nothing to redo.').waitFor();
  assert.deepEqual(await labels(page), now);
  await viewer.stop();
});

const status = (page) => page.locator('.side > .status').textContent();

/** What would be saved: the control points as numbers. */
const savedNet = (page) => savedFile(page, 'Save .bez');

test('A control point of a net moves by keys, with undo and redo', async () => {
  const viewer = await Viewer.start(homework('net keys'), 'wavy.bez');
  const { page } = viewer;
  await page.getByText('passed').waitFor({ timeout: 60000 });
  const first = await savedNet(page);
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press('p');
  await page.getByText(/Control point 1 of 16 at/).waitFor();
  await page.keyboard.press('Shift+P');
  await page.getByText(/Control point 16 of 16 at/).waitFor();
  const places = [await status(page)];
  for (const key of ['ArrowUp', 'Shift+ArrowRight', 'PageUp']) {
    await page.keyboard.press(key);
    places.push(await status(page));
  }
  assert.equal(new Set(places).size, 4);
  const moved = await savedNet(page);
  assert.notEqual(moved, first);
  assert.deepEqual(await accessibilityProblems(page), []);
  for (let i = 0; i < 3; ++i) await page.keyboard.press('z');
  assert.equal(await savedNet(page), first);
  for (let i = 0; i < 3; ++i) await page.keyboard.press('y');
  assert.equal(await savedNet(page), moved);
  await page.keyboard.press('Escape');
  assert.equal(await status(page), '');
  await viewer.stop();
});

/** Pixels of one colour: handles have colours that nothing else has. */
async function spotOf(page, name) {
  return page.evaluate((color) => {
    const canvas = document.querySelector('.stage canvas');
    const probe = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
    [probe.canvas.width, probe.canvas.height] = [canvas.width, canvas.height];
    probe.fillStyle = getComputedStyle(canvas).getPropertyValue(`--view-${color}`);
    probe.fillRect(0, 0, 1, 1);
    const want = probe.getImageData(0, 0, 1, 1).data;
    probe.drawImage(canvas, 0, 0);
    const { data } = probe.getImageData(0, 0, canvas.width, canvas.height);
    let [x, y, n] = [0, 0, 0];
    for (let i = 0; i < data.length; i += 4) {
      if (Math.abs(data[i] - want[0]) + Math.abs(data[i + 1] - want[1]) + Math.abs(data[i + 2] - want[2]) > 6) continue;
      x += (i / 4) % canvas.width;
      y += Math.floor(i / 4 / canvas.width);
      ++n;
    }
    const box = canvas.getBoundingClientRect();
    return n && [box.left + (x / n) * (box.width / canvas.width), box.top + (y / n) * (box.height / canvas.height)];
  }, name);
}

test('A control point of a net is dragged, and the camera stays', async () => {
  const viewer = await Viewer.start(homework('net drag'), 'wavy.bez');
  const { page } = viewer;
  await page.getByText('passed').waitFor({ timeout: 60000 });
  const first = await savedNet(page);
  await page.evaluate(() => document.activeElement.blur());
  for (let i = 0; i < 6; ++i) await page.keyboard.press('p');
  await page.waitForTimeout(500);
  const from = await spotOf(page, 'wrong');
  assert.ok(from, 'the chosen control point is drawn');
  await drag(page, from, [70, -50]);
  await page.waitForTimeout(500);
  const to = await spotOf(page, 'wrong');
  // A drag in the plane of the screen: the point stays under the pointer.
  assert.ok(Math.hypot(to[0] - from[0] - 70, to[1] - from[1] + 50) < 4, `from ${from} to ${to}`);
  const moved = await savedNet(page);
  const lines = (text) => text.match(/\S+ \S+ \S+(?=  |\n|$)/g);
  const different = lines(moved).filter((line, i) => line !== lines(first)[i]);
  assert.equal(different.length, 1, 'one control point has moved');
  await page.getByRole('button', { name: /Undo/ }).click();
  assert.equal(await savedNet(page), first);
  await viewer.stop();
});

test('Control points where patches meet move together', async () => {
  const viewer = await Viewer.start(homework('teapot'), 'teapot.bez');
  const { page } = viewer;
  await page.getByText('passed').waitFor({ timeout: 120000 });
  await page.keyboard.press('p');
  const [, count] = /of (\d+) at/.exec(await status(page));
  assert.ok(Number(count) < 32 * 16, 'shared points are one');
  const numbers = (text) => text.split(/\s+/).map(Number);
  const first = numbers(await savedNet(page));
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press('ArrowUp');
  const moved = numbers(await savedNet(page));
  const changed = first.map((x, i) => [x, moved[i]]).filter(([a, b]) => a !== b);
  assert.ok(changed.length > 3, 'more than one control point has moved');
  await viewer.stop();
});

test('Curves on a surface follow sliders and pointer', async () => {
  const viewer = await Viewer.start(homework('iso'), 'wavy.bez');
  const { page } = viewer;
  await page.getByText('passed').waitFor({ timeout: 60000 });
  const asked = [];
  page.on('request', (request) => {
    if (request.url().endsWith('/isocurves')) asked.push(request.postDataJSON());
  });
  const answered = () => page.waitForResponse((response) => response.url().endsWith('/isocurves'));
  await Promise.all([answered(), page.keyboard.press('k')]);
  assert.deepEqual([asked.at(-1).u, asked.at(-1).v], [0.5, 0.5]);
  const u = page.getByRole('slider', { name: 'u' });
  await u.focus();
  await Promise.all([answered(), page.keyboard.press('ArrowRight')]);
  assert.deepEqual([asked.at(-1).u, asked.at(-1).v], [0.51, 0.5]);
  const box = await page.locator('.stage canvas').first().boundingBox();
  const [response] = await Promise.all([answered(),
    page.mouse.move(box.x + 0.42 * box.width, box.y + 0.55 * box.height)]);
  const { along_u: alongU, along_v: alongV } = await response.json();
  assert.equal(alongU.length, alongV.length);
  assert.notDeepEqual([asked.at(-1).u, asked.at(-1).v], [0.51, 0.5]);
  await page.waitForTimeout(500);
  await snap(page, 'viewer_isocurves');
  assert.deepEqual(await accessibilityProblems(page), []);
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press('k');
  assert.equal(await page.getByRole('button', { name: /Curves at/ }).getAttribute('aria-pressed'), 'false');
  await viewer.stop();
});
