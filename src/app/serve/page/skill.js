// A player's skill, from beginner to professional, as errors of aim and speed. The engine's players err alike, and in
// the place of the tip too: that takes ten times as long to count, too long while a ball is dragged.

const [beginner, pro] = [
  { angle: 0.6, share: 0.12 },
  { angle: 0.06, share: 0.02 },
];

/** Where the errors of `aiming` and `pacing` hold. */
export const own = -1;

const names = ['beginner', 'casual player', 'club player', 'league player', 'strong player', 'professional'];

/** Returns the errors of a skill; each changes by the same factor with every step. @param {number} skill from 0 to 1 */
export function noise(skill) {
  const between = (key) => Number((beginner[key] * (pro[key] / beginner[key]) ** skill).toPrecision(3));
  return { angle: between('angle'), speed: 0, speed_share: between('share') };
}

/** Describes a skill. @param {number} skill */
export function described(skill) {
  if (skill < 0) return 'your own errors';
  const { angle, speed_share } = noise(skill);
  const name = names[Math.round(skill * (names.length - 1))];
  return `${name}: errs by ${angle.toFixed(2)}° and ${(100 * speed_share).toFixed(0)} % of speed`;
}
