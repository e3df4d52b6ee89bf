// Makes the page's pictures for the README: node screenshots.mjs FOLDER
import { answered, launch, open, serve } from './browser.mjs';

const folder = process.argv[2];
const server = await serve();
const browser = await launch();
const nine =
  'target=play&skill=0.6&ball=1.2,0.7&others=2.12,0.97,0.62,0.31,1.86,0.29,1.02,0.95,2.31,0.55,0.41,0.98,1.55,1.08,1.72,0.7,0.85,0.62';
const drill =
  'target=pot&object=1&into=top-middle&most=0&skill=0.6&ball=1.5875,0.762&others=1.3018,1.143&zone=0.4762,0.1905,0.15';
const looks = [
  ['page-light', nine, { viewport: { width: 1280, height: 880 }, colorScheme: 'light' }],
  ['page-dark', drill, { viewport: { width: 1280, height: 880 }, colorScheme: 'dark' }],
  ['page-phone', '', { viewport: { width: 390, height: 800 }, colorScheme: 'light', isMobile: true, hasTouch: true }],
];
for (const [name, scene, options] of looks) {
  const { page } = await open(browser, `${server.url}#${scene}`, options);
  await answered(page);
  await page.waitForTimeout(500); // the rest of the cue ball's path
  await page.screenshot({ path: `${folder}/${name}.png` });
  await page.close();
}
await browser.close();
server.end();
