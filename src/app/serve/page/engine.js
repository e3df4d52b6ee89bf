// Asks the engine, whichever is there: the server that gave this page, or the one inside its file.
// The newest question of a kind is the only one that is answered.

/** One a page: at the server a newer request ends the older ones of its kind. */
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
/** Another engine than the server's. @param {typeof atServer} engine */
export const answerBy = (engine) => (send = engine);

const invalid = (error) => ({ status: 'invalid', error, shots: [] });

/**
 * @param {string} path under /api, with flags: "solve?all&path"
 * @param {object} [body] posted as JSON
 * @param {string} [kind] of which only the newest counts
 * @returns {Promise<any>} what it says, text where it is no JSON; null where a newer question took its place
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
 * Lets a search end before the next begins, as moves come faster than answers.
 * @param {() => Promise<void>} search reads what is asked when it begins
 * @returns {() => Promise<void>} calls it, or has it called once more when the running one ends
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

/** Nobody waits for it any longer. @param {string} kind */
export function forget(kind) {
  asking.get(kind)?.abort();
}
