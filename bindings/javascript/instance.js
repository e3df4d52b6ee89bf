// SPDX-License-Identifier: MIT
//
// One WebAssembly engine in this thread, with text as input and output.
// @ts-ignore: emscripten writes it
import bankshotEngine from 'bankshot-engine';

/** @typedef {{name: string, flags: string, body: string}} Question flags: one `name=value` per line */
/** @typedef {{ok: boolean, text: string}} Reply */

/** @param {WebAssembly.Module} module */
function begin(module) {
  return new Promise((done, fail) => {
    const instantiateWasm = (imports, ready) => {
      WebAssembly.instantiate(module, imports).then(ready, fail);
      return {};
    };
    bankshotEngine({ instantiateWasm }).then(done, fail);
  });
}

/**
 * @param {WebAssembly.Module} module
 * @returns {Promise<(question: Question) => Reply>}
 */
export async function instantiate(module) {
  const engine = await begin(module);

  /** Allocates a C string on the heap, because the stack is too small for a large puzzle. */
  const put = (text) => {
    const size = engine.lengthBytesUTF8(text) + 1;
    const at = engine._malloc(size);
    engine.stringToUTF8(text, at, size);
    return at;
  };

  return ({ name, flags, body }) => {
    const words = [name, flags, body].map(put);
    const at = engine._bankshot_ask(...words);
    const text = engine.UTF8ToString(at);
    for (const word of [...words, at]) engine._free(word);
    const status = text.slice(0, text.indexOf('\n'));
    return { ok: status === '200', text: text.slice(status.length + 1) };
  };
}
