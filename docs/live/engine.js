// The engine of a panel, in a worker. What does not answer in time is ended and begun anew: code
// that never ends must not take the page with it.
"use strict";

class Refused extends Error {}  // a sentence of the engine, or about it

class Engine {
  constructor(label, wasm) {
    this.label = label;
    this.bytes = Uint8Array.from(atob(wasm), c => c.charCodeAt(0));
    this.begin();
  }
  // Returns what the module tells of its settings and scenes.
  begin() {
    this.worker?.terminate();
    this.waiting = new Map();
    this.next = 0;
    const code = new Blob([$("worker").textContent], {type: "text/javascript"});
    const address = URL.createObjectURL(code);
    this.worker = new Worker(address);
    this.worker.onmessage = ({data}) => {
      const {resolve, reject, clock} = this.waiting.get(data.id);
      clearTimeout(clock);
      this.waiting.delete(data.id);
      data.refused === undefined ? resolve(data) : reject(new Refused(data.refused));
    };
    return this.about = this.ask("load", {bytes: this.bytes}, 20000);
  }
  // \param patience for the answer [ms]: the solution is known to end, however slow the machine
  ask(what, more = {}, patience = this.label === "the solution" ? 20000 : 3000) {
    return new Promise((resolve, reject) => {
      const id = this.next++;
      const one = {resolve, reject};
      // An answer may lie there and wait while the machine slept: it gets a last chance.
      one.clock = setTimeout(() => {
        one.clock = setTimeout(() => this.give_up(), 200);
      }, patience);
      this.waiting.set(id, one);
      this.worker.postMessage({id, what, ...more});
    });
  }
  give_up() {
    const all = [...this.waiting.values()];
    this.begin();
    for (const {clock, reject} of all) {
      clearTimeout(clock);
      reject(new Refused("no answer for three seconds: the code seems never to end. It was stopped."));
    }
  }
}
