// Asks the engine. The newest question of a kind is the only one that is answered.

/** One a page: a newer request ends the older ones at the server, too. */
const page = Math.random().toString(36).slice(2);

/** @type {Map<string, AbortController>} */
const asking = new Map();

/**
 * @param {string} path under /api
 * @param {object} [body] posted as JSON; without, GET
 * @param {string} [kind] of which only the newest counts
 * @returns {Promise<any>} null where a newer one took its place
 */
export async function ask(path, body, kind = path) {
  asking.get(kind)?.abort();
  const mine = new AbortController();
  asking.set(kind, mine);
  try {
    const reply = await fetch('/api/' + path, {
      method: body ? 'POST' : 'GET',
      headers: body ? { 'Content-Type': 'application/json', 'Bankshot-Page': page + kind } : {},
      body: body && JSON.stringify(body),
      signal: mine.signal,
    });
    const said = await reply.json();
    if (asking.get(kind) !== mine) return null;
    return reply.ok ? said : { status: 'invalid', error: said, shots: [] };
  } catch (error) {
    if (mine.signal.aborted) return null;
    return { status: 'invalid', error: { path: '', reason: 'the engine does not answer: ' + error }, shots: [] };
  }
}
