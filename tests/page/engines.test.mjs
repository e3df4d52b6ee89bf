// Tests the npm package in Node: it answers like the program, in this thread and in a worker.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, test } from 'node:test';
import { BankshotError, endless, examples, folder, isBuilt, load, loadWorker, run, same } from './engine.mjs';

const seed = 7;
const kinds = [
  ['pool-9ft', 'spin', '0-3', 'pocket'],
  ['pool-7ft', 'rolling', '1-3', 'pocket'],
  ['carom-10ft', 'spin', '1-3', 'stop'],
  ['pool-8ft', 'spin', '0', 'pot'],
];
const bank = examples['two-cushion-bank.json'];
const plain = { noTiming: true };

/** Returns the rows of a CSV file as objects, with numbers converted. */
function rows(csv) {
  const [head, ...lines] = csv.trim().split('\n');
  const value = (cell) => (cell === '' || isNaN(+cell) ? cell : +cell);
  return lines.map((line) => Object.fromEntries(line.split(',').map((cell, i) => [head.split(',')[i], value(cell)])));
}

/**
 * Returns true if two answers differ only as success does that counts many narrow parts: last digits choose its samples
 * there, and it may be off by 0.04 (docs/evidence.md).
 */
function isAsSure(a, b) {
  const [shot, other] = [a.shots[0], b.shots[0]];
  return a.status === b.status && Math.abs(shot?.success - other?.success) < 0.08;
}

/// What tells two answers of like success apart; answers that differ further fail.
function differences(native, answer, id) {
  try {
    same(native, answer, id);
    return [];
  } catch (error) {
    if (!isAsSure(native, answer)) throw error;
    return [error.message];
  }
}

describe('the npm package in Node', { skip: !isBuilt, timeout: 600000 }, () => {
  test('the program and the engine answer 200 puzzles alike', async () => {
    const engine = await load();
    let puzzles = 0;
    const unlike = [];
    for (const [table, physics, cushions, target] of kinds) {
      const args = ['generate', '--count', '50', '--seed', String(seed), '--table', table, '--physics', physics];
      const lines = run([...args, '--cushions', cushions, '--target', target])
        .trim()
        .split('\n');
      for (const line of lines) {
        const native = JSON.parse(run(['solve', '--json', '--no-timing'], line));
        unlike.push(...differences(native, engine.solve(line, plain), JSON.parse(line).id));
        ++puzzles;
      }
    }
    assert.equal(puzzles, 200);
    assert.ok(unlike.length <= 4, unlike.join('\n'));
  });

  test('the examples, in this thread and in a worker: the best shot, all of them, and how it is played', async () => {
    const [here, worker] = [await load(), await loadWorker()];
    let shots = 0;
    for (const [name, puzzle] of Object.entries(examples)) {
      const best = here.solve(puzzle, plain);
      same(JSON.parse(run(['solve', '--json', '--no-timing'], puzzle)), best, name);
      assert.deepEqual(await worker.solve(puzzle, plain), best);
      // Launches chosen by their value are in another order where the last digit of a sine differs.
      const all = await worker.solveAll(puzzle, { ...plain, noRobustness: true });
      const native = run(['solve', '--json', '--no-timing', '--no-robustness', '--all'], puzzle);
      same(JSON.parse(native), all, `${name}, all`);
      for (const shot of best.shots) {
        const scene = { ...puzzle, shot };
        same(JSON.parse(run(['simulate', '--json'], scene)), here.simulate(scene), `${name}, played`);
        const csv = await worker.simulate(scene, { csv: true, rate: 10 });
        assert.ok(csv.startsWith('t,ball,x,y,'));
        ++shots;
      }
    }
    assert.equal(Object.keys(examples).length, 18);
    assert.equal(shots, 17);
  });

  test('maps, tables, schemas and the version', async () => {
    const engine = await load();
    const scratch = mkdtempSync(join(tmpdir(), 'bankshot-'));
    run(['map', '-', '--grid', '5', '4', '-o', `${scratch}/map.csv`], bank);
    const map = rows(engine.map(bank, { grid: [5, 4] }));
    assert.equal(map.length, 20);
    same(rows(readFileSync(`${scratch}/map.csv`, 'utf8')), map);
    rmSync(scratch, { recursive: true });
    assert.match(engine.map(bank, { grid: [5, 4], svg: true }), /^<svg/);
    for (const document of ['puzzle', 'shot', 'answer', 'recording'])
      assert.deepEqual(engine.schema(document), JSON.parse(run(['schema', document])));
    assert.deepEqual(engine.schema(), engine.schema('puzzle'));
    assert.deepEqual(engine.tables().find(({ name }) => name === bank.table)?.length, 2.54);
    const { angle, speed } = engine.solve(bank).shots[0];
    const near = { angle: [angle - 0.01, angle + 0.01], speed: [speed - 0.001, speed + 0.001], grid: [3, 3] };
    assert.equal(engine.launches(bank, near).made, '111111111');
    assert.ok(run(['--version']).includes(engine.version()));
    assert.equal(JSON.parse(readFileSync(`${folder}package.json`, 'utf8')).version, engine.version());
  });

  test('says where a document is wrong, and what is wrong with a flag', async () => {
    const [here, worker] = [await load(), await loadWorker()];
    const wrong = (path, reason) => (error) => {
      assert.ok(error instanceof BankshotError);
      assert.equal(error.path, path);
      assert.match(error.reason, reason);
      return true;
    };
    const beside = { ...bank, ball: { at: [0.6, 9] } };
    assert.throws(() => here.solve({ ...bank, table: 'no' }), wrong('/table', /no/));
    assert.throws(() => here.simulate({ ...bank, shot: { speed: 'fast' } }), wrong('/shot/speed', /number/));
    assert.throws(() => here.solve(bank, { wrong: true }), wrong('', /--wrong/));
    assert.throws(() => here.solve(bank, { budget: -2 }), wrong('', /--budget/));
    assert.throws(() => here.solve('{"table": '), wrong('', /JSON|line/));
    assert.throws(() => here.solve(undefined), BankshotError);
    assert.throws(() => here.schema('no'), wrong('', /no document/));
    await assert.rejects(worker.map(beside), wrong(/** @type {any} */ ('/ball/at'), /./));
    assert.equal((await worker.solve(bank, { budget: 0 })).status, 'budget');
  });

  test('what nobody waits for makes room', async () => {
    const worker = await loadWorker();
    const map = (signal) => worker.map(endless, { grid: [200, 200], signal });
    const [first, second] = [new AbortController(), new AbortController()];
    await assert.rejects(map(AbortSignal.abort()), { name: 'AbortError' });
    const maps = [first, second].map(({ signal }) => map(signal));
    const answer = worker.solve(bank, plain);
    second.abort(); // before its turn
    await assert.rejects(maps[1], { name: 'AbortError' });
    first.abort(new Error('enough')); // while its worker is busy with it
    await assert.rejects(maps[0], { message: 'enough' });
    assert.equal((await answer).status, 'solved');
    const ended = [map(), map()];
    await new Promise((done) => setTimeout(done, 10));
    worker.end();
    for (const one of ended) await assert.rejects(one, /ended/);
    assert.deepEqual(await worker.solve(bank, plain), await answer);
  });

  test('several side by side share the compiled module and nothing else', async (t) => {
    const compiles = t.mock.method(WebAssembly, 'compile');
    const url = new URL(`file://${folder}bankshot.wasm?own`);
    const locateFile = (name) => (name === 'worker.js' ? `file://${folder}worker.js` : url);
    const engines = await Promise.all([load, load, loadWorker, loadWorker, loadWorker].map((f) => f({ locateFile })));
    assert.equal(compiles.mock.callCount(), 1);
    const puzzles = Object.values(examples).slice(0, engines.length);
    const alone = await load({ module: await compiles.mock.calls[0].result });
    assert.equal(compiles.mock.callCount(), 1);
    for (let turn = 0; turn < engines.length; ++turn) {
      const asked = engines.map((engine, i) => engine.solve(puzzles[(i + turn) % puzzles.length], plain));
      const answers = await Promise.all(asked);
      answers.forEach((answer, i) =>
        assert.deepEqual(answer, alone.solve(puzzles[(i + turn) % puzzles.length], plain)),
      );
    }
  });

  test('a thousand solves leave its memory as it was', async (t) => {
    const instantiate = t.mock.method(WebAssembly, 'instantiate');
    const engine = await load();
    const { exports } = await instantiate.mock.calls[0].result;
    const memory = Object.values(exports).find((one) => one instanceof WebAssembly.Memory);
    // Each call passes 20 kB of text in and out; if every call leaked them once, the memory would overflow.
    const puzzle = { ...bank, about: 'x'.repeat(20000) };
    const ask = () => assert.equal(engine.solve(puzzle, { path: true, budget: 2000 }).status, 'solved');
    for (let i = 0; i < 20; ++i) ask();
    const { byteLength } = memory.buffer;
    for (let i = 0; i < 1000; ++i) ask();
    assert.equal(memory.buffer.byteLength, byteLength);
    assert.ok(byteLength < 20e6, `${byteLength} bytes`);
  });
});
