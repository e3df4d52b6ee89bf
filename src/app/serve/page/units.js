// Places and lengths in words: millimetres or inches, and diamonds.
import { keep, kept } from './store.js';

export let inches = kept('inches', false);

/** @param {boolean} on */
export function useInches(on) {
  inches = on;
  keep('inches', on);
}

/** Returns the direction from one place to another, in degrees. */
export const angleTo = ([x0, y0], [x1, y1]) => (Math.atan2(y1 - y0, x1 - x0) * 180) / Math.PI;

/** Returns the same direction, from 0 to 360. @param {number} degrees */
export const wrapped = (degrees) => ((degrees % 360) + 360) % 360;

/** @param {number} metres */
export function length(metres) {
  if (inches) return (metres / 0.0254).toFixed(2) + ' in';
  return Math.abs(metres) < 1 ? (metres * 1000).toFixed(1) + ' mm' : metres.toFixed(3) + ' m';
}

/** Rails and pockets of a table that stands on its left end, as they are seen. */
const seen = { top: 'left', left: 'bottom', bottom: 'right', right: 'top' };

let turned = false;
/** @param {boolean} is the table stands on its left end */
export const turn = (is) => (turned = is);

/** Names a rail or a pocket as it is seen: "top-right". @param {string} name */
export function side(name) {
  if (!turned) return name;
  const [first, second] = name.split('-');
  if (!seen[first]) return name;
  if (!second) return seen[first];
  return second === 'middle' ? `${seen[first]}-middle` : `${seen[second]}-${seen[first]}`;
}

/** Returns a distance as a player paces it. @param {number} metres */
export function distance(metres) {
  if (inches) return `${Math.round(metres / 0.0254)} in`;
  return metres < 1 ? `${Math.round(100 * metres)} cm` : `${metres.toFixed(2)} m`;
}

const tip = 0.012; // m: width of a cue's tip
const quarters = ['', '¼', '½', '¾'];

/** Returns an offset from the ball's centre in widths of the tip. @param {number} metres */
export function tips(metres) {
  const count = Math.max(1, Math.round((4 * metres) / tip));
  const whole = Math.floor(count / 4);
  return `${whole || ''}${quarters[count % 4]} ${count > 4 ? 'tips' : 'tip'}`;
}

const [mile, kilometre] = [0.44704, 1 / 3.6]; // an hour, in m/s

/** D. Alciatore's names of speeds, as the program has them, and the speeds below which they hold [mph]. */
const paces = /** @type {[number, string][]} */ ([
  [1, 'soft touch'],
  [2, 'slow'],
  [4, 'medium'],
  [7, 'fast'],
  [10, 'power shot'],
  [25, 'harder than a power shot'],
  [Infinity, 'powerful break'],
]);

/** Returns a speed in the player's unit. @param {number} v in m/s */
export const speed = (v) => (inches ? `${(v / mile).toFixed(1)} mph` : `${v.toFixed(2)} m/s`);

/** Says how hard a shot is played. @param {number} v in m/s */
export function pace(v) {
  const mph = v / mile;
  const hour = inches ? '' : `, ${(v / kilometre).toFixed(1)} km/h`;
  return `${paces.find(([up]) => mph < up)[1]}: ${speed(v)}${hour}`;
}

/** @param {[number, number]} at @param {{length: number, width: number}} table */
export function place([x, y], table) {
  const across = ((x / table.length) * 8).toFixed(2);
  const up = ((y / table.width) * 4).toFixed(2);
  return `${length(x)}, ${length(y)} · ${across} of 8 diamonds, ${up} of 4`;
}
