// Measures the npm package's size, and its times in Node beside the program's: node engine_timing.mjs > javascript.csv
// All times are medians. The column `search` is `time_us`, the time of `solve` in C++. The column `call` is a whole
// call: text in, search, text out, parsed.
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { examples, folder, load, loadWorker, run } from './engine.mjs';

const starts = 20;
const calls = 2000;
const names = ['corner-pocket', 'three-cushions', 'two-cushion-bank', 'kick', 'combination'];
const flags = { noRobustness: true };

const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];
const row = (figure, puzzle, unit, value) => console.log([figure, puzzle, unit, value].join());

/** Times a script in a Node process of its own [ms]. @param {string} script prints the time */
const started = (script) =>
  median(
    Array.from({ length: starts }, () =>
      Number(
        execFileSync('node', ['--input-type=module', '-e', script.replace('PACKAGE', `${folder}index.js`)], {
          encoding: 'utf8',
        }),
      ),
    ),
  ).toFixed(1);

const timed = (what, ends) =>
  `const begin = performance.now(); const { ${what} } = await import('PACKAGE'); const engine = await ${what}();
   ${ends}; console.log(performance.now() - begin); engine.end?.();`;
const solve = (puzzle) => `await engine.solve(${JSON.stringify(puzzle)}, { noRobustness: true })`;

async function times(engine, puzzle) {
  const all = { search: [], call: [] };
  for (let i = 0; i < calls; ++i) {
    const begin = performance.now();
    const answer = await engine.solve(puzzle, flags);
    all.call.push(1000 * (performance.now() - begin));
    all.search.push(answer.time_us);
  }
  return { search: median(all.search.slice(calls / 4)), call: median(all.call.slice(calls / 4)) }; // compiled by then
}

row('figure', 'puzzle', 'unit', 'value');
const wasm = readFileSync(`${folder}bankshot.wasm`);
row('size of bankshot.wasm', '', 'bytes', wasm.length);
row('size of bankshot.wasm gzip -9', '', 'bytes', gzipSync(wasm, { level: 9 }).length);
for (const name of ['index.js', 'worker.js']) row(`size of ${name}`, '', 'bytes', readFileSync(folder + name).length);
for (const what of ['load', 'loadWorker']) {
  row(what, '', 'ms', started(timed(what, '')));
  row(`${what} and the first solve`, names[2], 'ms', started(timed(what, solve(examples[`${names[2]}.json`]))));
}
const [here, worker] = [await load(), await loadWorker()];
for (const name of names) {
  const puzzle = examples[`${name}.json`];
  const lines = `${JSON.stringify(puzzle)}\n`.repeat(calls);
  const native = run(['batch', '-', '-j', '1', '--quiet', '--no-robustness'], lines).trim().split('\n');
  row('search of the program', name, 'us', median(native.map((line) => JSON.parse(line).time_us)).toFixed(1));
  const [own, other] = [await times(here, puzzle), await times(worker, puzzle)];
  row('search of the engine', name, 'us', own.search.toFixed(1));
  row('call in this thread', name, 'us', own.call.toFixed(1));
  row('call in a worker', name, 'us', other.call.toFixed(1));
}
worker.end();
