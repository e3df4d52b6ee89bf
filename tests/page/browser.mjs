// Opens the page for the tests in Debian's Chromium, from the server and as one file from the disk.
import { spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const root = fileURLToPath(new URL('../..', import.meta.url));
export const program = process.env.BANKSHOT ?? `${root}build/release/bankshot`;
export const file = process.env.BANKSHOT_PAGE ?? `${root}build/wasm/bankshot.html`;

const quiet = [
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

/** Starts `bankshot serve` on a free port. @returns {Promise<{url: string, end: () => void}>} */
export function serve() {
  const server = spawn(program, ['serve', '--port', '0'], { stdio: ['ignore', 'pipe', 'pipe'] });
  const end = () => server.kill('SIGTERM');
  return new Promise((done, fail) => {
    let said = '';
    const listen = (text) => {
      said += text;
      const url = /http:\/\/\S+\//.exec(said)?.[0];
      if (url) done({ url, end });
    };
    server.stdout.on('data', listen);
    server.stderr.on('data', listen);
    server.on('error', fail);
    server.on('exit', () => fail(new Error(said)));
  });
}

/** Returns both ways to the page. @returns {Promise<{name: string, url: string}[]>} */
export async function ways(server) {
  const all = [{ name: 'the server', url: server.url }];
  if (existsSync(file)) all.push({ name: 'the file', url: `file://${file}` });
  else if (process.env.BANKSHOT_BROWSER) throw new Error(`${file} is not there: bash examples/page.sh`);
  else console.error(`SKIPPED: ${file} is not there (bash examples/page.sh)`);
  return all;
}

export async function launch() {
  return chromium.launch({ executablePath: '/usr/bin/chromium', args: quiet });
}

/**
 * Opens the page, waits for its first answer, and collects its errors and warnings.
 * @param {import('playwright-core').Browser} browser
 * @param {string} url
 * @param {object} [options] of the page
 */
export async function open(browser, url, options = {}) {
  const page = await browser.newPage({ viewport: { width: 1300, height: 1000 }, ...options });
  const complaints = [];
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('requestfailed', (request) => {
    if (!/ERR_ABORTED/.test(request.failure()?.errorText ?? '')) complaints.push(request.url());
  });
  await page.goto(url);
  await answered(page);
  return { page, complaints };
}

/** Waits until all shots of the last puzzle are there. */
export async function answered(page) {
  const done = () =>
    document.body.dataset.answered !== undefined && document.body.dataset.answered === document.body.dataset.asked;
  await page.waitForFunction(done, null, { timeout: 20000 });
}

/** Returns the middle of an element on the table, in pixels. */
export async function middle(page, selector) {
  const box = await page.locator(selector).boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Returns the text of an element. */
export const text = (page, id) => page.locator('#' + id).textContent();

/** Returns the scene that the address holds, as texts. */
export const scene = (page) => page.evaluate(() => Object.fromEntries(new URLSearchParams(location.hash.slice(1))));

/** Returns the pixels of a metre of the table. */
export const pixels = (page) =>
  page.evaluate(() => {
    const table = /** @type {SVGSVGElement} */ (document.querySelector('#table'));
    return table.getBoundingClientRect().width / table.viewBox.baseVal.width;
  });

/** Drags a grip by a distance in metres, in steps as a hand does. */
export async function drag(page, grip, right, up, steps = 12) {
  const { x, y } = await middle(page, `[data-grip="${grip}"].grip`);
  const metre = await pixels(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + right * metre, y - up * metre, { steps });
  await page.mouse.up();
}
