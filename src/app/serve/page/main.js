// The page: what is asked, the picture of it, and the engine's answer while things are dragged.
import { fill, pattern, words } from './answer.js';
import { draggable } from './drag.js';
import { ask } from './engine.js';
import { play } from './play.js';
import * as state from './state.js';
import { draw, shape, sight } from './table.js';

const $ = (id) => document.getElementById(id);
const svg = $('table');
let scene = state.read();
let tables = [];
let table, moving;
let shots = [], chosen = 0;
const grips = new Map();

const points = (path) => path.map(([, x, y]) => `${x},${y}`).join(' ');

function circle(kind, at, r, extra = {}) {
  return shape('circle', { class: kind, cx: at[0], cy: at[1], r, 'stroke-width': 0.004, ...extra }, moving);
}

/** All that may move: paths, balls, the target. */
function paint(looked = chosen) {
  moving.querySelectorAll('.drawn').forEach((e) => e.remove());
  const layer = shape('g', { class: 'drawn' });
  moving.prepend(layer);
  const line = (path, kind, width) =>
    shape('polyline', { class: 'path ' + kind, points: points(path), 'stroke-width': width }, layer);
  shots.forEach((shot, i) => i !== looked && shot.path && line(shot.path, '', 0.004));
  const shot = shots[looked];
  if (shot?.path) {
    const { at } = sight(table, scene.ball, shot.angle);
    shape('line', { class: 'aim', x1: scene.ball[0], y1: scene.ball[1], x2: at[0], y2: at[1], 'stroke-width': 0.005 }, layer);
    line(shot.path, 'best', 0.011);
    for (const path of Object.values(shot.paths ?? {})) line(path, 'sent', 0.008);
    const last = shot.path[shot.path.length - 1];
    shape('circle', { class: 'ghost', cx: last[1], cy: last[2], r: table.radius, 'stroke-width': 0.004 }, layer);
  }
  tell(shot);
}

function tell(shot) {
  $('title').textContent = shot ? (shot.cushions.length && !shot.then ? 'By ' : '') + pattern(shot) : 'No shot';
  $('words').replaceChildren();
  for (const button of ['play', 'slow']) $(button).disabled = !shot?.path;
  if (!shot) return;
  for (const [name, text] of words(shot, sight(table, scene.ball, shot.angle).words)) {
    const term = document.createElement('dt'), value = document.createElement('dd');
    term.textContent = name;
    value.textContent = text;
    $('words').append(term, value);
  }
}

async function solve() {
  state.write(scene);
  const puzzle = state.puzzle(scene);
  const quick = await ask('solve?first&path', puzzle, 'solve');
  if (quick) show(quick, 'looking for better shots …');
  const all = quick && (await ask('solve?all&path', puzzle, 'solve'));
  if (all) show(all, '');
}

function show(answer, more) {
  shots = answer.shots ?? [];
  chosen = 0;
  $('status').textContent = answer.error ? `${answer.error.path} ${answer.error.reason}` : `${answer.message} ${more}`;
  fill($('shots'), shots, chosen, { look: paint, choose: (i) => choose(i) });
  paint();
}

function choose(i) {
  chosen = i;
  fill($('shots'), shots, chosen, { look: paint, choose });
  paint();
  start(1);
}

function start(pace) {
  const shot = shots[chosen];
  if (!shot?.path) return;
  const others = Object.entries(shot.paths ?? {}).map(([id, path]) => ({ grip: 'other' + (Number(id) - 1), path }));
  const balls = [{ grip: 'ball', path: shot.path }, ...others];
  const back = () => {
    place('ball', scene.ball);
    scene.others.forEach((at, i) => place('other' + i, at));
  };
  play(balls.map(({ grip, path }) => ({ element: grips.get(grip).dot, path })), pace).then(back);
}

/** On the table, a ball's radius from each cushion. */
function inside([x, y]) {
  const r = table.radius, clamp = (v, most) => Math.min(Math.max(v, r), most - r);
  return [clamp(x, table.length), clamp(y, table.width)].map((v) => Math.round(v * 1e4) / 1e4);
}

function place(name, at) {
  const { dot, grip } = grips.get(name);
  for (const element of [dot, grip]) {
    element.setAttribute('cx', at[0]);
    element.setAttribute('cy', at[1]);
  }
}

/** A dot, and a grip that is wider than it. */
function movable(name, label, kind, where, put) {
  const dot = circle(kind, where(), table.radius);
  const grip = circle('grip', where(), Math.max(table.radius, 0.05), {
    tabindex: 0, role: 'button', 'aria-label': label, 'data-grip': name, 'stroke-width': 0.01,
  });
  grips.set(name, { dot, grip });
  let before = null;
  draggable(grip, svg, where, (at, done) => {
    before ??= structuredClone(scene);
    put(inside(at));
    place(name, where());
    if (done) state.remember(before), (before = null);
    solve();
  });
}

/** Everything anew, after what is not a movement. */
function rebuild() {
  table = tables.find((t) => t.name === scene.table) ?? tables[0];
  if (!targets().includes(scene.target)) scene.target = targets()[0];
  scene.ball = inside(scene.ball);
  moving = draw(svg, table);
  grips.clear();
  for (const pocket of table.pockets)
    if (pocket.name === scene.target) circle('target', pocket.at, pocket.half * 1.15, { 'stroke-width': 0.012 });
  if (scene.target === 'point') movable('point', 'Target', 'target', () => scene.point, (at) => (scene.point = at));
  scene.others.forEach((_, i) =>
    movable('other' + i, `Ball ${i + 1}`, 'other', () => scene.others[i], (at) => (scene.others[i] = at)));
  movable('ball', 'Cue ball', 'ball', () => scene.ball, (at) => (scene.ball = at));
  controls();
  solve();
}

function options(select, names, value) {
  select.replaceChildren(...names.map((name) => new Option(name, name, false, name === value)));
}

function targets() {
  if (!table.pockets.length) return ['point'];
  return [...table.pockets.map((p) => p.name), 'any', 'point', ...(scene.others.length ? [state.anyBall] : [])];
}

function controls() {
  options($('preset'), tables.map((t) => t.name), scene.table);
  options($('target'), targets(), scene.target);
  for (const id of ['physics', 'least', 'most', 'prefer', 'top', 'side']) $(id).value = scene[id];
  for (const id of ['top', 'side']) $(id).disabled = scene.physics !== 'spin';
}

function change(f) {
  state.remember(scene);
  f();
  rebuild();
}

/** All of one slide is one step of the history. */
function slide(input, put) {
  let before = null;
  input.addEventListener('input', () => {
    before ??= structuredClone(scene);
    put(Number(input.value));
    solve();
  });
  input.addEventListener('change', () => {
    if (before) state.remember(before);
    before = null;
  });
}

function listen() {
  const keys = { preset: 'table', physics: 'physics', target: 'target', prefer: 'prefer' };
  for (const [id, key] of Object.entries(keys))
    $(id).addEventListener('change', (e) => change(() => (scene[key] = e.target.value)));
  for (const id of ['least', 'most', 'top', 'side'])
    slide($(id), (value) => (scene[id] = value));
  $('add').addEventListener('click', () =>
    change(() => scene.others.push(inside([table.length * Math.random(), table.width * Math.random()]))));
  $('remove').addEventListener('click', () => change(() => scene.others.pop()));
  $('undo').addEventListener('click', () => ((scene = state.undo(scene)), rebuild()));
  $('redo').addEventListener('click', () => ((scene = state.redo(scene)), rebuild()));
  $('play').addEventListener('click', () => start(1));
  $('slow').addEventListener('click', () => start(0.25));
  $('controls').addEventListener('submit', (e) => e.preventDefault());
  addEventListener('hashchange', () => ((scene = state.read()), rebuild()));
  addEventListener('keydown', (e) => {
    if (!(e.ctrlKey || e.metaKey) || e.key.toLowerCase() !== 'z') return;
    e.preventDefault();
    scene = e.shiftKey ? state.redo(scene) : state.undo(scene);
    rebuild();
  });
}

tables = await ask('tables');
listen();
rebuild();
