// SPDX-License-Identifier: MIT
//
// An engine in a worker. It answers one question at a time; further questions wait in a queue.

/** ms to wait for an answer to an aborted question; then the worker ends, and the next question starts another. */
const patience = 60;

export class Desk {
  #begin;
  #module;
  #worker = null;
  /** @type {Set<AbortController>} one for each unanswered question */
  #asked = new Set();
  #turn = Promise.resolve();
  #fail = null; // rejects the question that the worker is answering

  /**
   * @param {() => Worker} begin
   * @param {WebAssembly.Module} module
   */
  constructor(begin, module) {
    this.#begin = begin;
    this.#module = module;
  }

  /**
   * @param {import('./instance.js').Question} question
   * @param {AbortSignal} [signal]
   * @returns {Promise<import('./instance.js').Reply>}
   */
  ask(question, signal) {
    return new Promise((done, fail) => {
      const stop = new AbortController();
      const leave = () => stop.abort(signal.reason);
      stop.signal.onabort = () => fail(stop.signal.reason);
      if (signal?.aborted) return leave();
      signal?.addEventListener('abort', leave, { once: true });
      this.#asked.add(stop);
      this.#turn = this.#turn
        .then(() => (stop.signal.aborted ? null : this.#put(question, stop.signal)))
        .then(done, fail)
        .finally(() => {
          this.#asked.delete(stop);
          signal?.removeEventListener('abort', leave);
        });
    });
  }

  /** Ends the worker and rejects all open questions; another question starts a new worker. */
  end() {
    const why = new Error('its worker was ended');
    for (const stop of this.#asked) stop.abort(why);
    this.#drop(why);
  }

  #drop(why) {
    this.#worker?.terminate();
    this.#worker = null;
    this.#fail?.(why);
  }

  #start() {
    const worker = this.#begin();
    worker.postMessage({ module: this.#module });
    return worker;
  }

  /** @param {AbortSignal} signal */
  async #put(question, signal) {
    const worker = /** @type {any} */ (this.#worker ??= this.#start());
    let late;
    signal.addEventListener('abort', () => (late = setTimeout(() => this.#drop(signal.reason), patience)));
    worker.ref?.(); // keeps Node alive while the worker is busy
    try {
      return await new Promise((done, fail) => {
        this.#fail = fail;
        worker.onmessage = ({ data }) => (data.broken ? this.#drop(new Error(data.broken)) : done(data));
        worker.onerror = (event) => this.#drop(new Error(event.message ?? 'its worker did not begin'));
        worker.postMessage(question);
      });
    } finally {
      this.#fail = null;
      clearTimeout(late);
      worker.unref?.();
    }
  }
}
