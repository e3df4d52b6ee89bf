// Simulates a launch and returns a path for each ball.
import { ask } from './engine.js';
import * as state from './state.js';

/**
 * @param {state.Scene} scene
 * @param {{speed: number, angle: number, spin?: object}} launch
 * @param {string} kind of question
 * @returns {Promise<any>} null if a newer question replaced it
 */
export async function follow(scene, launch, kind) {
  const shot = state.shot(scene, launch);
  const [told, table] = await Promise.all([ask('simulate', shot, kind), ask('simulate?csv', shot, kind + '-path')]);
  if (!told || !table) return null;
  if (told.error) return told;
  const paths = {};
  for (const line of table.trim().split('\n').slice(1)) {
    const [t, ball, x, y] = line.split(',');
    (paths[ball] ??= []).push([Number(t), Number(x), Number(y)]);
  }
  for (const [ball, path] of Object.entries(paths)) if (ball !== 'cue' && still(path)) delete paths[ball];
  return { events: told.events, end: told.end, path: paths.cue, paths };
}

/**
 * Returns how the balls move on after a shot's own paths, which end when its target is met.
 * @param {state.Scene} scene
 * @param {any} shot
 * @param {string} kind of question
 * @returns {Promise<{cue: any[], others: any[][]} | undefined>} samples; undefined if there is nothing to draw
 */
export async function finish(scene, shot, kind) {
  if (!shot?.cue_rests && !shot?.scratch) return undefined;
  const followed = await follow(scene, shot, kind);
  if (!followed?.path) return undefined;
  const later = (path) => path.filter(([t]) => t > shot.arrival.time);
  const others = Object.entries(followed.paths)
    .filter(([ball]) => ball !== 'cue')
    .map(([, path]) => later(path));
  return { cue: later(followed.path), others: others.filter((path) => path.length > 1) };
}

function still(path) {
  return path.every(([, x, y]) => x === path[0][1] && y === path[0][2]);
}

/** Returns a ball's velocity and spin after each of its events, for `play`. */
export function turns(events, ball) {
  const own = [];
  for (const event of events)
    for (const one of [event, event.other ? { ...event.other, time: event.time } : null])
      if (one?.ball === ball && one.spin) own.push({ ...one, type: event.type });
  return own;
}

/** Returns the events that make a sound. */
export function hits(events) {
  return events.filter(({ type }) => ['cushion', 'jaw', 'ball', 'pocket'].includes(type));
}

const counted = (n) => (n === 1 ? 'one cushion' : `${n || 'no'} cushions`);

/** Says how a launch ended. @param {state.Scene} scene */
export function outcome(scene, { events, path }) {
  const fallen = (one) => events.find(({ type, ball }) => type === 'pocket' && one(ball));
  if (state.sends(scene)) {
    const sent = fallen((ball) => ball !== 'cue');
    return sent ? `sends ball ${sent.ball} into ${sent.pocket}` : 'sends no ball into a pocket';
  }
  const own = events.filter(({ ball }) => ball === 'cue');
  const jaws = own.some(({ type }) => type === 'jaw') ? ', off a jaw' : '';
  const after = `after ${counted(own.filter(({ type }) => type === 'cushion').length)}${jaws}`;
  const fell = fallen((ball) => ball === 'cue');
  if (fell) return `falls into ${fell.pocket} ${after}`;
  if (scene.target !== 'point') return `falls nowhere and comes to rest ${after}`;
  const [, x, y] = path[path.length - 1];
  const miss = Math.hypot(x - scene.point[0], y - scene.point[1]);
  return `rests ${(100 * miss).toFixed(1)} cm from the target ${after}`;
}
