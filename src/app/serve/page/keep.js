// Keeps and shares: scenes under a name in this browser, links, pictures, and puzzles as the program reads them.
import { told } from './answer.js';
import * as controls from './controls.js';
import { $ } from './controls.js';
import { read } from './open.js';
import * as save from './save.js';
import * as state from './state.js';
import { keep, kept } from './store.js';

const place = 'scenes'; // key in the browser's store

/** @returns {Record<string, string>} addresses by name */
const scenes = () => kept(place, {});

/** Forgets a name. */
function forget(name) {
  const { [name]: _, ...others } = scenes();
  keep(place, others);
}

function showKept() {
  const names = Object.keys(scenes());
  controls.options($('kept'), [['', names.length ? '…' : 'none yet'], ...names.map(controls.same)], '');
}

/** Returns what a picture says below the table. @returns {string[]} */
function caption() {
  const rows = told($('words')).map((row) => row.join(': '));
  const third = Math.ceil(rows.length / 3);
  const lines = [0, 1, 2].map((i) => rows.slice(i * third, (i + 1) * third).join(' · '));
  return [$('title').textContent, ...lines.filter(Boolean)];
}

/**
 * @param {SVGSVGElement} svg
 * @param {{scene: () => state.Scene, tables: () => import('./table.js').Table[],
 *   begin: (scene: state.Scene, launch?: any) => void, beginAt: (address: string) => void, write: () => void}} page
 *   `write` writes the address of the scene and its shot
 */
export function sharing(svg, { scene, tables, begin, beginAt, write }) {
  const pressed = (id, f) => $(id).addEventListener('click', f);
  const say = (words) => ($('other').textContent = words);

  /** @param {string} text of a puzzle */
  const open = (text) => {
    const { scene: next, launch, left = [], moved = [], error } = read(text, tables());
    if (next) begin(next, launch);
    const words = [
      error ? `It was not opened: ${error}.` : '',
      left.length ? `The page does not show ${left.join(', ')} of this puzzle.` : '',
      moved.length ? `No ball can stand where the file has ${moved.join(', ')}: moved.` : '',
    ];
    say(words.filter(Boolean).join(' '));
  };
  /** Returns the address of the scene and the shot in view. */
  const address = () => (write(), location.hash.slice(1));

  /** @param {FileList} files */
  const openFirst = async ([file]) => file && open(await file.text());

  $('file').addEventListener('change', async () => {
    await openFirst($('file').files);
    $('file').value = '';
  });
  addEventListener('dragover', (event) => event.preventDefault());
  addEventListener('drop', (event) => {
    event.preventDefault();
    openFirst(event.dataTransfer.files);
  });
  addEventListener('paste', (event) => {
    const text = event.clipboardData.getData('text');
    if (/^\s*\{/.test(text) && !(/** @type {Element} */ (event.target).closest?.('input'))) open(text);
  });

  pressed('link', async () => {
    write();
    const copied = await navigator.clipboard?.writeText(location.href).then(
      () => true,
      () => false,
    );
    say(copied ? 'The link is copied.' : 'The link is in the address bar.');
  });
  pressed('json', () => save.json({ ...state.puzzle(scene()), about: { page: address() } }));
  pressed('svg', () => save.svg(svg, caption()));
  pressed('png', () => save.png(svg, caption()));
  pressed('print', () => print());
  pressed('keep', () => {
    const name = $('name').value.trim() || new Date().toLocaleString();
    const instead = scenes()[name] ? ', in place of the one before' : '';
    const done = keep(place, { ...scenes(), [name]: address() });
    say(done ? `Kept as “${name}”${instead}.` : 'This browser keeps nothing for this page.');
    showKept();
  });
  $('kept').addEventListener('change', () => {
    const known = scenes()[$('kept').value];
    if (known) beginAt(known);
    $('name').value = $('kept').value;
  });
  pressed('forget', () => {
    const name = $('name').value;
    if (!scenes()[name] || !confirm(`Forget “${name}”?`)) return;
    forget(name);
    showKept();
  });
  showKept();
}
