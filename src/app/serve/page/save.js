// Downloads: the puzzle as JSON, the picture with its caption as SVG and PNG.
import { shape } from './table.js';

const colours = ['fill', 'fill-opacity', 'stroke', 'stroke-width', 'stroke-dasharray', 'opacity', 'paint-order'];
const letters = ['text-anchor', 'dominant-baseline', 'font-size', 'font-weight', 'font-family'];
const kept = [...colours, ...letters];

const line = 0.075; // m: from one line of the caption to the next

/** Writes the caption below a picture. @returns {number} the height that it takes [m] */
function write(copy, lines, [left, top, width, height]) {
  const style = getComputedStyle(document.body);
  const high = line * (lines.length + 0.6);
  shape('rect', { x: left, y: top + height, width, height: high, fill: style.backgroundColor }, copy);
  lines.forEach((text, i) => {
    // Long lines are made to fit.
    const size = Math.min(i ? 0.042 : 0.055, (0.96 * width) / (0.5 * text.length));
    const place = { x: left + 0.02 * width, y: top + height + line * (i + 1), 'font-size': size };
    const attributes = { ...place, fill: style.color, 'font-family': 'sans-serif', 'font-weight': i ? 400 : 600 };
    shape('text', attributes, copy).textContent = text;
  });
  return high;
}

/**
 * Returns the picture as a file of its own, with its styles as attributes.
 * @param {SVGSVGElement} svg
 * @param {string[]} lines written below it
 */
function alone(svg, lines) {
  const copy = /** @type {SVGSVGElement} */ (svg.cloneNode(true));
  const [from, to] = [svg, copy].map((root) => [...root.querySelectorAll('*')]);
  from.forEach((element, i) => {
    const style = getComputedStyle(element);
    for (const name of kept) to[i].setAttribute(name, style.getPropertyValue(name));
  });
  copy.querySelectorAll('.grip, .click, [hidden]').forEach((element) => element.remove());
  const { x, y, width: wide, height: high } = svg.viewBox.baseVal;
  /** @type {[number, number, number, number]} */
  const box = [x, y, wide, high];
  box[3] += write(copy, lines, box);
  const [, , width, height] = box;
  copy.setAttribute('viewBox', box.join(' '));
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  copy.setAttribute('width', String(Math.round(500 * width)));
  copy.setAttribute('height', String(Math.round(500 * height)));
  return new XMLSerializer().serializeToString(copy);
}

function give(name, blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** Saves the puzzle, as `bankshot solve` reads it. @param {object} puzzle */
export function json(puzzle) {
  give('bankshot.json', new Blob([JSON.stringify(puzzle, null, 1) + '\n'], { type: 'application/json' }));
}

/** @param {SVGSVGElement} table @param {string[]} caption */
export function svg(table, caption) {
  give('bankshot.svg', new Blob([alone(table, caption)], { type: 'image/svg+xml' }));
}

/** @param {SVGSVGElement} table @param {string[]} caption */
export async function png(table, caption) {
  const image = new Image();
  image.src = 'data:image/svg+xml,' + encodeURIComponent(alone(table, caption));
  await image.decode();
  const canvas = document.createElement('canvas');
  canvas.width = 2 * image.width;
  canvas.height = 2 * image.height;
  canvas.getContext('2d').drawImage(image, 0, 0, canvas.width, canvas.height);
  canvas.toBlob((blob) => give('bankshot.png', blob));
}
