// Compiler and tests as the page calls them, each in a worker of its own.
import * as where from "./where.js";

const PATIENCE = 2000;  // with a test [ms]: on a slow machine the longest takes one second
const START = 10000;    // with the start of a worker [ms]
export const manifest = JSON.parse(await where.text("course/manifest.json"));

class Compilation {
  constructor() {
    this.waiting = new Map();
    this.next = 0;
    this.worker = where.worker("compile_worker.js");
    this.worker.onmessage = ({data}) => {
      if (data.told !== undefined) return this.told?.(data.told);
      const {resolve, reject} = this.waiting.get(data.id);
      this.waiting.delete(data.id);
      data.trouble === undefined ? resolve(data) : reject(new Error(data.trouble));
    };
  }
  ask(what, more = {}) {
    return new Promise((resolve, reject) => {
      const id = this.next++;
      this.waiting.set(id, {resolve, reject});
      this.worker.postMessage({id, what, ...more});
    });
  }
}
let compilation = null, loading = null;

const packs_of = chapter => ["compiler.xz", "common.xz", "header.xz", `${chapter.folder}.xz`];
const packed = names => Promise.all(names.map(async name =>
  ({...await where.pack(name), size: manifest.sizes[name]})));
const size_of = names => names.reduce((sum, name) => sum + manifest.sizes[name], 0);
/// How much the compiler weighs, packed [bytes].
export const weight = chapter => size_of(packs_of(chapter));
export const is_loaded = () => Boolean(compilation?.ready);

/// Loads the compiler and what a chapter needs, once. \param told called with 0 to 1
export function load(chapter, told) {
  compilation ||= new Compilation();
  compilation.told = told;
  loading ||= packed(packs_of(chapter)).then(packs => compilation.ask("load", {packs})).then(
    () => { compilation.ready = true; }, error => {
      compilation.worker.terminate();
      compilation = loading = null;
      throw error;
    });
  return loading;
}

const others = chapter =>
  manifest.chapters.map(({folder}) => folder).filter(folder => folder !== chapter.folder);
const build = async (chapter, text, {pack, ...more}) =>
  compilation.ask("build", {path: chapter.path, text, header: "/course.pch", flags: [], ...more,
                            packs: await packed([pack])});

/// The module of a chapter's tests with a file: {wasm} or {printed} by the compiler.
export const build_tests = (chapter, text) => build(chapter, text, {
  pack: `${chapter.folder}.xz`,
  link: {first: [`tests_${chapter.folder}`, `where_${chapter.folder}`,
                 `mistakes_${chapter.folder}`, "checker", "module"],
         maybe: ["engine", "given", ...others(chapter)]}});

/// The same with units: its numbers carry kilograms, metres and seconds.
export const build_units = (chapter, text) => build(chapter, text, {
  pack: "units.xz", header: "/units.pch", units: true,
  link: {first: [`units_${chapter.folder}`, "module"],
         maybe: ["units_engine", ...others(chapter).map(folder => `units_of_${folder}`)]}});

/// The module of the live page with a file.
export const build_live = (chapter, text) => build(chapter, text, {
  pack: "live.xz", flags: ["-O1"],
  link: {first: ["exports", "run", "scenes", "thrown", "bench"],
         maybe: ["engine", "given", ...others(chapter)]}});

/// Runs the tests of an exercise: the results of those that ran. One that does not end is ended.
export function run_tests(wasm, chapter, text, id) {
  return new Promise((resolve, reject) => {
    const worker = where.worker("test_worker.js"), results = [];
    let name = "", clock = 0;
    const wait = (patience, then) => {
      clearTimeout(clock);
      clock = setTimeout(then, patience);
    };
    const end = then => {
      clearTimeout(clock);
      worker.terminate();
      then();
    };
    // A result may lie there and wait while the page slept: it gets a last chance.
    const give_up = () => wait(200, () => end(() =>
      resolve([...results, {name, ended: "endless", words: "", printed: ""}])));
    wait(START, give_up);
    worker.onerror = event => end(() => reject(new Error(event.message)));
    worker.onmessage = ({data}) => {
      if (data.begun !== undefined) name = data.begun;
      if (data.result) results.push(data.result);
      if (data.trouble) return end(() => reject(new Error(data.trouble)));
      if (data.end) return end(() => resolve(results));
      wait(PATIENCE, give_up);
    };
    worker.postMessage({wasm, path: chapter.path, text, id});
  });
}
