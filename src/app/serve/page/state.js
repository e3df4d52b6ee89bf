// What is asked, as one plain object; its history, and the address that holds it.

/**
 * @typedef {{table: string, physics: string, ball: [number, number], target: string, point: [number, number],
 *   others: [number, number][], least: number, most: number, prefer: string, top: number, side: number}} Scene
 */

/** @type {Scene} */
const first = {
  table: 'pool-9ft', physics: 'spin', ball: [0.635, 0.4], target: 'top-right', point: [1.9, 0.9], others: [],
  least: 1, most: 2, prefer: 'robust', top: 0, side: 0,
};

/** @type {Scene[]} */
const past = [];
/** @type {Scene[]} */
const future = [];

/** @returns {Scene} of the address, or the first one */
export function read() {
  try {
    const text = decodeURIComponent(location.hash.slice(1));
    return text ? { ...first, ...JSON.parse(text) } : { ...first };
  } catch {
    return { ...first };
  }
}

/** Only what is not as at first, so that addresses are short. @param {Scene} scene */
export function write(scene) {
  const said = Object.fromEntries(
    Object.entries(scene).filter(([key, value]) => JSON.stringify(value) !== JSON.stringify(first[key])));
  history.replaceState(null, '', Object.keys(said).length ? '#' + encodeURIComponent(JSON.stringify(said)) : '#');
}

/** Before it changes. @param {Scene} scene */
export function remember(scene) {
  past.push(structuredClone(scene));
  future.length = 0;
}

/** @param {Scene} scene @returns {Scene} the one before */
export function undo(scene) {
  const before = past.pop();
  if (!before) return scene;
  future.push(structuredClone(scene));
  return before;
}

/** @param {Scene} scene @returns {Scene} the one that was undone */
export function redo(scene) {
  const after = future.pop();
  if (!after) return scene;
  past.push(structuredClone(scene));
  return after;
}

/** Another ball into a pocket, by up to the cushions that are asked. */
export const anyBall = 'another ball';

function target(scene) {
  if (scene.target === anyBall) return { ball: 'any', then: { pocket: 'any', cushions: { max: scene.most } } };
  return scene.target === 'point' ? { point: scene.point } : { pocket: scene.target };
}

/** As the engine reads it. @param {Scene} scene */
export function puzzle(scene) {
  return {
    table: scene.table,
    physics: scene.physics,
    ball: { at: scene.ball, ...(scene.physics === 'spin' ? { spin: { top: scene.top, side: scene.side } } : {}) },
    ...(scene.others.length ? { others: scene.others.map((at, i) => ({ id: String(i + 1), at })) } : {}),
    target: target(scene),
    cushions:
      scene.target === anyBall ? 0 : { min: Math.min(scene.least, scene.most), max: Math.max(scene.least, scene.most) },
    prefer: scene.prefer,
  };
}
