// Measures the time from a move of the pointer to the drawn answer, in milliseconds (node timing.mjs > page.csv).
// The time `first` ends when the first shot is in the picture, `frame` at the browser's next frame, and `all` at the
// frame after all shots.
// The ball is dragged across the table; each move waits for all shots of the move before.
import { answered, launch, middle, open, serve, ways } from './browser.mjs';

const moves = 100;
const scenes = [
  ['point', 'table=carom-10ft&target=point&point=2.1,0.9&ball=0.6,0.5'],
  ['a pocket', 'table=pool-9ft&target=top-right&ball=0.6,0.5'],
  ['any pocket', 'table=pool-9ft&target=any&ball=0.6,0.5'],
];

/** Runs in the page: times the drawing of the next answers from the next move of the pointer. */
function watch() {
  const drawn = (begin, done) => requestAnimationFrame(() => done(performance.now() - begin));
  globalThis.next = () =>
    new Promise((done) => {
      const took = {};
      const begin = new Promise((moved) =>
        addEventListener('pointermove', () => moved(performance.now()), { once: true, capture: true }),
      );
      const words = new MutationObserver(async () => {
        words.disconnect();
        const moved = await begin;
        took.first = performance.now() - moved;
        drawn(moved, (ms) => (took.frame = ms));
      });
      words.observe(document.getElementById('words'), { childList: true });
      const all = new MutationObserver(async () => {
        all.disconnect();
        drawn(await begin, (all) => done({ first: all, frame: all, ...took, all }));
      });
      all.observe(document.body, { attributes: true, attributeFilter: ['data-answered'] });
    });
}

const percentile = (values, share) => values.sort((a, b) => a - b)[Math.floor(share * (values.length - 1))].toFixed(1);

async function measure(browser, url, scene, cushions) {
  const { page } = await open(browser, `${url}#${scene}&least=${cushions}&most=${cushions}`);
  await page.evaluate(watch);
  const { x, y } = await middle(page, '[data-grip="ball"].grip');
  await page.mouse.move(x, y);
  await page.mouse.down();
  const found = [];
  for (let i = 1; i <= moves; ++i) {
    const next = page.evaluate(() => globalThis.next());
    await page.mouse.move(x + 2 * i, y - 60 * Math.sin(i / 20) + (i % 2));
    found.push(await next);
  }
  await page.mouse.up();
  await answered(page);
  await page.close();
  const column = (key) => found.map((one) => one[key]);
  const of = (key) => [0.5, 0.99].map((share) => percentile(column(key), share));
  return [...of('first'), ...of('frame'), ...of('all')];
}

const server = await serve();
const browser = await launch();
console.log(
  'engine,target,cushions,moves,first_median_ms,first_p99_ms,frame_median_ms,frame_p99_ms,all_median_ms,all_p99_ms',
);
for (const { name, url } of await ways(server))
  for (const [target, scene] of scenes)
    for (const cushions of [0, 1, 2, 3])
      console.log([name, target, cushions, moves, ...(await measure(browser, url, scene, cushions))].join());
await browser.close();
server.end();
