// Scenes to begin with: games, drills for the leave, and shots from the book of examples. Each is an address as the page
// writes it.

/** @type {Record<string, [string, string][]>} */
const gallery = {
  Games: [
    [
      'Nine-ball, after the break',
      'target=play&skill=0.6&ball=1.2,0.7&others=2.12,0.97,0.62,0.31,1.86,0.29,1.02,0.95,2.31,0.55,0.41,0.98,1.55,1.08,1.72,0.7,0.85,0.62',
    ],
    [
      'Eight-ball: solids',
      'target=play&game=eight&skill=0.6&ball=0.64,0.66&others=1.9,0.33,1.1,1.05,0.4,0.28,2.2,0.95,1.5,0.6,2.35,0.4,0.95,0.25,1.75,1.1&names=1,2,4,8,10,11,13,15',
    ],
    [
      'A rack of nine-ball',
      'target=play&skill=0.6&ball=0.6,0.635&others=1.90500,0.63500,1.95454,0.60640,1.95454,0.66360,2.00407,0.57780,2.00407,0.63500,2.00407,0.69220,2.05361,0.60640,2.05361,0.66360,2.10315,0.63500&names=1,2,3,4,9,5,6,7,8',
    ],
  ],
  'Drills: leave the cue ball': [
    [
      'L drill',
      'target=play&skill=0.6&ball=1.4287,0.381&others=1.905,0.3175,1.905,0.4763,1.905,0.635,2.0638,0.635,2.2225,0.635',
    ],
    [
      'Line-up',
      'target=play&game=any&skill=0.6&ball=1.5875,0.3175&others=1.4287,0.635,1.5875,0.635,1.7463,0.635,1.905,0.635,2.0638,0.635,2.2225,0.635',
    ],
    [
      'Wagon wheel',
      'target=pot&object=1&into=top-middle&most=0&skill=0.6&ball=1.5875,0.762&others=1.3017,1.143&zone=0.4763,0.1905,0.15',
    ],
    [
      'Target pool',
      'target=pot&object=1&into=top-right&most=0&skill=0.6&ball=0.9525,0.635&others=2.0638,0.9525&zone=1.27,0.3175,0.15',
    ],
    [
      'End of a rack',
      'target=play&skill=0.6&ball=0.7302,0.381&others=1.651,0.9843,2.1907,0.254,0.4445,1.0477&names=7,8,9',
    ],
  ],
  Shots: [
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
  ],
};

/** Lists the scenes. @param {HTMLSelectElement} select @param {(address: string, name: string) => void} choose */
export function hang(select, choose) {
  for (const [title, scenes] of Object.entries(gallery)) {
    const group = document.createElement('optgroup');
    group.label = title;
    group.append(...scenes.map(([name, address]) => new Option(name, address)));
    select.append(group);
  }
  select.addEventListener('change', () => {
    if (select.value) choose(select.value, select.selectedOptions[0].text);
    select.value = '';
  });
}
