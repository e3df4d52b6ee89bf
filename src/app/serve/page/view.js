// The answer in view: its list, its words, its picture and its animation.
import { fill, groups, heading, likest, mark, tell, told, words } from './answer.js';
import { $ } from './controls.js';
import { forget } from './engine.js';
import { finish, follow, hits, outcome, turns } from './follow.js';
import { aim, firstCushion, lead, note, paint } from './paint.js';
import { play, stop } from './play.js';
import { click } from './sound.js';
import { spread } from './spread.js';
import * as state from './state.js';
import { sight } from './table.js';

/**
 * @typedef {{
 *   scene: () => state.Scene, table: () => import('./table.js').Table, board: () => import('./board.js').Board,
 *   layers: () => Record<'answer', any>, closer: () => import('./closer.js').Closer, shown: (shot: any) => void,
 * }} Page `shown` is called with the shot in view
 */

/** A shot of another search replaces the one in view if its value is larger by this. */
const better = 0.002;

export class View {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    this.empty();
    this.picked = ''; // address of the scene for which the user chose a shot
    this.wanted = null; // launch of the shot that the address names
  }

  /** Forgets all shots, and says that others are looked for. */
  empty() {
    $('title').textContent = 'Searching …';
    tell($('words'), []);
    $('shots').replaceChildren();
    for (const id of ['playing', 'why', 'every']) $(id).hidden = true;
    for (const id of ['status', 'place', 'other']) $(id).textContent = '';
    /** @type {any[]} */
    this.shots = [];
    this.chosen = 0;
    this.seen = undefined; // shot in view
    /** @type {any} */
    this.last = {}; // latest answer
    this.plan = undefined; // of the best shot of a game
  }

  shot() {
    return this.shots[this.chosen];
  }

  /** Shows the best shot, while the list that was there waits for the wider search. */
  best(answer) {
    this.old(true);
    $('shot').style.setProperty('min-height', '0');
    this.take(answer, answer.shots ?? [], 0);
    this.status(answer, answer.shots?.length ? 'Looking for other shots …' : '');
    if (!$('shots').childElementCount) this.list();
    this.look();
  }

  /** Shows all shots. The best one stays in view unless a better one was found, or the user chose another. */
  all(answer) {
    const picked = this.picked === document.body.dataset.asked;
    const was = this.wanted ?? (picked ? this.shot() : this.shots[0]);
    const found = answer.shots ?? [];
    if (found.length || !this.shots.length) this.widen(answer, found, was, picked || Boolean(this.wanted));
    else this.last = { ...this.last, wider: answer.error?.reason ?? 'the wider search ended at its budget' };
    this.old(false);
    this.status(answer, '');
    this.list();
    this.look();
    this.wanted = null;
    $('said').textContent = this.spoken();
    if (!this.shots.length) this.lacks(answer);
  }

  /** Takes all shots, and keeps the one that was in view: a better one takes its place, unless the user chose it. */
  widen(answer, found, was, firm) {
    const plan = this.plan;
    // A plan belongs to the first shot of its answer.
    const stays = was && (firm || (!answer.plan && !beats(found[0], was)));
    const missing = stays && was.path && !found.some((shot) => same(shot, was));
    const shots = missing ? [was, ...found] : found;
    this.take(answer, shots, stays ? likest(shots, was) : 0);
    this.plan ??= stays ? plan : undefined;
  }

  take(answer, shots, chosen) {
    Object.assign(this, { last: answer, shots, chosen });
    this.plan = answer.plan;
  }

  /** Says the shot in a sentence, for those who do not see the table. */
  spoken() {
    return [$('title').textContent, ...told($('words')).map((row) => row.join(' '))].join('. ');
  }

  /** Dims the list that belongs to another scene. @param {boolean} is */
  old(is) {
    $('shots').inert = is;
    $('shots').classList.toggle('old', is);
  }

  /** Fills the list. */
  list() {
    const on = { look: (i) => this.look(i), choose: (i) => this.choose(i) };
    fill($('shots'), this.shots, this.chosen, on);
    $('shots').onmouseleave = () => this.seen !== this.shot() && this.look();
    $('every').hidden = this.shots.length < 3;
  }

  status(answer, more) {
    if (this.page.closer().guess) return;
    const text = answer.error ? answer.error.reason : brief(answer.message ?? '');
    $('status').textContent = (text[0] ?? '').toUpperCase() + text.slice(1) + (more ? '. ' + more : '');
  }

  /** Says why there is no shot, and shows what came nearest. */
  async lacks({ message = '', nearest, error }) {
    if (this.page.closer().guess) return;
    const { scene, layers, table } = this.page;
    const asked = document.body.dataset.asked;
    const followed = nearest && (await follow(scene(), nearest, 'nearest'));
    if (asked !== document.body.dataset.asked) return;
    if (followed?.path) lead(layers().answer, [], followed, 'nearest');
    const why = (error ? error.reason : message).split('; ').pop() || 'no reason is known';
    const point = scene().target === 'point' ? [scene().point] : [];
    const balls = [scene().ball, ...scene().others, ...point];
    note(layers().answer, table(), why[0].toUpperCase() + why.slice(1), balls);
    if (followed?.path) $('other').textContent = `What comes nearest ${outcome(scene(), followed)}.`;
  }

  /** Shows the user's guess in the place of the answer. */
  guessing() {
    const { scene, table, board, closer, layers } = this.page;
    const { at } = sight(table(), scene().ball, closer().guess.angle);
    layers().answer.replaceChildren();
    aim(layers().answer, scene().ball, at);
    board().place('cushion', at);
  }

  /** Shows a shot. @param {number} [i] its number; the chosen one without it */
  look(i = this.chosen) {
    const { scene, table, board, closer, shown } = this.page;
    if (closer().guess) return this.guessing();
    const shot = (this.seen = this.shots[i]);
    // The list below must not move away from under the pointer.
    $('shot').style.setProperty('min-height', `${$('shot').offsetHeight}px`);
    this.paint(shot);
    board().place('cushion', closer().aimed ?? this.aimPoint());
    $('title').textContent = [heading(shot, scene().target, this.last.status), this.last.wider]
      .filter(Boolean)
      .join('; ');
    $('playing').hidden = !shot?.path;
    $('further').hidden = !shot?.hits?.length;
    $('why').hidden = !shot;
    const over = shot && sight(table(), scene().ball, shot.angle).words;
    const plan = i === 0 ? this.plan : undefined;
    const steady = !state.sends(scene()) || scene().most === 0;
    tell($('words'), shot ? words(shot, { aim: over, table: table(), plan, steady }) : []);
    shown(shot);
    if (document.body.dataset.asked === document.body.dataset.answered) this.lookOn(shot);
  }

  /** Draws a shot before others: the best of each pattern. @param {any} shot @param {any} [afterwards] */
  paint(shot, afterwards) {
    const { scene, table, layers } = this.page;
    const others = $('paths').checked ? this.shots : [...groups(this.shots).values()].map(([i]) => this.shots[i]);
    const balls = new Map(state.namesOf(scene()).map((name, i) => [name, scene().others[i]]));
    const plan = shot === this.shots[0] ? this.plan : undefined;
    paint(layers().answer, table(), others, shot, { afterwards, all: $('paths').checked, plan, balls });
    layers().answer.classList.toggle('dims', shot !== this.shot());
  }

  /** Adds the rest of the cue ball's path, and where it stops for this player. */
  async lookOn(shot) {
    const { scene, table } = this.page;
    const [afterwards, spreads] = await Promise.all([
      finish(scene(), shot, 'afterwards'),
      shot?.spread ?? spread(scene(), table(), shot),
    ]);
    if (!afterwards || shot !== this.seen) return;
    if (spreads) shot.spread = spreads;
    this.paint(shot, afterwards);
  }

  /** Returns the cue ball's first point on a cushion, or null if it hits a ball. */
  aimPoint() {
    const shot = this.shot();
    return shot?.path && !shot.hits?.length ? firstCushion(this.page.table(), shot.path) : null;
  }

  choose(i) {
    this.chosen = i;
    this.picked = document.body.dataset.asked;
    this.page.closer().forgetAim();
    mark($('shots'), i);
    this.look();
    this.page.closer().look();
    $('said').textContent = this.spoken();
    state.write(this.page.scene(), i ? this.shot() : null);
    this.start(1);
  }

  // ---- the animation ----

  /** @returns {Promise<any>} what happened; nothing if another one took its place */
  async start(pace, launch = this.shot()) {
    if (!launch) return undefined;
    const followed = await follow(this.page.scene(), launch, 'play');
    if (followed?.error) $('other').textContent = `It cannot be played: ${followed.error.reason}.`;
    if (!followed || followed.error) return undefined;
    const names = state.namesOf(this.page.scene());
    const gripOf = (ball) => (ball === 'cue' ? 'ball' : `other${names.indexOf(ball)}`);
    const board = this.page.board();
    const balls = Object.entries({ cue: followed.path, ...followed.paths }).map(([ball, path]) => ({
      ...board.grips.get(gripOf(ball)),
      path,
      turns: turns(followed.events, ball),
      radius: this.page.table().radius,
    }));
    document.body.dataset.playing = 'true';
    const sounds = $('sound').checked ? hits(followed.events) : [];
    if (!(await play(balls, pace, sounds, click))) return undefined;
    document.body.dataset.played = balls.map(({ path }) => path[path.length - 1].slice(1).join()).join(' ');
    delete document.body.dataset.playing;
    setTimeout(() => document.body.dataset.playing || board.placeAll(), 700);
    return followed;
  }

  /** Returns the scene after the shot in view: balls that fell are gone. @returns {Promise<state.Scene | null>} */
  async after() {
    const { scene } = this.page;
    const followed = this.shot() && (await follow(scene(), this.shot(), 'further'));
    if (!followed?.path) return null;
    const next = structuredClone(scene());
    const end = (path) => path[path.length - 1].slice(1);
    const fell = new Set(followed.events.filter(({ type }) => type === 'pocket').map(({ ball }) => ball));
    if (!fell.has('cue')) next.ball = end(followed.path);
    const names = state.namesOf(next);
    for (let i = names.length - 1; i >= 0; --i) {
      const path = followed.paths[names[i]];
      if (fell.has(names[i])) state.removeBall(next, i);
      else if (path) next.others[i] = end(path);
    }
    return next;
  }

  /** Ends the animation and puts the balls back. */
  halt() {
    for (const kind of ['play', 'play-path']) forget(kind);
    if (!document.body.dataset.playing) return;
    stop();
    delete document.body.dataset.playing;
    this.page.board().placeAll();
  }
}

/** Shortens what the program says of a list: the page cannot find shots that the search missed either. */
const brief = (message) =>
  message.replace(/ distinct shots found; there may be more:.*/, ' shots found; there may be more');

const same = (a, b) => Math.abs(a.angle - b.angle) < 0.05 && Math.abs(a.speed - b.speed) < 0.02;

/** Says whether a shot is better than the one in view. */
const beats = (a, b) => (a?.value ?? a?.success ?? 0) > (b.value ?? b.success ?? 0) + better;
