// Workers with the engine inside, made from the page itself: nothing is asked of a network.
"use strict";
(function (kempe) {
  const bytesOf = (base64) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  let parts = null;

  /** The engine's script and machine code, unpacked once. */
  async function unpacked() {
    const packed = document.getElementById("engine-wasm").textContent.trim();
    const stream = new Blob([bytesOf(packed)]).stream().pipeThrough(new DecompressionStream("gzip"));
    const wasm = await new Response(stream).arrayBuffer();
    const script = document.getElementById("engine-script").textContent;
    return { wasm, url: URL.createObjectURL(new Blob([script], { type: "text/javascript" })) };
  }

  /** One worker. ask() waits in line; stop() ends whatever it does and begins anew. */
  class Engine {
    constructor() {
      this.count = 0;
      this.waiting = new Map();
      this.start();
    }

    start() {
      this.ready = (async () => {
        parts = parts || unpacked();
        const { wasm, url } = await parts;
        const worker = new Worker(url);
        this.worker = worker;
        return new Promise((resolve, reject) => {
          worker.onerror = (event) => reject(new Error(event.message || "the engine does not start"));
          worker.onmessage = ({ data }) => {
            if (!data.ready) return void (data.answer && reject(new Error(data.answer.error)));
            if (!data.holds) return void reject(new Error("Interval arithmetic does not hold in this browser: nothing could be called proven, so the studio does not start."));
            worker.onmessage = ({ data: told }) => this.hear(told);
            resolve(worker);
          };
          worker.postMessage({ wasm });
        });
      })();
      this.ready.catch(() => {});
    }

    hear({ id, answer, progress }) {
      const waiting = this.waiting.get(id);
      if (!waiting) return;
      if (progress) return void (waiting.onProgress && waiting.onProgress(progress));
      this.waiting.delete(id);
      if (answer.fatal) this.stop();
      waiting.resolve(answer);
    }

    get busy() {
      return this.waiting.size > 0;
    }

    /** The answer to a question; {stopped: true} if stop() came first. */
    async ask(question, argument, onProgress) {
      const id = ++this.count;
      return new Promise((resolve, reject) => {
        this.waiting.set(id, { resolve, onProgress });
        this.ready.then((worker) => { if (this.waiting.has(id)) worker.postMessage({ id, question, argument }); }, (fault) => { this.waiting.delete(id); reject(fault); });
      });
    }

    /** For good. */
    end() {
      const { waiting } = this;
      this.waiting = new Map();
      this.ready.then((worker) => worker.terminate(), () => {});
      for (const { resolve } of waiting.values()) resolve({ stopped: true });
    }

    stop() {
      const { waiting, worker } = this;
      this.waiting = new Map();
      if (worker) worker.terminate();
      this.worker = null;
      this.start();
      for (const { resolve } of waiting.values()) resolve({ stopped: true });
    }
  }

  kempe.Engine = Engine;
})((globalThis.kempe = globalThis.kempe || {}));
