// The course in a page: editors where the text says that an exercise can be done, and what the
// tests say of them. Without the compiler, which only a button loads, the page is the site's.
import * as engine from "./engine.js";
import * as store from "./store.js";
import {live_frame} from "./scene.js";
import {element, offer_file, unkept} from "./file.js";
import {keep_offline, text as text_of, where_in_page} from "./where.js";

const {make_editor} = await import("./editor.js").catch(() => import("./plain_editor.js"));
const places = [...document.querySelectorAll(".exercise[data-exercise]")];
const number = document.querySelector("[data-chapter]")?.dataset.chapter;
const chapter = JSON.parse(await text_of(`course/chapter_${number}.json`));

const stub = answers_in(chapter.stub), names = Object.keys(stub);
const answers = {...stub, ...store.kept(names)};  // of every region, as it stands in its editor
let undo = null;                                  // the button beside what can be undone
const editors = {};                               // by the regions' names
const file = () => filled(chapter.stub, answers);

const same = (one, other) => JSON.stringify(one) === JSON.stringify(other);
const POSES = / \((?:pencil and paper|upright|turned|moved|broken)[^)]*\)$/;
const button = (words, does, more = {}) =>
  element("button", {type: "button", textContent: words, onclick: does, ...more});

// ---- an exercise --------------------------------------------------------------------------------

/// The lines around a region, from the last empty line to the marker and the closing brace.
function around(region) {
  const lines = chapter.stub.split("\n");
  let head = region.begin - 1;
  while (head > 0 && lines[head - 1].trim()) --head;
  const tail = lines[region.end + 1] === "}" ? "}" : "";
  return [lines.slice(head, region.begin - 1).join("\n"), tail];
}

function calls() {  // the table of what an exercise may call, from the text
  const before = [...document.querySelectorAll(".textblock p")]
    .find(p => /You may call:$/.test(p.textContent.trim()));
  const table = before?.nextElementSibling;
  if (table?.tagName !== "TABLE") return "";
  return element("details", {className: "calls"},
                 element("summary", {textContent: "What you may call"}), table.cloneNode(true));
}

class Exercise {
  constructor(place) {
    this.id = place.dataset.exercise;
    this.place = place;
    this.report = element("pre", {className: "report", tabIndex: 0});
    this.report.setAttribute("role", "status");
    this.report.setAttribute("aria-label", `Report of exercise ${this.id}`);
    this.report.hidden = true;
    this.check = button("Check", () => this.test(), {className: "check"});
    this.bar = element("progress", {max: 1, value: 0, hidden: true});
    this.check.title = "Ctrl and Enter in the editor";
    this.hints = element("div", {className: "hints"});
    this.more = button("Hint", () => this.hint(), {className: "hint"});
    this.title = element("h3", {
      textContent: `Exercise ${this.id}: ${chapter.titles[this.id] || ""}`});
    this.regions = names.filter(name => name.startsWith(`${this.id}#`));
    this.live = element("div", {className: "scene"});
    const mine = regions(chapter.stub).filter(region => region.id === this.id);
    place.append(
      this.title,
      ...mine.flatMap(region => this.edited(region)), calls(),
      element("p", {className: "buttons"}, this.check,
              this.more,
              button("Reset", ({target}) => this.reset(target), {className: "reset"}), unkept()),
      this.bar, this.report, this.hints, this.live);
    place.removeAttribute("id");  // its first editor has it
    place.addEventListener("keydown", event => {
      if (event.key !== "Enter" || !(event.ctrlKey || event.metaKey)) return;
      event.preventDefault();
      this.test();
    }, true);
    this.label();
  }
  edited(region) {
    const name = name_of(region), [head, tail] = around(region);
    const words = lines => lines.join("\n");
    const id = `exercise-${this.id}` + (region.place > 1 ? `-${region.place}` : "");
    const label = `Exercise ${this.id}, your code`;
    const editor = make_editor(id, label, words(answers[name]), text => {
      answers[name] = text.split("\n");
      store.keep(name, answers[name], chapter.version);
      undo?.remove();
      refresh();
      number_lines();
    });
    editors[name] = editor;
    return [element("pre", {className: "around", textContent: head}), editor.element,
            element("pre", {className: "around", textContent: tail})];
  }
  label() {
    const size = Math.round(engine.weight(chapter) / 1e6);
    this.check.textContent = engine.is_loaded() ? "Check"
      : `Load the compiler (about ${size} MB) and check`;
  }
  /// Its lines in answers of the file: what a report and a mark belong to.
  part(all) { return Object.fromEntries(this.regions.map(name => [name, all[name]])); }
  /// \param of the lines that the words are about
  say(words, kind, of = this.part(answers)) {
    this.about = of;
    this.report.hidden = false;
    this.report.className = `report ${kind}`;
    const narrow = matchMedia("(max-width: 600px)").matches;  // a table needs the margin
    const here = words.replace(/\.\/wb hint \S+/g, "the button Hint")
      .replace(/\.\/wb test \S+/g, "the button Check");
    this.report.textContent = narrow ? here.replace(/^ {1,4}/gm, "") : here;
    this.refresh();
  }
  /// Whether report and mark are those of the present lines.
  refresh() {
    const stale = !same(this.about, this.part(answers));
    for (const one of [this.report, this.live]) one.classList.toggle("stale", stale);
    this.title.classList.toggle("done", is_done(this.id));
  }
  /// Its lines are others: what is said of those before goes.
  clear() {
    this.report.hidden = true;
    this.live.replaceChildren();
    this.refresh();
  }
  hint() {
    const given = this.hints.children.length, all = chapter.hints[this.id] || [];
    if (given >= all.length) return;
    this.hints.append(element("div", {innerHTML: all[given]}));
    this.hints.lastChild.querySelector("details").open = true;
    this.more.disabled = given + 1 === all.length;
  }
  reset(beside) {
    const undo = replace(this.part(stub), `Throw away your work in exercise ${this.id}?`);
    if (undo) beside.after(undo);
  }
  mark(line, words) {
    for (const region of regions(file())) {
      const inside = region.begin < line && line <= region.end;
      editors[name_of(region)].mark(inside ? line - region.begin : 0, words);
    }
  }
  async test() {
    if (this.check.hasAttribute("aria-disabled")) return;
    this.mark(0);
    if (regions(file()).filter(region => region.id === this.id).every(is_untouched))
      return this.say(`${this.id}  ${chapter.titles[this.id]}: ${OPEN}\n` +
                      "  Replace todo(...) with your code.", "open");
    if (navigator.deviceMemory < 1 && !engine.is_loaded() && !this.warned) {
      this.warned = true;
      return this.say("This device has less than 1 GB of memory, and the compiler needs about " +
                      "500 MB. Press the button again to try it.", "open");
    }
    this.check.setAttribute("aria-disabled", "true");  // disabled, it would lose the focus
    try {
      await this.load();
      await this.judge();
    } catch (error) {
      this.say(`${error.message}\n\nIf this computer has little memory, close other pages and ` +
               "load this one again: the compiler needs about 500 MB.", "bad");
    }
    this.check.removeAttribute("aria-disabled");
    exercises.forEach(one => one.label());
  }
  async load() {
    if (engine.is_loaded()) return;
    this.bar.hidden = false;
    this.bar.setAttribute("aria-label", "The compiler is loading");
    this.check.textContent = "Loading the compiler";
    await engine.load(chapter, fraction => { this.bar.value = fraction; });
    this.bar.hidden = true;
    keep_offline(engine.manifest);
  }
  async judge() {
    const text = file(), sent = this.part(answers);
    const changed = () => !same(sent, this.part(answers));
    this.check.textContent = "Checking";
    const began = performance.now(), built = await engine.build_tests(chapter, text);
    if (!built.wasm) {
      this.live.replaceChildren();
      const {text: words, line, words: short} = refused(built.printed, chapter, text);
      if (!changed()) this.mark(line, short);
      return this.say(words, "bad", sent);
    }
    const grade = graded(this.id, await engine.run_tests(built.wasm, chapter, text, this.id),
                         chapter, text);
    if (wants_units(grade)) await this.ask_units(grade, text);
    if (grade.status === DONE) store.mark(this.id, sent, chapter.version);
    else if (!changed() && is_done(this.id)) store.unmark(this.id);  // it calls what has changed
    this.say(told(grade, chapter, text), grade.status === DONE ? "good" : "bad", sent);
    this.place.dataset.verdict = grade.status;
    this.place.dataset.took = performance.now() - began;
    refresh();
    if (changed()) return;
    const next = grade.status === DONE && next_of(this.id);
    if (next) this.report.append(" Next: ", element("a", {
      href: `${next.page}#exercise-${next.id}`, textContent: `exercise ${next.id}`}));
    this.show_scene(text, grade, changed);  // the button does not wait for it
  }
  /// The scene with the code that was checked, right or wrong, unless it has changed meanwhile.
  async show_scene(text, grade, changed) {
    const first = grade.failures[0]?.report || "", mistake = named(first);
    if (first.startsWith(ENDLESS)) return this.live.replaceChildren(
      "No scene: the code does not end.");
    const ids = chapter.ids.filter(id => id === this.id || is_done(id)), shown = this.scene = {};
    const report = mistake ? `The check says: likely mistake: ${mistake.replace(POSES, "")}`
      : grade.status === WRONG ? "The check says what is wrong, in the report above." : "";
    const known = {right: grade.status === DONE, report};
    const frame = await live_frame(chapter, text, this.id, ids, known).catch(
      error => `The scene cannot be shown: ${error.message}`);
    if (this.scene === shown && !changed()) this.live.replaceChildren(frame || "");
  }
  async ask_units(grade, text) {
    if (!engine.manifest.sizes["units.xz"]) return;
    this.check.textContent = "Checking the units";
    const built = await engine.build_units(chapter, text);
    const said = built.wasm &&
      units_in(await engine.run_tests(built.wasm, chapter, text, this.id));
    const first = grade.failures[0];
    first.report = with_units(first.report, said || "Units: no fault that can be seen.");
  }
}

/// Shows other lines of a region.
function show(name, lines) {
  answers[name] = lines;
  editors[name]?.set(lines.join("\n"));
  number_lines();
  exercises.find(one => one.regions.includes(name))?.clear();
}

function give(others) {
  undo?.remove();
  for (const [name, lines] of Object.entries(others)) {
    if (same(lines, answers[name])) continue;
    if (same(lines, stub[name])) store.forget(name);
    else store.keep(name, lines, chapter.version);
    show(name, lines);
  }
  refresh();
}

/// Gives regions other lines, {"1.3#2": lines}, and keeps them; asks where work would be lost.
/// \returns where it was allowed, a button that undoes it, to be put behind another
function replace(others, question) {
  const before = Object.fromEntries(Object.keys(others).map(name => [name, answers[name]]));
  const lost = name => !same(before[name], stub[name]) && !same(before[name], others[name]);
  if (Object.keys(others).some(lost) && !confirm(question)) return null;
  give(others);
  return undo = button("Undo", ({target}) => {
    target.previousElementSibling.focus();
    give(before);
  }, {className: "undo"});
}

// ---- all chapters -------------------------------------------------------------------------------

const is_done = id => store.is_done(id, chapter.version);
/// The next exercise that is not done, {page, id}, behind this one or before it.
function next_of(id) {
  const all = engine.manifest.chapters.flatMap(({page, ids}) => ids.map(id => ({page, id})));
  const at = all.findIndex(one => one.id === id);
  return [...all.slice(at + 1), ...all.slice(0, at)].find(one => !is_done(one.id));
}

/// Reports, marks, and in the list of pages how many exercises of each chapter are done.
function refresh() {
  exercises.forEach(one => one.refresh());
  for (const {page, ids} of engine.manifest.chapters) {
    const link = document.querySelector(`#pages a[href="${page}"]`);
    link.querySelector(".count")?.remove();
    link.append(element("span", {className: "count", title: "exercises done",
                                 textContent: `${ids.filter(is_done).length}/${ids.length}`}));
  }
}

/// Every editor counts its lines as the file does.
function number_lines() {
  for (const region of regions(file())) editors[name_of(region)]?.number_from(region.begin + 1);
}

const exercises = places.map(place => new Exercise(place));
refresh();
offer_file(document.querySelector(".exercise-file"), chapter, file, replace,
           store.homeless(chapter.number, names));
store.listen(name => {
  const lines = store.kept([name])[name] || stub[name];
  if (name in stub && !same(lines, answers[name])) {
    undo?.remove();
    show(name, lines);
  }
  refresh();
});
number_lines();
const wanted = document.getElementById(where_in_page());
wanted?.scrollIntoView();
wanted?.focus({preventScroll: true});
document.documentElement.dataset.course = "ready";
