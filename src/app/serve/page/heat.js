// Success over aim and speed around a shot, which shows why it is safe or not. All shots found there are marked.
import { ask } from './engine.js';
import { wrapped } from './units.js';

const columns = 160;
const rows = 100;
const beside = 3; // degrees shown on either side

/** Returns the window shown, in degrees and m/s. @param {any} shot in the middle */
function view(shot) {
  return { angle: [shot.angle - beside, shot.angle + beside], speed: [0.4 * shot.speed, 1.8 * shot.speed] };
}

/** Gives the puzzle the shot's spin, if the planner chose it. */
function withSpin(puzzle, { spin }) {
  return spin && puzzle.ball.spin ? { ...puzzle, ball: { ...puzzle.ball, spin } } : puzzle;
}

/** Returns a colour that gets lighter with the success. */
function colour(chance) {
  const at = Math.sqrt(chance);
  return [255 * Math.min(1, 1.6 * at), 255 * Math.max(0, at * at * 0.95), 60 + 60 * Math.sin(Math.PI * at), 255];
}

/**
 * Draws the map.
 * @param {HTMLCanvasElement} canvas
 * @param {any} puzzle @param {any[]} shots @param {any} shot the one in the middle
 * @returns {Promise<string>} what went wrong, or nothing
 */
export async function heat(canvas, puzzle, shots, shot) {
  const v = view(shot);
  const asked = `launches?angle=${v.angle}&speed=${v.speed}&grid=${columns},${rows}`;
  const map = await ask(asked, withSpin(puzzle, shot), 'launches');
  if (!map) return '';
  if (map.error) return map.error.reason;
  const picture = new ImageData(columns, rows);
  map.chance.forEach((chance, i) => {
    const row = rows - 1 - Math.floor(i / columns); // slow at the bottom, larger angles on the left
    const at = row * columns + (columns - 1 - (i % columns));
    picture.data.set(colour(chance), 4 * at);
  });
  canvas.width = 2 * columns;
  canvas.height = 2 * rows;
  const pen = canvas.getContext('2d');
  pen.putImageData(picture, 0, 0);
  pen.imageSmoothingEnabled = false;
  pen.drawImage(canvas, 0, 0, columns, rows, 0, 0, 2 * columns, 2 * rows);
  for (const other of shots) mark(pen, v, other, other === shot);
  return '';
}

function mark(pen, { angle, speed }, shot, chosen) {
  const turn = wrapped(shot.angle - angle[0]) / (angle[1] - angle[0]);
  const faster = (shot.speed - speed[0]) / (speed[1] - speed[0]);
  if (turn > 1 || faster < 0 || faster > 1) return;
  pen.beginPath();
  pen.arc(2 * columns * (1 - turn), 2 * rows * (1 - faster), chosen ? 6 : 4, 0, 2 * Math.PI);
  pen.lineWidth = 2;
  pen.strokeStyle = '#fff';
  pen.stroke();
}

/** Describes the picture's axes. @param {any} shot in the middle */
export function scale(shot) {
  const { angle, speed } = view(shot);
  const [right, left] = angle.map((v) => wrapped(v).toFixed(1));
  const [slow, fast] = speed.map((v) => v.toFixed(2));
  return `Aim from ${left}° on the left to ${right}°, speed from ${slow} m/s up to ${fast}.`;
}

/**
 * Returns the launch at a place of the picture.
 * @param {any} shot in the middle
 * @param {number} x from 0 to 1
 * @param {number} y from 0 to 1, upwards
 */
export function launchAt(shot, x, y) {
  const { angle: a, speed: s } = view(shot);
  return {
    ...shot,
    angle: a[1] - x * (a[1] - a[0]),
    speed: s[0] + y * (s[1] - s[0]),
  };
}
