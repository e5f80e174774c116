// Reports and class pages where people read them: on a telephone, in the dark, on paper.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { before, test } from 'node:test';
import { Viewer, accessibilityProblems, homework, openPage, program, scratch } from './harness.mjs';
import { classData, classFile } from './made_class.mjs';

const report = join(scratch, 'read.html');
before(() => {
  const folder = homework('read', 'edge_split/next_forgotten', 'vertex_normal/unweighted');
  const run = spawnSync(program, ['check', folder, '--html', report], { encoding: 'utf8' });
  assert.equal(run.status, 1, run.stderr);
});

/** How far the page is wider than its window: then it has to be moved sideways to be read. */
function overhang(page) {
  return page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
}

/** Texts that can be seen and are smaller than 13 pixels, with their size. */
function smallTexts(page) {
  return page.evaluate(() => {
    const small = [];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const element = node.parentElement;
      if (!node.data.trim() || !element.checkVisibility() || element.closest('.unseen, script, style')) continue;
      const matrix = element.getScreenCTM?.();
      const size = parseFloat(getComputedStyle(element).fontSize) * (matrix ? matrix.a : 1);
      if (size < 12.9) small.push(`${node.data.trim().slice(0, 30)}: ${size.toFixed(1)}`);
    }
    return small;
  });
}

/** The light of a colour `rgb(...)`, from 0 to 1. */
function lightOf(color) {
  const [r, g, b] = color.match(/[\d.]+/g).map(Number);
  return (0.2126 * r + 0.7152 * g + 0.0722 * b) / 255;
}

test('A report is read at 400 pixels, by day and in the dark', async () => {
  const problems = [];
  const page = await openPage(`file://${report}`, problems);
  await page.setViewportSize({ width: 400, height: 800 });
  await page.locator('.case figure, .case svg').first().waitFor();
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme });
    assert.equal(await overhang(page), 0, colorScheme);
    assert.deepEqual(await smallTexts(page), [], colorScheme);
    assert.deepEqual(await accessibilityProblems(page), [], colorScheme);
    const ground = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    assert.equal(lightOf(ground) < 0.5, colorScheme === 'dark', ground);
  }
  assert.deepEqual(problems, []);
  await page.close();
});

test('The first failure comes before the exercises, and what passed is one line', async () => {
  const page = await openPage(`file://${report}`, []);
  const order = await page.evaluate(() => {
    const top = (selector) => document.querySelector(selector).getBoundingClientRect().top;
    return [top('.first-failure'), top('.overview')];
  });
  assert.ok(order[0] < order[1], `${order}`);
  const heights = await page.locator('.overview-passed').evaluateAll((rows) =>
    rows.map((row) => row.getBoundingClientRect().height));
  assert.equal(heights.length, 4);
  assert.ok(Math.max(...heights) < 80, `${heights}`);
  await page.close();
});

test('On paper a report is dark on light, whatever the screen', async () => {
  const page = await openPage(`file://${report}`, []);
  await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
  const [ground, ink] = await page.evaluate(() => {
    const style = getComputedStyle(document.body);
    return [style.backgroundColor, style.color];
  });
  assert.ok(lightOf(ink) < 0.4, ink);
  assert.ok(ground === 'rgba(0, 0, 0, 0)' || lightOf(ground) > 0.9, ground);
  await page.close();
});

test('A class is read at 360 pixels, and full points have a bar of their own', async () => {
  const problems = [];
  const page = await openPage(`file://${classFile(classData(30))}`, problems);
  await page.setViewportSize({ width: 360, height: 800 });
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme });
    assert.equal(await overhang(page), 0, colorScheme);
    assert.deepEqual(await smallTexts(page), [], colorScheme);
    assert.deepEqual(await accessibilityProblems(page), [], colorScheme);
  }
  await page.getByText('Student 3, Student 4').waitFor();
  assert.equal(await page.getByRole('link', { name: 'All pairs' }).getAttribute('href'), 'similar.html');
  assert.equal(await page.locator('.bin-name').last().textContent(), 'all');
  assert.equal(await page.locator('.bin-name').count(), 11);
  assert.deepEqual(problems, []);
  await page.close();
});

test('The viewer lists its keys, hides arrows, and its tools cover nothing', async () => {
  const viewer = await Viewer.start(homework('keys'));
  const { page } = viewer;
  await page.keyboard.press('?');
  await page.getByText('names, wireframe, arrows').waitFor();
  await page.keyboard.press('Escape');
  await page.keyboard.press('a');
  await page.waitForFunction(() => document.querySelector('[data-option=arrows]').ariaPressed === 'false');
  for (const width of [1280, 700]) {
    await page.setViewportSize({ width, height: 800 });
    const covered = await page.evaluate(() => {
      const box = (selector) => document.querySelector(selector).getBoundingClientRect();
      const [tools, picture] = [box('.tools'), box('.stage canvas')];
      return Math.min(tools.bottom, picture.bottom) > Math.max(tools.top, picture.top) + 1 &&
        Math.min(tools.right, picture.right) > Math.max(tools.left, picture.left) + 1;
    });
    assert.equal(covered, false, `the tools lie on the picture at ${width}`);
  }
  await viewer.stop();
});
