// The aim at the mirror image, as people take it. It is right only if cushions are mirrors.
import { angleTo } from './units.js';

/**
 * Returns the direction to the target's mirror image.
 * @param {{length: number, width: number, radius: number}} table
 * @param {[number, number]} from
 * @param {[number, number]} to
 * @param {string[]} cushions in order
 * @returns {number} degrees
 */
export function mirrorAim({ length, width, radius }, from, to, cushions) {
  let [x, y] = to;
  for (const cushion of [...cushions].reverse()) {
    if (cushion === 'left') x = 2 * radius - x;
    if (cushion === 'right') x = 2 * (length - radius) - x;
    if (cushion === 'bottom') y = 2 * radius - y;
    if (cushion === 'top') y = 2 * (width - radius) - y;
  }
  return angleTo(from, [x, y]);
}

/** Returns the path that mirror cushions would give. @returns {[number, number][]} */
export function mirrorPath({ length, width, radius }, from, to, cushions) {
  const points = [from];
  let at = from;
  cushions.forEach((cushion, i) => {
    const angle = (mirrorAim({ length, width, radius }, at, to, cushions.slice(i)) * Math.PI) / 180;
    const along = cushion === 'left' || cushion === 'right' ? 0 : 1;
    const wall = {
      left: radius,
      right: length - radius,
      bottom: radius,
      top: width - radius,
    }[cushion];
    const u = [Math.cos(angle), Math.sin(angle)];
    const t = (wall - at[along]) / u[along];
    at = [at[0] + t * u[0], at[1] + t * u[1]];
    points.push(at);
  });
  return [...points, to];
}
