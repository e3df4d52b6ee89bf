// A closer look at a shot: an aim of one's own, what the mirror image and another physics would say, why it is sure, and
// from where it can be played.
import { $ } from './controls.js';
import { ask, forget } from './engine.js';
import { follow, outcome } from './follow.js';
import { heat, launchAt } from './heat.js';
import { mirrorAim, mirrorPath } from './mirror.js';
import { firstCushion, lead } from './paint.js';
import { starts } from './starts.js';
import * as state from './state.js';

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
    /** @type {[number, number] | null} where an aim of one's own meets the first cushion */
    this.aimed = null;
    this.compared = 0; // how often
  }

  listen() {
    $('starts').addEventListener('click', () => this.starts());
    $('mirror').addEventListener('change', () => this.compare());
    $('compare').addEventListener('change', () => this.compare());
    $('why').addEventListener('toggle', () => this.heat());
    $('heat').addEventListener('click', (event) => {
      const box = $('heat').getBoundingClientRect();
      const [x, y] = [(event.clientX - box.left) / box.width, (box.bottom - event.clientY) / box.height];
      if (this.page.shot()) this.launch(launchAt(this.page.shot(), x, y));
    });
  }

  /** The scene has changed: nothing of it holds. */
  clear() {
    for (const kind of ['map', 'launches', 'mirror', 'compare']) forget(kind);
    this.forgetAim();
    const layers = this.page.layers();
    for (const layer of [layers.under, layers.compare]) layer.replaceChildren();
    $('other').textContent = '';
  }

  forgetAim() {
    for (const kind of ['own', 'own-path']) forget(kind);
    this.aimed = null;
    this.page.layers().own.replaceChildren();
  }

  /** At the chosen shot, as far as is asked. */
  look() {
    this.heat();
    this.compare();
  }

  /** The aim that meets the first cushion there, at the chosen shot's speed. @param {[number, number]} at */
  aimAt(at) {
    const shot = this.page.shot();
    const table = this.page.table();
    if (!shot) return;
    const wall = firstCushion(table, shot.path);
    const upright = wall && Math.min(wall[0], table.length - wall[0]) < table.radius + 1e-6;
    this.aimed = wall ? (upright ? [wall[0], at[1]] : [at[0], wall[1]]) : at;
    const [x, y] = this.page.scene().ball;
    const angle = (Math.atan2(this.aimed[1] - y, this.aimed[0] - x) * 180) / Math.PI;
    this.launch({ ...shot, angle });
  }

  async launch(launch) {
    const followed = await follow(this.page.scene(), launch, 'own');
    if (!followed || followed.error) return;
    const layer = this.page.layers().own;
    layer.replaceChildren();
    lead(layer, [], followed, 'own');
    const angle = (((launch.angle % 360) + 360) % 360).toFixed(2);
    const words = outcome(this.page.scene(), followed);
    $('other').textContent = `Your aim, ${angle}° at ${launch.speed.toFixed(2)} m/s: it ${words}.`;
  }

  /** What mirrors and another physics would say, and where that leads. */
  async compare() {
    const [shot, scene] = [this.page.shot(), this.page.scene()];
    const layer = this.page.layers().compare;
    layer.replaceChildren();
    const mine = ++this.compared;
    const said = [];
    const show = async (kind, name, launch, promised) => {
      const followed = await follow(scene, launch, kind);
      if (!followed || followed.error || mine !== this.compared) return;
      lead(layer, promised, followed, kind);
      said.push(`${name}, it ${outcome(scene, followed)}.`);
      $('other').textContent = said.join(' ');
    };
    if (!shot || shot.then) return;
    if ($('mirror').checked && shot.cushions.length) {
      const table = this.page.table();
      const to = scene.target === 'point' ? scene.point : shot.arrival.at;
      const promised = mirrorPath(table, scene.ball, to, shot.cushions);
      const angle = mirrorAim(table, scene.ball, to, shot.cushions);
      await show('mirror', 'Aimed at the mirror image', { ...shot, angle }, promised);
    }
    const other = $('compare').value;
    if (!other || mine !== this.compared) return;
    const speed = other === 'ideal' ? { speed: shot.speed } : {}; // there any speed would do
    const asked = { ...state.puzzle({ ...scene, physics: other }), cushions: shot.cushions, ...speed };
    const answer = await ask('solve?path&no-robustness', asked, 'compare');
    const found = answer?.shots?.[0];
    if (found) await show('compare', `Aimed as ${other} says`, found, found.path);
  }

  async heat() {
    const shot = this.page.shot();
    if (!shot || !$('why').open) return;
    const wrong = await heat($('heat'), state.puzzle(this.page.scene()), this.page.shots(), shot);
    if (wrong) $('other').textContent = wrong;
  }

  async starts() {
    const layer = this.page.layers().under;
    layer.replaceChildren();
    $('busy').hidden = false;
    const words = await starts(layer, state.puzzle(this.page.scene()), this.page.table());
    $('busy').hidden = true;
    if (words) $('other').textContent = words;
  }
}
