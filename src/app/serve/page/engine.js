// Asks the engine: the server that gave this page, or the engine inside the page's own file.
// Only the newest question of each kind is answered.

/** This page's name: at the server its newer requests end its older ones of the same kind. */
const page = Math.random().toString(36).slice(2);

/** @type {Map<string, AbortController>} */
const asking = new Map();

async function atServer(path, body, kind, signal) {
  const reply = await fetch('/api/' + path, {
    method: body ? 'POST' : 'GET',
    headers: body ? { 'Content-Type': 'application/json', 'Bankshot-Page': page + kind } : {},
    body,
    signal,
  });
  return { ok: reply.ok, text: await reply.text() };
}

let send = atServer;
/** Replaces the server by another engine. @param {typeof atServer} engine */
export const answerBy = (engine) => (send = engine);

const invalid = (error) => ({ status: 'invalid', error, shots: [] });

/** Time to wait before asking a lost engine again: longer each time, up to the last [ms]. */
const pauses = [500, 1000, 2000, 4000, 8000];

let lost = 0; // number of questions whose engine does not answer
/** @type {(lost: boolean) => void} */
let tell = () => {};
/** Has the page told when the engine is lost, and when it is back. @param {(lost: boolean) => void} f */
export const onLost = (f) => (tell = f);

function count(by) {
  const before = lost;
  lost += by;
  if (Boolean(before) !== Boolean(lost)) tell(Boolean(lost));
}

/** Waits, unless the question is withdrawn. @param {AbortSignal} signal */
const wait = (ms, signal) =>
  new Promise((done) => {
    setTimeout(done, ms);
    signal.addEventListener('abort', done, { once: true });
  });

/** Passes every error but that of `fetch` if it cannot reach the server, and that of a withdrawn question. */
function unreached(error) {
  if (!(error instanceof TypeError) && error.name !== 'AbortError') throw error;
  return null;
}

/** Sends a question until the engine answers or the question is withdrawn. @returns {Promise<any>} null if withdrawn */
async function answerTo(path, json, kind, signal) {
  let missed = 0; // times that the engine did not answer
  try {
    while (!signal.aborted) {
      const answer = await send(path, json, kind, signal).catch(unreached);
      if (answer) return answer;
      if (signal.aborted) break;
      if (!missed++) count(1);
      await wait(pauses[Math.min(missed, pauses.length) - 1], signal);
    }
    return null;
  } finally {
    if (missed) count(-1);
  }
}

/**
 * @param {string} path under /api, with flags: "solve?all&path"
 * @param {object} [body] posted as JSON
 * @param {string} [kind] kind of question; only the newest of a kind counts
 * @returns {Promise<any>} the answer, as text if it is not JSON; null if a newer question replaced it
 */
export async function ask(path, body, kind = path) {
  asking.get(kind)?.abort();
  const mine = new AbortController();
  asking.set(kind, mine);
  try {
    const answer = await answerTo(path, body && JSON.stringify(body), kind, mine.signal);
    if (!answer || mine.signal.aborted) return null;
    if (!answer.ok) return invalid(JSON.parse(answer.text));
    return /^\s*[[{]/.test(answer.text) ? JSON.parse(answer.text) : answer.text;
  } catch (error) {
    if (mine.signal.aborted) return null;
    return invalid({ path: '', reason: 'the engine does not answer: ' + error });
  }
}

/**
 * Lets each search end before the next begins, since moves come faster than answers.
 * @param {() => Promise<void>} search reads the question when it begins
 * @returns {() => Promise<void>} calls `search`, or has it called once more when the running one ends
 */
export function latest(search) {
  let [running, again] = [false, false];
  return async function begin() {
    again = running;
    if (running) return;
    running = true;
    await search().finally(() => (running = false));
    if (again) begin();
  };
}

/** Ends a question whose answer nobody needs any longer. @param {string} kind */
export function forget(kind) {
  asking.get(kind)?.abort();
}
