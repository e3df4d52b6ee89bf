// Draws a table to scale. One unit is a metre, y upwards.

const space = 'http://www.w3.org/2000/svg';
const rail = 0.13, nose = 0.045, diamondInset = 0.094;

/**
 * @param {string} name
 * @param {Record<string, string | number>} attributes
 * @param {Element} [parent]
 */
export function shape(name, attributes, parent) {
  const element = document.createElementNS(space, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  parent?.append(element);
  return element;
}

/**
 * @typedef {{name: string, length: number, width: number, cushions: string[], radius: number, diamond: number,
 *   pockets: {name: string, at: [number, number], half: number}[]}} Table
 */

/** Empties the picture and draws the table. @param {SVGSVGElement} svg @param {Table} table @returns a group for what moves */
export function draw(svg, table) {
  const { length, width } = table;
  svg.replaceChildren();
  svg.setAttribute('viewBox', `${-rail} ${-width - rail} ${length + 2 * rail} ${width + 2 * rail}`);
  const all = shape('g', { transform: 'scale(1 -1)' }, svg);
  shape('rect', { class: 'rail', x: -rail, y: -rail, width: length + 2 * rail, height: width + 2 * rail, rx: 0.06 }, all);
  shape('rect', { class: 'nose', x: -nose, y: -nose, width: length + 2 * nose, height: width + 2 * nose }, all);
  shape('rect', { class: 'cloth', x: 0, y: 0, width: length, height: width }, all);
  for (const pocket of table.pockets)
    shape('circle', { class: 'pocket', cx: pocket.at[0], cy: pocket.at[1], r: pocket.half }, all);
  for (let i = 1; i < 8; ++i)
    for (const y of [-diamondInset, width + diamondInset]) diamond(all, (i * length) / 8, y);
  for (let i = 1; i < 4; ++i)
    for (const x of [-diamondInset, length + diamondInset]) diamond(all, x, (i * width) / 4);
  return shape('g', {}, all);
}

function diamond(parent, x, y) {
  const d = 0.012;
  shape('path', { class: 'diamond', d: `M${x - d} ${y}L${x} ${y + d}L${x + d} ${y}L${x} ${y - d}Z` }, parent);
}

/** Where the line of aim crosses the line of diamonds. @returns {{at: [number, number], words: string}} */
export function sight(table, from, degrees) {
  const a = (degrees * Math.PI) / 180, ux = Math.cos(a), uy = Math.sin(a);
  const tx = ux > 0 ? (table.length + diamondInset - from[0]) / ux : ux < 0 ? (-diamondInset - from[0]) / ux : Infinity;
  const ty = uy > 0 ? (table.width + diamondInset - from[1]) / uy : uy < 0 ? (-diamondInset - from[1]) / uy : Infinity;
  const t = Math.min(tx, ty), at = [from[0] + t * ux, from[1] + t * uy];
  const long = ty <= tx;
  const count = (long ? (at[0] / table.length) * 8 : (at[1] / table.width) * 4).toFixed(2);
  const side = long ? (uy > 0 ? 'top' : 'bottom') : ux > 0 ? 'right' : 'left';
  return { at, words: `diamond ${count} on the ${side} rail` };
}
