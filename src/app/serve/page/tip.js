// A picture of the point where the cue meets the ball: its dot is dragged or moved by arrow keys.
import { arrow, pointIn } from './drag.js';
import { shape } from './table.js';

const widest = 1.25; // spin with the tip half a radius off the centre; beyond that the tip slips
const half = 0.5;

/**
 * @param {SVGSVGElement} svg
 * @param {(spin: {side: number, top: number}, done: boolean) => void} put
 * @returns {(spin: {side: number, top: number}) => void} draws another spin
 */
export function tip(svg, put) {
  svg.setAttribute('viewBox', '-1.05 -1.05 2.1 2.1');
  shape('circle', { class: 'face', r: 1 }, svg);
  shape('circle', { class: 'miscue', r: half }, svg);
  shape('path', { class: 'miscue', d: 'M-1 0H1M0 -1V1' }, svg);
  const label = 'Tip: arrow keys move it';
  const dot = shape('circle', { class: 'dot', r: 0.14, tabindex: 0, role: 'button', 'aria-label': label }, svg);
  let now = { side: 0, top: 0 };

  const rounded = (v) => Math.round(v * 50) / 50;
  const set = (side, top, done) => {
    const far = Math.max(1, Math.hypot(side, top) / widest);
    now = { side: rounded(side / far), top: rounded(top / far) };
    show(now);
    put(now, done);
  };
  const at = (event) => pointIn(svg, event).map((v) => (v / half) * widest);
  let held = false;
  svg.addEventListener('pointerdown', (event) => {
    if (svg.hasAttribute('aria-disabled') || event.button !== 0) return;
    held = true;
    svg.setPointerCapture(event.pointerId);
    const [side, top] = at(event);
    set(side, top, false);
  });
  svg.addEventListener('pointermove', (event) => {
    if (!held) return;
    const [side, top] = at(event);
    set(side, top, false);
  });
  for (const end of ['pointerup', 'pointercancel'])
    svg.addEventListener(end, () => {
      if (held) put(now, true);
      held = false;
    });
  dot.addEventListener('keydown', (/** @type {KeyboardEvent} */ event) => {
    const way = arrow(event);
    if (!way || svg.hasAttribute('aria-disabled')) return;
    event.preventDefault();
    const step = event.shiftKey ? 0.02 : 0.1;
    set(now.side + way[0] * step, now.top + way[1] * step, true);
  });

  /** @param {{side: number, top: number}} spin */
  function show(spin) {
    now = spin;
    dot.setAttribute('cx', String((spin.side / widest) * half));
    dot.setAttribute('cy', String((-spin.top / widest) * half));
  }
  return show;
}
