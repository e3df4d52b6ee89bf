// Balls by name: their colours, and the sets of which the tray offers one for each table.

const numbered = ['#f2c230', '#2455c3', '#d3252c', '#5f3391', '#ee7d1d', '#117a4a', '#8a2232', '#1b1b1d'];
const named = {
  red: '#b3131b',
  yellow: '#f0cc2e',
  green: '#12704a',
  brown: '#7b4a22',
  blue: '#2563c9',
  pink: '#f093b0',
  black: '#1b1b1d',
};
const pale = ['#f2c230', '#ee7d1d', '#f0cc2e', '#f093b0'];
const plain = '#c9a227';

const upTo = (n) => Array.from({ length: n }, (_, i) => String(i + 1));
const pool = upTo(15);
const snooker = [...upTo(15).map((i) => 'red' + i), 'yellow', 'green', 'brown', 'blue', 'pink', 'black'];
const carom = ['red', 'yellow'];

/** Returns the names of the balls that belong to a table. @param {{name: string}} table */
export function set({ name }) {
  return name.startsWith('snooker') ? snooker : name.startsWith('carom') ? carom : pool;
}

/**
 * Returns how a ball looks.
 * @param {string} name
 * @returns {{fill: string, band: string, ink: string, digit: string}} `band`: the colour of its stripe, if it has one;
 *   `digit`: what is written on it, if anything
 */
export function look(name) {
  const number = /^\d+$/.test(name) ? Number(name) : 0;
  const known = number >= 1 && number <= 15 ? numbered[(number - 1) % 8] : named[name.replace(/\d+$/, '')];
  const colour = known ?? plain;
  const ink = pale.includes(colour) || colour === plain ? '#1b1b1d' : '#ffffff';
  const stripe = number > 8 && number < 16;
  return { fill: stripe ? '#f7f5ee' : colour, band: stripe ? colour : '', ink, digit: number ? name : '' };
}

/** Returns the outline of a stripe around the middle of a ball. @param {number} radius */
export function band(radius) {
  const [x, y] = [0.8 * radius, 0.6 * radius]; // where it ends on the edge
  const round = `A${radius} ${radius} 0 0 1 `;
  return `M${-x} ${-y}L${x} ${-y}${round}${x} ${y}L${-x} ${y}${round}${-x} ${-y}Z`;
}

/** Names a ball in a sentence. @param {string} name */
export function called(name) {
  if (/^red\d+$/.test(name)) return 'a red';
  return /^\d/.test(name) || named[name] ? `the ${name}` : `ball ${name}`;
}

/** Returns the first name of the table's set that no ball has. @param {{name: string}} table @param {string[]} names */
export function freeName(table, names) {
  const known = set(table).find((name) => !names.includes(name));
  if (known) return known;
  for (let i = 1; ; ++i) if (!names.includes(String(i))) return String(i);
}
