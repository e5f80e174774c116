// Measures the live viewer on a large mesh: node measure.mjs <program> <homework> [<triangles>]
// Prints milliseconds; the median of several where it says so.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { openBrowser } from './browser.mjs';
import { torusObj } from './made_meshes.mjs';

const [program, homework, triangles = '200000'] = process.argv.slice(2);
const scratch = mkdtempSync(join(tmpdir(), 'meshgrade-measure-'));
const file = join(scratch, 'torus.obj');
const side = Math.round(Math.sqrt(Number(triangles) / 2));
writeFileSync(file, torusObj(side, side));

const child = spawn(program, ['view', file, '--submission', homework]);
const url = await new Promise((resolve, reject) => {
  let printed = '';
  child.stdout.on('data', (data) => {
    printed += data;
    const found = /http:\S+/.exec(printed);
    if (found) resolve(found[0]);
  });
  child.stderr.on('data', (data) => (printed += data));
  child.on('exit', () => reject(new Error(printed)));
});
process.on('exit', () => child.kill('SIGINT'));
const browser = await openBrowser({ viewport: { width: 1280, height: 800 } });
const page = await browser.context.newPage();
page.setDefaultTimeout(600_000);
page.on('pageerror', (error) => console.log(`page error: ${error.message}`));
page.on('console', (message) => message.type() === 'error' && console.log(message.text()));
const tell = (what, ms) => console.log(`${what.padEnd(32)}${Math.round(ms)} ms`);

/** Until everything asked of WebGL is drawn: its pixels can be read only then. */
const drawn = () => page.evaluate(() => new Promise((resolve) => {
  requestAnimationFrame(() => requestAnimationFrame(() => {
    const gl = document.querySelector('.stage canvas').getContext('webgl2');
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    resolve();
  }));
}));
const timed = async (act) => {
  const start = performance.now();
  await act();
  return performance.now() - start;
};
const median = (times) => times.sort((a, b) => a - b)[Math.floor(times.length / 2)];

tell('to the first frame', await timed(async () => {
  await page.goto(url);
  await page.waitForFunction(() => document.querySelector('.stage canvas')?.ariaLabel?.includes('faces'));
  await drawn();
}));
const box = await page.locator('.stage canvas').first().boundingBox();
const at = (x, y) => [box.x + x * box.width, box.y + y * box.height];
tell('a still frame (of 5)', median(await (async () => {
  const times = [];
  for (let i = 0; i < 5; ++i) {
    times.push(await timed(async () => {
      await page.evaluate(() => document.querySelector('.stage canvas').focus());
      await page.keyboard.press('ArrowLeft');
      await drawn();
    }));
  }
  return times;
})()));
await page.mouse.move(...at(0.1, 0.5));
await page.mouse.down();
const frames = [];
for (let i = 1; i <= 15; ++i) {
  frames.push(await timed(async () => {
    await page.mouse.move(...at(0.1 + 0.01 * i, 0.5));
    await drawn();
  }));
}
tell('a dragged frame (of 15)', median(frames.slice(3)));
tell('letting go', await timed(async () => {
  await page.mouse.up();
  await drawn();
}));
const picks = [];
for (let i = 0; i < 5; ++i) {
  await page.keyboard.press('Escape');
  await drawn();
  picks.push(await timed(async () => {
    await page.mouse.click(...at(0.4 + 0.002 * i, 0.62));
    await page.waitForFunction(() => document.querySelector('.status').textContent.includes('selected'));
    await drawn();
  }));
}
tell('a click that selects (of 5)', median(picks));
await page.fill('.finder input', 'e1000');
await page.keyboard.press('Enter');
await page.evaluate(() => document.activeElement.blur());
await drawn();
tell('a flip', await timed(async () => {
  await page.keyboard.press('f');
  await page.waitForFunction(() => document.querySelectorAll('.timeline li').length === 2
    && !document.body.classList.contains('busy'));
  await drawn();
}));
if (process.env.MESHGRADE_PICTURES) {
  await page.screenshot({ path: join(process.env.MESHGRADE_PICTURES, 'large_mesh.png') });
}
await browser.close();
child.removeAllListeners('exit');
child.kill('SIGINT');
rmSync(scratch, { recursive: true, force: true });
