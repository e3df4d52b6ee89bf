// Draws the answer on the table: paths, the line of aim, its margin, where the cue ball stops, and the other shots.
import { metres, shape, sight, upright } from './table.js';

const points = (path) => path.map((p) => p.slice(-2).join()).join(' ');

/** @param {Element} layer @param {any[]} path of [time, x, y] or [x, y] */
function line(layer, path, kind, width) {
  return shape('polyline', { class: 'path ' + kind, points: points(path), 'stroke-width': width }, layer);
}

/** Draws the margin of the aim, as far as the first rail. */
function fan(layer, table, from, shot) {
  const sides = shot.margin?.angle;
  if (!sides || sides.some((v) => v === null)) return;
  const ends = sides.map((v) => sight(table, from, shot.angle + v).at);
  const middle = sight(table, from, shot.angle).at;
  const corners = [from, ends[0], middle, ends[1]].map((p) => p.join()).join(' ');
  shape('polygon', { class: 'fan', points: corners }, layer);
}

/**
 * Returns the place where the cue ball rests or falls; null if it is unknown.
 * @param {import('./table.js').Table} table @returns {[number, number] | null}
 */
function end(table, { path, arrival, hits, pocket, cue_rests }) {
  const into = table.pockets.find(({ name }) => name === cue_rests);
  if (cue_rests) return into ? into.hole : cue_rests;
  return pocket || (!hits && arrival.speed === 0) ? path[path.length - 1].slice(1) : null;
}

/** Radii of the ellipses within which the cue ball stops in half and in nine tenths of plays, in standard deviations. */
const shares = [0.5, 0.9].map((share) => Math.sqrt(-2 * Math.log(1 - share)));

/** Draws where the cue ball stops for this player. */
function ellipses(layer, { leave, spread: own }) {
  const spread = leave?.spread ?? own;
  if (!spread) return;
  const { sigma, angle } = spread;
  const [cx, cy] = spread.at;
  const inside = shape('g', { 'clip-path': 'url(#cloth)' }, layer); // no ball stops on a rail
  for (const k of shares) {
    const [rx, ry] = sigma.map((v) => k * v);
    shape('ellipse', { class: 'spread', cx, cy, rx, ry, transform: `rotate(${angle} ${cx} ${cy})` }, inside);
  }
}

/** Draws the shots that are planned next: from where the cue ball stops to the ball, and on to its pocket. */
function planned(layer, table, places, plan) {
  for (const { ball, pocket, from } of plan?.next ?? []) {
    const at = places.get(ball);
    const into = table.pockets.find(({ name }) => name === pocket);
    if (at && into) line(layer, [from, at, into.hole], 'next', 0.006);
  }
}

/** Draws the line of aim. @param {Element} layer @param {[number, number]} from @param {[number, number]} to */
export function aim(layer, [x1, y1], [x2, y2]) {
  shape('line', { class: 'aim', x1, y1, x2, y2, 'stroke-width': 0.005 }, layer);
}

/** No ball moves after the shot's own paths. */
const rest = { cue: [], others: [] };

const most = 4; // paths beside the shot in view, unless all are asked for

/**
 * @param {SVGGElement} layer emptied first
 * @param {import('./table.js').Table} table
 * @param {any[]} others shots beside the one in view
 * @param {any} shot the one in view
 * @param {{afterwards?: {cue: any[], others: any[][]}, all?: boolean, plan?: any, balls?: Map<string, [number, number]>}} [more]
 *   `afterwards`: paths after those of the shot; `balls`: places by name, for the plan
 */
export function paint(layer, table, others, shot, { afterwards = rest, all = false, plan, balls = new Map() } = {}) {
  layer.replaceChildren();
  beside(layer, others.filter((other) => other !== shot && other.path).slice(0, all ? undefined : most));
  if (!shot?.path) return;
  ellipses(layer, shot);
  planned(layer, table, balls, plan);
  sighted(layer, table, shot);
  for (const path of afterwards.others) line(layer, path, 'after', 0.005);
  line(layer, [...shot.path, ...afterwards.cue], 'best', 0.011);
  for (const path of Object.values(shot.paths ?? {})) line(layer, path, 'sent', 0.008);
  touch(layer, table, shot.contact);
  const at = end(table, shot);
  if (at) ring(layer, at, table.radius, shot.scratch ? 'scratch' : '');
}

/** Draws paths that are not in view: the more, the fainter. */
function beside(layer, shots) {
  const faint = shape('g', { opacity: Math.min(1, 3 / Math.sqrt(1 + shots.length)) }, layer);
  for (const { path } of shots) line(faint, path, '', 0.004);
}

/** Draws the line of aim with its margin, and its count of diamonds. */
function sighted(layer, table, shot) {
  const from = shot.path[0].slice(1); // a ball being dragged may have left it
  fan(layer, table, from, shot);
  const { at, count } = sight(table, from, shot.angle);
  aim(layer, from, at);
  write(layer, 'count', at, metres(layer.ownerSVGElement, 12)).textContent = count;
}

/** Draws the ghost ball: where the cue ball is as it touches the other one. */
function touch(layer, table, contact) {
  if (!contact) return;
  const [cx, cy] = contact.ghost;
  shape('circle', { class: 'touch', cx, cy, r: table.radius, 'stroke-width': 0.004 }, layer);
}

/** Draws a ring at the place where a ball ends. @param {Element} layer */
function ring(layer, [cx, cy], r, kind) {
  shape('circle', { class: `ghost ${kind}`, cx, cy, r, 'stroke-width': 0.004 }, layer);
}

/** @param {any} layer @param {string} kind @param {[number, number]} at @param {number} size [m] */
function write(layer, kind, at, size) {
  return shape('text', { class: kind, 'font-size': size, transform: upright(layer.ownerSVGElement, at) }, layer);
}

const wide = 0.6; // width of a letter, as a share of its size

/**
 * Writes words on the table, where they cover no ball if possible.
 * @param {SVGGElement} layer @param {import('./table.js').Table} table @param {string} words @param {number[][]} balls
 */
export function note(layer, table, words, balls) {
  const turned = Boolean(layer.ownerSVGElement.dataset.turned);
  const [long, across, axis] = turned ? [table.width, table.length, 0] : [table.length, table.width, 1];
  const size = Math.max(long / 40, metres(layer.ownerSVGElement, 13));
  const longest = (0.9 * long) / (wide * size);
  const lines = [''];
  for (const word of words.split(' ')) {
    const last = lines[lines.length - 1];
    if ((last + word).length > longest) lines.push(word);
    else lines[lines.length - 1] = `${last} ${word}`.trim();
  }
  const high = 1.3 * size * (lines.length - 1);
  const clear = (y) => Math.min(table.radius + size, ...balls.map((ball) => Math.abs(ball[axis] - y) - high / 2));
  const rows = [0.5, 0.72, 0.28].map((part) => part * across);
  const y = rows.reduce((best, row) => (clear(row) > clear(best) ? row : best)) + high / 2;
  const text = write(layer, 'note', turned ? [y, table.width / 2] : [table.length / 2, y], size);
  lines.forEach((line, i) => {
    shape('tspan', { x: 0, y: 1.3 * size * i }, text).textContent = line;
  });
}

/**
 * Draws the promised path of a launch, and where it really leads.
 * @param {Element} layer @param {any[]} promised may be empty @param {any} followed @param {string} kind
 */
export function lead(layer, promised, followed, kind) {
  if (promised.length) line(layer, promised, kind + ' promised', 0.005);
  for (const path of Object.values(followed.paths)) line(layer, path, kind, 0.007);
  const stops = ['rest', 'pocketed'].includes(followed.end.reason);
  if (stops) ring(layer, followed.path[followed.path.length - 1].slice(1), 0.02, kind);
}

/**
 * Finds the point where a path first meets a cushion.
 * @param {import('./table.js').Table} table
 * @returns {[number, number] | null}
 */
export function firstCushion(table, path) {
  const r = table.radius;
  const near = (v, wall) => Math.abs(v - wall) < 1e-6;
  const met = path
    .slice(1)
    .find(([, x, y]) => near(x, r) || near(x, table.length - r) || near(y, r) || near(y, table.width - r));
  return met ? [met[1], met[2]] : null;
}
