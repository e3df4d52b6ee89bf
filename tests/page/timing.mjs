// Measures the picture while a ball is dragged by a pointer that does not wait (node timing.mjs > page.csv): redraws per
// second, the longest time without one, and the time from the end of the movement to the best shot and to all shots.
// The scenes ask what to play with one, three and nine object balls; answers are late by `latency_ms`.
import { setTimeout as wait } from 'node:timers/promises';
import { answered, launch, middle, open, pixels, serve, ways } from './browser.mjs';

const [moves, frame] = [240, 1000 / 60]; // ms between moves
const others = '1.7,0.4,2.1,0.95,1.2,1,1.9,0.7,2.2,0.3,0.3,1.1,1.5,0.15,2.35,0.6,0.9,0.15'.split(',');
const balls = (n) => `ball=0.6,0.5&others=${others.slice(0, 2 * n)}`;
/** @type {[string, (n: number) => string, number[]][]} the question, its scene with some balls, and how many */
const scenes = [
  ['a pocket', () => 'target=top-right&ball=0.6,0.5', [0]],
  ['another ball', (n) => `target=another ball&${balls(n)}`, [1, 3, 9]],
  ['what to play', (n) => `target=play&skill=0.6&${balls(n)}`, [1, 3, 9]],
];

/** Runs in the page: notes when the boldest path is drawn anew, and when all shots of a scene are there. */
function watch() {
  const seen = { drawn: [], answered: [] };
  let last = '';
  const look = () => {
    const points = document.querySelector('.path.best')?.getAttribute('points') ?? last;
    if (points !== last) seen.drawn.push(performance.now());
    last = points;
  };
  new MutationObserver(look).observe(document.querySelector('#table'), { childList: true, subtree: true });
  const all = () => seen.answered.push(performance.now());
  new MutationObserver(all).observe(document.body, { attributes: true, attributeFilter: ['data-answered'] });
  Object.assign(globalThis, { seen });
}

async function measure(browser, url, scene, latency) {
  const { page } = await open(browser, `${url}#${scene}`);
  if (latency)
    await page.route('**/api/**', async (route) => {
      await wait(latency);
      await route.continue().catch(() => {}); // its page may have cancelled it
    });
  const { x, y } = await middle(page, '[data-grip="ball"].grip');
  const r = 0.12 * (await pixels(page));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.evaluate(watch);
  const begin = await page.evaluate(() => performance.now());
  for (let i = 1; i <= moves; ++i) {
    const angle = i / 20;
    await Promise.all([page.mouse.move(x + r * Math.sin(angle), y + r * (1 - Math.cos(angle))), wait(frame)]);
  }
  const end = await page.evaluate(() => performance.now());
  await page.mouse.up();
  await answered(page);
  const { drawn, answered: all } = await page.evaluate(() => globalThis.seen);
  await page.close();
  const times = [begin, ...drawn.filter((t) => t <= end), end];
  const gap = Math.max(...times.slice(1).map((t, i) => t - times[i]));
  const first = drawn.find((t) => t > end) ?? end;
  return [
    ((times.length - 2) / ((end - begin) / 1000)).toFixed(1),
    gap.toFixed(0),
    (first - end).toFixed(0),
    (all.at(-1) - end).toFixed(0),
  ];
}

/** Returns every measurement of a way to the page. */
const plan = (name) =>
  scenes.flatMap(([question, scene, counts]) =>
    counts.flatMap((n) =>
      (name === 'the server' ? [0, 100] : [0]).map((latency) => ({ question, scene: scene(n), n, latency })),
    ),
  );

const server = await serve();
const browser = await launch();
console.log('engine,question,balls,latency_ms,redraws_per_s,longest_gap_ms,best_ms,all_ms');
for (const { name, url } of await ways(server))
  for (const { question, scene, n, latency } of plan(name))
    console.log([name, question, n, latency, ...(await measure(browser, url, scene, latency))].join());
await browser.close();
server.end();
