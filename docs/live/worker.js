// The engine in a worker: one module, one run. A message {id, what, ...} is answered by {id, ...} or
// by {id, refused: sentence}; after a sentence the module is a fresh one.
"use strict";

let compiled, module, memory, about, scene;

// The module wants a few functions of the system. What it prints is kept; files it never uses.
let printed = "";
const system = new Proxy({
  fd_write(_, parts, count, written) {
    const view = new DataView(memory.buffer);
    let sum = 0;
    for (let k = 0; k < count; ++k) {
      const [from, size] = [0, 4].map(place => view.getUint32(parts + 8 * k + place, true));
      printed += new TextDecoder().decode(new Uint8Array(memory.buffer, from, size).slice());
      sum += size;
    }
    printed = printed.slice(-500);
    view.setUint32(written, sum, true);
    return 0;
  },
  proc_exit() { throw new Error("the code ended the program"); },
}, {get: (known, name) => known[name] || (() => 0)});

function use(instance) {
  module = instance.exports;
  memory = module.memory;  // it grows: look at its buffer anew each time
}
function begin() {
  use(new WebAssembly.Instance(compiled, {wasi_snapshot_preview1: system, env: system}));
  module._initialize();
}
function text(pointer) {
  const bytes = new Uint8Array(memory.buffer, pointer);
  return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
}
const numbers = count =>
  new Float64Array(memory.buffer, module.wb_numbers(), count).slice();
function give(settings) {  // an object by names; what it does not name is zero
  about.settings.forEach((name, k) => {
    new Float64Array(memory.buffer, module.wb_settings(), k + 1)[k] = settings[name];
  });
}
// A second module tries the settings first, so that a refusal costs nothing of the run.
function try_settings(settings) {
  const running = module;
  try {
    begin();
    give(settings);
    module.wb_make(scene);
  } catch (error) {
    throw Object.assign(error, {sentence: text(module.wb_sentence()), harmless: true});
  } finally {
    use({exports: running});
  }
}
const state = () => {
  module.wb_driven();
  return {driven: JSON.parse(text(module.wb_text())), state: numbers(module.wb_state())};
};

// So many steps; of each of them time, gap and energy.
function steps({count}) {
  const samples = [];
  let used = 0;
  for (let k = 0; k < count; ++k) {
    const start = performance.now();
    module.wb_step(1);
    used += performance.now() - start;
    samples.push(...numbers(module.wb_state()).slice(0, 3));
  }
  return {samples, used, printed, ...state()};
}

const answers = {
  load({bytes}) {
    compiled = new WebAssembly.Module(bytes);
    begin();
    module.wb_about();
    about = JSON.parse(text(module.wb_text()));
    return about;
  },
  make({name, settings}) {
    scene = about.scenes.findIndex(each => each.name === name);
    give(settings);
    module.wb_make(scene);
    return {...JSON.parse(text(module.wb_text())), ...state()};
  },
  set({settings}) {
    try_settings(settings);
    give(settings);
    module.wb_set();
    return state();
  },
  steps,
  // A recording of a run's beginning, for the camera and to compare runs; as far as it comes.
  record({count, every}) {
    const frames = [];
    try {
      for (let k = 0; k <= count; ++k) {
        if (k) module.wb_step(1);
        if (k % every === 0) frames.push(Array.from(numbers(module.wb_state()).slice(3)));
      }
    } catch (error) {
      return {frames, ended: ended(error)};
    }
    return {frames, state: numbers(module.wb_state())};
  },
  // The errors of this code's rows, with the bodies at these poses.
  rows({poses}) {
    const to = module.wb_poses();
    new Float64Array(memory.buffer, to, poses.length).set(poses);
    return {rows: numbers(module.wb_rows())};
  },
  grab({body, point}) { module.wb_grab(body, ...point); return {}; },
  move({point}) { module.wb_move(...point); return {}; },
  let_go() { module.wb_let_go(); return {}; },
  look: ({iterations, blocks}) =>
    ({joints: numbers(module.wb_look(iterations, blocks)), blocks: module.wb_blocks()}),
  errors({most}) {
    const found = Array.from(numbers(module.wb_errors(most)));
    return {rate: found.pop(), errors: found};
  },
};

// What the browser says when a module stops without a sentence, in plain words.
const plainly = [
  [/unreachable/, "the code stopped: an index outside a vector, or a function without its return"],
  [/out of bounds/, "the code reached for memory that is not its own"],
  [/by zero/, "a whole number was divided by zero"],
  [/call stack/, "the code calls itself without end"]];
const in_words = message => plainly.find(([what]) => what.test(message))?.[1] || message;

// The sentence for an error; the module is a fresh one where it may be broken.
function ended(error) {
  const sentence = error.sentence || (module ? text(module.wb_sentence()) : "");
  if (compiled && !error.harmless) begin();
  return sentence || in_words(String(error.message || error));
}

self.onmessage = ({data}) => {
  try {
    self.postMessage({id: data.id, ...answers[data.what](data)});
  } catch (error) {
    self.postMessage({id: data.id, refused: ended(error)});
  }
};
