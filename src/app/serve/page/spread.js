// Where the cue ball stops for this player, for one shot whose answer does not say it.
import { ask } from './engine.js';
import * as state from './state.js';

const inOrder = (cushions) => (cushions.length ? cushions : 0);

/** Returns the question whose answer is this shot, which must leave the cue ball on the table. */
function question(scene, { length, width }, { then, hits, cushions, speed, spin }) {
  const { prefer, ball, ...asked } = /** @type {any} */ (state.puzzle(scene));
  const into = then && { then: { pocket: then.pocket, cushions: inOrder(then.cushions) } };
  return {
    ...asked,
    ball: { ...ball, ...(ball.spin ? { spin } : {}) },
    target: { ball: then?.ball ?? hits[0].ball, ...into },
    cushions: inOrder(cushions),
    speed,
    leave: {
      polygon: [
        [0, 0],
        [length, 0],
        [length, width],
        [0, width],
      ],
    },
  };
}

/**
 * Asks for the same shot again: the answer then has its spread.
 * @param {state.Scene} scene
 * @param {import('./table.js').Table} table
 * @param {any} shot
 * @returns {Promise<any>} mean, standard deviations and angle; undefined if nothing is known
 */
export async function spread(scene, table, shot) {
  const rests = Array.isArray(shot?.cue_rests) && shot.hits?.length;
  if (!rests || shot.leave || shot.then?.then) return undefined;
  const answer = await ask('solve', question(scene, table, shot), 'spread');
  const found = answer?.shots?.[0]?.leave;
  if (!found?.spread) return undefined;
  return { ...found.spread, at: shot.cue_rests.map((v, k) => v + found.spread.at[k] - found.at[k]) };
}
