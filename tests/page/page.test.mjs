// Tests the page as a person uses it, from the server and from a file.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, describe, test } from 'node:test';
import { answered, drag, launch, open, program, scene, serve, text, ways } from './browser.mjs';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const server = await serve();
const browser = await launch();
after(async () => {
  await browser.close();
  server.end();
});

const shots = (page) => page.locator('#shots button').count();
/** The address of the first scene; without an address the page opens on a layout. */
const first = '#table=pool-9ft';

for (const { name, url } of await ways(server))
  describe(`the page of ${name}`, () => {
    let page;
    let complaints;
    before(async () => ({ page, complaints } = await open(browser, url + first)));
    after(async () => {
      assert.deepEqual(complaints, []);
      await page.close();
    });

    test('lists shots, the best drawn boldest', async () => {
      assert.ok((await shots(page)) >= 3);
      assert.match(await text(page, 'title'), /^Into top-right/);
      assert.equal(await page.locator('.path.best').count(), 1);
    });

    test('draws no ring around what a mouse has touched', async () => {
      await drag(page, 'ball', 0.1, 0);
      await answered(page);
      assert.equal(await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle), 'none');
      await page.click('#undo');
      await answered(page);
    });

    test('offers the cushion laws of the engine, the default chosen', async () => {
      const laws = page.locator('select[name=cushion]');
      const known = JSON.parse(execFileSync(program, ['schema', 'shot'], { encoding: 'utf8' })).$defs.cushion
        .properties;
      assert.deepEqual(await laws.locator('option').allTextContents(), known.model.enum);
      assert.equal(await laws.inputValue(), known.model.default);
    });

    test('what is only looked at is not what is played', async () => {
      const best = await text(page, 'title');
      await page.hover('#shots button >> nth=1');
      await page.hover('#title');
      assert.equal(await text(page, 'title'), best);
    });

    test('a ball that is dragged while it rolls stands where it was put', async () => {
      await page.click('#slow');
      await page.waitForFunction(() => document.body.dataset.playing);
      await drag(page, 'ball', 0.1, 0.1);
      await answered(page);
      const at = await page.locator('circle.ball').evaluate((e) => [e.getAttribute('cx'), e.getAttribute('cy')]);
      assert.equal(at.join(), (await scene(page)).ball);
      await page.click('#undo');
      await answered(page);
    });

    test('a table takes balls until it is full', async () => {
      const own = await open(
        browser,
        `${url}#others=${Array.from({ length: 60 }, (_, i) => [0.1 + 0.1 * (i % 20), 0.8 + 0.1 * Math.floor(i / 20)]).join()}`,
      );
      await own.page.click('#add');
      await answered(own.page);
      assert.equal(await own.page.locator('.other').count(), 61);
      await own.page.close();
    });

    test('answers while the ball is dragged, and undoes that in one step', async () => {
      const [before, title] = [await page.url(), await text(page, 'words')];
      await drag(page, 'ball', 0.4, 0.2);
      await answered(page);
      assert.notEqual((await scene(page)).ball, undefined);
      assert.notEqual(await text(page, 'words'), title);
      await page.click('#undo');
      await answered(page);
      assert.equal(await page.url(), before);
      assert.equal(await text(page, 'words'), title);
      await page.click('#redo');
      await answered(page);
      assert.notEqual((await scene(page)).ball, undefined);
      await page.click('#undo');
      await answered(page);
    });

    test('plays a shot that ends where the answer says', async () => {
      await page.click('#shots button >> nth=1');
      await page.waitForFunction(() => document.body.dataset.played, null, { timeout: 15000 });
      const played = await page.evaluate(() => document.body.dataset.played.split(' ')[0].split(',').map(Number));
      const best = await page.locator('.path.best').getAttribute('points');
      const end = best.trim().split(' ').pop().split(',').map(Number);
      assert.ok(Math.hypot(played[0] - end[0], played[1] - end[1]) < 0.15, `${played} is not at ${end}`);
    });

    test('takes the target to another pocket and to a place', async () => {
      await drag(page, 'target', -1.27, 0, 30);
      await answered(page);
      assert.equal((await scene(page)).target, 'top-middle');
      await drag(page, 'target', 0.2, -0.6);
      await answered(page);
      assert.equal((await scene(page)).target, 'point');
      await page.click('#undo');
      await page.click('#undo');
      await answered(page);
      assert.equal((await scene(page)).target, undefined);
    });

    test('cushions are clicked in order', async () => {
      await page.locator('[data-cushion="bottom"]').click({ position: { x: 60, y: 20 } });
      await page.locator('[data-cushion="right"]').click();
      await answered(page);
      assert.equal((await scene(page)).order, 'bottom,right');
      for (const line of await page.locator('#shots > li > button span').allTextContents())
        assert.match(line, /^bottom, right/);
      await page.click('#unordered');
      await answered(page);
      assert.equal((await scene(page)).order, undefined);
    });

    test('another physics gives another answer, and says why there is none', async () => {
      const spin = await text(page, 'words');
      await page.locator('summary', { hasText: 'Physics' }).click();
      await page.selectOption('[name=physics]', 'rolling');
      await answered(page);
      assert.notEqual(await text(page, 'words'), spin);
      await page.locator('summary', { hasText: 'Limits' }).click();
      await page.locator('[name=fastest]').fill('0.3');
      await answered(page);
      assert.equal(await text(page, 'title'), 'No shot');
      assert.ok((await text(page, 'status')).length > 20);
      await page.click('#undo');
      await page.click('#undo');
      await answered(page);
      assert.equal(await text(page, 'words'), spin);
    });

    test('balls are added, named and removed; all of the list is asked for', async () => {
      for (let i = 0; i < 3; ++i) await page.click('#add');
      await page.selectOption('[name=target]', 'another ball');
      await answered(page);
      assert.equal(await page.locator('.other').count(), 3);
      assert.match((await page.locator('#shots > li > button').allTextContents()).join(), /[123] into /);
      for (let i = 0; i < 4; ++i) await page.click('#undo');
      await answered(page);
      assert.equal(await page.locator('.other').count(), 0);
    });

    test('an aim of one’s own is followed, and the mirror image misses', async () => {
      await drag(page, 'cushion', 0.06, 0.06);
      await page.waitForFunction(() => /^Your aim/.test(document.getElementById('other').textContent));
      assert.equal(await page.locator('.path.own').count(), 1);
      await page.locator('summary', { hasText: 'Look closer' }).click();
      await page.check('#mirror');
      await page.waitForFunction(() => /mirror image/.test(document.getElementById('other').textContent));
      assert.equal(await page.locator('.path.mirror').count(), 2);
      await page.uncheck('#mirror');
    });

    test('another physics stands beside, with its answer and where each one’s leads', async () => {
      await page.selectOption('#compare', 'rolling');
      await page.waitForSelector('#sides figure >> nth=1');
      const [here, there] = await page.locator('#sides figure').allTextContents();
      assert.match(here, /If spin is right.*spin says.*: into top-right.*rolling says/s);
      assert.match(there, /If rolling is right.*rolling says.*: into top-right.*spin says/s);
      assert.equal(await page.locator('#sides .path.best').count(), 2);
      assert.equal(await page.locator('#sides .path.compare').count(), 2);
      await page.selectOption('#compare', '');
      assert.equal(await page.locator('#sides figure').count(), 0);
    });

    test('pockets have their jaws, and a carom table none', async () => {
      assert.equal(await page.locator('#table path.cloth').count(), 6);
      const own = await open(browser, `${url}#table=carom-10ft&target=point`);
      assert.equal(await own.page.locator('#table path.cloth, #table .pocket').count(), 0);
      await own.page.close();
    });

    test('says why it is sure, and from where it can be played', async () => {
      await page.locator('summary', { hasText: 'Why' }).click();
      await page.waitForFunction(() => {
        const empty = document.createElement('canvas');
        Object.assign(empty, { width: 320, height: 200 });
        return document.getElementById('heat').toDataURL().length > empty.toDataURL().length + 1000;
      });
      await page.click('#starts');
      await page.waitForSelector('rect.start', { timeout: 15000, state: 'attached' });
      assert.match(await text(page, 'other'), /can be played from \d+ of/);
    });

    test('the address brings the scene back', async () => {
      await page.selectOption('#gallery', { label: 'What should I play?' });
      await answered(page);
      const [address, words] = [await page.url(), await text(page, 'words')];
      const again = await open(browser, address);
      assert.equal(await text(again.page, 'words'), words);
      assert.equal(await again.page.locator('.other').count(), 3);
      assert.deepEqual(again.complaints, []);
      await again.page.close();
      const odd = await open(browser, `${url}#ball=here&table=no-table&future=1&others=1,2,3&most=two`);
      assert.ok((await shots(odd.page)) >= 3);
      await odd.page.close();
    });

    test('is used by keyboard alone', async () => {
      const own = await open(browser, url + first);
      const reached = new Set();
      for (let i = 0; i < 160; ++i) {
        await own.page.keyboard.press('Tab');
        reached.add(
          await own.page.evaluate(() => {
            const e = document.activeElement;
            return e.id || e.getAttribute('name') || e.dataset.grip || e.dataset.cushion || e.ariaLabel || e.tagName;
          }),
        );
      }
      for (const what of ['gallery', 'ball', 'target', 'cushion', 'top', 'left', 'play', 'tables'])
        assert.ok(reached.has(what), `${what} is not among ${[...reached]}`);
      for (const control of await own.page.locator('#controls fieldset [name]:visible').all())
        assert.ok(reached.has((await control.getAttribute('id')) ?? (await control.getAttribute('name'))));
      await own.page.locator('[data-grip="ball"]').focus();
      await own.page.keyboard.press('ArrowRight');
      await answered(own.page);
      assert.equal((await scene(own.page)).ball, '0.645,0.4');
      await own.page.locator('[data-cushion="left"]').focus();
      await own.page.keyboard.press('Enter');
      await answered(own.page);
      await own.page.keyboard.press('Enter'); // still focused
      await answered(own.page);
      assert.equal((await scene(own.page)).order, 'left,left');
      await own.page.locator('#tip [role="button"]').focus();
      await own.page.keyboard.press('ArrowUp');
      await answered(own.page);
      assert.equal((await scene(own.page)).top, '0.1');
      for (let i = 0; i < 4; ++i) {
        await own.page.keyboard.press('Control+z');
        await answered(own.page);
      }
      assert.deepEqual(await scene(own.page), { table: 'pool-9ft' });
      assert.ok(await own.page.isDisabled('#undo'));
      await own.page.locator('[name="most"]').fill('3');
      await answered(own.page);
      await own.page.locator('[name="most"]').blur();
      await own.page.click('#undo');
      await answered(own.page);
      assert.deepEqual(await scene(own.page), { table: 'pool-9ft' });
      assert.deepEqual(own.complaints, []);
      await own.page.close();
    });

    for (const colorScheme of ['light', 'dark'])
      test(`has no serious fault for those who see or move otherwise, ${colorScheme}`, async () => {
        const own = await open(browser, url, { colorScheme, bypassCSP: true });
        await own.page.evaluate(() => document.querySelectorAll('details').forEach((d) => (d.open = true)));
        await own.page.evaluate(axe);
        const { violations } = await own.page.evaluate(() => globalThis.axe.run());
        const serious = violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
        const words = serious.map(({ id, nodes }) => `${id}: ${nodes.map((n) => n.html.slice(0, 120)).join(' | ')}`);
        assert.deepEqual(words, []);
        await own.page.close();
      });

    test('fits a phone', async () => {
      const own = await open(browser, url, { viewport: { width: 390, height: 800 }, hasTouch: true, isMobile: true });
      const wide = await own.page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= 390, `${wide} px wide`);
      const small = await own.page.evaluate(() =>
        [...document.querySelectorAll('.grip:not([hidden])')].map((e) => e.getBoundingClientRect().width),
      );
      for (const size of small) assert.ok(size >= 14, `a grip of ${size} px`);
      await own.page.evaluate(() => (location.hash = 'target=point&least=0&most=0&others=1.2,0.623'));
      await own.page.waitForSelector('.note');
      const high = await own.page.evaluate(() =>
        ['.note', '.digit'].map((text) => document.querySelector(text).getBoundingClientRect().height),
      );
      for (const size of high) assert.ok(size >= 11, `letters of ${size} px`);
      await own.page.close();
    });
  });
