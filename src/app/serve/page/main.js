// The page: the scene, its picture, and the engine's answer while things are dragged.
import { Board } from './board.js';
import { Closer } from './closer.js';
import * as controls from './controls.js';
import { $ } from './controls.js';
import { holding, pointIn, settle } from './drag.js';
import { ask, forget, onLost } from './engine.js';
import { hang } from './gallery.js';
import { sharing } from './keep.js';
import { apart, carry, inside } from './layout.js';
import { laying } from './laying.js';
import { mend } from './mend.js';
import { menus, showHistory, showSkill } from './menus.js';
import { Practice } from './practice.js';
import { searcher } from './search.js';
import * as skill from './skill.js';
import * as state from './state.js';
import { draw, shape, sight } from './table.js';
import { tip } from './tip.js';
import { tray } from './tray.js';
import * as units from './units.js';
import { View } from './view.js';
import { zoning } from './zone.js';

const svg = $('table');
const form = $('controls');
const upended = matchMedia('(orientation: portrait) and (max-width: 40rem)'); // a phone's table stands on its end

let scene = state.read();
/** @type {import('./table.js').Table[]} */
let tables = [];
/** @type {import('./table.js').Table} */
let table;
let layers;
/** @type {Board} */
let board;

const parts = { scene: () => scene, table: () => table, layers: () => layers, board: () => board };
const closer = new Closer({ ...parts, shots: () => view.shots, shot: () => view.shot() });
const view = new View({ ...parts, closer: () => closer, shown: showTip });
const search = searcher(parts.scene, {
  none() {
    view.empty();
    $('title').textContent = 'Put a ball on the table';
    write();
  },
  best: (answer) => view.best(answer),
  all: (answer) => {
    view.all(answer);
    write();
    closer.look();
  },
});
const practice = new Practice({ ...parts, view, closer, begin, tables: () => tables });

/** Writes the scene and the shot in view into the address. */
function write() {
  state.write(scene, view.chosen ? view.shot() : null);
}

/** Begins another scene. @param {state.Scene} next @param {any} [launch] of the shot to be in view */
function begin(next, launch = null) {
  $('sheet').textContent = '';
  change(() => (scene = next));
  view.wanted = launch;
}

/** Begins the scene of an address, with its shot in view. @param {string} [address] the page's own without it */
const beginAt = (address) => begin(state.read(address), state.launchOf(address));

// ---- the scene ----

/** Places of all balls when a movement began; they are pushed from there. */
let stood = null;

/** Moves a ball, and those in its way. @param {number} ball the cue ball by −1 @param {[number, number]} at */
function put(ball, at) {
  stood ??= [scene.ball, ...scene.others];
  const wanted = stood.with(ball + 1, inside(table, at, $('snap').checked));
  const balls = apart(table, wanted, ball + 1);
  if (!balls) return;
  [scene.ball, ...scene.others] = balls;
  for (const name of board.grips.keys()) if (/^(ball|other)/.test(name)) board.place(name);
}

const hands = {
  scene: () => scene,
  put,
  moved(before) {
    if (before) stood = null;
    if (before && state.address(before) !== state.address(scene)) remember(before);
    if (before) show();
    solve();
  },
  says: (name, at) => ($('place').textContent = `${name}: ${units.place(at, table)}`),
  removed(i) {
    change(() => (i < 0 ? (scene.zone = []) : state.removeBall(scene, i)));
    svg.querySelector('[data-grip="ball"]')?.focus(); // what had the focus is gone
  },
  // The planner goes on to choose the spin if it does now.
  clicked: (i) =>
    change(() => {
      const choose = state.chooses(scene);
      Object.assign(scene, { target: state.hit, object: state.nameOf(scene, i), order: [], least: 0, choose });
    }),
  pocket(name) {
    const planned = view.shot()?.then?.ball;
    const object = [state.pot, state.hit].includes(scene.target) ? scene.object : planned;
    const known = state.namesOf(scene).includes(object);
    change(() => {
      const choose = state.chooses(scene);
      Object.assign(scene, known ? { target: state.pot, object, into: name, choose } : { target: name });
    });
  },
  snaps: () => $('snap').checked,
  aim: {
    where: () => (closer.guess ? sight(table, scene.ball, closer.guess.angle).at : (closer.aimed ?? view.aimPoint())),
    move(at) {
      if (!closer.guess) return closer.aimAt(inside(table, at));
      closer.guess.angle = units.angleTo(scene.ball, at);
      view.look();
    },
  },
};

/** Draws everything anew, after a change that is not a movement. */
function rebuild() {
  const [[kind, focused] = []] = Object.entries(svg.querySelector(':focus')?.dataset ?? {});
  table = tables.find(({ name }) => name === scene.table) ?? tables[0];
  mend(scene, table);
  stood = null;
  const ordered = !state.sends(scene); // else the planner chooses the cushions
  units.turn(upended.matches);
  layers = draw(svg, table, (cushion) => ordered && change(() => scene.order.push(cushion)), upended.matches);
  layers.compare = shape('g', {}, layers.paths);
  layers.answer = shape('g', {}, layers.paths);
  layers.own = shape('g', {}, layers.paths);
  view.empty();
  board = new Board(svg, layers.grips, table, hands);
  if (kind) svg.querySelector(`[data-${kind}="${focused}"]`)?.focus(); // as before
  show();
  forget('solve'); // its answer would be drawn on another table
  solve();
}

/** Sets the controls to the scene. */
function show() {
  menus(form, scene, table, tables);
  drawTip({ side: scene.side, top: scene.top });
  drawTray(table, state.namesOf(scene));
}

/** Saves the scene before a change. @param {state.Scene} before */
function remember(before) {
  state.remember(before);
  showHistory();
}

function change(f) {
  settle();
  remember(scene);
  scene = structuredClone(scene);
  f();
  rebuild();
}

function solve() {
  closer.clear();
  view.halt();
  practice.check();
  search();
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

/** Shows where the planner puts the tip, if it chooses. @param {any} shot */
function showTip(shot) {
  if (scene.physics === 'spin' && state.chooses(scene) && shot) drawTip(shot.spin);
}

const { addBall, nextName, placeInHand } = laying({ ...parts, change });

const drawTray = tray($('tray'), svg, {
  add: addBall,
  remove: (name) => change(() => state.removeBall(scene, state.namesOf(scene).indexOf(name))),
});

zoning(svg, $('zone'), {
  table: () => table,
  has: () => scene.zone.length > 0,
  drawn(zone) {
    const object = view.shot()?.then?.ball ?? scene.object;
    const target = scene.target === state.play && object ? { target: state.pot, object } : {};
    change(() => Object.assign(scene, { zone, ...target }));
    $('other').textContent = `Now asked: pot ball ${scene.object} and leave the cue ball in the circle.`;
  },
  removed: () => change(() => (scene.zone = [])),
});

/** Keys of the scene whose change requires a new drawing. */
const shapes = ['table', 'target', 'game', 'group', 'object', 'into', 'physics', 'choose'];

/** @param {string} key of the scene that a control has set */
function changed(key) {
  let said = '';
  if (key === 'table') {
    const to = tables.find(({ name }) => name === scene.table);
    carry(scene, table, to);
  }
  if (key === 'target' && scene.target === state.play && scene.zone.length) {
    scene.zone = [];
    said = 'The circle is gone: a game plans where the cue ball stops.';
  }
  if (key === 'skill') showSkill(scene);
  if (key === 'aiming' || key === 'pacing') {
    scene.skill = skill.own;
    showSkill(scene);
  }
  for (const [low, high] of [
    ['slowest', 'fastest'],
    ['least', 'most'],
  ]) {
    if (scene[low] <= scene[high] || ![low, high].includes(key)) continue;
    scene[key === low ? high : low] = scene[key]; // the other one gives way, where all can see it
    controls.show(form, scene);
  }
  if (shapes.includes(key)) rebuild();
  else solve();
  if (said) $('other').textContent = said;
}

/** Goes back or forth in the history. @param {'undo' | 'redo'} way */
function turn(way) {
  settle();
  scene = state[way](scene);
  rebuild();
}

function listen() {
  const on = (id, event, f) => $(id).addEventListener(event, f);
  const pressed = (id, f) => on(id, 'click', f);
  const ended = (before) => {
    remember(before);
    show(); // a number beyond its limits was taken as the limit
  };
  controls.bind(form, () => scene, ended, changed);
  pressed('add', () => addBall(nextName()));
  pressed('clear', () => change(() => Object.assign(scene, { others: [], names: [], zone: [] })));
  pressed('further', async () => {
    const next = await view.after();
    if (next) begin(next);
  });
  pressed('remove', () => change(() => state.removeBall(scene, scene.others.length - 1)));
  pressed('inhand', placeInHand);
  pressed('unordered', () => change(() => (scene.order = [])));
  pressed('undo', () => turn('undo'));
  pressed('redo', () => turn('redo'));
  pressed('play', () => view.start(1));
  pressed('slow', () => view.start(0.25));
  sharing(svg, { ...parts, tables: () => tables, begin, beginAt, write });
  closer.listen();
  practice.listen();
  on('paths', 'change', () => view.look());
  on('inches', 'change', () => (units.useInches($('inches').checked), view.look()));
  hang($('gallery'), (address, name) => {
    const next = state.read(address);
    begin(next.skill < 0 ? { ...next, skill: scene.skill } : next);
    $('sheet').textContent = `${name}. Made: ___ of 10.`; // for who prints it
  });
  svg.addEventListener('dblclick', (event) => {
    if (event.target.classList.contains('cloth')) addBall(nextName(), pointIn(svg, event));
  });
  addEventListener('resize', () => board.placeAll());
  upended.addEventListener('change', () => {
    view.wanted = view.chosen ? view.shot() : null;
    rebuild();
  });
  const elsewhere = () => state.address(state.read()) !== state.address(scene);
  addEventListener('popstate', () => elsewhere() && beginAt());
  addEventListener('keydown', (event) => {
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || !['z', 'y'].includes(key) || holding()) return;
    event.preventDefault();
    turn(event.shiftKey || key === 'y' ? 'redo' : 'undo');
  });
}

document.body.classList.toggle('embed', new URLSearchParams(location.search).has('embed'));
$('inches').checked = units.inches;
onLost((lost) => {
  document.body.toggleAttribute('data-lost', lost);
  $('status').textContent = lost ? 'The engine does not answer; asking again …' : '';
});
const [known, schema] = await Promise.all([ask('tables'), ask('schema?document=shot')]);
tables = known;
if (Array.isArray(tables)) {
  const laws = state.laws(schema);
  scene = state.read();
  view.wanted = state.launchOf();
  controls.options(form.elements.cushion, laws.map(controls.same), scene.cushion);
  listen();
  rebuild();
} else {
  $('status').textContent = /** @type {any} */ (tables)?.error.reason ?? 'the engine does not answer';
}
