// SPDX-License-Identifier: MIT
//
// One engine in a worker of a browser or of Node. The first message holds the compiled engine, every other a question.
import { instantiate } from './instance.js';
import { builtin } from './builtin.js';

function serve(port) {
  let engine;
  port.onmessage = async ({ data }) => {
    if (data.module) engine = instantiate(data.module);
    else {
      try {
        port.postMessage((await engine)(data));
      } catch (error) {
        port.postMessage({ broken: String(error) });
      }
    }
  };
}

if (typeof postMessage === 'function') serve(globalThis);
else builtin('worker_threads').then(({ parentPort }) => serve(parentPort));
