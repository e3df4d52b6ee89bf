// From where on the table the shot can be played: the planner asked from a grid of places.
import { ask } from './engine.js';
import { shape } from './table.js';

const grid = [32, 16];

/**
 * @param {Element} layer
 * @param {any} puzzle
 * @param {import('./table.js').Table} table
 * @returns {Promise<string>} in words; nothing where another question took its place
 */
export async function starts(layer, puzzle, table) {
  const answer = await ask(`map?grid=${grid}`, puzzle, 'map');
  if (!answer) return '';
  if (answer.error) return answer.error.reason;
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
  return `It can be played from ${made} of ${lines.length} places; the darker, the surer.`;
}
