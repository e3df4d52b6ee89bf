// An answer in a coach's words: the list of shots, and the shot in view.
import { called } from './balls.js';
import { distance, pace, side, speed, tips } from './units.js';

const by = (cushions) => (cushions.length ? ' by ' + cushions.map(side).join(', ') : '');

/** Names the route of the cue ball, or of the object ball that it pots. @param {any} shot */
export function pattern(shot) {
  const sent = shot.then;
  if (shot.safety) return `safety off ${called(shot.hits[0].ball)}${by(shot.cushions)}`;
  const way = sent?.pocket
    ? `${sent.ball} into ${side(sent.pocket)}${by(sent.cushions)}${shot.cushions.length ? `, kicked${by(shot.cushions)}` : ''}`
    : route(shot);
  return way + (shot.rattles ? ', off jaws' : '') + (shot.scratch ? ', SCRATCH' : '');
}

/** Names the ball that is hit and the cushions before it. */
function route({ cushions, hits, then }) {
  const ball = then?.then ? `${then.ball}, then ${then.then.ball} into ${side(then.then.pocket)}` : hits?.[0]?.ball;
  return (ball ? `${ball}, ` : '') + (cushions.map(side).join(', ') || (ball ? 'direct' : 'straight'));
}

/** Finds the shot most like another one. @param {any[]} shots @param {any} shot */
export function likest(shots, shot) {
  const off = (other) =>
    Math.abs(other.angle - shot.angle) +
    Math.abs(other.speed - shot.speed) +
    (!shot.cushions || pattern(other) === pattern(shot) ? 0 : 360);
  return shots.reduce((best, other, i) => (off(other) < off(shots[best]) ? i : best), 0);
}

/** @param {any} shot @param {string} target @param {string} [status] of the answer */
export function heading(shot, target, status = '') {
  if (!shot) return status === 'budget' ? 'No shot found yet: the search ran out' : 'No shot';
  return plain(shot, target) + (shot.scratch ? ' – SCRATCH' : '');
}

/** Names the shot of an object ball that falls. @param {any} shot */
function sending({ cushions: kicked, then: { ball, cushions, pocket, then } }) {
  const verb = (plain) => (kicked.length ? `Kick ${called(ball)}${by(kicked)}` : `${plain} ${called(ball)}`);
  if (then) return `${verb('Play')} onto ${called(then.ball)}, into ${side(then.pocket)}`;
  const into = `into ${side(pocket)}`;
  // A rail that ends at the pocket leads a ball into it.
  if (cushions.length === 1 && pocket.split('-').includes(cushions[0]))
    return `${verb('Pot')} along the ${side(cushions[0])} rail ${into}`;
  return verb(cushions.length ? 'Bank' : 'Pot') + (cushions.length ? by(cushions) : '') + ` ${into}`;
}

function plain(shot, target) {
  const first = shot.hits?.[0]?.ball;
  if (shot.safety) return `Play safe off ${called(first)}${by(shot.cushions)}`;
  if (shot.then && (shot.then.pocket || shot.then.then)) return sending(shot);
  if (first)
    return shot.cushions.length ? `Kick at ${called(first)}${by(shot.cushions)}` : `Hit ${called(first)} direct`;
  const into = target === 'point' && !shot.pocket ? 'the point' : side(shot.pocket ?? target);
  return `Into ${into}${shot.cushions.length ? by(shot.cushions) : ', straight'}`.replace('Into the', 'To the');
}

/** @param {number | null | undefined} chance */
export function percent(chance) {
  if (chance === undefined || chance === null) return '';
  return chance > 0.995 ? '> 99 %' : chance < 0.005 ? '< 1 %' : Math.round(100 * chance) + ' %';
}

const fractions = ['a hair', '1/8', '1/4', '3/8', 'half', '5/8', '3/4', '7/8', 'full'];

/** Says how much of the object ball is covered. @param {number} fullness */
function fullness(fullness) {
  const thin = fullness < 0.2 ? ', thin' : fullness > 0.95 ? '' : fullness > 0.7 ? ', thick' : '';
  return `${fractions[Math.round(8 * Math.min(Math.max(fullness, 0), 1))]} ball${thin}`;
}

/** Says where the cue ball stops. @param {any} shot @param {any} table */
function rests({ cue_rests, leave }, table) {
  if (typeof cue_rests === 'string') return `falls into ${side(cue_rests)}: a scratch`;
  if (!cue_rests) return '';
  const [x, y] = cue_rests;
  const across = x < table.length / 2 ? [x, 'left'] : [table.length - x, 'right'];
  const up = y < table.width / 2 ? [y, 'bottom'] : [table.width - y, 'top'];
  const off = leave?.cushions.length ? `, off ${leave.cushions.map(side).join(', ')}` : '';
  return `stops ${distance(across[0])} from the ${side(across[1])} rail, ${distance(up[0])} from the ${side(up[1])}${off}`;
}

/**
 * Returns what is planned after a shot of a game.
 * @param {any} shot @param {any} plan
 * @returns {[string, string][]}
 */
function planned(shot, plan) {
  /** @type {[string, string][]} */
  const rows = [];
  const next = plan?.next.length ? plan.next : shot.leave?.next ? [shot.leave.next] : [];
  next.forEach(({ ball, pocket, success }, i) =>
    rows.push([i ? 'then' : 'next', `${called(ball)} into ${side(pocket)}, ${percent(success)}`]),
  );
  if (plan && plan.clears.length > 1) {
    const what = plan.table ? 'the table' : `${plan.clears.length} balls`;
    rows.push(['clears', `${what} in ${percent(plan.clears[plan.clears.length - 1])} of visits, by an estimate`]);
  }
  if (plan?.why) rows.push(['why', plan.why]);
  return rows;
}

/** Says how likely the shot is made and leaves the cue ball as asked. @returns {[string, string][]} */
function position({ leave, safety }) {
  if (!leave || safety) return [];
  const next = leave.next ? 'made, and the next ball potted' : 'made, and the cue ball stops there';
  return [['position', `${percent(leave.success)}: ${next}`]];
}

/**
 * @param {any} shot
 * @param {{aim: string, table: any, plan?: any, steady: boolean}} with `steady`: only these cushions count, so that the
 *   margin says how sure the shot is
 * @returns {[string, string][]}
 */
export function words(shot, { aim, table, plan, steady }) {
  const off = (v, more, less) => (v ? `${tips(Math.abs(v))} ${v > 0 ? more : less}` : '');
  const tip =
    shot.tip && [off(shot.tip.up, 'high', 'low'), off(shot.tip.right, 'right', 'left')].filter(Boolean).join(', ');
  /** @type {[string, string][]} */
  const rows = [
    ['aim', `${aim} (${shot.angle.toFixed(2)}°)`],
    ['speed', pace(shot.speed)],
    ['tip', tip || 'in the centre'],
  ];
  if (shot.contact) rows.push(['hit', fullness(shot.contact.fullness)]);
  else rows.push(['arrives', `after ${shot.arrival.time.toFixed(2)} s at ${speed(shot.arrival.speed)}`]);
  if (shot.rattles) rows.push(['but', 'off the jaws of a pocket']);
  const leaves = rests(shot, table);
  if (leaves && shot.hits?.length) rows.push(['cue ball', leaves]);
  if (shot.success !== undefined) rows.push(['success', percent(shot.success)]);
  rows.push(...position(shot));
  if (steady && shot.margin?.angle.every((v) => v !== null)) {
    const [less, more] = shot.margin.angle.map((v) => Math.abs(v).toFixed(2));
    rows.push(['margin', `${less}° to the right, ${more}° to the left`]);
  }
  const into = typeof shot.cue_rests === 'string' ? ` into ${side(shot.cue_rests)}` : '';
  if (shot.scratch) rows.push(['SCRATCH', `the cue ball falls${into}, too`]);
  return [...rows, ...planned(shot, plan)];
}

/** Fills a description list with terms and their values. @param {HTMLElement} list @param {[string, string][]} rows */
export function tell(list, rows) {
  const items = rows.flatMap(([name, text]) => {
    const [term, value] = [document.createElement('dt'), document.createElement('dd')];
    term.textContent = name;
    value.textContent = text;
    for (const part of [term, value]) part.classList.toggle('bad', name === 'SCRATCH');
    return [term, value];
  });
  list.replaceChildren(...items);
}

/** Names what a shot is for: a ball and its pocket, or else its route. @param {any} shot */
const purpose = (shot) =>
  shot.then?.pocket && !shot.safety ? `${shot.then.ball} into ${shot.then.pocket}` : pattern(shot);

/** Returns the terms and values of a description list. @param {HTMLElement} list @returns {[string, string][]} */
export const told = (list) =>
  [...list.querySelectorAll('dt')].map((term) => [term.textContent, term.nextSibling.textContent]);

/** Returns the numbers of the shots for each purpose, best first. @param {any[]} shots @returns {Map<string, number[]>} */
export function groups(shots) {
  const found = new Map();
  shots.forEach((shot, i) => found.set(purpose(shot), [...(found.get(purpose(shot)) ?? []), i]));
  return found;
}

/**
 * Fills the list of shots: the best for each purpose, its other ways folded below it.
 * @param {HTMLElement} list
 * @param {any[]} shots
 * @param {number} chosen
 * @param {{look: (i: number) => void, choose: (i: number) => void}} on
 */
export function fill(list, shots, chosen, on) {
  const items = [];
  for (const [best, ...more] of groups(shots).values()) {
    const item = document.createElement('li');
    item.append(entry(shots[best], best, best === chosen, on));
    if (more.length) item.append(folded(shots, distinct(shots, more), chosen, on));
    items.push(item);
  }
  list.replaceChildren(...items);
}

/** How likely a shot is made and leaves the cue ball as asked. @param {any} shot */
const chance = (shot) => shot.leave?.success ?? shot.success;

/** Says how one of the other ways is played. @param {any} shot */
const way = (shot) => `${pattern(shot)}: ${shot.angle.toFixed(1)}°, ${speed(shot.speed)}`;

/** Returns ways to the same end, likeliest first; of those that read alike the best. @param {number[]} more */
function distinct(shots, more) {
  const byWords = new Map();
  for (const i of more) if (!byWords.has(way(shots[i]))) byWords.set(way(shots[i]), i);
  return [...byWords.values()].sort((a, b) => (chance(shots[b]) ?? 0) - (chance(shots[a]) ?? 0));
}

/** Returns the other ways to the same end, which are listed once they are unfolded. @param {number[]} more */
function folded(shots, more, chosen, on) {
  const fold = document.createElement('details');
  const [summary, inner] = ['summary', 'ol'].map((tag) => document.createElement(tag));
  summary.textContent = more.length > 1 ? `${more.length} more ways` : 'one more way';
  const unfold = () => {
    if (!fold.open || inner.childElementCount) return;
    for (const i of more) {
      const line = document.createElement('li');
      line.append(entry(shots[i], i, i === chosen, on, true));
      inner.append(line);
    }
  };
  fold.addEventListener('toggle', unfold);
  fold.open = more.includes(chosen);
  unfold();
  fold.append(summary, inner);
  return fold;
}

/** Marks the chosen shot in the list. @param {HTMLElement} list @param {number} chosen */
export function mark(list, chosen) {
  for (const button of list.querySelectorAll('button'))
    button.setAttribute('aria-current', String(Number(button.dataset.shot) === chosen));
}

/** Returns a line of the list; one of the other ways says how it is played, too. */
function entry(shot, i, current, on, other = false) {
  const [button, share, text] = ['button', 'strong', 'span'].map((tag) => document.createElement(tag));
  share.textContent = percent(chance(shot));
  text.textContent = other ? way(shot) : pattern(shot);
  text.classList.toggle('bad', Boolean(shot.scratch));
  button.setAttribute('type', 'button');
  button.dataset.shot = String(i);
  button.setAttribute('aria-current', String(current));
  button.append(share, ' ', text);
  button.addEventListener('mouseenter', () => on.look(i));
  button.addEventListener('focus', () => on.look(i));
  button.addEventListener('click', () => on.choose(i));
  return button;
}
