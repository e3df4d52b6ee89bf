// SPDX-License-Identifier: MIT
//
// bankshot in JavaScript: documents in, documents out, with an engine in this thread (`load`) or in a worker
// (`loadWorker`). index.d.ts documents the functions.
import { builtin } from './builtin.js';
import { Desk } from './desk.js';
import { instantiate } from './instance.js';

/** An error in a document or a flag. */
export class BankshotError extends Error {
  constructor({ path, reason }) {
    super(path ? `${path}: ${reason}` : reason);
    this.name = 'BankshotError';
    this.path = path;
    this.reason = reason;
  }
}

/** Converts flags to command-line form: {noTiming: true, grid: [40, 20]} is --no-timing --grid=40,20. */
function typed(flags) {
  const given = Object.entries(flags).filter(([, value]) => value !== undefined && value !== false);
  const dashed = (name) => name.replace(/[A-Z]/g, (letter) => '-' + letter.toLowerCase());
  return given.map(([name, value]) => `${dashed(name)}=${value === true ? '' : value}\n`).join('');
}

function read({ ok, text }) {
  if (!ok) throw new BankshotError(JSON.parse(text));
  return /^[[{]/.test(text) ? JSON.parse(text) : text;
}

/** Returns the public functions on top of `ask`, which returns a result or a promise of it. */
function functions(ask) {
  const call = (name, document, options = {}) => {
    const { signal, ...flags } = options;
    const body = typeof document === 'string' ? document : (JSON.stringify(document) ?? '');
    return ask({ name, flags: typed(flags), body }, signal);
  };
  return {
    solve: (puzzle, flags) => call('solve', puzzle, flags),
    solveAll: (puzzle, flags) => call('solve', puzzle, { ...flags, all: true }),
    simulate: (shot, flags) => call('simulate', shot, flags),
    map: (puzzle, flags) => call('map', puzzle, flags),
    launches: (puzzle, flags) => call('launches', puzzle, flags),
    schema: (document = 'puzzle', options) => call('schema', '', { ...options, document }),
    tables: (options) => call('tables', '', options),
    version: (options) => call('version', '', options),
  };
}

async function compile(url) {
  if (url.protocol === 'file:') return WebAssembly.compile(await (await builtin('fs/promises')).readFile(url));
  const reply = await fetch(url);
  if (!reply.ok) throw new Error(`${url}: ${reply.status} ${reply.statusText}`);
  if (reply.headers.get('Content-Type') === 'application/wasm') return WebAssembly.compileStreaming(reply);
  return WebAssembly.compile(await reply.arrayBuffer());
}

/** @type {Map<string, Promise<WebAssembly.Module>>} by address, shared by all engines */
const compiled = new Map();

/** @typedef {{module?: WebAssembly.Module, locateFile?: (name: string) => string | URL}} Options */

/** @param {Options} options @returns {WebAssembly.Module | Promise<WebAssembly.Module>} */
function moduleOf({ module, locateFile }) {
  if (module) return module;
  // Bundlers recognise this form of URL.
  const url = locateFile
    ? new URL(locateFile('bankshot.wasm'), import.meta.url)
    : new URL('./bankshot.wasm', import.meta.url);
  if (!compiled.has(url.href)) compiled.set(url.href, compile(url));
  const found = compiled.get(url.href);
  found.catch(() => compiled.delete(url.href)); // allows another attempt
  return found;
}

/** Returns Node's Worker with the interface of a browser's. @returns {Promise<any>} */
async function nodeWorker() {
  const { Worker } = await builtin('worker_threads');
  return class extends Worker {
    constructor(url) {
      super(url, { execArgv: [] }); // options such as --input-type do not apply to the worker
      this.on('message', (data) => this.onmessage?.({ data }));
      this.on('error', (error) => this.onerror?.(error));
    }
  };
}

/** @param {Options} options */
export async function load(options = {}) {
  const answer = await instantiate(await moduleOf(options));
  return functions((question, signal) => {
    signal?.throwIfAborted();
    return read(answer(question));
  });
}

/** @param {Options} options */
export async function loadWorker(options = {}) {
  const { locateFile } = options;
  const module = await moduleOf(options);
  const Worker = globalThis.Worker ?? (await nodeWorker());
  const url = locateFile ? new URL(locateFile('worker.js'), import.meta.url) : new URL('./worker.js', import.meta.url);
  const desk = new Desk(() => new Worker(url), module);
  return { ...functions((question, signal) => desk.ask(question, signal).then(read)), end: () => desk.end() };
}
