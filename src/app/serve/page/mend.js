// Mends a scene that does not fit its table or its balls, such as one of an address that was typed.
import { within } from './layout.js';
import { targets } from './menus.js';
import * as state from './state.js';

/** The target that this table does not have, and the one in its place. */
let [wanted, stopgap] = ['', ''];

/** Gives the scene a target that the table has; another table brings back the one that was wanted. */
function mendTarget(scene, table) {
  const known = targets(table).map(([target]) => target);
  if (known.includes(wanted) && scene.target === stopgap) scene.target = wanted;
  if (known.includes(scene.target)) {
    if (scene.target !== stopgap) wanted = stopgap = '';
    return;
  }
  wanted = scene.target;
  scene.target = stopgap = known.includes(state.first.target) ? state.first.target : known[0];
}

/** Gives the balls names of their own, and the target one of them. */
function mendNames(scene) {
  const names = state.namesOf(scene);
  if (new Set(names).size < names.length || names.includes('cue')) scene.names = [];
  const moves = [state.pot, state.hit].includes(scene.target);
  if (!moves || !names.includes(scene.object)) scene.object = moves && names.length ? state.nameOf(scene, 0) : '';
  if (scene.target === state.play && names.some((name) => !(Number(name) > 0))) scene.game = 'any';
}

/** @param {state.Scene} scene changed in place @param {import('./table.js').Table} table */
export function mend(scene, table) {
  scene.table = table.name;
  mendTarget(scene, table);
  mendNames(scene);
  if (!table.pockets.some(({ name }) => name === scene.into)) scene.into = 'any';
  scene.order = scene.order.filter((cushion) => table.cushions.includes(cushion));
  scene.ball = within(table, scene.ball);
  scene.others = scene.others.map((at) => within(table, at));
  scene.point = within(table, scene.point);
}
