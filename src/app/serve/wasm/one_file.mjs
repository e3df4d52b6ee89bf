// SPDX-License-Identifier: MIT
//
// Writes the page and the engine as one file: node one_file.mjs PAGE_FOLDER SCRIPT.js PACKAGE_FOLDER > bankshot.html
// SCRIPT is the page's modules joined into one, since browsers do not load modules from a disk.
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';

const [page, script, engine] = process.argv.slice(2);
const text = (path) => readFileSync(path, 'utf8');
const hash = (code) => `'sha256-${createHash('sha256').update(code).digest('base64')}'`;

/** Replaces a text that must occur exactly once in the page. */
function put(html, old, now) {
  if (html.split(old).length !== 2) throw new Error(`the page has not one ${old}`);
  return html.replace(old, () => now);
}

const code = `\n${text(script)}`.replaceAll('</script', '<\\/script');
const style = text(`${page}/style.css`);
const icon = 'data:image/svg+xml;base64,' + readFileSync(`${page}/icon.svg`).toString('base64');
const own = text(`${engine}/worker.js`).replaceAll('</script', '<\\/script');
const bytes = gzipSync(readFileSync(`${engine}/bankshot.wasm`), {
  level: 9,
}).toString('base64');
const policy = [
  "default-src 'none'",
  `script-src ${hash(code)} 'wasm-unsafe-eval'`,
  `style-src ${hash(style)}`,
  'worker-src blob:',
  'img-src data: blob:',
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

let html = text(`${page}/index.html`);
html = put(
  html,
  '<meta charset="utf-8">',
  `<meta charset="utf-8">\n<meta http-equiv="Content-Security-Policy" content="${policy}">`,
);
html = put(html, '<link rel="icon" href="/icon.svg">', `<link rel="icon" href="${icon}">`);
html = put(html, '<link rel="stylesheet" href="/style.css">', `<style>${style}</style>`);
html = put(html, '<script type="module" src="/main.js"></script>', '');
const parts = [
  `<script type="text/plain" id="engine-worker">${own}</script>`,
  `<script type="text/plain" id="engine-bytes">${bytes}</script>`,
  `<script type="module">${code}</script>`,
];
process.stdout.write(put(html, '</body>', `${parts.join('\n')}\n</body>`));
