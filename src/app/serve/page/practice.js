// Practice: today's puzzle and drills, which are guessed before the answer is shown, and a record of the guesses.
import { called } from './balls.js';
import { $ } from './controls.js';
import { ask } from './engine.js';
import { read } from './open.js';
import * as state from './state.js';
import { keep, kept } from './store.js';
import { angleTo, side } from './units.js';

/** What each kind of drill asks of the generator. @type {Record<string, string>} */
const kinds = {
  pot: 'target=pot&cushions=0&balls=3',
  bank: 'target=pot&cushions=0&then=1&balls=3',
  kick: 'target=kick&cushions=1-2&balls=3',
  pocket: 'target=pocket&cushions=1-2',
};
const speeds = '0.5,5'; // m/s: a player's
const store = 'record'; // key in the browser's store

/** Returns the number of a day: its year, month and day. @param {Date} day */
const dayOf = (day) => day.getFullYear() * 10000 + (day.getMonth() + 1) * 100 + day.getDate();

/** @returns {{tried: number, made: number, days: number[]}} */
const record = () => kept(store, { tried: 0, made: 0, days: [] });

/** @param {state.Scene} scene */
function cushions({ least, most }) {
  return least === most ? (most === 1 ? 'one cushion' : `${most} cushions`) : `${least} to ${most} cushions`;
}

/** Says what a puzzle asks. @param {state.Scene} scene */
function task(scene) {
  const by = scene.order.length ? ` by ${scene.order.join(', ')}` : '';
  if (scene.target === state.pot) {
    const banks = scene.most ? `Bank ${called(scene.object)}` : `Pot ${called(scene.object)}`;
    return `${banks} into ${scene.into === 'any' ? 'any pocket' : side(scene.into)}.`;
  }
  if (scene.target === state.hit) return `Hit ${called(scene.object)} by ${cushions(scene)}.`;
  return `The cue ball into ${side(scene.target)}${by || ` by ${cushions(scene)}`}.`;
}

/** Says whether a launch made what the scene asks. @param {state.Scene} scene @param {any} followed */
function made(scene, { events }) {
  const falls = events.filter(({ type }) => type === 'pocket');
  const cue = falls.find(({ ball }) => ball === 'cue');
  if (scene.target === state.pot)
    return !cue && falls.some(({ ball, pocket }) => ball === scene.object && ['any', pocket].includes(scene.into));
  const first = events.find(({ type }) => type === 'ball');
  const names = first ? [first.ball, first.other?.ball ?? first.other] : [];
  const before = events.slice(0, events.indexOf(first));
  const rails = before.filter(({ type, ball }) => type === 'cushion' && ball === 'cue').length;
  if (scene.target === state.hit) return !cue && names.includes(scene.object) && rails >= scene.least;
  return cue?.pocket === scene.target;
}

export class Practice {
  /**
   * @param {{scene: () => state.Scene, view: import('./view.js').View, closer: import('./closer.js').Closer,
   *   begin: (scene: state.Scene) => void, tables: () => import('./table.js').Table[]}} page
   */
  constructor(page) {
    this.page = page;
    this.day = 0; // the day whose puzzle this is
    this.asked = ''; // address of the puzzle
  }

  listen() {
    $('daily').addEventListener('click', () => this.daily());
    $('drill').addEventListener('click', () => this.drill());
    $('shoot').addEventListener('click', () => this.shoot());
    $('reveal').addEventListener('click', () => this.reveal());
    $('again').addEventListener('click', () => this.again());
    const say = () => ($('guess').querySelector('.value').textContent = Number($('force').value).toFixed(2));
    $('force').addEventListener('input', say);
    say();
    this.tell();
  }

  /** The same puzzle for everyone, each day of another kind. */
  daily() {
    const day = dayOf(new Date());
    const names = Object.keys(kinds);
    return this.make(names[day % names.length], 'medium', day, day);
  }

  drill() {
    const seed = Math.floor(Math.random() * 1e9);
    return this.make($('kind').value, $('level').value, seed, 0);
  }

  /** @param {string} kind @param {string} level @param {number} seed @param {number} day 0 for a drill */
  async make(kind, level, seed, day) {
    $('other').textContent = 'Making a puzzle …';
    $('busy').hidden = false;
    const before = state.address(this.page.scene());
    const flags = `seed=${seed}&difficulty=${level}&speed=${speeds}&no-spin&${kinds[kind]}`;
    const puzzle = await ask(`generate?${flags}`, {}, 'generate');
    $('busy').hidden = true;
    // The user may have gone on to something else.
    if (!puzzle || state.address(this.page.scene()) !== before) return;
    const { scene, error } = puzzle.error
      ? { error: puzzle.error.reason }
      : read(JSON.stringify(puzzle), this.page.tables());
    if (!scene) {
      $('other').textContent = error;
      return;
    }
    this.day = day;
    this.page.closer.guess = null;
    this.page.begin({ ...scene, skill: this.page.scene().skill });
    this.asked = state.address(this.page.scene());
    this.check();
    $('task').textContent = task(this.page.scene());
    if ($('guessing').checked || day > 0) this.again();
    document.body.scrollIntoView({ behavior: 'smooth' });
  }

  /** Lets the user guess, for the first time or once more. */
  again() {
    this.aim();
    this.page.closer.forgetAim();
    this.show();
    $('status').textContent = '';
    this.page.view.look();
  }

  /** Ends the guessing if the scene is no longer that of the puzzle. */
  check() {
    const own = state.address(this.page.scene()) === this.asked;
    if (!own) this.page.closer.guess = null;
    this.show();
    $('again').hidden = !own;
  }

  /** Aims straight at what is to be hit, as a first guess. */
  aim() {
    const { scene, table, closer } = /** @type {any} */ (this.page);
    const { object, ball, target } = scene();
    const i = state.namesOf(scene()).indexOf(object);
    const pocket = table().pockets.find(({ name }) => name === target);
    const at = [state.pot, state.hit].includes(target) && i >= 0 ? scene().others[i] : (pocket?.at ?? [0, 0]);
    closer.guess = { angle: angleTo(ball, at) };
  }

  /** Shows what is to be guessed, or else the answer. */
  show() {
    const guesses = this.page.closer.guess !== null;
    $('guess').hidden = !guesses;
    $('told').hidden = guesses;
  }

  /** Ends the guessing. */
  reveal() {
    this.page.closer.guess = null;
    this.show();
    this.page.view.look();
  }

  /** Plays the guess, counts it, and shows the answer. */
  async shoot() {
    const { closer, view, scene } = this.page;
    const launch = { ...closer.guess, speed: Number($('force').value), spin: { top: 0, side: 0 } };
    this.reveal();
    closer.launch(launch);
    const followed = await view.start(1, launch);
    if (!followed) return;
    const good = made(scene(), followed);
    const all = record();
    Object.assign(all, { tried: all.tried + 1, made: all.made + Number(good) });
    if (good && this.day && !all.days.includes(this.day)) all.days.push(this.day);
    keep(store, all);
    this.tell(all);
    $('other').textContent = good ? 'Made!' : 'Missed. Your path is drawn beside the best one.';
  }

  tell({ tried, made, days } = record()) {
    $('record').textContent = tried ? `${made} of ${tried} made, ${days.length} daily puzzles solved.` : '';
  }
}
