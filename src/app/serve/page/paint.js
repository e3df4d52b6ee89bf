// Draws the answer on the table: paths, the line of aim, its margin, and the other shots.
import { metres, shape, sight } from './table.js';

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

/**
 * @param {SVGGElement} layer emptied first
 * @param {import('./table.js').Table} table
 * @param {any[]} shots
 * @param {any} shot the one in view
 * @param {any[]} afterwards the cue ball's path after that of the shot
 */
export function paint(layer, table, shots, shot, afterwards = []) {
  layer.replaceChildren();
  const rest = shots.filter((other) => other !== shot && other.path);
  const faint = shape('g', { opacity: Math.min(1, 3 / Math.sqrt(1 + rest.length)) }, layer);
  for (const other of rest) line(faint, other.path, '', 0.004);
  if (!shot?.path) return;
  const from = shot.path[0].slice(1); // a ball being dragged may have left it
  fan(layer, table, from, shot);
  const [x1, y1] = from;
  const aim = sight(table, from, shot.angle);
  const [x2, y2] = aim.at;
  shape('line', { class: 'aim', x1, y1, x2, y2, 'stroke-width': 0.005 }, layer);
  write(layer, 'count', aim.at, metres(layer.ownerSVGElement, 12)).textContent = aim.count;
  line(layer, [...shot.path, ...afterwards], 'best', 0.011);
  for (const path of Object.values(shot.paths ?? {})) line(layer, path, 'sent', 0.008);
  const at = end(table, shot);
  if (at) ring(layer, at, table.radius, shot.scratch ? 'scratch' : '');
}

/** Draws a ring at the place where a ball ends. @param {Element} layer */
function ring(layer, [cx, cy], r, kind) {
  shape('circle', { class: `ghost ${kind}`, cx, cy, r, 'stroke-width': 0.004 }, layer);
}

/** @param {Element} layer @param {string} kind @param {[number, number]} at @param {number} size [m] */
function write(layer, kind, [x, y], size) {
  return shape('text', { class: kind, 'font-size': size, transform: `translate(${x} ${y}) scale(1 -1)` }, layer);
}

const wide = 0.6; // width of a letter, as a share of its size

/**
 * Writes words on the table, where they cover no ball if possible.
 * @param {SVGGElement} layer @param {import('./table.js').Table} table @param {string} words @param {number[][]} balls
 */
export function note(layer, table, words, balls) {
  const size = Math.max(table.length / 40, metres(layer.ownerSVGElement, 13));
  const longest = (0.9 * table.length) / (wide * size);
  const lines = [''];
  for (const word of words.split(' ')) {
    const last = lines[lines.length - 1];
    if ((last + word).length > longest) lines.push(word);
    else lines[lines.length - 1] = `${last} ${word}`.trim();
  }
  const high = 1.3 * size * (lines.length - 1);
  const clear = (y) => Math.min(table.radius + size, ...balls.map((ball) => Math.abs(ball[1] - y) - high / 2));
  const rows = [0.5, 0.72, 0.28].map((part) => part * table.width);
  const y = rows.reduce((best, row) => (clear(row) > clear(best) ? row : best));
  const text = write(layer, 'note', [table.length / 2, y + high / 2], size);
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
