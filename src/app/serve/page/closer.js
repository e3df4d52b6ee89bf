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
import { wrapped } from './units.js';

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
    if (this.page.shot()) $('other').textContent = '';
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
    const angle = wrapped(launch.angle).toFixed(2);
    const words = outcome(this.page.scene(), followed);
    $('other').textContent = `Your aim, ${angle}° at ${launch.speed.toFixed(2)} m/s: it ${words}.`;
  }

  /** What mirrors and another physics would say, and where that leads. */
  async compare() {
    const shot = this.page.shot();
    const mine = ++this.compared;
    const ways = [$('mirror').checked && this.mirrored, $('compare').value && this.otherwise].filter(Boolean);
    this.page.layers().compare.replaceChildren();
    if (!shot) return;
    if (!this.aimed) $('other').textContent = ways.length && shot.then ? 'Nothing to compare: it sends a ball on.' : '';
    if (shot.then) return;
    const said = [];
    for (const way of ways) {
      const found = await way.call(this, shot);
      if (mine !== this.compared) return;
      const words = typeof found === 'string' ? found : found && (await this.lead(found));
      if (mine !== this.compared) return;
      if (words) said.push(words);
      $('other').textContent = said.join(' ');
    }
  }

  /** Where a launch really leads, drawn and in words. */
  async lead({ kind, name, launch, promised }) {
    const scene = this.page.scene();
    const followed = await follow(scene, launch, kind);
    if (!followed || followed.error) return '';
    lead(this.page.layers().compare, promised, followed, kind);
    return `${name}, it ${outcome(scene, followed)}.`;
  }

  mirrored(shot) {
    if (!shot.cushions.length) return 'Straight, a mirror changes nothing.';
    const [scene, table] = [this.page.scene(), this.page.table()];
    const to = scene.target === 'point' ? scene.point : shot.arrival.at;
    const angle = mirrorAim(table, scene.ball, to, shot.cushions);
    const promised = mirrorPath(table, scene.ball, to, shot.cushions);
    return { kind: 'mirror', name: 'Aimed at the mirror image', launch: { ...shot, angle }, promised };
  }

  async otherwise(shot) {
    const physics = $('compare').value;
    const speed = physics === 'ideal' ? { speed: shot.speed } : {}; // there any speed would do
    const puzzle = { ...state.puzzle({ ...this.page.scene(), physics }), cushions: shot.cushions, ...speed };
    const answer = await ask('solve?path&no-robustness', puzzle, 'compare');
    const launch = answer?.shots?.[0];
    if (!launch) return answer && `${physics} knows no such shot.`;
    return { kind: 'compare', name: `Aimed as ${physics} says`, launch, promised: launch.path };
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
    const say = (words) => ($('other').textContent = words);
    await starts(layer, state.puzzle(this.page.scene()), this.page.table(), say);
    $('busy').hidden = true;
  }
}
