// The menus: what can be chosen in a scene, and what is chosen.
import * as controls from './controls.js';
import { $ } from './controls.js';
import * as skill from './skill.js';
import * as state from './state.js';
import { side } from './units.js';

/** Returns the pockets, each with its name as it is seen. @returns {[string, string][]} */
const pockets = (table) => table.pockets.map(({ name }) => [name, side(name)]);

/**
 * Returns the targets to choose from, with their names.
 * @param {import('./table.js').Table} table
 * @returns {[string, string][]}
 */
export function targets(table) {
  /** @type {[string, string][]} */
  const moves = [
    [state.play, 'what should I play?'],
    [state.anyBall, state.anyBall],
    [state.pot, 'pot this ball'],
    [state.hit, 'hit this ball'],
  ];
  const places = pockets(table);
  if (!places.length) return [['point', 'point'], moves[3]];
  return [...places, ['any', 'any'], ['point', 'point'], ...moves];
}

/**
 * Sets the controls to the scene.
 * @param {HTMLFormElement} form
 * @param {state.Scene} scene
 * @param {import('./table.js').Table} table
 * @param {import('./table.js').Table[]} tables
 */
export function menus(form, scene, table, tables) {
  controls.options(
    $('tables'),
    tables.map(({ name }) => controls.same(name)),
    scene.table,
  );
  controls.options($('targets'), targets(table), scene.target);
  controls.options($('objects'), state.namesOf(scene).map(controls.same), scene.object);
  controls.options($('pockets'), [controls.same('any'), ...pockets(table)], scene.into);
  const elements = /** @type {any} */ (form.elements);
  controls.show(form, scene);
  showSkill(scene);
  // The games of pool go by numbers.
  const numbered = state.namesOf(scene).every((name) => Number(name) > 0);
  for (const option of elements.game.options) option.disabled = !numbered && option.value !== 'any';
  const is = (...all) => all.includes(scene.target);
  for (const [name, wanted] of /** @type {[string, boolean][]} */ ([
    ['game', is(state.play)],
    ['group', is(state.play) && scene.game === 'eight'],
    ['object', is(state.pot, state.hit)],
    ['into', is(state.pot)],
  ]))
    elements[name].parentElement.hidden = !wanted;
  $('tip').toggleAttribute('aria-disabled', scene.physics !== 'spin' || state.chooses(scene));
  const sent = state.sends(scene);
  const any = sent ? 'cushions of the object ball' : 'any order; click cushions to set one';
  $('order').firstElementChild.textContent = (!sent && scene.order.map(side).join(', then ')) || any;
  $('unordered').hidden = sent || scene.order.length === 0;
  elements.least.disabled = sent || scene.order.length > 0;
  elements.most.disabled = is(state.play) || (!sent && scene.order.length > 0);
  $('remove').disabled = scene.others.length === 0;
  $('zone').textContent = scene.zone.length ? 'Leave it anywhere' : 'Leave the cue ball …';
  showHistory();
}

/** Says whose errors count. @param {state.Scene} scene */
export function showSkill(scene) {
  $('skilled').querySelector('.value').textContent = skill.described(scene.skill);
}

/** Offers to undo and redo where there is something. */
export function showHistory() {
  for (const [id, can] of Object.entries(state.can())) $(id).disabled = !can;
}
