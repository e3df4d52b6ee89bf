// Moves things by their grips: with mouse, pen or finger, or with the arrow keys (1 mm; with Shift 0.1 mm).

/**
 * Returns a pointer's place in the units of a picture, y upwards.
 * @param {SVGSVGElement} svg
 * @returns {[number, number]}
 */
export function pointIn(svg, event) {
  const p = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
  return [p.x, -p.y];
}

/** Returns the direction of an arrow key; undefined for any other key. @param {KeyboardEvent} event */
export function arrow(event) {
  return { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
}

let grips = 0; // number of grips held

export const holding = () => grips > 0;

/**
 * @param {SVGElement} grip
 * @param {SVGSVGElement} svg
 * @param {() => [number, number]} where returns its place [m]
 * @param {(at: [number, number], done: boolean) => void} move
 * @param {() => [number, number] | null} coarse returns the step of a key, or null for millimetres
 */
export function draggable(grip, svg, where, move, coarse) {
  let held = null;
  let moved = false;
  grip.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    ++grips;
    const at = where();
    const p = pointIn(svg, event);
    held = [at[0] - p[0], at[1] - p[1]];
    moved = false;
    grip.setPointerCapture(event.pointerId);
  });
  grip.addEventListener('pointermove', (event) => {
    if (!held) return;
    const p = pointIn(svg, event);
    moved = true;
    move([p[0] + held[0], p[1] + held[1]], false);
  });
  const drop = () => {
    if (held) --grips;
    if (held && moved) move(where(), true);
    held = null;
  };
  grip.addEventListener('pointerup', drop);
  grip.addEventListener('pointercancel', drop);
  grip.addEventListener('keydown', (event) => {
    const way = arrow(event);
    if (!way) return;
    event.preventDefault();
    const fine = event.shiftKey ? 0.0001 : 0.001;
    const [dx, dy] = coarse() ?? [fine, fine];
    const at = where();
    move([at[0] + way[0] * dx, at[1] + way[1] * dy], true);
  });
}
