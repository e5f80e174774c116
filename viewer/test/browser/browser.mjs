// Starts Debian's Chromium without a display, for the tests of the page.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';

const ARGUMENTS = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
];

/** A browser with an empty profile; `close()` removes it again. */
export async function openBrowser(options = {}) {
  const profile = mkdtempSync(join(tmpdir(), 'meshgrade-browser-'));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.MESHGRADE_CHROMIUM ?? '/usr/bin/chromium',
    headless: true,
    args: ARGUMENTS,
    ...options,
  });
  return {
    context,
    close: async () => {
      await context.close();
      rmSync(profile, { recursive: true, force: true });
    },
  };
}
