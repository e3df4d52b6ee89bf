// Tests what a player keeps, shares, opens and practises, and a page whose engine is lost.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { after, describe, test } from 'node:test';
import { answered, drag, launch, open, program, scene, serve, text } from './browser.mjs';

const server = await serve();
const browser = await launch();
after(async () => {
  await browser.close();
  server.end();
});

const numbers = (list) => list.split(',').map(Number);

const balls = 'ball=0.6,0.5&others=1.7,0.4,2.1,0.95,1.2,1&names=5,7,9';

describe('a layout is kept and shared', () => {
  test('the file that is saved is one that solve reads, and the page opens it again', async () => {
    const { page, complaints } = await open(browser, `${server.url}#target=pot&object=7&into=any&skill=0.4&${balls}`);
    await page.locator('summary', { hasText: 'Keep and share' }).click();
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#json')]);
    const path = `${tmpdir()}/bankshot-page-${process.pid}.json`;
    await download.saveAs(path);
    assert.match(execFileSync(program, ['solve', path], { encoding: 'utf8' }), /^solved/);
    const before = await scene(page);
    await page.selectOption('#gallery', { label: 'L drill' });
    await answered(page);
    await page.locator('#file').setInputFiles(path);
    await page.waitForFunction(() => location.hash.includes('object=7'));
    await answered(page);
    assert.deepEqual(await scene(page), before);
    assert.deepEqual(complaints, []);
    await page.close();
  });

  test('of a file that was edited, what it says now is shown', async () => {
    const { page } = await open(browser, `${server.url}#target=play&skill=0.4&${balls}`);
    await page.locator('summary', { hasText: 'Keep and share' }).click();
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#json')]);
    const path = `${tmpdir()}/bankshot-page-${process.pid}.json`;
    await download.saveAs(path);
    const puzzle = JSON.parse(readFileSync(path, 'utf8'));
    puzzle.ball.at = [0.9, 0.3];
    puzzle.others[1].at = [9, 0.95];
    writeFileSync(path, JSON.stringify(puzzle));
    await page.locator('#file').setInputFiles(path);
    await page.waitForFunction(() => location.hash.includes('0.9,0.3'));
    assert.match(await text(page, 'other'), /^No ball can stand where the file has the 7: moved\.$/);
    const now = await scene(page);
    assert.equal(now.skill, '0.4');
    assert.ok(numbers(now.others)[2] < 2.54);
    await page.close();
  });

  test('every puzzle of the examples is opened, or the page says why not', async () => {
    const { page } = await open(browser, server.url);
    const folder = new URL('../../examples/puzzles/', import.meta.url);
    for (const name of [
      'first-shot',
      'nine-ball-end-game',
      'bank-shot',
      'too-soft',
      'masse',
      'kick',
      'three-cushion-carom',
    ]) {
      const puzzle = readFileSync(new URL(`${name}.json`, folder), 'utf8');
      const path = `${tmpdir()}/bankshot-page-${process.pid}.json`;
      writeFileSync(path, puzzle);
      const before = await page.evaluate(() => document.body.dataset.asked);
      await page.locator('#file').setInputFiles(path);
      await page.waitForFunction(
        (before) =>
          document.body.dataset.asked !== before ||
          /not opened|does not show/.test(document.getElementById('other').textContent),
        before,
      );
      const said = await text(page, 'other');
      if (/not opened/.test(said)) continue;
      if (name === 'bank-shot') assert.match(said, /order of the object ball/);
      await answered(page);
      const at = JSON.parse(puzzle).ball.at[0] * (JSON.parse(puzzle).unit === 'diamond' ? 0.3175 : 1);
      if (JSON.parse(puzzle).table === 'pool-9ft')
        assert.ok(Math.abs(numbers((await scene(page)).ball ?? '0.635,0.4')[0] - at) < 1e-3, `${name}: ${said}`);
    }
    await page.close();
  });

  test('a name brings a layout back, and Back the one before', async () => {
    const { page } = await open(browser, `${server.url}#target=play&${balls}`);
    await page.locator('summary', { hasText: 'Keep and share' }).click();
    await page.fill('#name', 'league night');
    await page.click('#keep');
    const before = await scene(page);
    await drag(page, 'ball', 0.3, 0.1);
    await answered(page);
    assert.notDeepEqual(await scene(page), before);
    await page.goBack();
    await answered(page);
    assert.deepEqual(await scene(page), before);
    await page.goForward();
    await answered(page);
    assert.notDeepEqual(await scene(page), before);
    await page.selectOption('#kept', 'league night');
    await answered(page);
    assert.deepEqual(await scene(page), before);
    await page.click('#shots button >> nth=1');
    const chosen = await text(page, 'title');
    await page.fill('#name', 'league night');
    await page.click('#keep');
    assert.match(await text(page, 'other'), /^Kept as “league night”, in place of the one before\.$/);
    await page.reload();
    await answered(page);
    assert.equal(await page.locator('#kept option').count(), 2);
    await page.click('#clear');
    await page.locator('summary', { hasText: 'Keep and share' }).click();
    await page.selectOption('#kept', 'league night');
    await answered(page);
    assert.equal(await text(page, 'title'), chosen);
    page.once('dialog', (dialog) => dialog.accept());
    await page.click('#forget');
    assert.equal(await page.locator('#kept option').count(), 1);
    await page.close();
  });

  test('the chosen shot stays when the table turns', async () => {
    const { page } = await open(browser, `${server.url}#target=another ball&${balls}`);
    await page.click('#shots button >> nth=1');
    const [title, address] = [await text(page, 'title'), page.url()];
    await page.setViewportSize({ width: 600, height: 900 });
    // A table that stands on its end has other names for its pockets.
    const turned = (is) =>
      page.waitForFunction(
        (is) =>
          document.getElementById('table').dataset.turned === is &&
          document.querySelector('#shots [data-shot="1"][aria-current=true]') !== null,
        is,
      );
    await turned('true');
    assert.equal(page.url(), address);
    await page.setViewportSize({ width: 1300, height: 1000 });
    await turned('');
    assert.equal(await text(page, 'title'), title);
    assert.equal(page.url(), address);
    await page.close();
  });

  test('a link holds the shot that was chosen', async () => {
    const { page } = await open(browser, `${server.url}#target=another ball&${balls}`);
    await page.click('#shots button >> nth=2');
    const [address, title] = [page.url(), await text(page, 'title')];
    assert.match(address, /&shot=/);
    const again = await open(browser, address);
    assert.equal(await text(again.page, 'title'), title);
    await again.page.close();
    await page.close();
  });
});

test('a drill is printed with its name, its answer and a place for the score, without controls', async () => {
  const { page } = await open(browser, server.url);
  await page.selectOption('#gallery', { label: 'Wagon wheel' });
  await answered(page);
  await page.emulateMedia({ media: 'print' });
  assert.match(await text(page, 'sheet'), /^Wagon wheel\. Made: _+ of 10/);
  for (const id of ['sheet', 'table', 'title', 'words']) assert.ok(await page.isVisible('#' + id), id);
  for (const id of ['controls', 'tray', 'playing', 'skilled']) assert.ok(await page.isHidden('#' + id), id);
  await page.close();
});

describe('practice', () => {
  test('today’s puzzle is guessed, counted and then shown', async () => {
    const { page, complaints } = await open(browser, server.url);
    await page.locator('summary', { hasText: 'Practice' }).click();
    await page.click('#daily');
    await page.waitForSelector('#guess:not([hidden])');
    await answered(page);
    assert.ok(await page.isHidden('#told'));
    assert.equal(await page.locator('.path.best').count(), 0);
    assert.ok((await text(page, 'task')).length > 10);
    await drag(page, 'cushion', 0, 0.05);
    await page.click('#shoot');
    await page.waitForFunction(() => /Made|Missed/.test(document.getElementById('other').textContent), null, {
      timeout: 20000,
    });
    assert.ok(await page.isVisible('#told'));
    assert.match(await page.locator('#record').textContent(), /of 1 made/);
    await page.click('#again');
    assert.ok(await page.isHidden('#told'));
    await page.selectOption('#gallery', { label: 'L drill' });
    await answered(page);
    assert.ok(await page.isVisible('#told'));
    assert.deepEqual(complaints, []);
    await page.close();
  });

  test('drills of each kind have a shot', async () => {
    const { page, complaints } = await open(browser, server.url);
    await page.locator('summary', { hasText: 'Practice' }).click();
    for (const kind of ['pot', 'bank', 'kick', 'pocket']) {
      const before = await page.evaluate(() => document.body.dataset.asked);
      await page.selectOption('#kind', kind);
      await page.click('#drill');
      await page.waitForFunction((before) => document.body.dataset.asked !== before, before, { timeout: 20000 });
      await answered(page);
      const asks = { pot: /^(Pot|Play)/, bank: /^Bank/, kick: /^Kick/, pocket: /^Into/ };
      assert.match(await text(page, 'title'), asks[kind]);
    }
    assert.deepEqual(complaints, []);
    await page.close();
  });
});

describe('an engine that is lost', () => {
  test('is said once, asked again, and nothing is lost', async () => {
    const { page } = await open(browser, `${server.url}#target=play&${balls}`);
    const title = await text(page, 'title');
    await page.route('**/api/**', (route) => route.abort());
    await drag(page, 'ball', 0.02, 0);
    await page.waitForSelector('body[data-lost]');
    assert.match(await text(page, 'status'), /does not answer/);
    assert.equal(await text(page, 'title'), title);
    assert.equal(await page.locator('.path.best').count(), 1);
    await page.unroute('**/api/**');
    await answered(page);
    assert.equal(await page.locator('body[data-lost]').count(), 0);
    assert.equal((await scene(page)).ball, '0.62,0.5');
    await page.close();
  });
});

test('?embed shows the table alone, in a frame of another page', async () => {
  const page = await browser.newPage();
  const complaints = [];
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  await page.setContent(`<iframe width="900" height="700" src="${server.url}?embed#target=play&${balls}"></iframe>`);
  const frame = page.frameLocator('iframe');
  await frame.locator('.path.best').waitFor({ state: 'attached' });
  for (const id of ['controls', 'tray']) assert.ok(await frame.locator('#' + id).isHidden());
  assert.ok(await frame.locator('#title').isVisible());
  assert.deepEqual(complaints, []);
  await page.close();
});
