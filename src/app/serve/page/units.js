// Places and lengths in words: millimetres or inches, and diamonds.

/** Returns the stored unit; null (metres) if storage is blocked. */
function stored() {
  try {
    return localStorage.getItem('unit');
  } catch {
    return null;
  }
}

export let inches = stored() === 'inches';

/** @param {boolean} on */
export function useInches(on) {
  inches = on;
  try {
    localStorage.setItem('unit', on ? 'inches' : 'metres');
  } catch {
    // The choice holds for this visit only.
  }
}

/** Returns the same direction, from 0 to 360. @param {number} degrees */
export const wrapped = (degrees) => ((degrees % 360) + 360) % 360;

/** @param {number} metres */
export function length(metres) {
  if (inches) return (metres / 0.0254).toFixed(2) + ' in';
  return Math.abs(metres) < 1 ? (metres * 1000).toFixed(1) + ' mm' : metres.toFixed(3) + ' m';
}

/** Returns a distance as a player paces it. @param {number} metres */
export function distance(metres) {
  if (inches) return `${Math.round(metres / 0.0254)} in`;
  return metres < 1 ? `${Math.round(100 * metres)} cm` : `${metres.toFixed(2)} m`;
}

const [mile, kilometre] = [0.44704, 1 / 3.6]; // an hour, in m/s

/** Says how hard a shot is played. @param {number} v in m/s */
export function pace(v) {
  const mph = v / mile;
  const word = mph < 2 ? 'soft' : mph < 4 ? 'medium' : mph < 7 ? 'firm' : mph < 10 ? 'hard' : 'as hard as a break';
  const hour = inches ? `${mph.toFixed(1)} mph` : `${(v / kilometre).toFixed(1)} km/h`;
  return `${word}: ${v.toFixed(2)} m/s, ${hour}`;
}

/** @param {[number, number]} at @param {{length: number, width: number}} table */
export function place([x, y], table) {
  const across = ((x / table.length) * 8).toFixed(2);
  const up = ((y / table.width) * 4).toFixed(2);
  return `${length(x)}, ${length(y)} · ${across} of 8 diamonds, ${up} of 4`;
}
