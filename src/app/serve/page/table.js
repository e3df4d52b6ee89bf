// Draws a table to scale. One unit is a metre, y upwards.
import { side as seen } from './units.js';

const space = 'http://www.w3.org/2000/svg';
const wood = 0.15;
const nose = 0.045;
const leather = 0.012; // width around a hole
export const diamondInset = 0.094;

/**
 * @param {string} name
 * @param {Record<string, string | number>} attributes
 * @param {Element} [parent]
 * @returns {any} an SVG element
 */
export function shape(name, attributes, parent) {
  const element = document.createElementNS(space, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  parent?.append(element);
  return element;
}

/**
 * @typedef {{name: string, length: number, width: number, cushions: string[], radius: number, diamond: number,
 *   pockets: Pocket[]}} Table
 * @typedef {{name: string, at: [number, number], half: number, hole: [number, number], radius: number,
 *   mouth?: [number, number][], tip?: number}} Pocket `mouth`: from a rail round a tip, along a facing, across and back
 */

/** Returns a strip along each cushion, as wide as the wood. @param {Table} table */
function rails({ length, width }) {
  return {
    bottom: [0, -wood, length, wood],
    right: [length, 0, wood, width],
    top: [0, width, length, wood],
    left: [-wood, 0, wood, width],
  };
}

/**
 * Returns a number of pixels in metres, at the picture's present size.
 * @param {SVGSVGElement} svg
 * @param {number} pixels
 */
export function metres(svg, pixels) {
  return (pixels * svg.viewBox.baseVal.width) / svg.getBoundingClientRect().width;
}

/** Turns the table's coordinates into those of the picture; each is its own inverse. */
const [lying, standing] = ['scale(1 -1)', 'matrix(0 -1 -1 0 0 0)'];

/**
 * Returns the transform that puts something upright at a place of the table.
 * @param {SVGSVGElement} svg
 * @param {[number, number]} at
 */
export const upright = (svg, [x, y]) => `translate(${x} ${y}) ${svg.dataset.turned ? standing : lying}`;

/** Returns the outline of the cloth between two jaws. @param {Pocket} pocket */
function mouth({ mouth, tip }) {
  const ways = ['M', `A${tip} ${tip} 0 0 0 `, 'L', 'L', 'L', `A${tip} ${tip} 0 0 0 `];
  return mouth.map(([x, y], i) => `${ways[i]}${x} ${y}`).join('') + 'z';
}

/** Calls `f` when something is clicked, or pressed by a key. @param {Element} element @param {() => void} f */
export function onPress(element, f) {
  element.addEventListener('click', f);
  element.addEventListener('keydown', (/** @type {any} */ event) => {
    if (event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    f();
  });
}

/** Adds the areas on which a click adds a cushion to the order. */
function clickable(all, table, clicked) {
  for (const [name, [x, y, width, height]] of Object.entries(rails(table))) {
    const label = `${seen(name)} cushion: add it to the order`;
    const attributes = { class: 'click', x, y, width, height, tabindex: 0, role: 'button', 'aria-label': label };
    const rail = shape('rect', { ...attributes, 'data-cushion': name, 'stroke-width': 0.01 }, all);
    onPress(rail, () => clicked(name));
  }
}

/**
 * Empties the picture and draws the table.
 * @param {SVGSVGElement} svg
 * @param {Table} table
 * @param {(cushion: string) => void} [clicked] without it nothing can be clicked
 * @param {boolean} [turned] the table stands on its left end
 * @returns groups for marks under the paths, for paths, and for things that may be dragged, bottom first
 */
export function draw(svg, table, clicked, turned = false) {
  const { length, width } = table;
  svg.replaceChildren();
  const sides = [-wood, -width - wood, length + 2 * wood, width + 2 * wood];
  svg.setAttribute('viewBox', (turned ? [sides[1], -length - wood, sides[3], sides[2]] : sides).join(' '));
  svg.dataset.turned = turned ? 'true' : '';
  svg.style.setProperty('--aspect', String(turned ? sides[3] / sides[2] : sides[2] / sides[3]));
  const all = shape('g', { transform: turned ? standing : lying, 'data-frame': '' }, svg);
  const box = (by) => ({ x: -by, y: -by, width: length + 2 * by, height: width + 2 * by });
  shape('rect', { class: 'rail', ...box(wood), rx: 0.06 }, all);
  for (const { hole, radius } of table.pockets)
    shape('circle', { class: 'leather', cx: hole[0], cy: hole[1], r: radius + leather }, all);
  shape('rect', { class: 'nose', ...box(nose) }, all);
  shape('rect', { class: 'cloth', ...box(0) }, all);
  shape('rect', box(0), shape('clipPath', { id: 'cloth' }, all));
  for (const pocket of table.pockets) if (pocket.mouth) shape('path', { class: 'cloth', d: mouth(pocket) }, all);
  diamonds(all, table, table.pockets.length > 0);
  if (clicked) clickable(all, table, clicked);
  for (const { hole, radius } of table.pockets)
    shape('circle', { class: 'pocket', cx: hole[0], cy: hole[1], r: radius }, all);
  return {
    under: shape('g', {}, all),
    paths: shape('g', {}, all),
    grips: shape('g', {}, all),
  };
}

/** Draws the diamonds, but none at a middle pocket. @param {Element} parent @param {Table} table */
function diamonds(parent, { length, width }, pockets) {
  const d = 0.012;
  const at = (x, y) =>
    shape(
      'path',
      {
        class: 'diamond',
        d: `M${x - d} ${y}L${x} ${y + d}L${x + d} ${y}L${x} ${y - d}Z`,
      },
      parent,
    );
  const eighths = [1, 2, 3, 4, 5, 6, 7].filter((i) => i !== 4 || !pockets);
  for (const i of eighths) for (const y of [-diamondInset, width + diamondInset]) at((i * length) / 8, y);
  for (let i = 1; i < 4; ++i) for (const x of [-diamondInset, length + diamondInset]) at(x, (i * width) / 4);
}

/**
 * Finds the point where the line of aim crosses the line of diamonds.
 * @param {Table} table @param {[number, number]} from @param {number} degrees
 * @returns {{at: [number, number], count: string, words: string}}
 */
export function sight(table, from, degrees) {
  const a = (degrees * Math.PI) / 180;
  const [ux, uy] = [Math.cos(a), Math.sin(a)];
  const until = (p, u, end) => (u > 0 ? (end + diamondInset - p) / u : u < 0 ? (-diamondInset - p) / u : Infinity);
  const tx = until(from[0], ux, table.length);
  const ty = until(from[1], uy, table.width);
  const t = Math.min(tx, ty);
  /** @type {[number, number]} */
  const at = [from[0] + t * ux, from[1] + t * uy];
  const long = ty <= tx;
  const count = (long ? (at[0] / table.length) * 8 : (at[1] / table.width) * 4).toFixed(2);
  const side = long ? (uy > 0 ? 'top' : 'bottom') : ux > 0 ? 'right' : 'left';
  return { at, count, words: `diamond ${count} on the ${seen(side)} rail` };
}
