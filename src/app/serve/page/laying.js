// How balls come onto the table: a new one, and the cue ball in hand.
import { freeName } from './balls.js';
import { $ } from './controls.js';
import { ask } from './engine.js';
import { apart, free, inside } from './layout.js';
import * as state from './state.js';

/**
 * @param {{scene: () => state.Scene, table: () => import('./table.js').Table, change: (f: () => void) => void}} page
 *   `change` makes a change that can be undone
 */
export function laying({ scene, table, change }) {
  /**
   * Adds a ball at a place, from which it pushes others away, or without one where there is room.
   * @param {string} name @param {[number, number]} [at]
   */
  function addBall(name, at) {
    const place = at ? inside(table(), at) : free(table(), [scene().ball, ...scene().others]);
    if (!place) return;
    change(() => {
      const now = scene();
      state.addBall(now, name, place);
      const balls = apart(table(), [now.ball, ...now.others], now.others.length);
      if (balls) [now.ball, ...now.others] = balls;
    });
  }

  /** Puts the cue ball, which is in hand, where the shot is best. */
  async function placeInHand() {
    $('other').textContent = 'Looking for the best place …';
    const asked = state.puzzle(scene());
    const answer = await ask('solve', { ...asked, ball: { ...asked.ball, at: 'anywhere' } }, 'place');
    if (!answer) return;
    if (answer.ball) change(() => (scene().ball = inside(table(), answer.ball.at)));
    $('other').textContent = answer.ball
      ? 'The cue ball stands where the shot is best.'
      : `No place was found: ${answer.error?.reason ?? answer.message}.`;
  }

  return { addBall, placeInHand, nextName: () => freeName(table(), state.namesOf(scene())) };
}
