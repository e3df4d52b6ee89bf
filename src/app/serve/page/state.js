// The scene as one plain object, its history, and the address that holds it.
import * as skill from './skill.js';
import { wrapped } from './units.js';

/**
 * @typedef {[number, number]} Point in metres
 * @typedef {typeof first} Scene
 */

/** The values of keys that an address leaves out. The type of each must never change, since addresses outlive versions. */
export const first = {
  table: 'pool-9ft',
  physics: 'spin',
  cushion: '', // the engine's default, once it was asked
  sliding: 0.2,
  rolling: 0.01,
  restitution: 0.85,
  /** @type {Point} */
  ball: [0.635, 0.4],
  target: 'top-right',
  /** @type {Point} */
  point: [1.9, 0.9],
  within: 0.01,
  /** @type {Point[]} */
  others: [],
  /** @type {string[]} names of the others; one without a name is called by its number in the list */
  names: [],
  object: '', // the ball of the targets `pot` and `hit`
  into: 'any', // the pocket of `pot`
  game: 'rotation',
  group: 'solids',
  /** @type {number[]} x, y and radius of the place where the cue ball should stop; empty: anywhere */
  zone: [],
  /** @type {string[]} cushions in order; empty: `least` to `most` of any */
  order: [],
  least: 1,
  most: 2,
  prefer: 'robust',
  top: 0,
  side: 0,
  choose: false, // the planner chooses the spin
  slowest: 0.1,
  fastest: 10,
  skill: skill.own, // 0 is a beginner, 1 a professional
  aiming: 0.125, // errors of a player whose skill is `own`: degrees, m/s
  pacing: 0.075,
};

/** The scene of a page without an address: the end of a rack of nine-ball. */
const opening =
  'target=play&skill=0.6&ball=0.7,0.42&others=1.62,0.98,2.05,0.36,1.05,1.02,0.36,0.72,2.2,0.86&names=3,5,6,8,9';

/** Takes the default cushion law from the engine's schema of a shot. @returns {string[]} names of all laws */
export function laws(schema) {
  const model = schema.$defs.cushion.properties.model;
  first.cushion = model.default;
  return model.enum;
}

/** Targets that move an object ball: the game's, any of them by at most `most` cushions, and one of them. */
export const [play, anyBall, pot, hit] = ['play', 'another ball', 'pot', 'hit'];

/** Says whether the planner chooses the cue ball's cushions. @param {Scene} scene */
export const sends = (scene) => [play, anyBall, pot].includes(scene.target);

/** Says whether the planner chooses the spin. @param {Scene} scene */
export const chooses = (scene) => scene.choose || scene.target === play || leaves(scene);

/** Says whether the scene asks where the cue ball should stop. @param {Scene} scene */
const leaves = (scene) => scene.zone.length > 0 && [anyBall, pot, hit].includes(scene.target);

/** Returns the name of a ball. @param {Scene} scene @param {number} i */
export const nameOf = (scene, i) => scene.names[i] || String(i + 1);

/** Returns the names of all balls but the cue ball. @param {Scene} scene */
export const namesOf = (scene) => scene.others.map((_, i) => nameOf(scene, i));

/** Adds a ball. @param {Scene} scene @param {string} name @param {Point} at */
export function addBall(scene, name, at) {
  scene.names = [...namesOf(scene), name];
  scene.others.push(at);
}

/** Takes a ball off. @param {Scene} scene @param {number} i */
export function removeBall(scene, i) {
  scene.names = namesOf(scene);
  scene.names.splice(i, 1);
  scene.others.splice(i, 1);
}

/** @type {Scene[]} */
const past = [];
/** @type {Scene[]} */
const future = [];

/** @param {Scene} scene */
const copy = (scene) => structuredClone(scene);

/** Reads a list of numbers; undefined if it is none, or if none may be as long. @param {(n: number) => boolean} fits */
function numbers(text, fits) {
  const all = text === '' ? [] : text.split(',').map(Number);
  return all.every(Number.isFinite) && fits(all.length) ? all : undefined;
}

const words = (text) => (text === '' ? [] : text.split(','));

/** Keys whose lists may be empty, and how each is read. */
const lists = {
  order: words,
  names: words,
  zone: (text) => numbers(text, (n) => n === 0 || n === 3),
  others: (text) => pairs(numbers(text, (n) => n % 2 === 0)),
};

/** @param {string} text of `key`, @returns {any} undefined if it is no valid value */
function parse(key, text) {
  if (lists[key]) return lists[key](text);
  if (Array.isArray(first[key])) return numbers(text, (n) => n === 2);
  if (typeof first[key] === 'number') return numbers(text, (n) => n === 1)?.[0];
  return typeof first[key] === 'boolean' ? text === 'true' : text;
}

function pairs(numbers) {
  if (!numbers) return undefined;
  return Array.from({ length: numbers.length / 2 }, (_, i) => numbers.slice(2 * i, 2 * i + 2));
}

/** Reads "ball=0.5,0.4&most=3"; keys that are missing or wrong keep their first values. @returns {Scene} */
export function read(text = location.hash.slice(1)) {
  const scene = copy(first);
  for (const [key, value] of new URLSearchParams(text || opening)) {
    if (!Object.hasOwn(first, key)) continue;
    const parsed = parse(key, value);
    if (parsed !== undefined) scene[key] = parsed;
  }
  return scene;
}

/**
 * Returns the table and the keys that differ from the first scene, to keep the address short.
 * @param {Scene} scene
 */
export function address(scene) {
  const said = Object.entries(scene).filter(([key, value]) => key === 'table' || String(value) !== String(first[key]));
  return said.map(([key, value]) => `${key}=${encodeURIComponent(String(value)).replaceAll('%2C', ',')}`).join('&');
}

/** Returns the launch of the shot that an address names. @returns {{angle: number, speed: number} | null} */
export function launchOf(text = location.hash.slice(1)) {
  const [angle, speed] = (new URLSearchParams(text).get('shot') ?? '').split(',').map(Number);
  return angle >= 0 && speed > 0 ? { angle, speed } : null;
}

/**
 * Writes the scene and the chosen shot into the address. Another scene gets an entry in the browser's history.
 * @param {Scene} scene @param {any} shot null for the best
 */
export function write(scene, shot) {
  const now = address(scene);
  const launch = shot ? `&shot=${shot.angle.toFixed(3)},${shot.speed.toFixed(3)}` : '';
  if (location.hash.slice(1) === now + launch) return;
  const same = !location.hash || address(read()) === now;
  try {
    history[same ? 'replaceState' : 'pushState'](null, '', '#' + now + launch);
  } catch {
    // Browsers take some hundred entries a minute; the next one will be taken.
  }
}

/** Saves the scene before a change. @param {Scene} scene */
export function remember(scene) {
  past.push(copy(scene));
  future.length = 0;
}

function back(from, to, scene) {
  const other = from.pop();
  if (!other) return scene;
  to.push(copy(scene));
  return other;
}

/** Says whether there is something to undo, and to redo. */
export const can = () => ({ undo: past.length > 0, redo: future.length > 0 });

/** @param {Scene} scene @returns {Scene} the one before */
export const undo = (scene) => back(past, future, scene);

/** @param {Scene} scene @returns {Scene} the one that was undone */
export const redo = (scene) => back(future, past, scene);

/** @param {Scene} scene */
function physics(scene) {
  if (scene.physics === 'ideal') return 'ideal';
  if (scene.physics === 'rolling')
    return {
      model: 'rolling',
      friction: scene.rolling,
      restitution: scene.restitution,
    };
  return {
    model: 'spin',
    sliding_friction: scene.sliding,
    rolling_friction: scene.rolling,
    cushion:
      scene.cushion === 'mirror' ? { model: 'mirror' } : { model: scene.cushion, restitution: scene.restitution },
  };
}

/** @param {Scene} scene */
function target(scene) {
  const by = scene.most > 0 ? { cushions: { max: scene.most } } : {};
  if (scene.target === play) return { game: scene.game, ...(scene.game === 'eight' ? { group: scene.group } : {}) };
  if (scene.target === anyBall) return { ball: 'any', then: { pocket: 'any', ...by } };
  if (scene.target === pot) return { ball: scene.object, then: { pocket: scene.into, ...by } };
  if (scene.target === hit) return { ball: scene.object };
  return scene.target === 'point' ? { point: scene.point, within: scene.within } : { pocket: scene.target };
}

/** @param {Scene} scene */
function cushions(scene) {
  if (sends(scene)) return { cushions: 0 };
  if (scene.order.length) return { cushions: scene.order };
  return { cushions: { min: Math.min(scene.least, scene.most), max: Math.max(scene.least, scene.most) } };
}

/** @param {Scene} scene */
function spin(scene) {
  if (scene.target === play) return {};
  if (chooses(scene)) return { spin: { top: [-1, 1], side: [-0.8, 0.8] } };
  return { spin: { top: scene.top, side: scene.side } };
}

const corners = 16; // of the polygon that stands for a round zone

/** @param {Scene} scene */
function leave(scene) {
  if (!leaves(scene)) return {};
  const [x, y, r] = scene.zone;
  const turn = (2 * Math.PI) / corners;
  const polygon = Array.from({ length: corners }, (_, i) => [x + r * Math.cos(i * turn), y + r * Math.sin(i * turn)]);
  return { leave: { polygon } };
}

/** @param {Scene} scene */
function noise(scene) {
  if (scene.skill >= 0) return skill.noise(scene.skill);
  return { angle: scene.aiming, speed: scene.pacing };
}

/** Returns the scene as the puzzle that the engine reads. @param {Scene} scene */
export function puzzle(scene) {
  return {
    ...place(scene),
    settle: true,
    target: target(scene),
    ...(scene.target === play ? {} : { ...cushions(scene), prefer: scene.prefer }),
    ...leave(scene),
    speed: [Math.min(scene.slowest, scene.fastest), Math.max(scene.slowest, scene.fastest)],
    noise: noise(scene),
  };
}

/** Returns the table, the physics and the balls. @param {Scene} scene */
function place(scene) {
  return {
    table: scene.table,
    physics: physics(scene),
    ball: { at: scene.ball, ...(scene.physics === 'spin' ? spin(scene) : {}) },
    ...(scene.others.length ? { others: scene.others.map((at, i) => ({ id: nameOf(scene, i), at })) } : {}),
  };
}

/**
 * Returns the scene with a launch, as the shot that the engine reads.
 * @param {Scene} scene
 * @param {{speed: number, angle: number, spin?: object}} launch
 */
export function shot(scene, { speed, angle, spin }) {
  const { ball, ...rest } = place(scene);
  const struck = scene.physics === 'spin' && spin ? { spin } : {};
  return {
    ...rest,
    ball: { at: ball.at },
    shot: { speed, angle: wrapped(angle), ...struck },
  };
}
