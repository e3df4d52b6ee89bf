// Downloads: the puzzle and its answer as JSON, the picture as SVG and PNG.

const colours = ['fill', 'fill-opacity', 'stroke', 'stroke-width', 'stroke-dasharray', 'opacity', 'paint-order'];
const letters = ['text-anchor', 'dominant-baseline', 'font-size', 'font-weight', 'font-family'];
const kept = [...colours, ...letters];

/** Returns the picture as a file of its own, with its styles as attributes. @param {SVGSVGElement} svg */
function alone(svg) {
  const copy = /** @type {SVGSVGElement} */ (svg.cloneNode(true));
  const [from, to] = [svg, copy].map((root) => [...root.querySelectorAll('*')]);
  from.forEach((element, i) => {
    const style = getComputedStyle(element);
    for (const name of kept) to[i].setAttribute(name, style.getPropertyValue(name));
  });
  copy.querySelectorAll('.grip, .click, [hidden]').forEach((element) => element.remove());
  const [, , width, height] = svg.getAttribute('viewBox').split(' ').map(Number);
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

/** @param {object} puzzle @param {any[]} shots */
export function json(puzzle, shots) {
  const plain = shots.map(({ path, paths, ...shot }) => shot);
  give(
    'bankshot.json',
    new Blob([JSON.stringify({ puzzle, shots: plain }, null, 1)], {
      type: 'application/json',
    }),
  );
}

/** @param {SVGSVGElement} table */
export function svg(table) {
  give('bankshot.svg', new Blob([alone(table)], { type: 'image/svg+xml' }));
}

/** @param {SVGSVGElement} table */
export async function png(table) {
  const image = new Image();
  image.src = 'data:image/svg+xml,' + encodeURIComponent(alone(table));
  await image.decode();
  const canvas = document.createElement('canvas');
  canvas.width = 2 * image.width;
  canvas.height = 2 * image.height;
  canvas.getContext('2d').drawImage(image, 0, 0, canvas.width, canvas.height);
  canvas.toBlob((blob) => give('bankshot.png', blob));
}
