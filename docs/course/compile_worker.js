// The compiler in a worker: loads it, compiles a reader's file, links it with the tests or with the
// live page's engine. A message {id, what, ...} is answered by {id, ...}; {told} is progress.
"use strict";
importScripts("npm/xz-decompress.js", "wasi.js", "pack.js", "compiler.js");

const files = new Files(), loaded = new Set();
let compiler = null;

/// \param blob the pack itself, in the one-file edition
async function fetched({name, blob}, told) {
  if (blob) return unpacked(blob.stream(), told);
  const answer = await fetch(name);
  if (!answer.ok) throw new Error(`${name} cannot be loaded (${answer.status})`);
  return unpacked(answer.body, told);
}
async function load_pack(pack, told) {
  if (loaded.has(pack.name)) return;
  add_pack(files, await fetched(pack, told));
  loaded.add(pack.name);
}
const objects = names => names.map(name => `/lib/${name}.o`);

const answers = {
  // \param packs the files to load, {name, size}, the compiler's own first
  async load({packs}) {
    const so_far = packs.map(() => 0);
    const all = packs.reduce((sum, {size}) => sum + size, 0);
    const told = k => count => {
      so_far[k] = count;
      self.postMessage({told: so_far.reduce((sum, one) => sum + one, 0) / all});
    };
    const [program] = await Promise.all([fetched(packs[0], told(0)),
      ...packs.slice(1).map((pack, k) => load_pack(pack, told(k + 1)))]);
    compiler = new Compiler(await WebAssembly.compile(program), files);
    return {};
  },
  // \param link a list of names of objects: `first`, and `maybe` of those that are called
  async build({path, text, packs, header, flags, units, link}) {
    for (const pack of packs) await load_pack(pack);
    files.add(path, new TextEncoder().encode(text));
    const compiled = compiler.compile(path, header, "/mine.o", units ? UNITS : flags);
    if (compiled.status) return {printed: compiled.printed};
    const linked = compiler.link(["/mine.o", ...objects(link.first)], objects(link.maybe),
                                 "/out.wasm");
    if (linked.status) return {printed: linked.printed};
    return {wasm: files.bytes("/out.wasm").slice(), warnings: compiled.printed};
  },
};

self.onmessage = async ({data}) => {
  try {
    self.postMessage({id: data.id, ...await answers[data.what](data)});
  } catch (error) {
    self.postMessage({id: data.id, trouble: String(error.message || error)});
  }
};
