// Places of balls on a table: kept inside, kept apart, and carried over to another table.
import { set } from './balls.js';

/** @typedef {[number, number]} Point in metres */
/** @typedef {import('./table.js').Table} Table */

/** Returns the snap distances: half a diamond each way. @param {Table} table @returns {Point} */
export const snaps = (table) => [table.length / 16, table.width / 8];

const places = 1e5; // per metre, to which coordinates are rounded

/**
 * Moves a point inside the table, at least a ball's radius from each cushion.
 * @param {Table} table
 * @returns {Point}
 */
export function inside(table, [x, y], snap = false) {
  const r = table.radius;
  const to = (v, step) => (snap ? Math.round(v / step) * step : v);
  const clamp = (v, most) =>
    Math.min(Math.max(Math.round(v * places), Math.ceil(r * places)), Math.floor((most - r) * places)) / places;
  const [dx, dy] = snaps(table);
  return [clamp(to(x, dx), table.length), clamp(to(y, dy), table.width)];
}

/**
 * Returns a point as it is, or moved inside if it is outside: balls that touch stay where they are.
 * @param {Table} table
 * @param {Point} at
 */
export function within(table, [x, y]) {
  const r = table.radius;
  const fits = x >= r && x <= table.length - r && y >= r && y <= table.width - r;
  return fits ? /** @type {Point} */ ([x, y]) : inside(table, [x, y]);
}

/**
 * Finds a place without a ball; null if the table is full.
 * @param {Table} table
 * @param {Point[]} balls
 */
export function free(table, balls) {
  const clear = (at) => balls.every(([x, y]) => Math.hypot(x - at[0], y - at[1]) > 2 * table.radius);
  for (let k = 1; k < 1000; ++k) {
    // These two factors fill a square evenly.
    const at = inside(table, [table.length * ((0.7549 * k) % 1), table.width * ((0.5698 * k) % 1)]);
    if (clear(at)) return at;
  }
  return null;
}

const turns = 300;

/**
 * Moves two balls apart if they overlap.
 * @param {Table} table
 * @param {Point[]} all changed in place
 * @param {number} held the ball that does not give way
 * @returns {boolean} whether they overlapped
 */
function part(table, all, i, j, held) {
  const [touch, gap] = [2 * table.radius + 1e-6, 2 * table.radius + 1e-4]; // a place is rounded to 1e-5 m
  const [dx, dy] = [all[j][0] - all[i][0], all[j][1] - all[i][1]];
  const d = Math.hypot(dx, dy);
  if (d >= touch) return false;
  // Two balls at one place part along a direction of their own, so that a heap spreads.
  const [ux, uy] = d > 1e-6 ? [dx / d, dy / d] : [Math.cos(j), Math.sin(j)];
  const give = (k, by) => (all[k] = inside(table, [all[k][0] + by * ux, all[k][1] + by * uy]));
  const share = i === held ? 0 : j === held ? 1 : 0.5;
  give(i, -share * (gap - d));
  give(j, (1 - share) * (gap - d));
  return true;
}

/**
 * Pushes balls apart that overlap.
 * @param {Table} table
 * @param {Point[]} balls
 * @param {number} [held] the ball that pushes and does not give way
 * @returns {Point[] | null} null if there is no room
 */
export function apart(table, balls, held = -1) {
  const all = balls.slice();
  for (let turn = 0; turn < turns; ++turn) {
    let moved = false;
    for (let i = 0; i < all.length; ++i)
      for (let j = i + 1; j < all.length; ++j) moved = part(table, all, i, j, held) || moved;
    if (!moved) return all;
  }
  return null;
}

/** @typedef {{table: string, ball: Point, others: Point[], names: string[], point: Point, zone: number[]}} Places */

/** Returns the places of a scene. @param {any} scene @returns {Places} */
const placesOf = ({ table, ball, others, names, point, zone }) =>
  structuredClone({ table, ball, others, names, point, zone });

/** Returns names of a table's own set, and numbers where it has too few. @param {Table} table */
const named = (table, count) => Array.from({ length: count }, (_, i) => set(table)[i] ?? String(i + 1));

/** The places as they were laid by hand, and as the last change of the table left them. */
let laid = null;
let carried = '';

/**
 * Carries the scene over to another table, by diamonds. Back on its own table it is as it was laid.
 * @param {any} scene changed in place
 * @param {Table} from
 * @param {Table} to
 */
export function carry(scene, from, to) {
  if (JSON.stringify(placesOf({ ...scene, table: from.name })) !== carried)
    laid = { ...placesOf(scene), table: from.name, from, game: scene.game };
  const [sx, sy] = [to.length / laid.from.length, to.width / laid.from.width];
  const put = (/** @type {Point} */ [x, y]) =>
    /** @type {Point} */ (to.name === laid.table ? [x, y] : inside(to, [x * sx, y * sy]));
  scene.table = to.name;
  scene.point = put(laid.point);
  scene.names = to.name === laid.table || set(to) === set(laid.from) ? laid.names : named(to, laid.others.length);
  if (scene.names === laid.names) scene.game = laid.game;
  if (laid.zone.length) scene.zone = [...put(laid.zone), laid.zone[2]];
  /** @type {Point[]} */
  const balls = [laid.ball, ...laid.others].map(put);
  [scene.ball, ...scene.others] = to.name === laid.table ? balls : (apart(to, balls) ?? balls);
  carried = JSON.stringify(placesOf(scene));
}
