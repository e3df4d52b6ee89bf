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
    const json = body && JSON.stringify(body);
    const { ok, text } = await send(path, json, kind, mine.signal);
    if (mine.signal.aborted) return null;
    if (!ok) return invalid(JSON.parse(text));
    return /^\s*[[{]/.test(text) ? JSON.parse(text) : text;
  } catch (error) {
    if (mine.signal.aborted) return null;
    return invalid({
      path: '',
      reason: 'the engine does not answer: ' + error,
    });
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
