// A closer look at a shot: an aim of the user's own, an aim at the mirror image, the same shot in another physics,
// success around it, and the places from which it can be played.
import { $ } from './controls.js';
import { forget, latest } from './engine.js';
import { follow, outcome } from './follow.js';
import { heat, launchAt, scale } from './heat.js';
import { mirrorAim, mirrorPath } from './mirror.js';
import { firstCushion, lead } from './paint.js';
import { forgetSides, sides } from './sides.js';
import { starts } from './starts.js';
import * as state from './state.js';
import { angleTo, wrapped } from './units.js';

/**
 * @typedef {{
 *   scene: () => state.Scene, table: () => import('./table.js').Table, shots: () => any[], shot: () => any,
 *   layers: () => Record<'under' | 'compare' | 'own', Element>,
 * }} Page
 */

export class Closer {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    /** @type {[number, number] | null} where the user's own aim meets the first cushion */
    this.aimed = null;
    /** @type {any} the user's own launch */
    this.tried = null;
    /** @type {{angle: number} | null} the user's guess, before the answer is shown */
    this.guess = null;
  }

  listen() {
    $('starts').addEventListener('click', () => this.starts());
    $('mirror').addEventListener('change', () => {
      $('other').textContent = '';
      this.mirror();
    });
    $('compare').addEventListener('change', () => this.sides());
    $('why').addEventListener('toggle', () => this.heat());
    $('heat').addEventListener('click', (event) => {
      const box = $('heat').getBoundingClientRect();
      const [x, y] = [(event.clientX - box.left) / box.width, (box.bottom - event.clientY) / box.height];
      if (this.page.shot()) this.launch(launchAt(this.page.shot(), x, y));
    });
  }

  /** Drops all results, because the scene has changed. */
  clear() {
    for (const kind of ['map', 'launches', 'mirror', 'mirror-path', 'afterwards', 'afterwards-path', 'spread'])
      forget(kind);
    forgetSides();
    this.forgetAim();
    const layers = this.page.layers();
    for (const layer of [layers.under, layers.compare]) layer.replaceChildren();
    $('other').textContent = '';
  }

  forgetAim() {
    for (const kind of ['own', 'own-path']) forget(kind);
    this.aimed = null;
    this.tried = null;
    this.page.layers().own.replaceChildren();
    if (this.page.shot()) $('other').textContent = '';
  }

  /** Updates the views that are switched on, for the chosen shot. */
  look() {
    this.heat();
    this.mirror();
    this.sides();
  }

  /** Aims at a point of the first cushion, with the chosen shot's speed. @param {[number, number]} at */
  aimAt(at) {
    const shot = this.page.shot();
    const table = this.page.table();
    if (!shot) return;
    const wall = firstCushion(table, shot.path);
    const upright = wall && Math.min(wall[0], table.length - wall[0]) < table.radius + 1e-6;
    this.aimed = wall ? (upright ? [wall[0], at[1]] : [at[0], wall[1]]) : at;
    const angle = angleTo(this.page.scene().ball, this.aimed);
    this.launch({ ...shot, angle });
  }

  launch(launch) {
    this.tried = launch;
    this.followTried();
  }

  followTried = latest(async () => {
    const launch = this.tried;
    const followed = launch && (await follow(this.page.scene(), launch, 'own'));
    if (!followed || followed.error) return;
    const layer = this.page.layers().own;
    layer.replaceChildren();
    lead(layer, [], followed, 'own');
    const angle = wrapped(launch.angle).toFixed(2);
    const words = outcome(this.page.scene(), followed);
    $('other').textContent = `Your aim, ${angle}° at ${launch.speed.toFixed(2)} m/s: it ${words}.`;
  });

  /** Shows the aim at the mirror image, and where it really leads. */
  async mirror() {
    const shot = this.page.shot();
    const layer = this.page.layers().compare;
    const say = (words) => ($('other').textContent = words);
    layer.replaceChildren();
    if (!shot) return;
    if (!$('mirror').checked) return;
    if (shot.then) return say('No mirror: this shot moves an object ball.');
    if (!shot.cushions.length) return say('Straight: a mirror changes nothing.');
    const [scene, table] = [this.page.scene(), this.page.table()];
    const to = scene.target === 'point' ? scene.point : shot.arrival.at;
    const launch = { ...shot, angle: mirrorAim(table, scene.ball, to, shot.cushions) };
    const followed = await follow(scene, launch, 'mirror');
    if (!followed || followed.error) return;
    lead(layer, mirrorPath(table, scene.ball, to, shot.cushions), followed, 'mirror');
    say(`Aimed at the mirror image, it ${outcome(scene, followed)}.`);
  }

  /** Shows the shot in another physics beside this one. */
  async sides() {
    const [shot, physics, box] = [this.page.shot(), $('compare').value, $('sides')];
    if (physics && shot) await sides(box, this.page.table(), this.page.scene(), shot, physics);
    else box.replaceChildren();
  }

  async heat() {
    const shot = this.page.shot();
    if (!shot || !$('why').open) return;
    const wrong = await heat($('heat'), state.puzzle(this.page.scene()), this.page.shots(), shot);
    $('scale').textContent = scale(shot);
    if (wrong) $('other').textContent = wrong;
  }

  async starts() {
    const layer = this.page.layers().under;
    layer.replaceChildren();
    $('busy').hidden = false;
    const say = (words) => ($('other').textContent = words);
    await starts(layer, state.puzzle(this.page.scene()), this.page.table(), say);
    $('busy').hidden = true;
  }
}
