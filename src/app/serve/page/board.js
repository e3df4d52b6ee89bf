// The balls, the target, the place to leave the cue ball and the aim, which are moved by hand.
import { band, called, look } from './balls.js';
import { draggable } from './drag.js';
import { inside, snaps } from './layout.js';
import { nameOf } from './state.js';
import { metres, onPress, shape, upright } from './table.js';
import { side } from './units.js';

/**
 * @typedef {[number, number]} Point
 * @typedef {{
 *   scene: () => import('./state.js').Scene,
 *   put: (ball: number, at: Point) => void,
 *   moved: (before: import('./state.js').Scene | null) => void,
 *   says: (name: string, at: Point) => void,
 *   removed: (ball: number) => void,
 *   clicked: (ball: number) => void,
 *   pocket: (name: string) => void,
 *   snaps: () => boolean,
 *   aim: {where: () => Point | null, move: (at: Point) => void},
 * }} Hands callbacks: `put` places a ball, the cue ball by −1; `moved` gets the scene before, once a movement ends
 */

const [fine, thumb] = [11, 22]; // pixels: least radius of a grip for a mouse and for a finger
const letters = 11; // pixels
const smallest = 9; // pixels: smaller letters cannot be read on a ball

/** Finds the pocket at a point. @param {import('./table.js').Table} table @param {Point} at */
function pocketNear(table, [x, y]) {
  return table.pockets.find(({ at, half }) => Math.hypot(x - at[0], y - at[1]) < 1.6 * half);
}

/** Draws what is on a ball: its stripe and its number. @returns {SVGElement} a group around the ball's centre */
function skin(layer, name, radius) {
  const { band: stripe, ink, digit } = look(name);
  const group = shape('g', { class: 'skin' }, layer);
  if (stripe) shape('path', { d: band(radius), fill: stripe }, group);
  if (digit) shape('text', { class: 'digit', fill: ink }, group).textContent = digit;
  return group;
}

/** Makes the number of a ball large enough to read: on the ball, or else beside it. */
function fit(group, radius, pixel) {
  const digit = group.querySelector('text');
  if (!digit) return;
  const on = (digit.textContent.length > 1 ? 1 : 1.2) * radius;
  const beside = on < smallest * pixel;
  const off = beside ? radius + 0.35 * letters * pixel : 0;
  digit.setAttribute('font-size', String(beside ? letters * pixel : on));
  digit.setAttribute('x', String(off));
  digit.setAttribute('y', String(-off));
  digit.classList.toggle('beside', beside);
}

/** @typedef {{dot: SVGElement, grip: SVGElement, skin?: SVGElement, label: string,
 *   where: () => Point | null, take: Function}} Grip */

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
    /** @type {Map<string, Grip>} */
    this.grips = new Map();
    const { target, others, zone } = hands.scene();
    this.pockets();
    if (zone.length) this.zone();
    if (target === 'point' || table.pockets.some(({ name }) => name === target)) this.target();
    others.forEach((_, i) => this.other(i));
    const cue = { where: () => hands.scene().ball, put: (at) => hands.put(-1, at) };
    this.movable('ball', 'Cue ball', 'ball', table.radius, cue);
    const { where, move } = hands.aim;
    this.movable('cushion', 'Aim: where the cue ball meets the first cushion', 'cushion-point', 0.016, {
      where,
      put: move,
      aims: true,
    });
    // A finger takes what is nearest, not what lies on top.
    layer.parentElement.addEventListener('pointerdown', (event) => this.nearest(event), true);
  }

  /** Returns the least radius of a grip in metres, at the picture's present size. */
  reach() {
    return metres(this.svg, matchMedia('(pointer: coarse)').matches ? thumb : fine);
  }

  /** @param {any} event */
  nearest(event) {
    if (event.pointerType !== 'touch') return;
    const far = ({ grip }) => {
      const { x, y, width, height } = grip.getBoundingClientRect();
      return Math.hypot(x + width / 2 - event.clientX, y + height / 2 - event.clientY);
    };
    const shown = [...this.grips.values()].filter(
      ({ grip }) => !grip.hasAttribute('hidden') && grip.dataset.grip !== 'zone',
    );
    const [best] = shown.sort((a, b) => far(a) - far(b));
    if (!best || far(best) > thumb || best.grip === event.target) return;
    event.stopPropagation();
    best.take(event);
  }

  /** Makes each pocket something to click. */
  pockets() {
    for (const { name, hole, radius } of this.table.pockets) {
      const size = Math.max(radius, this.reach());
      const attributes = { class: 'click', cx: hole[0], cy: hole[1], r: size, tabindex: 0, role: 'button' };
      const pocket = shape(
        'circle',
        { ...attributes, 'aria-label': `Pocket ${side(name)}`, 'data-pocket': name, 'stroke-width': 0.01 },
        this.layer,
      );
      onPress(pocket, () => this.hands.pocket(name));
    }
  }

  zone() {
    const { table, hands } = this;
    const zone = () => hands.scene().zone;
    const where = () => /** @type {Point} */ (zone().slice(0, 2));
    const put = (at) => (hands.scene().zone = [...inside(table, at), zone()[2]]);
    const grip = this.movable('zone', 'Where the cue ball should stop', 'zone', zone()[2], { where, put });
    grip.addEventListener('keydown', ({ key }) => {
      if (key === 'Delete' || key === 'Backspace') hands.removed(-1);
    });
  }

  target() {
    const { table, hands } = this;
    const pocket = () => table.pockets.find(({ name }) => name === hands.scene().target);
    const size = () => (pocket() ? pocket().radius + 0.012 : table.radius);
    const put = (at) => {
      const into = pocketNear(table, at);
      if (into) hands.scene().target = into.name;
      else Object.assign(hands.scene(), { target: 'point', point: inside(table, at, hands.snaps()) });
      this.grips.get('target').dot.setAttribute('r', String(size()));
    };
    const where = () => pocket()?.hole ?? hands.scene().point;
    const grip = this.movable('target', 'Target: a place, or a pocket', 'target', size(), { where, put });
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
    const name = nameOf(hands.scene(), i);
    const label = called(name)
      .replace(/^(the|ball) /, 'Ball ')
      .replace(/^a red/, 'Red ball');
    const where = () => hands.scene().others[i];
    const leave = () => hands.removed(i);
    const hold = { where, put: (at) => hands.put(i, at), click: () => hands.clicked(i), leave, name };
    const grip = this.movable(`other${i}`, label, 'other', table.radius, hold);
    grip.addEventListener('keydown', ({ key }) => {
      if (key === 'Delete' || key === 'Backspace') leave();
    });
  }

  /**
   * Adds a dot, and a grip that is at least as wide.
   * @param {{where: () => Point | null, put: (at: Point) => void, click?: () => void, leave?: () => void, name?: string,
   *   aims?: boolean}} held `leave`: it was dragged off the table; `name`: of a ball; `aims`: it changes no scene
   */
  movable(name, label, kind, radius, held) {
    const { hands, layer } = this;
    const { where, put } = held;
    const dot = shape('circle', { class: kind, r: radius, 'stroke-width': kind === 'target' ? 0.012 : 0.004 }, layer);
    if (held.name) dot.setAttribute('fill', look(held.name).fill);
    const drawn = held.name ? skin(layer, held.name, radius) : undefined;
    const size = Math.max(radius, this.reach());
    const attributes = { tabindex: 0, role: 'button', 'aria-label': label, 'data-grip': name, 'stroke-width': 0.01 };
    const grip = shape('circle', { class: 'grip', r: size, ...attributes }, layer);
    let before = null;
    const move = (at, done, out) => {
      before ??= structuredClone(hands.scene());
      if (!done) put(at);
      if (done && out && held.leave) {
        Object.assign(hands.scene(), before);
        before = null;
        return held.leave();
      }
      this.place(name);
      hands.says(label, where());
      if (!held.aims) hands.moved(done ? before : null);
      if (done) before = null;
    };
    const coarse = () => (hands.snaps() && !held.aims ? snaps(this.table) : null);
    const take = draggable(grip, this.svg, { where, move, click: held.click, coarse });
    this.grips.set(name, { dot, grip, where, skin: drawn, take, label });
    this.place(name);
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
    const { dot, grip, skin, label } = this.grips.get(name);
    if (at) grip.setAttribute('aria-label', `${label} at ${at.map((v) => v.toFixed(3)).join(', ')} m`);
    if (skin && at) {
      skin.setAttribute('transform', upright(this.svg, at));
      fit(skin, Number(dot.getAttribute('r')), metres(this.svg, 1));
    }
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
