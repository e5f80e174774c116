// What the browser tests share: pages that fail a test when anything goes wrong in them, and
// running viewers. Needs a built grader; MESHGRADE_PROGRAM and MESHGRADE_SOURCE name it.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before } from 'node:test';
import { openBrowser } from './browser.mjs';

export const program = process.env.MESHGRADE_PROGRAM;
export const source = process.env.MESHGRADE_SOURCE;
assert.ok(program && source, 'MESHGRADE_PROGRAM and MESHGRADE_SOURCE must be set');
const axeSource = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const pictures = process.env.MESHGRADE_PICTURES;

let browser;
export const scratch = mkdtempSync(join(tmpdir(), 'meshgrade-flows-'));
before(async () => {
  browser = await openBrowser({ viewport: { width: 1280, height: 800 } });
});
const running = new Set();
after(async () => {
  await browser?.close();
  for (const child of running) child.kill('SIGINT');
  rmSync(scratch, { recursive: true, force: true });
});

/** The reference, with files of a wrong submission over it. */
export function homework(name, ...wrong) {
  const folder = join(scratch, name);
  cpSync(join(source, 'reference'), folder, { recursive: true });
  for (const other of wrong) {
    cpSync(join(source, 'tests/submissions/wrong', other), folder, {
      recursive: true,
      filter: (file) => !file.endsWith('.toml'),
    });
  }
  return folder;
}

/** A page that fails the test when its script does, or when it asks for anything outside. */
export async function openPage(url, problems) {
  const page = await browser.context.newPage();
  page.on('pageerror', (error) => problems.push(error.message));
  page.on('console', (message) => {
    if (message.type() === 'error') problems.push(message.text());
  });
  const origin = new URL(url).origin;
  page.on('request', (request) => {
    const other = new URL(request.url());
    if (other.protocol !== 'blob:' && other.protocol !== 'data:' && other.origin !== origin) {
      problems.push(`asks for ${request.url()}`);
    }
  });
  await page.goto(url);
  return page;
}

export async function accessibilityProblems(page) {
  await page.evaluate((text) => new Function(text)(), axeSource).catch(async () => {
    // The page's policy allows no other script: the check comes in beside it.
    const session = await page.context().newCDPSession(page);
    await session.send('Page.setBypassCSP', { enabled: true });
    await session.send('Runtime.evaluate', { expression: axeSource });
  });
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  return violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.target.join(' ')).slice(0, 4).join(', ')}`);
}

export async function snap(page, name) {
  if (pictures) await page.screenshot({ path: join(pictures, `${name}.png`) });
}

/** The text of the file that a button saves. */
export async function savedFile(page, button) {
  const [download] = await Promise.all([page.waitForEvent('download'),
    page.getByRole('button', { name: button }).click()]);
  const chunks = [];
  for await (const chunk of await download.createReadStream()) chunks.push(chunk);
  return Buffer.concat(chunks).toString();
}

export class Viewer {
  static async start(folder, mesh = 'cube.obj') {
    const viewer = new Viewer();
    const file = mesh.startsWith('/') ? mesh : join(source, 'meshes', mesh);
    viewer.child = spawn(program, ['view', file, '--submission', folder]);
    running.add(viewer.child);
    let printed = '';
    viewer.url = await new Promise((resolve, reject) => {
      viewer.child.stdout.on('data', (data) => {
        printed += data;
        const found = /http:\S+/.exec(printed);
        if (found) resolve(found[0]);
      });
      viewer.child.stderr.on('data', (data) => (printed += data));
      viewer.child.on('exit', () => reject(new Error(printed)));
    });
    viewer.problems = [];
    viewer.page = await openPage(viewer.url, viewer.problems);
    if (!/\.bez$|\.bzc$/.test(mesh)) await viewer.steps(1);
    return viewer;
  }

  async select(name) {
    await this.page.fill('.finder input', name);
    await this.page.keyboard.press('Enter');
    await this.page.evaluate(() => document.activeElement.blur());
    await this.page.getByText(`${name} selected`).waitFor();
  }

  /** Waits until the timeline has so many entries and nothing is under way. */
  async steps(count, timeout = 60000) {
    await this.page.waitForFunction(
      (n) => document.querySelectorAll('.timeline li').length === n && !document.body.classList.contains('busy'),
      count, { timeout });
  }

  async counts() {
    return this.page.getAttribute('.stage canvas', 'aria-label');
  }

  async stop() {
    await this.page.close();
    const ended = new Promise((resolve) => this.child.on('exit', resolve));
    running.delete(this.child);
    this.child.kill('SIGINT');
    assert.equal(await ended, 0);
    assert.deepEqual(this.problems, []);
  }
}
