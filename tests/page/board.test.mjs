// Tests what a player does with the board: balls and pockets are clicked, balls come from the tray and leave the table,
// push each other, and move to another table.
import assert from 'node:assert/strict';
import { after, describe, test } from 'node:test';
import { answered, drag, launch, middle, open, scene, serve, text } from './browser.mjs';

const server = await serve();
const browser = await launch();
after(async () => {
  await browser.close();
  server.end();
});

const numbers = (list) => list.split(',').map(Number);

/** Clicks a grip or a pocket of the table. */
async function click(page, selector) {
  const { x, y } = await middle(page, selector);
  await page.mouse.click(x, y);
  await answered(page);
}

const balls = 'ball=0.6,0.5&others=1.7,0.4,2.1,0.95,1.2,1&names=5,7,9';

describe('the board', () => {
  test('opens on a layout, says what to play and what comes next', async () => {
    const { page, complaints } = await open(browser, server.url);
    assert.match(await text(page, 'title'), /^Pot the 3 into /);
    assert.match(await text(page, 'words'), /cue ballstops.*nextthe 5 into .*clears/s);
    assert.equal(await page.locator('.other').count(), 5);
    assert.equal(await page.locator('.spread').count(), 2);
    assert.ok((await page.locator('.path.next').count()) >= 1);
    assert.deepEqual(complaints, []);
    await page.close();
  });

  test('a ball is clicked, then a pocket', async () => {
    const { page } = await open(browser, `${server.url}#target=play&${balls}`);
    await click(page, '[data-grip="other1"].grip');
    assert.deepEqual([(await scene(page)).target, (await scene(page)).object], ['hit', '7']);
    assert.match(await text(page, 'title'), /^(Hit|Kick at) the 7/);
    await click(page, '[data-pocket="top-right"]');
    assert.deepEqual([(await scene(page)).target, (await scene(page)).into], ['pot', 'top-right']);
    assert.match(await text(page, 'title'), /^(Pot|Bank) the 7 .*into top-right/);
    await page.click('#undo');
    await page.click('#undo');
    await answered(page);
    assert.equal((await scene(page)).target, 'play');
    await page.close();
  });

  test('balls come from the tray and leave the table', async () => {
    const { page } = await open(browser, `${server.url}#target=play&${balls}`);
    const from = await page.locator('#tray [data-ball="3"]').boundingBox();
    const table = await page.locator('#table').boundingBox();
    await page.mouse.move(from.x + 10, from.y + 10);
    await page.mouse.down();
    await page.mouse.move(table.x + 0.3 * table.width, table.y + 0.7 * table.height, { steps: 8 });
    await page.mouse.up();
    await answered(page);
    assert.equal((await scene(page)).names, '5,7,9,3');
    const [x, y] = numbers((await scene(page)).others).slice(-2);
    assert.ok(x > 0.6 && x < 0.8 && y > 0.2 && y < 0.5, `${x}, ${y}`);
    await page.click('#tray [data-ball="9"]');
    await answered(page);
    assert.equal((await scene(page)).names, '5,7,3');
    await drag(page, 'other0', 0.2, -3, 20);
    await answered(page);
    assert.equal((await scene(page)).names, '7,3');
    assert.equal(await page.locator('#tray [aria-pressed="true"]').count(), 2);
    await page.close();
  });

  test('a ball pushes others aside, and they come back when it has passed', async () => {
    const { page, complaints } = await open(browser, `${server.url}#target=play&${balls}`);
    await drag(page, 'other0', 0.4, 0.55, 30);
    await answered(page);
    const [ax, ay, bx, by] = numbers((await scene(page)).others);
    assert.ok(Math.hypot(ax - bx, ay - by) > 2 * 0.028575, `${[ax, ay, bx, by]}`);
    await page.click('#undo');
    await answered(page);
    await drag(page, 'other0', 0.75, 0.6, 30);
    await answered(page);
    assert.deepEqual(numbers((await scene(page)).others).slice(2), [2.1, 0.95, 1.2, 1]);
    assert.deepEqual(complaints, []);
    await page.close();
  });

  test('a table changes by diamonds, and back to what was laid', async () => {
    const { page, complaints } = await open(
      browser,
      `${server.url}#target=play&ball=0.5,0.6&others=2.51,1.24,2.45,1.24,2.39,1.24`,
    );
    const before = await scene(page);
    await page.selectOption('#tables', 'pool-7ft');
    await answered(page);
    const at = numbers((await scene(page)).others);
    for (const [i, j] of [
      [0, 2],
      [2, 4],
      [0, 4],
    ])
      assert.ok(Math.hypot(at[i] - at[j], at[i + 1] - at[j + 1]) > 2 * 0.0284, `${at}`);
    await page.selectOption('#tables', 'pool-9ft');
    await answered(page);
    assert.deepEqual(await scene(page), before);
    assert.deepEqual(complaints, []);
    await page.close();
  });

  test('the cue ball is to be left in a zone that is drawn', async () => {
    const { page, complaints } = await open(browser, `${server.url}#target=play&${balls}`);
    await page.click('#zone');
    const { x, y, width, height } = await page.locator('#table').boundingBox();
    await page.mouse.move(x + 0.4 * width, y + 0.6 * height);
    await page.mouse.down();
    await page.mouse.move(x + 0.45 * width, y + 0.65 * height, { steps: 5 });
    await page.mouse.up();
    await answered(page);
    const now = await scene(page);
    assert.equal(now.target, 'pot');
    assert.equal(numbers(now.zone).length, 3);
    assert.match(await text(page, 'words'), /position\d+ %/);
    await page.click('#zone');
    await answered(page);
    assert.equal((await scene(page)).zone, undefined);
    await page.goBack();
    await answered(page);
    await page.selectOption('#targets', 'play');
    await answered(page);
    assert.equal((await scene(page)).zone, undefined);
    assert.match(await text(page, 'other'), /a game plans where the cue ball stops/);
    assert.deepEqual(complaints, []);
    await page.close();
  });

  test('a cue ball in hand is put where the shot is best', async () => {
    const { page, complaints } = await open(browser, `${server.url}#target=play&skill=0.4&${balls}`);
    const chance = async () => Number(/position\D*(\d+)/.exec(await text(page, 'words'))[1]);
    const before = await chance();
    await page.click('#inhand');
    await page.waitForFunction(() => /best\.$/.test(document.getElementById('other').textContent), null, {
      timeout: 20000,
    });
    await answered(page);
    assert.notEqual((await scene(page)).ball, '0.6,0.5');
    assert.ok((await chance()) >= before, `${await chance()} and ${before}`);
    assert.deepEqual(complaints, []);
    await page.close();
  });

  test('the list has one line per ball and pocket, and its other ways below', async () => {
    const { page } = await open(browser, `${server.url}#target=another ball&${balls}`);
    const lines = await page.locator('#shots > li > button').allTextContents();
    const ends = lines.map((line) => /\d+ into [a-z-]+/.exec(line)[0]);
    assert.equal(new Set(ends).size, ends.length, `${ends}`);
    await page.locator('#shots summary').first().click();
    await page.locator('#shots details button').first().waitFor();
    await page.close();
  });

  test('a kick that pots is called one, and its other ways are in order', async () => {
    const { page } = await open(
      browser,
      `${server.url}#ball=1.27,0.63634&target=play&others=1.62,0.98,2.05,0.36,2.2,0.86,1.91745,0.72365&names=3,5,9,7&skill=0.6`,
    );
    await page.evaluate(() => document.querySelectorAll('#shots details').forEach((d) => (d.open = true)));
    await page.locator('#shots details li').first().waitFor();
    const ways = await page.locator('#shots > li').evaluateAll((items) =>
      items.map((item) =>
        [...item.querySelectorAll('details button')].map((b) => ({
          share: Number(/\d+/.exec(b.querySelector('strong').textContent)[0]),
          text: b.querySelector('span').textContent,
        })),
      ),
    );
    for (const all of ways) {
      const shares = all.map(({ share }) => share);
      assert.deepEqual(
        shares,
        [...shares].sort((a, b) => b - a),
      );
      assert.equal(new Set(all.map(({ text }) => text)).size, all.length);
    }
    await page.locator('#shots button', { hasText: 'kicked by' }).first().click();
    assert.match(await text(page, 'title'), /^Kick the 3 by (top|bottom|left|right)/);
    const said = await text(page, 'said');
    assert.ok(said.startsWith(await text(page, 'title')), said);
    await page.close();
  });

  test('a beginner is told another chance than a professional', async () => {
    const { page } = await open(browser, `${server.url}#target=play&skill=1&${balls}`);
    const chance = async () => Number(/success\D*(\d+)/.exec(await text(page, 'words'))[1]);
    const pro = await chance();
    await page.locator('[name=skill]').fill('0');
    await answered(page);
    assert.equal((await scene(page)).skill, '0');
    assert.ok((await chance()) < pro, `${await chance()} and ${pro}`);
    assert.match(await text(page, 'skilled'), /beginner: errs by 0.60°/);
    await page.close();
  });

  test('a number beyond its limits is shown as what is asked, and a bound moves the other', async () => {
    const { page } = await open(browser, `${server.url}#table=pool-9ft`);
    await page.locator('[name=most]').fill('99');
    await page.locator('[name=most]').blur();
    await answered(page);
    assert.equal(await page.locator('[name=most]').inputValue(), '9');
    await page.locator('summary', { hasText: 'Limits' }).click();
    await page.locator('[name=fastest]').fill('2');
    await page.locator('[name=slowest]').fill('5');
    await answered(page);
    assert.equal(await page.locator('[name=fastest]').inputValue(), '5');
    await page.close();
  });

  test('keys move a ball by a centimetre, and many presses are one step to undo', async () => {
    const { page } = await open(browser, `${server.url}#target=play&${balls}`);
    await page.locator('[data-grip="ball"]').focus();
    for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Shift+ArrowUp');
    await page.keyboard.press('Control+z');
    await answered(page);
    assert.equal((await scene(page)).ball, '0.6,0.5');
    await page.close();
  });
});

describe('a stranger', () => {
  test('undoes while the balls roll, clears the table and puts a ball back', async () => {
    const { page, complaints } = await open(browser, `${server.url}#target=play&${balls}`);
    await drag(page, 'ball', 0.1, 0.05);
    await answered(page);
    await page.click('#slow');
    await page.waitForFunction(() => document.body.dataset.playing);
    await page.click('#undo');
    await answered(page);
    await page.click('#clear');
    await answered(page);
    assert.equal(await text(page, 'title'), 'Put a ball on the table');
    await page.click('#tray [data-ball="4"]');
    await answered(page);
    assert.equal((await scene(page)).target, 'play');
    assert.match(await text(page, 'title'), /the 4/);
    assert.deepEqual(complaints, []);
    await page.close();
  });

  test('goes on from where the balls stop', async () => {
    const { page, complaints } = await open(browser, server.url);
    const [, x, y] = /stops (\d+) cm.*?, (\d+) cm/.exec(await text(page, 'words')).map(Number);
    await page.click('#further');
    await page.waitForFunction(() => location.hash.includes('names=5,6,8,9'));
    await answered(page);
    assert.match(await text(page, 'title'), /the 5 /);
    const [cx, cy] = numbers((await scene(page)).ball);
    assert.ok(Math.abs(Math.min(cx, 2.54 - cx) - x / 100) < 0.02 && Math.abs(Math.min(cy, 1.27 - cy) - y / 100) < 0.02);
    assert.deepEqual(complaints, []);
    await page.close();
  });

  test('changes to a snooker table and to a carom table, and comes back to the question', async () => {
    const { page, complaints } = await open(browser, `${server.url}#target=play&${balls}`);
    const before = await scene(page);
    await page.selectOption('#tables', 'snooker-12ft');
    await answered(page);
    assert.equal((await scene(page)).names, 'red1,red2,red3');
    const rotation = page.locator('[name=game] option[value=rotation]');
    assert.ok(await rotation.evaluate((/** @type {HTMLOptionElement} */ option) => option.disabled));
    await page.selectOption('#tables', 'carom-10ft');
    await answered(page);
    assert.equal((await scene(page)).target, 'point');
    await page.selectOption('#tables', 'pool-9ft');
    await answered(page);
    assert.deepEqual(await scene(page), before);
    assert.deepEqual(complaints, []);
    await page.close();
  });

  test('reads on a phone the names of the rails as they are seen', async () => {
    const phone = { viewport: { width: 390, height: 800 }, hasTouch: true, isMobile: true };
    const { page } = await open(browser, `${server.url}#target=pot&object=5&into=top-right&most=0&${balls}`, phone);
    assert.match(await text(page, 'title'), /into top-left$/);
    const [ball, hole] = [
      await middle(page, '[data-grip="other0"].grip'),
      await middle(page, '[data-pocket="top-right"]'),
    ];
    assert.ok(hole.x < ball.x && hole.y < ball.y);
    await page.close();
  });
});

test('every control has a name, and every ball a place', async () => {
  const { page } = await open(browser, server.url);
  await page.evaluate(() => document.querySelectorAll('details').forEach((d) => (d.open = true)));
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll('input, select, button, [role=button]')]
      .filter((e) => {
        const label = /** @type {HTMLInputElement} */ (e).labels?.[0]?.textContent;
        return !(e.getAttribute('aria-label') || label || e.textContent || '').trim();
      })
      .map((e) => e.outerHTML.slice(0, 100)),
  );
  assert.deepEqual(nameless, []);
  const labels = await page
    .locator('[data-grip^="other"], [data-grip="ball"]')
    .evaluateAll((all) => all.map((e) => e.ariaLabel));
  for (const label of labels) assert.match(label, / at \d/);
  await page.close();
});
