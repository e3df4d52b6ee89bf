// Tests dragging as people do it: by a finger, and without a pause while the engine searches.
import assert from 'node:assert/strict';
import { after, describe, test } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { answered, launch, middle, open, pixels, serve } from './browser.mjs';

const server = await serve();
const browser = await launch();
after(async () => {
  await browser.close();
  server.end();
});

const three = 'ball=0.6,0.5&target=another ball&most=2&others=1.7,0.4,2.1,0.95,1.2,1';
const nine = `${three},1.9,0.7,2.2,0.3,0.3,1.1,1.5,0.15,2.35,0.6,0.9,0.15`;

const frame = 1000 / 60; // ms between the moves of a pointer
const moves = 240;

describe('a finger', () => {
  const phone = { viewport: { width: 390, height: 800 }, hasTouch: true, isMobile: true };

  /** Moves a finger by a distance in pixels in many steps, and lifts it. */
  async function swipe(page, { x, y }, right, down) {
    const client = await page.context().newCDPSession(page);
    const touch = (type, ...touchPoints) => client.send('Input.dispatchTouchEvent', { type, touchPoints });
    await touch('touchStart', { x, y });
    for (let i = 1; i <= 20; ++i) await touch('touchMove', { x: x + (right * i) / 20, y: y + (down * i) / 20 });
    await touch('touchEnd');
    await client.detach();
  }

  for (const [grip, right, down] of /** @type {[string, number, number][]} */ ([
    ['ball', -60, -80],
    ['ball', 10, -90],
    ['other0', 60, 50],
    ['target', 50, 60],
    ['cushion', 0, 30],
  ]))
    test(`takes ${grip} ${right} px to the right and ${down} px down`, async () => {
      const { page, complaints } = await open(
        browser,
        `${server.url}#ball=0.5,0.2&target=point&point=2,0.9&others=1.6,1`,
        phone,
      );
      const from = await middle(page, `[data-grip="${grip}"].grip`);
      await swipe(page, from, right, down);
      const to = await middle(page, `[data-grip="${grip}"].grip`);
      assert.ok(Math.abs(to.x - from.x - right) < 1.5, `${to.x} px, from ${from.x}`);
      // The aim stays on its cushion.
      if (grip !== 'cushion') assert.ok(Math.abs(to.y - from.y - down) < 1.5, `${to.y} px, from ${from.y}`);
      assert.equal(await page.evaluate(() => scrollY), 0);
      await answered(page);
      assert.deepEqual(complaints, []);
      await page.close();
    });

  test('moves the tip', async () => {
    const { page } = await open(browser, `${server.url}#table=pool-9ft`, phone);
    await page.locator('#tip').scrollIntoViewIfNeeded();
    const before = await page.evaluate(() => scrollY);
    const { width } = await page.locator('#tip').boundingBox();
    await swipe(page, await middle(page, '#tip'), 0, -0.2 * width);
    await answered(page);
    assert.equal(await page.evaluate(() => scrollY), before);
    assert.match(await page.url(), /top=1\b/);
    await page.close();
  });

  test('scrolls the page where nothing is dragged', async () => {
    const { page } = await open(browser, `${server.url}#table=pool-9ft`, phone);
    const { x, y } = await middle(page, '#table');
    await swipe(page, { x, y }, 0, -90);
    await page.waitForFunction(() => scrollY > 20);
    await page.close();
  });
});

describe('the picture follows what is dragged without a pause', () => {
  /** Counts the paths that are drawn and differ from the last one. */
  async function count(page, kind) {
    await page.evaluate((kind) => {
      const counts = { drawn: 0 };
      let last = document.querySelector(kind)?.getAttribute('points');
      const look = () => {
        const points = document.querySelector(kind)?.getAttribute('points');
        if (points && points !== last) ++counts.drawn;
        last = points ?? last;
      };
      new MutationObserver(look).observe(document.querySelector('#table'), { childList: true, subtree: true });
      Object.assign(globalThis, { counts });
    }, kind);
    return () => page.evaluate(() => globalThis.counts.drawn);
  }

  /** Moves a grip in circles. @returns the redraws while it moves */
  async function round(page, grip, kind, radius) {
    const { x, y } = await middle(page, `[data-grip="${grip}"].grip`);
    const r = radius * (await pixels(page));
    await page.mouse.move(x, y);
    await page.mouse.down();
    const drawn = await count(page, kind);
    for (let i = 1; i <= moves; ++i) {
      const angle = i / 20;
      await Promise.all([page.mouse.move(x + r * Math.sin(angle), y + r * (1 - Math.cos(angle))), wait(frame)]);
    }
    const redraws = await drawn();
    await page.mouse.up();
    return redraws;
  }

  /** Counts the requests, the most that are open at a time, and those that are cancelled. */
  function watch(page) {
    const seen = { most: 0, open: 0, ended: 0, asked: 0 };
    const is = (request) => request.url().includes('/api/solve?path');
    page.on('request', (request) => {
      if (!is(request)) return;
      ++seen.asked;
      seen.most = Math.max(seen.most, ++seen.open);
    });
    page.on('requestfinished', (request) => is(request) && --seen.open);
    page.on('requestfailed', (request) => is(request) && (--seen.open, ++seen.ended));
    return seen;
  }

  for (const [name, scene, latency] of /** @type {[string, string, number][]} */ ([
    ['three balls', three, 0],
    ['nine balls', nine, 0],
    ['three balls, answers 100 ms late', three, 100],
  ]))
    test(name, async (t) => {
      const { page, complaints } = await open(browser, `${server.url}#${scene}`);
      const late = async (route) => {
        await wait(latency);
        await route.continue().catch(() => {}); // its page may have cancelled it
      };
      if (latency) await page.route('**/api/**', late);
      const seen = watch(page);
      const redraws = await round(page, 'ball', '.path.best', 0.12);
      t.diagnostic(`${redraws} redraws in ${moves} moves, ${seen.asked} questions, ${seen.ended} given up`);
      assert.ok(redraws >= 10, `${redraws} redraws`);
      assert.equal(seen.most, 1);
      assert.equal(seen.ended, 0);
      await answered(page);
      const ball = await page.locator('circle.ball').evaluate((e) => [e.getAttribute('cx'), e.getAttribute('cy')]);
      const best = await page.locator('.path.best').getAttribute('points');
      assert.equal(best.split(' ')[0], ball.join());
      assert.deepEqual(complaints, []);
      await page.close();
    });

  test('the headline stays when all shots are listed, unless a better one was found', async (t) => {
    const { page } = await open(browser, `${server.url}#${three}`);
    await page.evaluate(() => {
      const [title, status] = ['title', 'status'].map((id) => document.getElementById(id));
      const look = () => {
        if (/Looking/.test(status.textContent)) Object.assign(globalThis, { first: title.textContent });
      };
      new MutationObserver(look).observe(status, { childList: true });
    });
    const { x, y } = await middle(page, '[data-grip="ball"].grip');
    await page.mouse.move(x, y);
    await page.mouse.down();
    let [changes, scratches] = [0, 0];
    for (let i = 1; i <= 20; ++i) {
      const before = await page.evaluate(() => document.body.dataset.asked);
      await page.mouse.move(x + 6 * i, y + 25 * Math.sin(i));
      await page.waitForFunction((before) => document.body.dataset.asked !== before, before);
      await answered(page);
      const [first, last] = await page.evaluate(() => [globalThis.first, document.getElementById('title').textContent]);
      changes += Number(first !== last);
      scratches += Number(/SCRATCH/.test(first));
    }
    await page.mouse.up();
    t.diagnostic(`${changes} of 20 headlines changed, ${scratches} began with a scratch`);
    assert.ok(changes <= 2, `${changes} changes`);
    assert.equal(scratches, 0);
    await page.close();
  });

  test('an aim of one’s own, answers 100 ms late', async (t) => {
    const { page } = await open(browser, `${server.url}#table=pool-9ft`);
    await page.route('**/api/**', async (route) => {
      await wait(100);
      await route.continue();
    });
    const redraws = await round(page, 'cushion', '.path.own', 0.1);
    t.diagnostic(`${redraws} redraws in ${moves} moves`);
    assert.ok(redraws >= 10, `${redraws} redraws`);
    await page.close();
  });
});
