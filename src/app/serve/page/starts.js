// A map of the places from which the shot can be played: the planner is asked at each place of a grid.
import { ask } from './engine.js';
import { shape } from './table.js';

const grids = [
  [16, 8],
  [32, 16],
]; // a rough map first

/**
 * @param {Element} layer
 * @param {any} puzzle
 * @param {import('./table.js').Table} table
 * @param {(words: string) => void} say
 */
export async function starts(layer, puzzle, table, say) {
  for (const grid of grids) {
    const answer = await ask(`map?grid=${grid}`, puzzle, 'map');
    if (!answer) return;
    if (answer.error && grid !== grids[0]) return; // the rough map stays
    say(answer.error ? answer.error.reason : show(layer, answer, grid, table));
    if (answer.error) return;
  }
}

/** @returns {string} in words */
function show(layer, answer, grid, table) {
  layer.replaceChildren();
  const [head, ...lines] = answer.trim().split('\n');
  const names = head.split(',');
  const column = (name) => names.findIndex((n) => n.startsWith(name));
  const [x, y, status, success] = ['x', 'y', 'status', 'success'].map(column);
  const [w, h] = [(table.length - 2 * table.radius) / grid[0], (table.width - 2 * table.radius) / grid[1]];
  let made = 0;
  for (const line of lines) {
    const cells = line.split(',');
    if (cells[status] !== 'solved') continue;
    ++made;
    const corner = {
      x: Number(cells[x]) - w / 2,
      y: Number(cells[y]) - h / 2,
      width: w,
      height: h,
    };
    shape(
      'rect',
      {
        class: 'start',
        ...corner,
        'fill-opacity': 0.05 + 0.5 * Number(cells[success]),
      },
      layer,
    );
  }
  return `It can be played from ${made} of ${lines.length} places; the stronger the colour, the surer.`;
}
