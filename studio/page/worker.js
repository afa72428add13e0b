// The engine's worker: one question at a time, answered as it comes. kempeEngine is Emscripten's; it stands before this.
"use strict";
let engine = null;

self.onmessage = async ({ data }) => {
  try {
    if (data.wasm) {
      let asked = null;
      engine = await kempeEngine({
        wasmBinary: data.wasm,
        onProgress: (share, what) => self.postMessage({ id: asked, progress: { share, what } }),
        print: () => {},
        printErr: () => {},
      });
      engine.FS.ignorePermissions = true;  // one user, who begins with a mask that forbids everything
      engine.asking = (id) => { asked = id; };
      const holds = JSON.parse(engine.ccall("kempe_ask", "string", ["string", "string"], ["check", "{}"])).holds;
      self.postMessage({ ready: true, holds });
      return;
    }
    if (data.question === "memory") return void self.postMessage({ id: data.id, answer: { bytes: engine.HEAPU8.length } });
    engine.asking(data.id);
    const answer = JSON.parse(engine.ccall("kempe_ask", "string", ["string", "string"], [data.question, JSON.stringify(data.argument)]));
    if (answer.files) answer.files = answer.files.map((name) => ({ name, bytes: engine.FS.readFile(`/files/${name}`) }));
    self.postMessage({ id: data.id, answer });
  } catch (fault) {
    self.postMessage({ id: data.id, answer: { error: `the engine stopped: ${fault && fault.message ? fault.message : fault}`, fatal: true } });
  }
};
