// The conduct of the search: the best shot first, while things are dragged too; then, at rest, all shots.
import { $ } from './controls.js';
import { ask, latest } from './engine.js';
import * as state from './state.js';

/**
 * @param {() => state.Scene} scene
 * @param {{none: () => void, best: (answer: any) => void, all: (answer: any) => void}} on called with the newest
 *   answers; `none`: the table has no ball to play
 * @returns {() => void} begins a search; a newer one ends it
 */
export function searcher(scene, on) {
  let slow; // timer
  const wait = () => {
    clearTimeout(slow);
    slow = setTimeout(() => ($('busy').hidden = false), 300);
  };
  const rest = () => {
    clearTimeout(slow);
    $('busy').hidden = true;
  };
  const answered = () => (document.body.dataset.answered = document.body.dataset.asked); // tests wait for it
  const newest = (asked) => asked === document.body.dataset.asked;

  /** Lists all shots, perhaps for seconds; a move ends it. */
  async function all(puzzle) {
    const answer = await ask('solve?all&path', puzzle, 'solve');
    if (!answer) return;
    rest();
    answered();
    on.all(answer);
  }

  /** A move lets this question end, so that the picture follows the dragging. */
  const best = latest(async () => {
    if (!scene().others.length && (state.sends(scene()) || scene().target === state.hit)) {
      answered();
      return on.none();
    }
    const [asked, puzzle] = [document.body.dataset.asked, state.puzzle(scene())];
    wait();
    // A plan takes longer than its first shot; it comes with the list.
    const answer = await ask(scene().target === state.play ? 'solve?path&depth=0' : 'solve?path', puzzle, 'solve');
    if (!answer) return;
    on.best(answer);
    if (newest(asked)) all(puzzle);
  });

  return () => {
    document.body.dataset.asked = state.address(scene());
    best();
  };
}
