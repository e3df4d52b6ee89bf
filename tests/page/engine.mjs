// Shared by the tests of the npm package: its place, the output of the program, and the comparison of two answers.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { program } from './browser.mjs';

const root = new URL('../../', import.meta.url);
export const folder = fileURLToPath(new URL('build/wasm/npm/', root));

export const isBuilt = existsSync(`${folder}documents.d.ts`);
if (!isBuilt) {
  assert.ok(!process.env.BANKSHOT_BROWSER, 'no engine: bash examples/page.sh');
  console.error('SKIPPED: no engine (bash examples/page.sh)');
}

export const { load, loadWorker, BankshotError } = isBuilt ? await import(`${folder}index.js`) : {};

/** The puzzles of examples/, by name. @type {Record<string, any>} */
export const examples = Object.fromEntries(
  readdirSync(new URL('examples/puzzles/', root))
    .filter((name) => name.endsWith('.json'))
    .map((name) => [name, JSON.parse(readFileSync(new URL(`examples/puzzles/${name}`, root), 'utf8'))]),
);

/** The map of this puzzle takes hours: a test that waits for it fails. */
export const endless = {
  ...examples['two-cushion-bank.json'],
  physics: { model: 'spin', cushion: { model: 'mathavan2010' } },
  cushions: { min: 4, max: 5 },
};

/** Returns the output of the program; exit 1 only means that a puzzle has no shot. */
export function run(args, document) {
  const input = typeof document === 'object' ? JSON.stringify(document) : document;
  try {
    return execFileSync(program, args, { input, encoding: 'utf8', maxBuffer: 1e9, stdio: ['pipe', 'pipe', 'ignore'] });
  } catch (error) {
    if (error.status === 1) return error.stdout;
    throw error;
  }
}

/** Returns true for two `safest` shots with different launches. */
function differ(a, b) {
  if (a?.aim !== 'safest' || b?.aim !== 'safest') return false;
  return Math.abs(a.speed - b.speed) > 1e-7 || Math.abs(a.angle - b.angle) > 1e-7;
}

/**
 * Compares numbers up to rounding (the C libraries' sines differ in the last digit), and everything else exactly. The
 * number of simulations is ignored: it depends on the last digit, and on NLopt, which the engine lacks. So does the
 * choice between `safest` launches of equal value, so only the value of such shots is compared.
 */
export function same(a, b, path = '') {
  if (path.endsWith('simulations')) return;
  if (typeof a === 'number' && typeof b === 'number') {
    const rough = /success|value|margin|condition|miss/.test(path) ? 1e-3 : 1e-7;
    assert.ok(Math.abs(a - b) <= rough * Math.max(1, Math.abs(a)), `${path}: ${a} and ${b}`);
  } else if (differ(a, b)) {
    assert.ok(Math.abs(a.value - b.value) < 1e-2, `${path}: worth ${a.value} and ${b.value}`);
  } else if (a && b && typeof a === 'object') {
    assert.deepEqual(Object.keys(a), Object.keys(b), path);
    for (const key of Object.keys(a)) same(a[key], b[key], `${path}/${key}`);
  } else assert.equal(a, b, path);
}
