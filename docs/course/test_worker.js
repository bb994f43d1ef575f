// The tests of an exercise in a worker, which the page ends where a test does not.
"use strict";
importScripts("wasi.js", "runner.js");

self.onmessage = ({data: {wasm, path, text, id}}) => {
  try {
    const files = new Files();
    files.add(path, new TextEncoder().encode(text));
    const runner = new Runner(new WebAssembly.Module(wasm), files);
    for (const {k, name} of runner.list(`[${id}]`)) {
      self.postMessage({begun: name});
      const result = {name, ...runner.run(k)};
      self.postMessage({result});
      if (result.ended === "crash" || result.ended === "exit") break;
    }
    self.postMessage({end: true});
  } catch (error) {
    self.postMessage({trouble: String(error.message || error)});
  }
};
