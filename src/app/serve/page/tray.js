// The balls that may be put on the table: dragged onto it, or pressed.
import { band, called, look, set } from './balls.js';
import { pointIn } from './drag.js';
import { shape } from './table.js';

const far = 6; // pixels that make a press a drag

/** Returns the picture of a ball. */
function picture(name) {
  const { fill, band: stripe, ink, digit } = look(name);
  const svg = shape('svg', { viewBox: '-1.1 -1.1 2.2 2.2', 'aria-hidden': 'true' });
  shape('circle', { r: 1, fill, stroke: '#222', 'stroke-width': 0.1 }, svg);
  if (stripe) shape('path', { d: band(1), fill: stripe }, svg);
  if (digit) shape('text', { class: 'digit', fill: ink, 'font-size': 1 }, svg).textContent = digit;
  return svg;
}

/**
 * @param {HTMLElement} box
 * @param {SVGSVGElement} table the picture onto which balls are dragged
 * @param {{add: (name: string, at?: [number, number]) => void, remove: (name: string) => void}} on
 * @returns {(table: import('./table.js').Table, there: string[]) => void} draws the tray of a table
 */
export function tray(box, table, on) {
  let there = [];

  /** Follows a ball that is dragged onto the table. */
  function drag(button, name) {
    let from = null;
    let held = null; // its picture under the pointer
    button.addEventListener('pointerdown', (event) => {
      delete button.dataset.dragged; // a finger's drag ends without a click
      if (event.button !== 0 || there.includes(name)) return;
      from = [event.clientX, event.clientY];
      button.setPointerCapture(event.pointerId);
    });
    button.addEventListener('pointermove', ({ clientX: x, clientY: y }) => {
      if (!from || (!held && Math.hypot(x - from[0], y - from[1]) < far)) return;
      held ??= box.appendChild(Object.assign(document.createElement('div'), { className: 'held' }));
      if (!held.firstChild) held.append(picture(name));
      held.style.setProperty('transform', `translate(${x}px, ${y}px) translate(-50%, -50%)`);
    });
    const drop = (event) => {
      const [dragged, box] = [held, table.getBoundingClientRect()];
      held?.remove();
      held = from = null;
      const { clientX: x, clientY: y } = event;
      const over = x > box.left && x < box.right && y > box.top && y < box.bottom;
      if (dragged && over && event.type === 'pointerup') on.add(name, pointIn(table, event));
      if (dragged) button.dataset.dragged = 'true'; // the click that follows is none
    };
    button.addEventListener('pointerup', drop);
    button.addEventListener('pointercancel', drop);
  }

  /** @returns {HTMLButtonElement} */
  function ball(name) {
    const button = document.createElement('button');
    button.type = 'button';
    button.dataset.ball = name;
    button.setAttribute('aria-label', `Put ${called(name)} on the table, or take it off`);
    button.append(picture(name));
    drag(button, name);
    button.addEventListener('click', () => {
      if (button.dataset.dragged) delete button.dataset.dragged;
      else if (there.includes(name)) on.remove(name);
      else on.add(name);
    });
    return button;
  }

  return (kind, names) => {
    there = names;
    const all = set(kind);
    if (box.dataset.set !== all.join()) box.replaceChildren(...all.map(ball));
    box.dataset.set = all.join();
    for (const button of box.querySelectorAll('button'))
      button.setAttribute('aria-pressed', String(there.includes(button.dataset.ball)));
  };
}
