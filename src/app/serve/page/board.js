// The balls, the target and the aim, which are moved by hand.
import { draggable } from './drag.js';
import { metres, shape } from './table.js';

/**
 * @typedef {[number, number]} Point
 * @typedef {{
 *   scene: () => import('./state.js').Scene,
 *   moved: (before: import('./state.js').Scene | null) => void,
 *   says: (name: string, at: Point) => void,
 *   removed: (ball: number) => void,
 *   snaps: () => boolean,
 *   aim: {where: () => Point | null, move: (at: Point) => void},
 * }} Hands callbacks of a movement: `moved` gets the scene before it, once the movement ends
 */

const reach = 11; // pixels: least radius of a grip
const letters = 11; // pixels
const smallest = 9; // pixels: smaller letters cannot be read on a ball

/** Returns the snap distances: half a diamond each way. @param {import('./table.js').Table} table @returns {Point} */
const snaps = (table) => [table.length / 16, table.width / 8];

/**
 * Moves a point inside the table, at least a ball's radius from each cushion.
 * @param {import('./table.js').Table} table
 * @returns {Point}
 */
export function inside(table, [x, y], snap = false) {
  const r = table.radius;
  const to = (v, step) => (snap ? Math.round(v / step) * step : v);
  const clamp = (v, most) => Math.round(Math.min(Math.max(v, r), most - r) * 1e4) / 1e4;
  const [dx, dy] = snaps(table);
  return [clamp(to(x, dx), table.length), clamp(to(y, dy), table.width)];
}

/**
 * Finds a place without a ball; null if the table is full.
 * @param {import('./table.js').Table} table
 * @param {Point[]} balls
 */
export function free(table, balls) {
  const clear = (at) => balls.every(([x, y]) => Math.hypot(x - at[0], y - at[1]) > 2 * table.radius);
  for (let k = 1; k < 1000; ++k) {
    // These two factors fill a square evenly.
    const at = inside(table, [table.length * ((0.7549 * k) % 1), table.width * ((0.5698 * k) % 1)]);
    if (clear(at)) return at;
  }
  return null;
}

/** Finds the pocket at a point. @param {import('./table.js').Table} table @param {Point} at */
function pocketNear(table, [x, y]) {
  return table.pockets.find(({ at, half }) => Math.hypot(x - at[0], y - at[1]) < 1.6 * half);
}

/** Puts a digit on its ball, or beside it if it would be too small to read. */
function writeDigit(digit, at, radius, pixel) {
  const on = 1.2 * radius;
  const beside = on < smallest * pixel;
  const off = beside ? radius + 0.35 * letters * pixel : 0;
  digit.setAttribute('font-size', String(beside ? letters * pixel : on));
  digit.setAttribute('transform', `translate(${at[0] + off} ${at[1] + off}) scale(1 -1)`);
  digit.classList.toggle('beside', beside);
}

export class Board {
  /**
   * @param {SVGSVGElement} svg
   * @param {SVGGElement} layer
   * @param {import('./table.js').Table} table
   * @param {Hands} hands
   */
  constructor(svg, layer, table, hands) {
    this.svg = svg;
    this.layer = layer;
    this.table = table;
    this.hands = hands;
    /** @type {Map<string, {dot: SVGElement, grip: SVGElement, where: () => Point | null, digit: any}>} */
    this.grips = new Map();
    const { target, others } = hands.scene();
    if (target === 'point' || table.pockets.some(({ name }) => name === target)) this.target();
    others.forEach((_, i) => this.other(i));
    const put = (at) => (hands.scene().ball = inside(table, at, hands.snaps()));
    this.movable('ball', 'Cue ball', 'ball', table.radius, () => hands.scene().ball, put);
    const { where, move } = hands.aim;
    this.movable('cushion', 'First cushion point: the aim', 'cushion-point', 0.016, where, move, true);
  }

  /** Returns the least radius of a grip in metres, at the picture's present size. */
  reach() {
    return metres(this.svg, reach);
  }

  target() {
    const { table, hands } = this;
    const pocket = () => table.pockets.find(({ name }) => name === hands.scene().target);
    const size = () => (pocket() ? pocket().radius + 0.012 : table.radius);
    const put = (at) => {
      const into = pocketNear(table, at);
      if (into) hands.scene().target = into.name;
      else
        Object.assign(hands.scene(), {
          target: 'point',
          point: inside(table, at, hands.snaps()),
        });
    };
    const where = () => pocket()?.hole ?? hands.scene().point;
    const resized = (at) => {
      put(at);
      this.grips.get('target').dot.setAttribute('r', String(size()));
    };
    const grip = this.movable('target', 'Target: a place, or a pocket', 'target', size(), where, resized);
    // Arrow keys move the target from one pocket to the next.
    const next = (event) => {
      const turn = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 }[event.key];
      if (!turn || !pocket()) return;
      event.preventDefault();
      event.stopPropagation();
      const before = structuredClone(hands.scene());
      const all = table.pockets.length;
      hands.scene().target = table.pockets[(table.pockets.indexOf(pocket()) + turn + all) % all].name;
      this.place('target');
      hands.moved(before);
    };
    grip.parentElement.addEventListener('keydown', (event) => event.target === grip && next(event), true);
  }

  other(i) {
    const { table, hands } = this;
    const put = (at) => (hands.scene().others[i] = inside(table, at, hands.snaps()));
    const grip = this.movable(`other${i}`, `Ball ${i + 1}`, 'other', table.radius, () => hands.scene().others[i], put);
    grip.addEventListener('keydown', ({ key }) => {
      if (key === 'Delete' || key === 'Backspace') hands.removed(i);
    });
  }

  /** Adds a dot, and a grip that is at least as wide. */
  movable(name, label, kind, radius, where, put, aims = false) {
    const { hands } = this;
    const dot = shape(
      'circle',
      {
        class: kind,
        r: radius,
        'stroke-width': kind === 'target' ? 0.012 : 0.004,
      },
      this.layer,
    );
    const attributes = {
      tabindex: 0,
      role: 'button',
      'aria-label': label,
      'data-grip': name,
      'stroke-width': 0.01,
    };
    const grip = shape('circle', { class: 'grip', r: Math.max(radius, this.reach()), ...attributes }, this.layer);
    const digit = /^Ball/.test(label) ? shape('text', { class: 'digit' }, this.layer) : null;
    if (digit) digit.textContent = label.slice(5);
    this.grips.set(name, { dot, grip, where, digit });
    this.place(name);
    let before = null;
    draggable(
      grip,
      this.svg,
      where,
      (at, done) => {
        before ??= structuredClone(hands.scene());
        put(at);
        this.place(name);
        hands.says(label, where());
        if (!aims) hands.moved(done ? before : null);
        if (done) before = null;
      },
      () => (hands.snaps() && !aims ? snaps(this.table) : null),
    );
    for (const event of ['pointerenter', 'focus'])
      grip.addEventListener(event, () => where() && hands.says(label, where()));
    return grip;
  }

  /**
   * Draws a dot and its grip where they are now, or hides them if they have no place.
   * @param {string} name
   * @param {Point | null} [at]
   */
  place(name, at = this.grips.get(name)?.where()) {
    if (!this.grips.has(name)) return;
    const { dot, grip, digit } = this.grips.get(name);
    if (digit) writeDigit(digit, at, Number(dot.getAttribute('r')), metres(this.svg, 1));
    for (const element of [dot, grip]) {
      element.toggleAttribute('hidden', !at);
      if (at) element.setAttribute('cx', String(at[0]));
      if (at) element.setAttribute('cy', String(at[1]));
    }
  }

  placeAll() {
    for (const [name, { dot, grip }] of this.grips) {
      grip.setAttribute('r', String(Math.max(Number(dot.getAttribute('r')), this.reach())));
      this.place(name);
    }
  }
}
