// Makes the page's pictures for the README: node screenshots.mjs FOLDER
import { answered, launch, open, serve } from './browser.mjs';

const folder = process.argv[2];
const server = await serve();
const browser = await launch();
const scene = 'ball=0.62,0.5&target=another ball&most=2&others=1.72,0.42,2.1,0.95,1.25,1';
const looks = [
  ['page-light', { viewport: { width: 1280, height: 880 }, colorScheme: 'light' }],
  ['page-dark', { viewport: { width: 1280, height: 880 }, colorScheme: 'dark' }],
  ['page-phone', { viewport: { width: 390, height: 800 }, colorScheme: 'light', isMobile: true }],
];
for (const [name, options] of looks) {
  const { page } = await open(browser, `${server.url}#${name === 'page-dark' ? 'least=1&most=3' : scene}`, options);
  if (name === 'page-dark') {
    await page.locator('summary', { hasText: 'Why' }).click();
    await page.waitForTimeout(1500);
  }
  await answered(page);
  await page.screenshot({ path: `${folder}/${name}.png` });
  await page.close();
}
await browser.close();
server.end();
