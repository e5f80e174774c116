// Drives the page in a real browser: reports from files, and the live viewer with right and
// wrong solutions.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, readFileSync, writeFileSync } from 'node:fs';
import http from 'node:http';
import { join } from 'node:path';
import { test } from 'node:test';
import { Viewer, accessibilityProblems, homework, openPage, program, scratch, snap, source } from './harness.mjs';
import { classData, classFile } from './made_class.mjs';

test('A report opens from a file, shows the first failure and asks for nothing', async () => {
  const html = join(scratch, 'report.html');
  const folder = homework('reported', 'edge_split/next_forgotten');
  const run = spawnSync(program, ['check', folder, 'edge_split', '--html', html], { encoding: 'utf8' });
  assert.equal(run.status, 1, run.stderr);
  const problems = [];
  const page = await openPage(`file://${html}`, problems);
  await page.getByRole('heading', { name: 'Edge split' }).waitFor();
  await page.getByText('h0.next is still h1 (ab)').first().waitFor();
  assert.ok((await page.locator('.pointer-table td.wrong').count()) >= 2);
  await page.locator('.show-3d').first().click();
  await page.locator('.mesh-panel .stage canvas').first().waitFor();
  assert.match(await page.getAttribute('.stage canvas', 'aria-label'), /Open faces: f2, f3/);
  await page.getByRole('button', { name: 'Expected', exact: true }).click();
  assert.match(await page.getAttribute('.stage canvas', 'aria-label'), /Mesh Expected: 5 vertices/);
  assert.deepEqual(await accessibilityProblems(page), []);
  assert.deepEqual(problems, []);
  await page.close();
});

test('Markup in names and output comes out as text', async () => {
  const folder = homework('<img src=x onerror=alert(1)>');
  const file = join(folder, 'edge_flip.cpp');
  writeFileSync(file, readFileSync(file, 'utf8').replace(
    /(EdgeIter HalfedgeMesh::flipEdge\(EdgeIter e0\) \{)/,
    '$1 std::puts("</script><script>alert(2)</script><b>bold</b>");').replace(/^/, '#include <cstdio>\n'));
  const html = join(scratch, 'hostile.html');
  spawnSync(program, ['check', folder, 'edge_flip', '--html', html]);
  const problems = [];
  const page = await openPage(`file://${html}`, problems);
  page.on('dialog', (dialog) => problems.push(`dialog: ${dialog.message()}`));
  await page.getByRole('heading', { name: '<img src=x onerror=alert(1)>' }).waitFor();
  assert.equal(await page.locator('main img, main b, main script').count(), 0);
  await page.locator('.overview-passed > summary').first().click();
  await page.locator('.case > summary').first().click();
  await page.locator('.output > summary').first().click();
  await page.getByText('</script><script>alert(2)</script><b>bold</b>').first().waitFor();
  assert.deepEqual(problems, []);
  await page.close();
});

test('A class of 1,000 is sorted and searched, from a file', async () => {
  const data = classData(1000);
  const problems = [];
  const page = await openPage(`file://${classFile(data)}`, problems);
  const rows = page.locator('.class-table tbody tr');
  assert.equal(await rows.count(), 1000);
  await page.getByRole('button', { name: 'Points', exact: true }).click();
  const shown = await rows.locator('td:nth-child(3)').allTextContents();
  assert.deepEqual(shown, data.class.rows.map((r) => r.points).sort((a, b) => b - a).map(String));
  await page.getByRole('searchbox').fill('five');
  assert.equal(await rows.count(), 1);
  assert.equal(await rows.locator('a').textContent(), '<b>Five</b>');
  assert.equal(await rows.locator('a').getAttribute('href'), 'results/k5/report.html');
  assert.deepEqual(await accessibilityProblems(page), []);
  assert.deepEqual(problems, []);
  await page.close();
});

test('Flip, split, subdivide and undo by keys alone', async () => {
  const viewer = await Viewer.start(homework('right'));
  const { page } = viewer;
  await viewer.select('e4');
  for (const [key, steps] of [['f', 2], ['s', 3], ['u', 4]]) {
    await page.keyboard.press(key);
    await viewer.steps(steps);
  }
  assert.deepEqual(await page.locator('.timeline .sign.good').count(), 3);
  // V + E, 2E + 3F and 4F of 9 vertices, 21 edges and 14 faces.
  assert.match(await viewer.counts(), /30 vertices, 84 edges, 56 faces/);
  await page.keyboard.press('z');
  await page.waitForFunction(() => document.querySelector('[aria-current]').textContent.includes('split'));
  assert.match(await viewer.counts(), /9 vertices, 21 edges, 14 faces/);
  await page.keyboard.press('y');
  await page.waitForFunction(() => document.querySelector('[aria-current]').textContent.includes('subdivide'));
  await page.keyboard.press('q');
  await page.waitForFunction(() => document.querySelector('[data-option=smooth]').ariaPressed === 'true');
  assert.deepEqual(await accessibilityProblems(page), []);
  await viewer.stop();
});

test('Wrong weights are coloured, marked and listed by their distance from OpenSubdiv', async () => {
  const viewer = await Viewer.start(homework('far off', 'loop_subdivision/old_vertices_stay'));
  const { page } = viewer;
  await page.keyboard.press('d');
  await page.getByText('Nothing to compare here').waitFor();
  await page.keyboard.press('u');
  await viewer.steps(2);
  await page.getByText('Off: 8 of 26 vertices').waitFor();
  assert.match(await viewer.counts(), /Coloured by the distance from OpenSubdiv\. Off: 8 of 26/);
  await page.locator('.worst button').first().click();
  await page.getByText(/^Vertex v\d selected$/).waitFor();
  await page.keyboard.press('Escape');
  await snap(page, 'viewer_distance');
  assert.deepEqual(await accessibilityProblems(page), []);
  await page.keyboard.press('d');
  assert.equal(await page.locator('.legend').count(), 0);
  await viewer.stop();
});

test('Levels stand beside each other and follow the steps', async () => {
  const viewer = await Viewer.start(homework('levels'));
  const { page } = viewer;
  await page.keyboard.press('u');
  await viewer.steps(2);
  await page.keyboard.press('v');
  await page.getByText('level 1: 26 vertices').waitFor();
  await page.keyboard.press('u');
  await viewer.steps(3);
  await page.getByText('level 2: 98 vertices').waitFor();
  const captions = await page.locator('.mesh-grid figcaption').allTextContents();
  assert.deepEqual(captions, ['level 0: 8 vertices', 'level 1: 26 vertices', 'level 2: 98 vertices']);
  await snap(page, 'viewer_levels');
  const pictures = () => page.$$eval('.mesh-grid canvas:not(.labels)', (all) => all.map((c) => c.toDataURL()));
  const first = await pictures();
  await page.locator('.mesh-grid canvas:not(.labels)').last().focus();
  await page.keyboard.press('ArrowRight');
  await page.waitForTimeout(300);
  const turned = await pictures();
  assert.ok(turned.every((picture, i) => picture !== first[i]), 'the arrow key turns all levels');
  await page.keyboard.press(' ');
  await page.waitForTimeout(300);
  assert.deepEqual((await pictures()).map((picture, i) => picture === first[i]), [true, true, true],
    'Space shows them as at first');
  assert.deepEqual(await accessibilityProblems(page), []);
  await page.keyboard.press('v');
  assert.equal(await page.locator('.mesh-grid figcaption').count(), 0);
  await viewer.stop();
});

test('A broken split is shown, and heals when the source is saved', async () => {
  const folder = homework('healing', 'edge_split/next_forgotten');
  const viewer = await Viewer.start(folder);
  const { page } = viewer;
  await viewer.select('e4');
  await page.keyboard.press('s');
  await viewer.steps(2);
  await page.getByText('h3.next is still h4 (ab)').first().waitFor();
  assert.match(await viewer.counts(), /Open faces: f12, f13\. Wrong pointers: h3\.next/);
  assert.ok((await page.locator('button.break').count()) > 3);
  await page.locator('button.break').first().click();
  await page.getByText('Half-edge h4 selected').or(page.getByText('Half-edge h3 selected')).first().waitFor();
  await viewer.select('e4');
  await page.waitForTimeout(500);
  await snap(page, 'viewer_broken_split');
  assert.deepEqual(await accessibilityProblems(page), []);
  cpSync(join(source, 'reference/edge_split.cpp'), join(folder, 'edge_split.cpp'));
  await page.getByText('No mesh rule is broken').waitFor({ timeout: 120000 });
  await page.locator('.timeline .sign.good').waitFor();
  await page.waitForTimeout(500);
  await snap(page, 'viewer_healed_split');
  await viewer.stop();
});

/** What is put in front of the first line of the reference's flipEdge. */
const STOPS = [
  ['A crash', 'int* none = nullptr; *none = 1;', 'crashed'],
  ['A dangling pointer', 'deleteEdge(e0); e0->halfedge();', 'crashed'],
  ['An endless walk', 'for (HalfedgeIter h = e0->halfedge();; h = h->next()) {}', 'out of steps'],
  ['An endless loop', 'volatile int i = 0; while (i == 0) {}', 'out of time'],
];
for (const [what, code, text] of STOPS) {
  test(`${what} is told, and the mesh before is kept`, async () => {
    const folder = homework(what);
    const file = join(folder, 'edge_flip.cpp');
    const right = readFileSync(file, 'utf8');
    const wrong = right.replace(/flipEdge\(EdgeIter e0\) \{/, `$& ${code}`);
    assert.notEqual(wrong, right);
    writeFileSync(file, wrong);
    const viewer = await Viewer.start(folder);
    const { page } = viewer;
    await viewer.select('e4');
    await page.keyboard.press('f');
    await page.locator('.stop').getByText(text).first().waitFor({ timeout: 60000 });
    assert.match(await viewer.counts(), /8 vertices, 18 edges, 12 faces/);
    if (what === 'A crash') await snap(page, 'viewer_crash');
    writeFileSync(file, right);
    await page.locator('.timeline .sign.good').waitFor({ timeout: 120000 });
    assert.equal(await page.locator('.stop').count(), 0);
    await viewer.stop();
  });
}

test('A curve is stepped by keys, dragged, and follows the source', async () => {
  const folder = homework('curve');
  const viewer = await Viewer.start(folder, 'arch_4.bzc');
  const { page } = viewer;
  await page.getByText('evaluateStep at t = 0.50').waitFor();
  // The middle of the cubic: (p0 + 3 p1 + 3 p2 + p3) / 8.
  await page.locator('.levels tr').last().getByText('(1.5, 1.3438)').waitFor();
  for (let level = 1; level <= 3; ++level) {
    await page.keyboard.press('e');
    assert.equal(await page.locator('.curve circle.level, .curve circle.result').count(), [3, 5, 6][level - 1]);
  }
  await page.keyboard.press('c');
  assert.equal(await page.locator('.curve .yours').count(), 1);
  await snap(page, 'viewer_curve');
  const control = page.locator('.control').nth(1);
  const box = await control.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 80, box.y + 60, { steps: 4 });
  await page.mouse.up();
  await page.waitForFunction(() => !document.querySelector('.control:nth-of-type(1)')?.ariaLabel?.includes('0.5, 1.5'));
  assert.doesNotMatch(await control.getAttribute('aria-label'), /0\.5, 1\.5/);
  await page.keyboard.press('a');
  assert.equal(await page.locator('.control').count(), 5);
  await page.keyboard.press('Delete');
  assert.equal(await page.locator('.control').count(), 4);
  assert.deepEqual(await accessibilityProblems(page), []);
  cpSync(join(source, 'tests/submissions/wrong/bezier_curve/t_swapped/bezier_curve.cpp'), join(folder, 'bezier_curve.cpp'));
  await page.getByRole('slider').press('ArrowRight');
  await page.locator('.told .tag.bad').waitFor({ timeout: 120000 });
  await viewer.stop();
});

test('A surface comes from the student\'s evaluate', async () => {
  const viewer = await Viewer.start(homework('patch'), 'wavy.bez');
  const { page } = viewer;
  await page.getByText('passed').waitFor({ timeout: 60000 });
  assert.match(await viewer.counts(), /1 patches, 289 points/);
  await page.getByRole('combobox').selectOption('32');
  await page.waitForFunction(() => document.querySelector('.stage canvas').ariaLabel.includes('1089 points'));
  assert.deepEqual(await accessibilityProblems(page), []);
  await viewer.stop();
});

function status(url, headers) {
  return new Promise((resolve, reject) => {
    http.get(url, { headers }, (response) => {
      response.resume();
      resolve(response.statusCode);
    }).on('error', reject);
  });
}

test('Other hosts, other pages and other users are refused', async () => {
  const viewer = await Viewer.start(homework('guarded'));
  const { origin } = new URL(viewer.url);
  assert.equal(await status(viewer.url, {}), 200);
  assert.equal(await status(viewer.url, { Host: 'evil.example' }), 403);
  assert.equal(await status(viewer.url, { Origin: 'http://evil.example' }), 403);
  assert.equal(await status(`${origin}/`, {}), 403);
  assert.equal(await status(`${origin}/?token=0`, {}), 403);
  await viewer.stop();
});
