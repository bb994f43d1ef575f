// Runs the tests of a module, each in an instance of its own, in a worker of the page and in node.
"use strict";
if (typeof module !== "undefined") Object.assign(globalThis, require("./wasi.js"));

const MOST_PRINTED = 1 << 16;  // of what a test prints is kept [bytes]

/// How a test ends: it failed, or something was thrown, with words.
class Ended extends Error {
  constructor(kind, words) {
    super(words);
    this.kind = kind;
  }
}

class Runner {
  /// \param module of the tests \param files what they may read, such as the reader's file
  constructor(module, files, variables = []) {
    this.module = module;
    this.files = files;
    this.variables = variables;
  }
  /// A fresh instance.
  begin() {
    this.printed = "";
    let instance = null;
    const decoder = new TextDecoder(), memory = () => instance.exports.memory;
    const words = (from, size) =>
      new TextDecoder().decode(new Uint8Array(memory().buffer, from, size).slice());
    const system = wasi(this.files, [], (_, bytes) => {
      if (this.printed.length < MOST_PRINTED) this.printed += decoder.decode(bytes, {stream: true});
    }, memory, this.variables);
    const workbook = {
      fail(from, size) { throw new Ended("failed", words(from, size)); },
      thrown(from, size) { throw new Ended("thrown", words(from, size)); },
      attempt(call, data) {
        const stack = instance.exports.__stack_pointer?.value;
        try {
          instance.exports.wb_call(call, data);
          return 1;
        } catch (error) {
          if (error.kind !== "thrown") throw error;
          if (stack !== undefined) instance.exports.__stack_pointer.value = stack;
          return 0;
        }
      },
    };
    instance = new WebAssembly.Instance(this.module, {wasi_snapshot_preview1: system, workbook});
    instance.exports._initialize();
    this.exports = instance.exports;
  }
  text(pointer) {
    const bytes = new Uint8Array(this.exports.memory.buffer, pointer);
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }
  /// The tests with a tag such as "[1.1]": [{k, name}].
  list(tag) {
    this.begin();
    const found = [];
    for (let k = 0; k < this.exports.wb_count(); ++k)
      if (this.text(this.exports.wb_tag(k)).includes(tag))
        found.push({k, name: this.text(this.exports.wb_name(k))});
    return found;
  }
  /// Runs a test: {ended: "passed", "failed", "thrown", "exit" or "crash", words, printed}.
  run(k) {
    try {
      this.begin();
      this.exports.wb_run(k);
      return {ended: "passed", words: "", printed: this.printed};
    } catch (error) {
      const ended = error.kind || (error instanceof Exit ? "exit" : "crash");
      return {ended, words: String(error.message), printed: this.printed};
    }
  }
}

if (typeof module !== "undefined") module.exports = {Runner, Ended};
