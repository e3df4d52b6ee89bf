// Both engines say the same: 200 puzzles solved by the program and by the engine that is inside the page's file.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { createContext, runInContext } from 'node:vm';
import { program } from './browser.mjs';

const folder = fileURLToPath(new URL('../../build/wasm/', import.meta.url));
const seed = 7;

/** The worker of the page, with what it posts as what it answers. */
async function local() {
  let posted;
  const bankshotEngine = createRequire(import.meta.url)(folder + 'engine.js');
  const worker = createContext({ bankshotEngine, WebAssembly, postMessage: (reply) => (posted = reply) });
  runInContext(readFileSync(new URL('../../src/app/serve/wasm/worker.js', import.meta.url), 'utf8'), worker);
  await worker.onmessage({ data: { module: await WebAssembly.compile(readFileSync(folder + 'engine.wasm')) } });
  return async (name, flags, body) => {
    await worker.onmessage({ data: { name, flags, body } });
    return posted.text;
  };
}

const run = (args, input) => execFileSync(program, args, { input, encoding: 'utf8', maxBuffer: 1e9 });
const kinds = [
  ['pool-9ft', 'spin', '0-3', 'pocket'],
  ['pool-7ft', 'rolling', '1-3', 'pocket'],
  ['carom-10ft', 'spin', '1-3', 'stop'],
  ['pool-8ft', 'spin', '0', 'pot'],
];

/**
 * Numbers but for rounding (the C libraries' sines differ in the last digit), all else as it is. How many simulations
 * it took hangs on the last digit, and on NLopt, which the page has not.
 */
function same(a, b, path = '') {
  if (path.endsWith('simulations')) return;
  if (typeof a === 'number' && typeof b === 'number') {
    const rough = /success|margin|condition|miss/.test(path) ? 1e-3 : 1e-7;
    assert.ok(Math.abs(a - b) <= rough * Math.max(1, Math.abs(a)), `${path}: ${a} and ${b}`);
  } else if (a && b && typeof a === 'object') {
    assert.deepEqual(Object.keys(a), Object.keys(b), path);
    for (const key of Object.keys(a)) same(a[key], b[key], `${path}/${key}`);
  } else assert.equal(a, b, path);
}

test('the program and the page’s own engine answer 200 puzzles alike', async (t) => {
  if (!existsSync(folder + 'engine.wasm')) {
    assert.ok(!process.env.BANKSHOT_BROWSER, 'no engine: bash examples/page.sh');
    return t.skip('no engine: bash examples/page.sh');
  }
  const ask = await local();
  let puzzles = 0;
  for (const [table, physics, cushions, target] of kinds) {
    const args = ['generate', '--count', '50', '--seed', String(seed), '--table', table, '--physics', physics];
    const lines = run([...args, '--cushions', cushions, '--target', target])
      .trim()
      .split('\n');
    for (const line of lines) {
      const native = JSON.parse(run(['solve', '--json', '--no-timing'], line));
      const own = JSON.parse(await ask('solve', 'no-timing=\n', line));
      same(native, own, JSON.parse(line).id);
      ++puzzles;
    }
  }
  assert.equal(puzzles, 200);
});

test('the page’s own engine refuses as the program does', async (t) => {
  if (!existsSync(folder + 'engine.wasm')) return t.skip('no engine: bash examples/page.sh');
  const ask = await local();
  assert.deepEqual(JSON.parse(await ask('solve', '', '{"table": "no"}')).path, '/table');
  assert.match(JSON.parse(await ask('solve', 'wrong=\n', '{}')).reason, /--wrong/);
  assert.match(JSON.parse(await ask('nothing', '', '')).reason, /nothing/);
});
