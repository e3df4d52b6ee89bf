// The page: the scene, its picture, and the engine's answer while things are dragged.
import { fill, heading, likest, mark, tell, words } from './answer.js';
import { Board, free, inside } from './board.js';
import { Closer } from './closer.js';
import * as controls from './controls.js';
import { $ } from './controls.js';
import { holding, pointIn } from './drag.js';
import { ask, forget, latest } from './engine.js';
import { finish, follow, hits, outcome, turns } from './follow.js';
import { hang } from './gallery.js';
import { firstCushion, lead, note, paint } from './paint.js';
import { play, stop } from './play.js';
import * as save from './save.js';
import { click } from './sound.js';
import * as state from './state.js';
import { draw, shape, sight } from './table.js';
import { tip } from './tip.js';
import * as units from './units.js';

const svg = $('table');
const form = $('controls');

let scene = state.read();
/** @type {import('./table.js').Table[]} */
let tables = [];
/** @type {import('./table.js').Table} */
let table;
let layers;
/** @type {Board} */
let board;
let shots = [];
let chosen = 0;
let picked = ''; // address of the scene for which the user chose a shot
let seen; // shot in view
let last = {}; // latest answer

const closer = new Closer({
  scene: () => scene,
  table: () => table,
  shots: () => shots,
  shot: () => shots[chosen],
  layers: () => layers,
});

// ---- the scene ----

const hands = {
  scene: () => scene,
  moved(before) {
    if (before && state.address(before) !== state.address(scene)) remember(before);
    if (before) show();
    solve();
  },
  says: (name, at) => ($('place').textContent = `${name}: ${units.place(at, table)}`),
  removed: (i) => change(() => scene.others.splice(i, 1)),
  snaps: () => $('snap').checked,
  aim: {
    where: () => closer.aimed ?? aimPoint(shots[chosen]),
    move: (at) => closer.aimAt(inside(table, at)),
  },
};

/** Returns the cue ball's first point on a cushion, or null if it hits a ball. */
function aimPoint(shot) {
  return shot?.path && !shot.hits?.length ? firstCushion(table, shot.path) : null;
}

function targets() {
  if (!table.pockets.length) return ['point'];
  return [...table.pockets.map(({ name }) => name), 'any', 'point', ...(scene.others.length ? [state.anyBall] : [])];
}

/** Draws everything anew, after a change that is not a movement. */
function rebuild() {
  const { grip, cushion } = svg.querySelector(':focus')?.dataset ?? {};
  table = tables.find(({ name }) => name === scene.table) ?? tables[0];
  scene.table = table.name;
  if (!targets().includes(scene.target)) scene.target = targets().find((t) => t === state.first.target) ?? targets()[0];
  scene.order = scene.order.filter((cushion) => table.cushions.includes(cushion));
  scene.ball = inside(table, scene.ball);
  scene.others = scene.others.map((at) => inside(table, at));
  scene.point = inside(table, scene.point);
  const ordered = scene.target !== state.anyBall; // with any ball the planner chooses the cushions
  layers = draw(svg, table, (cushion) => ordered && change(() => scene.order.push(cushion)));
  layers.compare = shape('g', {}, layers.paths);
  layers.answer = shape('g', {}, layers.paths);
  layers.own = shape('g', {}, layers.paths);
  shots = [];
  board = new Board(svg, layers.grips, table, hands);
  svg.querySelector(grip ? `[data-grip="${grip}"]` : `[data-cushion="${cushion}"]`)?.focus(); // as before
  show();
  forget('solve'); // its answer would be drawn on another table
  solve();
}

/** Sets the controls to the scene. */
function show() {
  controls.options(
    $('tables'),
    tables.map(({ name }) => name),
    scene.table,
  );
  controls.options($('targets'), targets(), scene.target);
  controls.show(form, scene);
  drawTip({ side: scene.side, top: scene.top });
  $('tip').toggleAttribute('aria-disabled', scene.physics !== 'spin' || scene.choose);
  const sent = scene.target === state.anyBall;
  const any = sent ? 'cushions of the object ball' : 'any order; click cushions to set one';
  $('order').firstElementChild.textContent = (!sent && scene.order.join(', then ')) || any;
  $('unordered').hidden = sent || scene.order.length === 0;
  form.elements.least.disabled = sent || scene.order.length > 0;
  form.elements.most.disabled = !sent && scene.order.length > 0;
  $('remove').disabled = scene.others.length === 0;
  canUndo();
}

function canUndo() {
  for (const [id, can] of Object.entries(state.can())) $(id).disabled = !can;
}

/** Saves the scene before a change. @param {state.Scene} before */
function remember(before) {
  state.remember(before);
  canUndo();
}

function change(f) {
  remember(scene);
  f();
  rebuild();
}

// ---- the answer ----

function solve() {
  document.body.dataset.asked = state.address(scene); // tests wait until `answered` equals it
  closer.clear();
  halt();
  searchFirst();
}

let slow; // timer

/** Searches for one shot. A move lets this search end, so that the picture follows the dragging. */
const searchFirst = latest(async () => {
  const [asked, puzzle] = [document.body.dataset.asked, state.puzzle(scene)];
  clearTimeout(slow);
  slow = setTimeout(() => ($('busy').hidden = false), 300);
  const first = await ask('solve?first&path', puzzle, 'solve');
  if (!first) return;
  answered(first, 'Looking for better shots …');
  if (asked === document.body.dataset.asked) searchAll(puzzle, first);
});

/** Searches for all shots, perhaps for seconds; a move ends it. If it finds none, the first shot stays. */
async function searchAll(puzzle, first) {
  const all = await ask('solve?all&path', puzzle, 'solve');
  if (!all) return;
  clearTimeout(slow);
  $('busy').hidden = true;
  state.write(scene); // not while dragging: browsers allow only some hundred a minute
  document.body.dataset.answered = document.body.dataset.asked;
  const wider = all.error?.reason ?? 'the wider search ended at its budget';
  answered(first.shots.length && !all.shots.length ? { ...first, wider } : all, '');
  closer.look();
}

function answered(answer, more) {
  const before = picked === document.body.dataset.asked ? shots[chosen] : null;
  shots = answer.shots ?? [];
  chosen = before ? likest(shots, before) : 0;
  last = answer;
  const text = answer.error ? answer.error.reason : (answer.message ?? '');
  $('status').textContent = (text[0] ?? '').toUpperCase() + text.slice(1) + (more ? '. ' + more : '');
  fill($('shots'), shots, chosen, { look, choose });
  look();
  if (!shots.length && !more) lacks(answer);
}

/** Says why there is no shot, and shows what came nearest. */
async function lacks({ message = '', nearest, error }) {
  const asked = document.body.dataset.asked;
  const followed = nearest && (await follow(scene, nearest, 'nearest'));
  if (asked !== document.body.dataset.asked) return;
  if (followed?.path) lead(layers.answer, [], followed, 'nearest');
  const why = (error ? error.reason : message).split('; ').pop();
  const point = scene.target === 'point' ? [scene.point] : [];
  note(layers.answer, table, why[0].toUpperCase() + why.slice(1), [scene.ball, ...scene.others, ...point]);
  if (followed?.path) $('other').textContent = `What comes nearest ${outcome(scene, followed)}.`;
}

/** Shows a shot. @param {number} [i] its number; the chosen one without it */
function look(i = chosen) {
  const shot = (seen = shots[i]);
  $('shots').onmouseleave = () => i !== chosen && look();
  paint(layers.answer, table, shots, shot);
  board.place('cushion', closer.aimed ?? aimPoint(shot));
  $('title').textContent = [heading(shot, scene.target), last.wider].filter(Boolean).join('; ');
  $('playing').hidden = !shot?.path;
  $('why').hidden = !shot;
  const rows = shot ? words(shot, sight(table, scene.ball, shot.angle).words, units.length) : [];
  tell($('words'), rows);
  if (document.body.dataset.asked === document.body.dataset.answered) lookOn(shot);
}

/** Adds the rest of the cue ball's path. */
async function lookOn(shot) {
  const afterwards = await finish(scene, shot, 'afterwards');
  if (afterwards && shot === seen) paint(layers.answer, table, shots, shot, afterwards);
}

function choose(i) {
  chosen = i;
  picked = document.body.dataset.asked;
  closer.forgetAim();
  mark($('shots'), chosen);
  look();
  closer.look();
  start(1);
}

// ---- the animation ----

/** Returns the name of a ball's grip on the board. */
const gripOf = (ball) => (ball === 'cue' ? 'ball' : `other${Number(ball) - 1}`);

async function start(pace, launch = shots[chosen]) {
  if (!launch) return;
  const followed = await follow(scene, launch, 'play');
  if (!followed || followed.error) return;
  const balls = Object.entries({ cue: followed.path, ...followed.paths }).map(([ball, path]) => ({
    ...board.grips.get(gripOf(ball)),
    path,
    turns: turns(followed.events, ball),
    radius: table.radius,
  }));
  document.body.dataset.playing = 'true';
  const sounds = $('sound').checked ? hits(followed.events) : [];
  if (!(await play(balls, pace, sounds, click))) return;
  document.body.dataset.played = balls.map(({ path }) => path[path.length - 1].slice(1).join()).join(' ');
  delete document.body.dataset.playing;
  setTimeout(() => document.body.dataset.playing || board.placeAll(), 700);
}

/** Ends the animation and puts the balls back. */
function halt() {
  for (const kind of ['play', 'play-path']) forget(kind);
  if (!document.body.dataset.playing) return;
  stop();
  delete document.body.dataset.playing;
  board.placeAll();
}

// ---- the controls ----

let untouched = null;
const drawTip = tip($('tip'), ({ side, top }, done) => {
  untouched ??= structuredClone(scene);
  Object.assign(scene, { side, top });
  if (done) remember(untouched);
  if (done) untouched = null;
  solve();
});

/** Keys of the scene whose change requires a new drawing. */
const shapes = ['table', 'target', 'physics', 'choose'];

function listen() {
  const on = (id, event, f) => $(id).addEventListener(event, f);
  const pressed = (id, f) => on(id, 'click', f);
  controls.bind(
    form,
    () => scene,
    remember,
    (key) => (shapes.includes(key) ? rebuild() : solve()),
  );
  pressed('add', () => {
    const at = free(table, [scene.ball, ...scene.others]);
    if (at) change(() => scene.others.push(at));
  });
  pressed('remove', () => change(() => scene.others.pop()));
  pressed('unordered', () => change(() => (scene.order = [])));
  pressed('undo', () => ((scene = state.undo(scene)), rebuild()));
  pressed('redo', () => ((scene = state.redo(scene)), rebuild()));
  pressed('play', () => start(1));
  pressed('slow', () => start(0.25));
  pressed('json', () => save.json(state.puzzle(scene), shots));
  pressed('svg', () => save.svg(svg));
  pressed('png', () => save.png(svg));
  closer.listen();
  on('inches', 'change', () => (units.useInches($('inches').checked), answered(last, '')));
  hang($('gallery'), (address) => change(() => (scene = state.read(address))));
  svg.addEventListener('dblclick', (event) => {
    if (!event.target.classList.contains('cloth')) return;
    change(() => scene.others.push(inside(table, pointIn(svg, event))));
  });
  addEventListener('resize', () => board.placeAll());
  addEventListener('hashchange', () => change(() => (scene = state.read())));
  addEventListener('keydown', (event) => {
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || !['z', 'y'].includes(key) || holding()) return;
    event.preventDefault();
    scene = event.shiftKey || key === 'y' ? state.redo(scene) : state.undo(scene);
    rebuild();
  });
}

document.body.classList.toggle('embed', new URLSearchParams(location.search).has('embed'));
$('inches').checked = units.inches;
const [known, schema] = await Promise.all([ask('tables'), ask('schema?document=shot')]);
tables = known;
if (Array.isArray(tables)) {
  const laws = state.laws(schema);
  scene = state.read();
  controls.options(form.elements.cushion, laws, scene.cushion);
  listen();
  rebuild();
} else {
  $('status').textContent = /** @type {any} */ (tables)?.error.reason ?? 'the engine does not answer';
}
