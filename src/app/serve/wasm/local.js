// The engine inside the page's own file: WebAssembly in workers, so that the page never blocks.
import { Desk } from '../../../../bindings/javascript/desk.js';
import { answerBy } from '../page/engine.js';

const longest = 10000; // ms; the time limit of an answer, as at the server
const code = document.getElementById('engine-worker').textContent;
const bytes = document.getElementById('engine-bytes').textContent; // gzip, base64

const url = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
const module = compile();
/** @type {Map<string, Desk>} one desk for each kind of work */
const desks = new Map();

async function compile() {
  const packed = Uint8Array.from(atob(bytes.trim()), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}

async function deskFor(work) {
  const compiled = await module;
  if (!desks.has(work)) desks.set(work, new Desk(() => new Worker(url), compiled));
  return desks.get(work);
}

answerBy(async (path, body, kind, signal) => {
  const [name, query = ''] = path.split('?');
  const flags = [...new URLSearchParams(query)].map(([k, v]) => `${k}=${v}\n`).join('');
  const work = name === 'schema' ? 'tables' : name; // the page asks for both at once, as it opens
  const desk = await deskFor(work + (path.includes('first') ? ' first' : ''));
  const limit = AbortSignal.timeout(longest);
  try {
    return await desk.ask({ name, flags, body: body ?? '' }, AbortSignal.any([signal, limit]));
  } catch (error) {
    if (signal.aborted || !limit.aborted) throw error;
    return { ok: false, text: JSON.stringify({ path: '', reason: `the time limit of ${longest / 1000} s ended it` }) };
  }
});
