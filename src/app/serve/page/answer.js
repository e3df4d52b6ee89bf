// An answer in words: the list of shots by pattern, and the shot in view.

const by = (cushions) => (cushions.length ? ' by ' + cushions.join(', ') : '');

/** Names the route of the cue ball, or of the object ball that it pots. @param {any} shot */
export function pattern(shot) {
  const sent = shot.then;
  const way = sent ? `${sent.ball} into ${sent.pocket}${by(sent.cushions)}` : shot.cushions.join(', ') || 'straight';
  return way + (shot.rattles ? ', off jaws' : '') + (shot.scratch ? ', a scratch' : '');
}

/** Finds the shot most like the one chosen while the search went on. @param {any[]} shots @param {any} shot */
export function likest(shots, shot) {
  const off = (other) => Math.abs(other.angle - shot.angle) + (pattern(other) === pattern(shot) ? 0 : 360);
  return shots.reduce((best, other, i) => (off(other) < off(shots[best]) ? i : best), 0);
}

/** @param {any} shot @param {string} target */
export function heading(shot, target) {
  if (!shot) return 'No shot';
  if (shot.then) return `Ball ${pattern(shot)}`;
  const into = shot.pocket ?? (target === 'point' ? 'the point' : target);
  return `Into ${into}${shot.cushions.length ? by(shot.cushions) : ', straight'}`.replace('Into the', 'To the');
}

/** @param {number | null | undefined} chance */
export function percent(chance) {
  if (chance === undefined || chance === null) return '';
  return chance > 0.995 ? '> 99 %' : chance < 0.005 ? '< 1 %' : Math.round(100 * chance) + ' %';
}

/** @param {number} v in m/s */
export function pace(v) {
  const mph = v / 0.44704;
  const word = mph < 2 ? 'soft' : mph < 4 ? 'medium' : mph < 7 ? 'firm' : mph < 10 ? 'hard' : 'as hard as a break';
  return `${word}: ${v.toFixed(2)} m/s`;
}

/**
 * @param {any} shot
 * @param {string} aim
 * @param {(metres: number) => string} length
 * @returns {[string, string][]}
 */
export function words(shot, aim, length) {
  const off = (v, more, less) => (v ? `${length(Math.abs(v))} ${v > 0 ? more : less}` : '');
  const tip =
    shot.tip && [off(shot.tip.up, 'above', 'below'), off(shot.tip.right, 'right', 'left')].filter(Boolean).join(', ');
  /** @type {[string, string][]} */
  const rows = [
    ['aim', `${aim} (${shot.angle.toFixed(2)}°)`],
    ['speed', pace(shot.speed)],
    ['tip', tip || 'in the centre'],
    ['arrives', `after ${shot.arrival.time.toFixed(2)} s at ${shot.arrival.speed.toFixed(2)} m/s`],
  ];
  if (shot.success !== undefined) rows.push(['success', percent(shot.success)]);
  if (shot.margin?.angle.every((v) => v !== null)) {
    const [less, more] = shot.margin.angle.map((v) => Math.abs(v).toFixed(2));
    rows.push(['margin', `${less}° to the right, ${more}° to the left`]);
  }
  const into = typeof shot.cue_rests === 'string' ? ` into ${shot.cue_rests}` : '';
  if (shot.scratch) rows.push(['but', `the cue ball falls${into}, too`]);
  return rows;
}

/** Fills a description list with terms and their values. @param {HTMLElement} list @param {[string, string][]} rows */
export function tell(list, rows) {
  const items = rows.flatMap(([name, text]) => {
    const [term, value] = [document.createElement('dt'), document.createElement('dd')];
    term.textContent = name;
    value.textContent = text;
    return [term, value];
  });
  list.replaceChildren(...items);
}

/**
 * Fills the list of shots, best pattern first.
 * @param {HTMLElement} list
 * @param {any[]} shots
 * @param {number} chosen
 * @param {{look: (i: number) => void, choose: (i: number) => void}} on
 */
export function fill(list, shots, chosen, on) {
  /** @type {Map<string, number[]>} */
  const groups = new Map();
  shots.forEach((shot, i) => groups.set(pattern(shot), [...(groups.get(pattern(shot)) ?? []), i]));
  const items = [];
  for (const [name, members] of groups) {
    const item = document.createElement('li');
    const head = document.createElement('h3');
    head.textContent = members.length > 1 ? `${name} (${members.length})` : name;
    const inner = document.createElement('ol');
    inner.append(...members.map((i) => entry(shots[i], i, i === chosen, on)));
    item.append(head, inner);
    items.push(item);
  }
  list.replaceChildren(...items);
}

/** Marks the chosen shot in the list. @param {HTMLElement} list @param {number} chosen */
export function mark(list, chosen) {
  for (const button of list.querySelectorAll('button'))
    button.setAttribute('aria-current', String(Number(button.dataset.shot) === chosen));
}

function entry(shot, i, current, on) {
  const [item, button, chance, text] = ['li', 'button', 'strong', 'span'].map((tag) => document.createElement(tag));
  chance.textContent = percent(shot.success);
  text.textContent = `${shot.angle.toFixed(2)}°, ${shot.speed.toFixed(2)} m/s`;
  button.setAttribute('type', 'button');
  button.dataset.shot = String(i);
  button.setAttribute('aria-current', String(current));
  button.append(chance, ' ', text);
  button.addEventListener('mouseenter', () => on.look(i));
  button.addEventListener('focus', () => on.look(i));
  button.addEventListener('click', () => on.choose(i));
  item.append(button);
  return item;
}
