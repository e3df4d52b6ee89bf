// The engine inside the page's own file: WebAssembly in workers, so that the page never waits.

const code = document.getElementById('engine-worker');
const bytes = document.getElementById('engine-bytes'); // gzip, base64

export const isHere = code !== null;

const patience = 60; // ms for an answer that nobody waits for; then its worker ends
const longest = 10000; // ms for any other, as the server has it

/** @type {Promise<WebAssembly.Module>} compiled once, for all workers */
let compiled;
/** @typedef {{worker: Worker, busy: Promise<void> | null, signal: AbortSignal | null, release: () => void}} Desk */
/** @type {Map<string, Desk>} one for each kind of work */
const desks = new Map();

async function compile() {
  const packed = Uint8Array.from(atob(bytes.textContent.trim()), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}

/** @param {string} work @param {WebAssembly.Module} module @returns {Desk} */
function begin(work, module) {
  const url = URL.createObjectURL(new Blob([code.textContent], { type: 'text/javascript' }));
  const desk = { worker: new Worker(url), busy: null, signal: null, release: null };
  URL.revokeObjectURL(url);
  desks.set(work, desk);
  desk.worker.postMessage({ module });
  return desk;
}

function end(work) {
  desks.get(work)?.worker.terminate();
  desks.delete(work);
}

const after = (ms) => new Promise((done) => setTimeout(done, ms));

/** @param {Desk} desk @param {AbortSignal} signal */
function take(desk, signal) {
  desk.signal = signal;
  desk.busy = new Promise((done) => {
    desk.release = () => {
      desk.busy = null;
      done();
    };
  });
  return desk;
}

/** A desk that is free: in turn, but what nobody waits for makes room. */
async function free(work, module, signal) {
  for (;;) {
    signal.throwIfAborted();
    const desk = desks.get(work) ?? begin(work, module);
    if (!desk.busy) return take(desk, signal);
    const { busy } = desk;
    const dropped = desk.signal.aborted;
    await Promise.race(dropped ? [busy, after(patience)] : [busy, whenAborted(desk.signal)]);
    if (dropped && desk.busy === busy && desks.get(work) === desk) end(work);
  }
}

/** @param {string} path @param {string} body @param {AbortSignal} signal */
export async function send(path, body, signal) {
  const module = await (compiled ??= compile());
  const work = path.split('?')[0] + (path.includes('first') ? ' first' : '');
  const desk = await free(work, module, signal);
  const [name, query = ''] = path.split('?');
  const flags = [...new URLSearchParams(query)].map(([k, v]) => `${k}=${v}\n`).join('');
  const answer = new Promise((done, fail) => {
    desk.worker.onmessage = ({ data }) => done(data);
    desk.worker.onerror = (event) => fail(new Error(event.message));
  });
  const { busy } = desk;
  const leave = (broken) => {
    if (desk.busy !== busy) return;
    if (broken && desks.get(work) === desk) end(work);
    desk.release();
  };
  answer.then(
    () => leave(false),
    () => leave(true),
  );
  desk.worker.postMessage({ name, flags, body: body ?? '' });
  const late = after(longest).then(() => {
    leave(true);
    return { ok: false, text: JSON.stringify({ path: '', reason: `the time limit of ${longest / 1000} s ended it` }) };
  });
  return Promise.race([answer, late, whenAborted(signal).then(() => signal.throwIfAborted())]);
}

/** @param {AbortSignal} signal */
function whenAborted(signal) {
  return new Promise((done) => signal.addEventListener('abort', done, { once: true }));
}
