// Tests the npm package as its users have it: packed and installed in a project, checked by TypeScript, and in
// Chromium.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch } from './browser.mjs';
import { endless, examples, folder, isBuilt, load, run, same } from './engine.mjs';

const here = fileURLToPath(new URL('.', import.meta.url));
const bank = examples['two-cushion-bank.json'];
const plain = { noTiming: true };

describe('a project with the npm package', { skip: !isBuilt, timeout: 600000 }, () => {
  const project = mkdtempSync(join(tmpdir(), 'bankshot-'));
  const installed = join(project, 'node_modules/bankshot');
  const at = { cwd: project, encoding: /** @type {const} */ ('utf8') };
  before(() => {
    const packed = execFileSync('npm', ['pack', '--silent', folder], at).trim();
    writeFileSync(join(project, 'package.json'), '{"private": true, "type": "module"}');
    execFileSync('npm', ['install', '--silent', '--offline', '--no-audit', '--no-fund', `./${packed}`], at);
  });
  after(() => rmSync(project, { recursive: true }));

  test('runs, asks the network for nothing, and ends by itself', () => {
    const program = `
      import { syncBuiltinESMExports } from 'node:module';
      import net from 'node:net';
      import dns from 'node:dns';
      const asked = () => { throw new Error('the network was asked'); };
      globalThis.fetch = net.Socket.prototype.connect = dns.lookup = asked;
      syncBuiltinESMExports();
      const { load, loadWorker } = await import('bankshot');
      const engines = [await load(), await loadWorker()];
      const answers = await Promise.all(engines.map((e) => e.solve(${JSON.stringify(bank)}, { noTiming: true })));
      console.log(JSON.stringify(answers));`;
    const answers = JSON.parse(execFileSync('node', ['--input-type=module', '-e', program], { ...at, timeout: 60000 }));
    for (const answer of answers) same(JSON.parse(run(['solve', '--json', '--no-timing'], bank)), answer);
    assert.equal(answers.length, 2);
  });

  test('has types that are those of the schema, of all that the engine gives and takes', async () => {
    const engine = await load();
    const typed = [];
    const says = (type, value) => typed.push(`const _${typed.length}: b.${type} = ${JSON.stringify(value)};`);
    for (const puzzle of Object.values(examples)) {
      says('Puzzle', puzzle);
      says('Answer', engine.solveAll(puzzle, { path: true, sensitivity: true }));
      for (const shot of engine.solve(puzzle).shots) {
        says('Shot', { ...puzzle, shot });
        says('Trajectory', engine.simulate({ ...puzzle, shot }));
      }
    }
    says('NamedTable[]', engine.tables());
    const launches = engine.launches(bank, { angle: [0, 90], speed: [1, 3], grid: [4, 3] });
    says('LaunchMap', launches);
    assert.ok(typed.length > 40);
    copyFileSync(join(here, 'types.ts'), join(project, 'types.ts'));
    writeFileSync(
      join(project, 'given.ts'),
      ["import type * as b from 'bankshot';", ...typed, 'export {};'].join('\n'),
    );
    symlinkSync(join(here, 'node_modules/typescript'), join(project, 'node_modules/typescript'));
    const options = ['--noEmit', '--strict', '--module', 'nodenext', '--target', 'es2022', '--lib', 'es2022,dom'];
    const said = (files) => {
      try {
        return execFileSync('node', ['node_modules/typescript/bin/tsc', ...options, ...files], at);
      } catch (error) {
        return error.stdout;
      }
    };
    assert.equal(said(['types.ts', 'given.ts']), '');
  });

  test('every flag that has a type is one of the engine', async () => {
    const engine = await load();
    const declared = readFileSync(join(installed, 'index.d.ts'), 'utf8');
    const keys = (name) => {
      const body = declared.split(`interface ${name} {`)[1].split('\n}')[0];
      return [...body.matchAll(/^ {2}(\w+)\??:/gm)].map(([, key]) => key);
    };
    // A place has a value where a ball is to be potted.
    const asked = { solve: bank, map: examples['first-shot.json'], launches: bank };
    const needed = { solve: {}, map: { grid: [3, 2] }, launches: { angle: [0, 90], speed: [1, 2] } };
    const values = {
      planner: 'auto',
      budget: 1000,
      depth: 2,
      plies: 2,
      noise: 'pro',
      grid: [3, 2],
      angle: [0, 90],
      speed: [1, 2],
    };
    const flags = { solve: keys('SolveFlags'), map: keys('MapFlags'), launches: keys('LaunchFlags') };
    for (const [name, all] of Object.entries(flags))
      for (const key of all) {
        assert.ok(engine[name](asked[name], { ...needed[name], [key]: values[key] ?? true }), `${name}: ${key}`);
      }
    assert.deepEqual(
      Object.values(flags).map((all) => all.length),
      [11, 5, 3],
    );
  });

  test('is what a bundler takes for a browser', () => {
    const out = join(project, 'bundle.js');
    writeFileSync(join(project, 'entry.js'), "import { load } from 'bankshot'; load();");
    const options = ['--bundle', '--format=esm', '--platform=browser', '--log-level=warning', `--outfile=${out}`];
    execFileSync('esbuild', ['entry.js', ...options], at);
    assert.match(readFileSync(out, 'utf8'), /new URL\("\.\/bankshot\.wasm", import\.meta\.url\)/);
  });
});

describe('the npm package in Chromium', { skip: !isBuilt, timeout: 600000 }, () => {
  const types = { js: 'text/javascript', wasm: 'application/wasm', html: 'text/html' };
  const server = createServer((request, reply) => {
    const name = new URL(request.url, 'http://localhost').pathname.slice(1);
    const type = types[name.split('.').pop()] ?? 'text/html';
    const policy = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'; worker-src 'self'";
    reply.writeHead(200, { 'Content-Type': type, 'Content-Security-Policy': policy });
    const own = "import { load } from '/index.js'; load().then((e) => postMessage(e.version()));";
    if (name === 'own.js') reply.end(own);
    else reply.end(name.includes('.') ? readFileSync(folder + name) : '<!doctype html><link rel="icon" href="data:,">');
  });
  let browser, page, asked;
  before(async () => {
    await new Promise((done) => server.listen(0, '127.0.0.1', () => done()));
    browser = await launch();
    page = await browser.newPage();
    asked = [];
    page.context().on('request', (request) => asked.push(new URL(request.url()).pathname));
    await page.goto(`http://127.0.0.1:${/** @type {any} */ (server.address()).port}/`);
  });
  after(async () => {
    await browser.close();
    server.close();
  });

  for (const way of ['load', 'loadWorker'])
    test(`${way} answers as the program does`, async () => {
      const answers = await page.evaluate(
        async ([way, puzzles, plain]) => {
          const bankshot = await import(/** @type {any} */ ('/index.js'));
          const engine = await bankshot[way]();
          const answers = [];
          for (const puzzle of puzzles) answers.push(await engine.solve(puzzle, plain));
          return answers;
        },
        [way, Object.values(examples), plain],
      );
      for (const [name, puzzle] of Object.entries(examples))
        same(JSON.parse(run(['solve', '--json', '--no-timing'], puzzle)), answers.shift(), name);
      const loaded = { load: ['/index.js', '/bankshot.wasm'], loadWorker: ['/worker.js'] };
      assert.deepEqual(
        asked.splice(0).filter((path) => path !== '/'),
        loaded[way],
      );
    });

  test('errors have their path, what is aborted makes room, several stand side by side', async () => {
    const said = await page.evaluate(
      async ([bank, endless]) => {
        const { load, loadWorker } = await import(/** @type {any} */ ('/index.js'));
        const engines = await Promise.all([load(), loadWorker(), loadWorker()]);
        const wrong = await engines[1].solve({ ...bank, table: 'no' }).catch((error) => [error.name, error.path]);
        const stop = new AbortController();
        const map = engines[1].map(endless, { grid: [200, 200], signal: stop.signal });
        setTimeout(() => stop.abort(), 10);
        const aborted = await map.catch(({ name }) => name);
        const answers = await Promise.all(engines.map((engine) => engine.solve(bank, { noTiming: true })));
        return { wrong, aborted, answers: answers.map((answer) => JSON.stringify(answer)) };
      },
      [bank, endless],
    );
    assert.deepEqual(said.wrong, ['BankshotError', '/table']);
    assert.equal(said.aborted, 'AbortError');
    assert.equal(said.answers.length, 3);
    assert.equal(new Set(said.answers).size, 1);
    assert.deepEqual(asked.splice(0), ['/worker.js', '/worker.js', '/worker.js']);
  });

  test('a worker of one’s own loads it', async () => {
    const said = () =>
      new Promise((done) => (new Worker('/own.js', { type: 'module' }).onmessage = ({ data }) => done(data)));
    assert.equal(await page.evaluate(said), JSON.parse(readFileSync(`${folder}package.json`, 'utf8')).version);
    assert.deepEqual(asked.splice(0), ['/own.js', '/index.js', '/bankshot.wasm']);
  });
});
