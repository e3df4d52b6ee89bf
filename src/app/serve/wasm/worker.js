// A worker of the page's own engine; what emscripten wrote comes before it, in one text.
/* global bankshotEngine */

let engine;

/** A C string of our own: the stack is too small for a large puzzle. */
function put(text) {
  const size = engine.lengthBytesUTF8(text) + 1;
  const at = engine._malloc(size);
  engine.stringToUTF8(text, at, size);
  return at;
}

function ask({ name, flags, body }) {
  const words = [name, flags, body].map(put);
  const at = engine._bankshot_ask(...words);
  const text = engine.UTF8ToString(at);
  for (const word of [...words, at]) engine._free(word);
  const status = text.slice(0, text.indexOf('\n'));
  return { ok: status === '200', text: text.slice(status.length + 1) };
}

/** The first message brings the compiled engine, each other one a question. */
onmessage = async ({ data }) => {
  engine = data.module
    ? bankshotEngine({
        instantiateWasm: (imports, done) => {
          WebAssembly.instantiate(data.module, imports).then((instance) => done(instance));
          return {};
        },
      })
    : await engine;
  if (!data.module) postMessage(ask(data));
};
