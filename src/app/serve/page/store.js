// What this browser keeps for the page. A browser may keep nothing: what is kept then holds for this visit at most.

/** Returns what is kept under a key, or something else if nothing is. @template T @param {string} key @param {T} other @returns {T} */
export function kept(key, other) {
  try {
    return JSON.parse(localStorage.getItem(key) ?? 'null') ?? other;
  } catch {
    return other;
  }
}

/** @param {string} key @param {any} value @returns {boolean} whether it is kept */
export function keep(key, value) {
  try {
    localStorage.setItem(key, JSON.stringify(value));
    return true;
  } catch {
    return false;
  }
}
