// Twenty scenes to begin with, from the book of examples. Each is an address as the page writes it.

/** @type {[string, string][]} */
const gallery = [
  ['One cushion, easy', 'table=pool-8ft&ball=1.271,0.155&target=top-middle&most=1'],
  ['Across the table', 'physics=rolling&ball=1.591,0.578&target=bottom-middle&most=1'],
  ['Two cushions into the middle', 'table=pool-8ft&ball=1.558,0.254&target=bottom-middle&least=2'],
  [
    'Off the bottom rail, with side',
    'table=pool-7ft&ball=0.518,0.273&target=top-middle&order=bottom&top=0.2&side=-0.3',
  ],
  ['Left, then top', 'table=pool-7ft&physics=rolling&ball=0.689,0.312&target=bottom-right&order=left,top'],
  ['Three cushions', 'table=pool-7ft&ball=1.135,0.487&target=top-left&least=3&most=3'],
  ['Three cushions with draw', 'table=pool-7ft&ball=1.233,0.484&target=bottom-middle&least=3&most=3&top=-0.3'],
  ['Around the table', 'ball=0.312,0.512&table=pool-8ft&target=bottom-middle&order=bottom,top,right'],
  ['Four cushions, hard', 'table=pool-8ft&ball=0.866,0.489&target=bottom-middle&least=4&most=4'],
  ['Five, rolling', 'table=pool-7ft&physics=rolling&ball=1.319,0.635&target=bottom-right&least=5&most=5'],
  ['Snooker, two cushions', 'table=snooker-12ft&ball=2.701,1.223&target=bottom-right&least=2'],
  ['Snooker, follow', 'table=snooker-12ft&ball=1.677,1.555&target=top-left&least=2&top=1'],
  [
    'Carom: three cushions to a point',
    'table=carom-10ft&ball=0.807,1.047&target=point&point=2.144,0.076&least=3&most=3',
  ],
  ['Carom: five', 'table=carom-10ft&ball=0.201,1.011&target=point&point=2.364,0.031&least=5&most=5&restitution=0.92'],
  ['Rest at a point', 'ball=0.841,0.875&target=point&point=2.356,0.412&order=top,bottom,top,bottom'],
  [
    'Mirrors, where mirrors are right',
    'table=seed&physics=ideal&ball=0.587,0.11&target=point&point=2.363,0.346&least=2',
  ],
  ['Any pocket', 'ball=1.2,0.7&target=any&least=1&most=3'],
  ['The planner chooses the spin', 'ball=0.4,0.3&target=top-middle&most=1&choose=true'],
  ['In the way', 'ball=0.5,0.4&target=top-right&most=3&others=1.4,0.85,1.9,0.6,1,0.2'],
  ['What should I play?', 'ball=0.6,0.5&target=another ball&most=2&others=1.7,0.4,2.1,0.95,1.2,1'],
];

/** Lists the scenes. @param {HTMLSelectElement} select @param {(address: string) => void} choose */
export function hang(select, choose) {
  for (const [name, address] of gallery) select.append(new Option(name, address));
  select.addEventListener('change', () => {
    if (select.value) choose(select.value);
    select.value = '';
  });
}
