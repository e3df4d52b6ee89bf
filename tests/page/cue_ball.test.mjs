// Tests what the page shows of an answer: where the cue ball ends, and the shot that stays when a wider search finds
// none.
import assert from 'node:assert/strict';
import { after, describe, test } from 'node:test';
import { answered, drag, launch, open, serve, text } from './browser.mjs';

const server = await serve();
const browser = await launch();
after(async () => {
  await browser.close();
  server.end();
});

const balls = 'ball=0.6,0.5&target=another ball&most=2&others=1.7,0.4,2.1,0.95,1.2,1';
const every = '**/api/solve?all*';

/** Moves the ball, and returns the answer with all shots after `change` was applied to it. A question that the page gave
 * up on its way is answered without shots: that answer is passed on as it is. */
async function changed(page, change = (answer) => answer) {
  let told;
  await page.route(every, async (route) => {
    const response = await route.fetch();
    const answer = await response.json();
    told = answer.shots?.length ? change(answer) : answer;
    await route.fulfill({ response, json: told });
  });
  await drag(page, 'ball', 0.02, 0.02);
  await answered(page);
  await page.unroute(every);
  return told;
}

/** Unfolds the whole list. */
const unfold = (page) =>
  page.evaluate(() => document.querySelectorAll('#shots details').forEach((d) => (d.open = true)));

const ring = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('#table .ghost')].map((e) => ['cx', 'cy'].map((key) => Number(e.getAttribute(key)))),
  );

/** Waits until the boldest path ends near one of these places. */
const pathEnds = (page, places, within) =>
  page.waitForFunction(
    ([places, within]) => {
      const points = document.querySelector('.path.best').getAttribute('points').split(' ');
      const [x, y] = points[points.length - 1].split(',').map(Number);
      return places.some((at) => Math.hypot(at[0] - x, at[1] - y) < within);
    },
    [places, within],
  );

describe('where the cue ball ends', () => {
  test('its path leads to the ring, where it rests', async () => {
    const { page, complaints } = await open(browser, `${server.url}#${balls}`);
    const { shots } = await changed(page);
    await unfold(page);
    let afterwards = 0;
    for (const [i, { cue_rests, path }] of shots.slice(0, 8).entries()) {
      if (!cue_rests) continue;
      await page.locator(`#shots [data-shot="${i}"]`).hover();
      assert.deepEqual(await ring(page), [cue_rests]);
      await pathEnds(page, [cue_rests], 1e-3);
      const [, x, y] = path[path.length - 1];
      afterwards += Math.hypot(cue_rests[0] - x, cue_rests[1] - y) > 0.05;
    }
    assert.ok(afterwards >= 3, `${afterwards} go on`);
    assert.deepEqual(complaints, []);
    await page.close();
  });

  test('a scratch is marked at its pocket, and its path leads into one', async () => {
    const { page } = await open(browser, `${server.url}#${balls}`);
    const { shots } = await changed(page, (answer) => {
      Object.assign(answer.shots[0], { scratch: true, cue_rests: 'top-left' });
      return answer;
    });
    const tables = await (await fetch(`${server.url}api/tables`)).json();
    const { pockets } = tables.find(({ name }) => name === 'pool-9ft');
    assert.deepEqual(await ring(page), [pockets.find(({ name }) => name === 'top-left').hole]);
    assert.equal(await page.locator('.ghost.scratch').count(), 1);
    assert.match(await text(page, 'words'), /the cue ball falls into top-left, too/);
    await unfold(page);
    const real = shots.findIndex(({ scratch }, i) => scratch && i > 0);
    assert.ok(real > 0);
    await page.locator(`#shots [data-shot="${real}"]`).hover();
    const holes = pockets.map(({ hole }) => hole);
    await pathEnds(page, holes, 0.1);
    await page.close();
  });

  test('no ring where it goes on, one where it falls or rests', async () => {
    for (const [scene, rings] of /** @type {[string, number][]} */ ([
      [`physics=ideal&${balls}`, 0],
      ['table=seed&physics=ideal&ball=0.587,0.11&target=point&point=2.363,0.346&least=2', 0],
      ['target=point', 1],
      ['target=top-right', 1],
    ])) {
      const { page } = await open(browser, `${server.url}#${scene}`);
      assert.equal(await page.locator('.path.best').count(), 1, scene);
      assert.equal((await ring(page)).length, rings, scene);
      await page.close();
    }
  });
});

test('a shot without a place asked for has its spread, too', async () => {
  for (const scene of [balls, 'ball=0.6,0.5&target=hit&object=2&least=1&others=1.7,0.4,2.1,0.95,1.2,1']) {
    const { page, complaints } = await open(browser, `${server.url}#${scene}`);
    await page.waitForSelector('.spread >> nth=1', { state: 'attached' });
    const [cx, cy] = await page
      .locator('.spread')
      .first()
      .evaluate((e) => ['cx', 'cy'].map((key) => Number(e.getAttribute(key))));
    const [[x, y]] = await ring(page);
    assert.ok(Math.hypot(cx - x, cy - y) < 0.25, `${[cx, cy]} and ${[x, y]}`);
    assert.deepEqual(complaints, []);
    await page.close();
  }
});

describe('a wider search that finds nothing', () => {
  for (const [name, answer, title] of /** @type {[string, object, RegExp][]} */ ([
    [
      'for its budget',
      { status: 'budget', shots: [], nearest: null, modelled: [], simulations: 9, message: 'no shot found' },
      /^Into top-right.*; the wider search ended at its budget$/,
    ],
    ['for an error', { path: '', reason: 'the server is busy' }, /^Into top-right.*; the server is busy$/],
  ]))
    test(`${name} leaves the shot that is there`, async () => {
      const { page } = await open(browser, `${server.url}#table=pool-9ft`);
      const status = 'reason' in answer ? 503 : 200;
      await page.route(every, (route) => route.fulfill({ status, json: answer }));
      await drag(page, 'ball', 0.02, 0.02);
      await answered(page);
      assert.match(await text(page, 'title'), title);
      assert.equal(await page.locator('.path.best').count(), 1);
      assert.equal(await page.locator('#shots button').count(), 1);
      await page.unroute(every);
      await drag(page, 'ball', 0.02, 0.02);
      await answered(page);
      assert.doesNotMatch(await text(page, 'title'), /;/);
      await page.close();
    });

  test('leaves none of another question', async () => {
    const { page } = await open(browser, `${server.url}#table=pool-9ft`);
    await page.locator('summary', { hasText: 'Limits' }).click();
    await page.locator('[name=fastest]').fill('0.3');
    await answered(page);
    assert.equal(await text(page, 'title'), 'No shot');
    assert.equal(await page.locator('.path.best').count(), 0);
    await page.close();
  });
});
