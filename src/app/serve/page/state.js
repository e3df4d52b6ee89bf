// The scene as one plain object, its history, and the address that holds it.
import { wrapped } from './units.js';

/**
 * @typedef {[number, number]} Point in metres
 * @typedef {typeof first} Scene
 */

/** The first scene. The type of each value must never change, since addresses outlive versions. */
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
  aiming: 0.125, // how far a player errs: degrees, m/s
  pacing: 0.075,
};

/** Takes the default cushion law from the engine's schema of a shot. @returns {string[]} names of all laws */
export function laws(schema) {
  const model = schema.$defs.cushion.properties.model;
  first.cushion = model.default;
  return model.enum;
}

/** The target: pot any object ball, by at most `most` cushions. */
export const anyBall = 'another ball';

/** @type {Scene[]} */
const past = [];
/** @type {Scene[]} */
const future = [];

/** @param {Scene} scene */
const copy = (scene) => structuredClone(scene);

/** @param {string} text of `key`, @returns {any} undefined if it is no valid value */
function parse(key, text) {
  const numbers = text === '' ? [] : text.split(',').map(Number);
  const good = numbers.every(Number.isFinite);
  if (key === 'order') return text === '' ? [] : text.split(',');
  if (key === 'others') return good && numbers.length % 2 === 0 ? pairs(numbers) : undefined;
  if (Array.isArray(first[key])) return good && numbers.length === 2 ? numbers : undefined;
  if (typeof first[key] === 'number') return good && numbers.length === 1 ? numbers[0] : undefined;
  return typeof first[key] === 'boolean' ? text === 'true' : text;
}

function pairs(numbers) {
  return Array.from({ length: numbers.length / 2 }, (_, i) => numbers.slice(2 * i, 2 * i + 2));
}

/** Reads "ball=0.5,0.4&most=3"; keys that are missing or wrong keep their first values. @returns {Scene} */
export function read(text = location.hash.slice(1)) {
  const scene = copy(first);
  for (const [key, value] of new URLSearchParams(text)) {
    if (!Object.hasOwn(first, key)) continue;
    const parsed = parse(key, value);
    if (parsed !== undefined) scene[key] = parsed;
  }
  return scene;
}

/** Returns the keys that differ from the first scene, to keep the address short. @param {Scene} scene */
export function address(scene) {
  const said = Object.entries(scene).filter(([key, value]) => String(value) !== String(first[key]));
  return said.map(([key, value]) => `${key}=${encodeURIComponent(String(value)).replaceAll('%2C', ',')}`).join('&');
}

/** @param {Scene} scene */
export function write(scene) {
  history.replaceState(null, '', '#' + address(scene));
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
  if (scene.target === anyBall)
    return {
      ball: 'any',
      then: { pocket: 'any', cushions: { max: scene.most } },
    };
  return scene.target === 'point' ? { point: scene.point, within: scene.within } : { pocket: scene.target };
}

/** @param {Scene} scene */
function cushions(scene) {
  if (scene.target === anyBall) return 0;
  if (scene.order.length) return scene.order;
  return {
    min: Math.min(scene.least, scene.most),
    max: Math.max(scene.least, scene.most),
  };
}

/** @param {Scene} scene */
function spin(scene) {
  if (scene.choose) return { top: [-1, 1], side: [-0.8, 0.8] };
  return { top: scene.top, side: scene.side };
}

/** Returns the scene as the puzzle that the engine reads. @param {Scene} scene */
export function puzzle(scene) {
  return {
    ...place(scene),
    target: target(scene),
    cushions: cushions(scene),
    speed: [Math.min(scene.slowest, scene.fastest), Math.max(scene.slowest, scene.fastest)],
    prefer: scene.prefer,
    noise: { angle: scene.aiming, speed: scene.pacing },
  };
}

/** Returns the table, the physics and the balls. @param {Scene} scene */
function place(scene) {
  return {
    table: scene.table,
    physics: physics(scene),
    ball: {
      at: scene.ball,
      ...(scene.physics === 'spin' ? { spin: spin(scene) } : {}),
    },
    ...(scene.others.length ? { others: scene.others.map((at, i) => ({ id: String(i + 1), at })) } : {}),
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
