// Reads a puzzle, as the program takes it, into a scene of the page.
import { called } from './balls.js';
import { within } from './layout.js';
import * as state from './state.js';

const isPoint = (v) => Array.isArray(v) && v.length === 2 && v.every(Number.isFinite);
const isNumber = (v) => typeof v === 'number';
const isText = (v) => typeof v === 'string';

/** Returns what a puzzle says of an object ball's way into a pocket. */
const into = (target) => target.then ?? (target.pocket ? { pocket: target.pocket } : null);
const rails = (/** @type {any} */ { cushions = 0 }) => ({ most: cushions.length ?? cushions.max ?? cushions });

/** Each of the page's targets: whether a puzzle's is one, and what it says of the scene. @type {[Function, Function][]} */
const targets = [
  [(t) => !t || t.game, (t) => ({ target: state.play, game: t?.game ?? 'rotation', group: t?.group ?? 'solids' })],
  [(t) => isPoint(t.point), (t) => ({ target: 'point', point: t.point, within: t.within ?? 0.01 })],
  [(t) => t.ball === 'any' && into(t)?.pocket, (t) => ({ target: state.anyBall, ...rails(into(t)) })],
  [
    (t) => isText(t.ball) && into(t)?.pocket,
    (t) => ({ target: state.pot, object: t.ball, into: into(t).pocket, ...rails(into(t)) }),
  ],
  [(t) => isText(t.ball) && !into(t) && t.ball !== 'any', (t) => ({ target: state.hit, object: t.ball })],
  [(t) => isText(t.pocket) && !t.ball, (t) => ({ target: t.pocket })],
];

/** Each key of a scene, where it stands in a puzzle, and whether the page can show what stands there. */
const keys = [
  ['order', (p) => p.cushions, Array.isArray],
  ['least', (p) => p.cushions, isNumber],
  ['most', (p) => p.cushions, isNumber],
  ['least', (p) => p.cushions?.min, isNumber],
  ['most', (p) => p.cushions?.max, isNumber],
  ['slowest', (p) => p.speed?.[0], isNumber],
  ['fastest', (p) => p.speed?.[1], isNumber],
  ['prefer', (p) => p.prefer, isText],
  ['aiming', (p) => p.noise?.angle, isNumber],
  ['pacing', (p) => p.noise?.speed, isNumber],
  ['physics', (p) => p.physics?.model ?? p.physics, isText],
  ['sliding', (p) => p.physics?.sliding_friction, isNumber],
  ['rolling', (p) => p.physics?.rolling_friction ?? p.physics?.friction, isNumber],
  ['cushion', (p) => p.physics?.cushion?.model ?? p.physics?.cushion, isText],
  ['restitution', (p) => p.physics?.cushion?.restitution ?? p.physics?.restitution, isNumber],
  ['top', (p) => p.ball.spin?.top, isNumber],
  ['side', (p) => p.ball.spin?.side, isNumber],
];

/** Keys of a puzzle that the page shows or may leave out without another answer. */
const shown = ['id', 'about', 'table', 'unit', 'physics', 'ball', 'others', 'target', 'cushions', 'speed', 'settle'];

/** Returns the zone of a leave; undefined if the page has none like it. */
const zoneOf = ({ leave }, unit) =>
  isPoint(leave?.point) ? [...leave.point.map((v) => v * unit), leave.within ?? 0.1] : undefined;

/** Returns what of a puzzle the page does not show. @param {(key: string) => boolean} own as the page wrote it */
function missing(puzzle, own) {
  const left = Object.keys(puzzle).filter((key) => ![...shown, 'prefer', 'noise', 'leave'].includes(key));
  if (puzzle.leave && !zoneOf(puzzle, 1) && !own('leave')) left.push('leave');
  if (puzzle.prefer && !isText(puzzle.prefer)) left.push('prefer');
  if (Array.isArray(puzzle.target?.then?.cushions)) left.push('the order of the object ball’s cushions');
  if (puzzle.ball.spin?.masse) left.push('masse');
  const errors = Object.keys(puzzle.noise ?? {});
  if (errors.some((key) => !['angle', 'speed'].includes(key)) && !own('noise')) left.push('the player’s errors');
  return left;
}

/** Parses JSON; an object with the error if it is none. */
function parsed(text) {
  try {
    const puzzle = JSON.parse(text);
    return { puzzle: puzzle?.puzzle ?? puzzle ?? {} };
  } catch (error) {
    return { error: `it is no JSON (${/** @type {Error} */ (error).message})` };
  }
}

/** Returns the places of the balls, in metres. @param {import('./table.js').Table} table */
function places(puzzle, table) {
  const unit = puzzle.unit === 'diamond' ? table.diamond : 1;
  const metres = (at) => /** @type {state.Point} */ (at.map((v) => v * unit));
  const others = (puzzle.others ?? []).filter(({ at }) => isPoint(at));
  return {
    ball: metres(puzzle.ball.at),
    others: others.map(({ at }) => metres(at)),
    names: others.map(({ id }) => String(id)),
    zone: zoneOf(puzzle, unit) ?? [],
    ...(isPoint(puzzle.target?.point) ? { point: metres(puzzle.target.point) } : {}),
  };
}

/** Returns the balls of a scene that stand where none can. @param {state.Scene} scene */
function outside(scene, table) {
  const stands = (at) => String(within(table, at)) === String(at);
  const others = state.namesOf(scene).filter((_, i) => !stands(scene.others[i]));
  return [...(stands(scene.ball) ? [] : ['the cue ball']), ...others.map(called)];
}

/** Returns the scene of a puzzle's own keys. @returns {any} an object with the error if the page has none like it */
function sceneOf(puzzle, table) {
  if (!isPoint(puzzle.ball?.at)) return { error: 'the cue ball has no place in it' };
  const target = targets.find(([is]) => is(puzzle.target));
  if (!target) return { error: 'the page has no target like this one' };
  const { top, side } = puzzle.ball.spin ?? {};
  /** @type {any} */
  const scene = { ...structuredClone(state.first), table: table.name, choose: [top, side].some(Array.isArray) };
  for (const [key, where, is] of /** @type {[string, Function, Function][]} */ (keys))
    if (is(where(puzzle))) scene[key] = where(puzzle);
  return { scene: Object.assign(scene, target[1](puzzle.target), places(puzzle, table)) };
}

/**
 * Returns the scene of a puzzle. A file that the page has written brings its own address along, which holds for what
 * nobody has edited since.
 * @param {string} text
 * @param {import('./table.js').Table[]} tables
 * @returns {{scene?: state.Scene, launch?: any, left?: string[], moved?: string[], error?: string}} `left`: keys that
 *   the page does not show; `moved`: balls that stand elsewhere than in the file
 */
export function read(text, tables) {
  const { puzzle, error } = parsed(text);
  if (error) return { error };
  const page = isText(puzzle.about?.page) ? puzzle.about.page : '';
  const own = page ? state.read(page) : null;
  const written = own && state.puzzle(own);
  const isOwn = (key) => own !== null && JSON.stringify(puzzle[key]) === JSON.stringify(written[key]);
  if (own && Object.keys({ ...puzzle, ...written }).every((key) => key === 'about' || isOwn(key)))
    return { scene: own, launch: state.launchOf(page) };
  const table = tables.find(({ name }) => name === puzzle.table);
  if (!table) return { error: 'it is no puzzle on one of the page’s tables' };
  const { scene, error: unlike } = sceneOf(puzzle, table);
  if (unlike) return { error: unlike };
  if (isOwn('noise')) scene.skill = own.skill;
  if (isOwn('leave')) scene.zone = own.zone;
  return { scene, left: missing(puzzle, isOwn), moved: outside(scene, table) };
}
