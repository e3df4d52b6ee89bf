// An answer in words: the list of shots by pattern, and the one that is looked at.

/** By what the ball goes, or the one that it sends on. @param {any} shot */
export function pattern(shot) {
  const sent = shot.then;
  const by = (cushions) => (cushions.length ? ' by ' + cushions.join(', ') : '');
  const way = sent ? `${sent.ball} into ${sent.pocket}${by(sent.cushions)}` : shot.cushions.join(', ') || 'straight';
  return way + (shot.rattles ? ', off jaws' : '');
}

/** @param {number} chance */
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

/** @param {any} shot @param {string} aim @returns {[string, string][]} */
export function words(shot, aim) {
  const mm = (v, more, less) => (v ? `${(1000 * Math.abs(v)).toFixed(1)} mm ${v > 0 ? more : less}` : '');
  const tip = shot.tip && [mm(shot.tip.up, 'above', 'below'), mm(shot.tip.right, 'right', 'left')].filter(Boolean).join(', ');
  const rows = [
    ['aim', `${aim} (${shot.angle.toFixed(2)}°)`],
    ['speed', pace(shot.speed)],
    ['tip', tip || 'in the centre'],
    ['arrives', `after ${shot.arrival.time.toFixed(2)} s at ${shot.arrival.speed.toFixed(2)} m/s`],
  ];
  if (shot.success !== undefined) rows.push(['chance', percent(shot.success)]);
  if (shot.margin?.angle.every((v) => v !== null))
    rows.push(['margin', shot.margin.angle.map((v) => (v > 0 ? '+' : '') + v.toFixed(2)).join(' to ') + ' degrees']);
  return rows;
}

/**
 * @param {HTMLElement} list
 * @param {any[]} shots
 * @param {number} chosen
 * @param {{look: (i: number) => void, choose: (i: number) => void}} on
 */
export function fill(list, shots, chosen, on) {
  list.replaceChildren();
  const groups = new Map();
  shots.forEach((shot, i) => groups.set(pattern(shot), [...(groups.get(pattern(shot)) ?? []), i]));
  for (const [name, members] of groups) {
    const head = document.createElement('li');
    head.className = 'pattern';
    head.textContent = members.length > 1 ? `${name} (${members.length})` : name;
    list.append(head);
    for (const i of members) list.append(entry(shots[i], i, i === chosen, on));
  }
}

function entry(shot, i, current, on) {
  const item = document.createElement('li'), button = document.createElement('button');
  const chance = document.createElement('strong'), text = document.createElement('span');
  chance.textContent = percent(shot.success);
  text.textContent = `${shot.angle.toFixed(1)}°, ${shot.speed.toFixed(2)} m/s`;
  button.type = 'button';
  button.setAttribute('aria-current', String(current));
  button.append(chance, text);
  button.addEventListener('mouseenter', () => on.look(i));
  button.addEventListener('focus', () => on.look(i));
  button.addEventListener('click', () => on.choose(i));
  item.append(button);
  return item;
}
