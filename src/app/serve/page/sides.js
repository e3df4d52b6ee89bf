// The same scene in two physics, side by side: the answer of each, and where it leads if the other one is right.
import { heading } from './answer.js';
import { look } from './balls.js';
import { ask, forget } from './engine.js';
import { finish, follow, outcome } from './follow.js';
import { lead, paint } from './paint.js';
import * as state from './state.js';
import { draw, shape } from './table.js';

/** Asks for the same route to the same target. @param {state.Scene} scene in the other physics @param {any} shot */
function question(scene, { cushions, then, speed }) {
  const target = then ? { target: { ball: then.ball, then: { pocket: then.pocket, cushions: then.cushions } } } : {};
  const fixed = scene.physics === 'ideal' ? { speed } : {}; // without friction any speed would do
  return { ...state.puzzle(scene), cushions, ...target, ...fixed };
}

const none = 'has no such shot';

const lower = (words) => words[0].toLowerCase() + words.slice(1);
const launch = ({ angle, speed }) => `${angle.toFixed(2)}° at ${speed.toFixed(2)} m/s`;

/** Returns a line of text under a picture, in the colour of its path. */
function words(kind, text) {
  const line = document.createElement('p');
  line.className = 'key ' + kind;
  line.textContent = text;
  return line;
}

/** Draws the target and the balls. */
function stand(layer, table, scene) {
  const pocket = table.pockets.find(({ name }) => name === scene.target);
  const put = (kind, [cx, cy], r, width = 0.004) =>
    shape('circle', { class: kind, cx, cy, r, 'stroke-width': width }, layer);
  if (pocket) put('target', pocket.hole, pocket.radius + 0.012, 0.012);
  else if (scene.target === 'point') put('target', scene.point, table.radius, 0.012);
  scene.others.forEach((at, i) =>
    put('other', at, table.radius).setAttribute('fill', look(state.nameOf(scene, i)).fill),
  );
  put('ball', scene.ball, table.radius);
}

/**
 * Returns one of the two pictures.
 * @param {import('./table.js').Table} table @param {state.Scene} scene
 * @param {any} own its answer @param {any} afterwards how the balls move on
 * @param {{physics: string, shot: any, followed: any}} other the other physics, whose aim is tried here
 */
function side(table, scene, own, afterwards, other) {
  const [figure, caption] = ['figure', 'figcaption'].map((tag) => document.createElement(tag));
  caption.textContent = `If ${scene.physics} is right`;
  const { physics, shot, followed } = other;
  const says = own
    ? `${scene.physics} says ${launch(own)}: ${lower(heading(own, scene.target))}`
    : `${scene.physics} ${none}`;
  const leads = shot ? `${physics} says ${launch(shot)}: ${outcome(scene, followed)}` : `${physics} ${none}`;
  const svg = shape('svg', { role: 'img', 'aria-label': `${caption.textContent}. ${says}. ${leads}` });
  figure.append(caption, svg, words('best', says), words('compare', leads));
  const show = () => {
    const { paths, grips } = draw(svg, table);
    paint(shape('g', {}, paths), table, [], own, { afterwards });
    if (shot) lead(paths, [], followed, 'compare');
    stand(grips, table, scene);
  };
  return { figure, show };
}

/**
 * @param {HTMLElement} box
 * @param {import('./table.js').Table} table
 * @param {state.Scene} scene
 * @param {any} shot answer in this physics
 * @param {string} physics the other physics
 */
export async function sides(box, table, scene, shot, physics) {
  const theirs = { ...scene, physics };
  const answer = await ask('solve?path&no-robustness', question(theirs, shot), 'side');
  if (!answer) return;
  const best = answer.shots?.[0] ?? null;
  const [here, there, mine, other] = await Promise.all([
    best ? follow(scene, best, 'side-here') : { path: [] },
    follow(theirs, shot, 'side-there'),
    finish(scene, shot, 'side-mine'),
    finish(theirs, best, 'side-theirs'),
  ]);
  if (!here || !there || here.error || there.error) return;
  const both = [
    side(table, scene, shot, mine, { physics, shot: best, followed: here }),
    side(table, theirs, best, other, { physics: scene.physics, shot, followed: there }),
  ];
  box.replaceChildren(...both.map(({ figure }) => figure));
  for (const { show } of both) show(); // only now, as letters scale with the picture's width
}

/** Ends all questions of this comparison. */
export function forgetSides() {
  for (const kind of [
    'side',
    ...['here', 'there', 'mine', 'theirs'].flatMap((end) => [`side-${end}`, `side-${end}-path`]),
  ])
    forget(kind);
}
