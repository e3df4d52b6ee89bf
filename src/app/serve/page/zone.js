// The place where the cue ball should stop: a circle that is drawn on the cloth.
import { $ } from './controls.js';
import { pointIn } from './drag.js';
import { shape } from './table.js';

const [least, usual] = [0.03, 0.15]; // m: radii of the smallest zone, and of one that was only clicked

/**
 * @param {SVGSVGElement} svg
 * @param {HTMLElement} button that begins the drawing, or takes the zone away
 * @param {{table: () => import('./table.js').Table, has: () => boolean, drawn: (zone: number[]) => void,
 *   removed: () => void}} on
 */
export function zoning(svg, button, on) {
  const usually = $('hint').textContent;
  let circle = null;
  let [middle, radius] = [[0, 0], 0];
  const drawing = (is) => {
    button.setAttribute('aria-pressed', String(is));
    svg.classList.toggle('zoning', is);
    $('hint').textContent = is ? 'Draw a circle on the table: there the cue ball should stop.' : usually;
  };
  const wants = () => button.getAttribute('aria-pressed') === 'true';
  button.addEventListener('click', ({ detail }) => {
    if (on.has()) on.removed();
    else if (detail === 0)
      middleOf(on.table()); // pressed by a key: the arrow keys move it
    else drawing(!wants());
  });
  const middleOf = ({ length, width }) => on.drawn([length / 2, width / 2, usual]);
  svg.addEventListener(
    'pointerdown',
    (event) => {
      if (!wants() || event.button !== 0) return;
      event.stopPropagation();
      event.preventDefault();
      svg.setPointerCapture(event.pointerId);
      [middle, radius] = [pointIn(svg, event), 0];
      circle = shape('circle', { class: 'zone', cx: middle[0], cy: middle[1], r: least }, svg.firstElementChild);
    },
    true,
  );
  svg.addEventListener('pointermove', (event) => {
    if (!circle) return;
    const [x, y] = pointIn(svg, event);
    radius = Math.hypot(x - middle[0], y - middle[1]);
    circle.setAttribute('r', String(Math.max(radius, least)));
  });
  const end = (event) => {
    if (!circle) return;
    circle.remove();
    circle = null;
    drawing(false);
    if (event.type !== 'pointerup') return;
    const { length, width } = on.table();
    const [x, y] = [Math.min(Math.max(middle[0], 0), length), Math.min(Math.max(middle[1], 0), width)];
    const r = radius < least ? usual : radius;
    on.drawn([x, y, r].map((v) => Math.round(v * 1e4) / 1e4));
  };
  svg.addEventListener('pointerup', end);
  svg.addEventListener('pointercancel', end);
  addEventListener('keydown', ({ key }) => key === 'Escape' && drawing(false));
}
