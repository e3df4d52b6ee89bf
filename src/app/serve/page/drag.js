// Moves things by their grips: with mouse, pen or finger, or with the arrow keys (1 cm; with Shift 1 mm, with Alt 0.1 mm).

/**
 * Returns a pointer's place in the units of a picture, y upwards. The first group of the picture, if any, is its frame.
 * @param {SVGSVGElement} svg
 * @returns {[number, number]}
 */
export function pointIn(svg, { clientX, clientY }) {
  const frame = /** @type {SVGGraphicsElement} */ (svg.querySelector('[data-frame]'));
  const p = new DOMPoint(clientX, clientY).matrixTransform((frame ?? svg).getScreenCTM().inverse());
  return [p.x, frame ? p.y : -p.y];
}

/** Returns the direction of an arrow key; undefined for any other key. @param {KeyboardEvent} event */
export function arrow(event) {
  return { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
}

/** Returns the step of an arrow key in metres. @param {KeyboardEvent} event */
const step = (event) => (event.altKey ? 1e-4 : event.shiftKey ? 1e-3 : 1e-2);

let grips = 0; // number of grips held

export const holding = () => grips > 0;

/** Ends the movement by keys that has not ended yet: presses within this time are one movement. */
let end = null;
const pause = 800; // ms
let timer;
export function settle() {
  clearTimeout(timer);
  end?.();
  end = null;
}

/**
 * @typedef {{
 *   where: () => [number, number], move: (at: [number, number], done: boolean, out?: boolean) => void,
 *   click?: () => void, coarse: () => [number, number] | null,
 * }} Held `where` returns its place [m]; `out`: it was let go outside the picture; `click`: it was pressed and not moved;
 *   `coarse` returns the step of a key, or null for the usual one
 */

/**
 * @param {SVGElement} grip
 * @param {SVGSVGElement} svg
 * @param {Held} held
 * @returns {(event: PointerEvent) => void} takes the grip, as a press on it does
 */
export function draggable(grip, svg, { where, move, click, coarse }) {
  let off = null; // from the pointer to the thing held
  let from = null; // where the pointer went down, in pixels
  let moved = false;
  const take = (event) => {
    if (event.button !== 0) return;
    settle();
    ++grips;
    const [at, p] = [where(), pointIn(svg, event)];
    off = [at[0] - p[0], at[1] - p[1]];
    from = [event.clientX, event.clientY];
    moved = false;
    grip.setPointerCapture(event.pointerId);
  };
  grip.addEventListener('pointerdown', take);
  const still = 3; // pixels: a click may tremble
  grip.addEventListener('pointermove', (event) => {
    if (!off) return;
    if (!moved && Math.hypot(event.clientX - from[0], event.clientY - from[1]) < still) return;
    const p = pointIn(svg, event);
    moved = true;
    move([p[0] + off[0], p[1] + off[1]], false);
  });
  const drop = (event) => {
    if (!off) return;
    --grips;
    off = null;
    if (moved) move(where(), true, event.type === 'pointerup' && outside(svg, event));
    else if (event.type === 'pointerup') click?.();
  };
  grip.addEventListener('pointerup', drop);
  grip.addEventListener('pointercancel', drop);
  grip.addEventListener('keydown', (event) => {
    const way = arrow(event);
    if (event.key === 'Enter' || event.key === ' ') {
      event.preventDefault();
      click?.();
    }
    if (!way) return;
    event.preventDefault();
    const [dx, dy] = coarse() ?? [step(event), step(event)];
    const at = where();
    move([at[0] + way[0] * dx, at[1] + way[1] * dy], false);
    end = () => move(where(), true);
    clearTimeout(timer);
    timer = setTimeout(settle, pause);
  });
  grip.addEventListener('blur', settle);
  return take;
}

/** Says whether a pointer is outside a picture. @param {Element} svg */
function outside(svg, { clientX: x, clientY: y }) {
  const box = svg.getBoundingClientRect();
  return x < box.left || x > box.right || y < box.top || y > box.bottom;
}
