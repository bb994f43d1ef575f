// The run: what the engines of all panels are asked, one question after the other.
"use strict";

let about, entry, settings, scene, panels = [];
let time = 0, playing = false, busy = false, asked = false, before = 0, owed = 0;
let inside = null;    // {iteration, block} while the page looks into a step
let straight = true;  // the run is what its address says: nothing was changed or dragged on the way
let view = "energy", wrong = "", refusal = "", looked = 0;
let forces = false;   // the impulses of the step to come are shown as arrows
let held = null;      // {panel, body, point, local}: a hand holds a body by one of its points
let pace = {rate: 1, wall: 0, time: 0};  // of the run, and since when it has been counted

// One thing after the other: whoever wants something of the engines stands in line.
let line = Promise.resolve();
const in_line = job => line = line.then(job).catch(error => {
  refusal = `Refused: ${error.message}`;
  if (!(error instanceof Refused)) console.error(error);
  ask();
});

const alive = () => panels.filter(panel => !panel.stopped);

// Asks the engines of all panels that run; one that refuses stops with its sentence.
async function ask_all(what, more, use = () => {}, patience) {
  await Promise.all(alive().map(async panel => {
    try {
      use(panel, await panel.engine.ask(what, more, patience));
    } catch (error) {
      if (!(error instanceof Refused)) throw error;
      panel.stopped = error.message;
      playing = panels.some(one => !one.stopped) && playing;
    }
  }));
}
// Whether the bodies have gained more than a scene begins with, and so much that there is nothing to
// be seen any more.
const blown_up = panel => !(panel.now[2] <= panel.scale);
const gone = panel => !(panel.now[2] < 1000 * panel.scale);
// Whether joints are so far apart that the picture falls to pieces.
const scene_size = () => Math.hypot(...scene.high.map((c, k) => c - scene.low[k]));
const torn = panel => panel.now[1] > 0.05 * scene_size();
const failed = panel => blown_up(panel) || torn(panel);

// What this run had, by its name, that the scene does not begin with: settings, and a hand.
let had = {};
function differences() {
  const idle = settings.direct ? [] : ["newton", "added_inertia"];
  return Object.fromEntries(about.settings.filter((name, k) => !idle.includes(name) &&
    settings[name] !== entry.begin[k]).map(name => [name, in_words(name, settings[name])]));
}

function take_state(panel, {state, driven}) {
  panel.driven = driven;
  panel.now = Array.from(state.slice(0, 3));
  panel.run.frames = [Array.from(state.slice(3))];
  for (const fault of [blown_up, torn])  // what there was when it began
    if (!fault(panel)) panel.faults.delete(fault);
    else if (!panel.faults.has(fault)) panel.faults.set(fault, {...had});
}

async function restart() {
  time = owed = 0;
  inside = held = null;
  rested = false;
  straight = true;
  wrong = refusal = "";
  had = differences();
  for (const panel of panels)
    Object.assign(panel, {stopped: "", samples: [], errors: null, joints: null, forces: null,
                          us: 0, used: 0, counted: 0, now: [0, 0, 0], faults: new Map(),
                          scale: Infinity, printed: "", driven: []});
  for (const panel of panels)  // one that cannot be made shows where the scene begins
    panel.run = {...scene.runs[0], label: panel.label, dt: 1,
                 frames: scene.runs[0].frames.slice(0, 1)};
  await ask_all("make", {name: entry.name, settings}, (panel, made) => {
    const known = scene.runs[0];
    panel.run = {label: panel.label, dt: 1, lines: made.lines, marks: made.marks,
                 endless: known.endless,
                 bodies: made.bodies.map((body, k) => ({...known.bodies[k], ...body}))};
    panel.scale = made.energy_scale;
    take_state(panel, made);
  });
  await find_forces();
}

// A browser's clock is coarse: microseconds come from twenty steps or more.
function time_steps(panel, used, count) {
  panel.used += used;
  panel.counted += count;
  if (panel.counted < 20 && panel.used < 20) return;
  panel.us = 1000 * panel.used / panel.counted;
  panel.used = panel.counted = 0;
}
// So many steps, in pieces that take about a thirtieth of a second.
async function steps(count) {
  inside = null;
  while (count > 0 && alive().length) {
    const us = Math.max(...alive().map(panel => panel.us)) || 1e4;
    const piece = Math.min(count, Math.max(1, Math.floor(33000 / us)));
    await ask_all("steps", {count: piece}, (panel, done) => {
      panel.printed = done.printed;
      time_steps(panel, done.used, piece);
      for (let k = 0; k < piece; ++k)
        panel.samples.push(done.samples.slice(3 * k, 3 * k + 3));
      if (panel.samples.length > 20000) panel.samples.splice(0, 5000);
      panel.errors = panel.joints = null;
      take_state(panel, done);
    });
    count -= piece;
    time = Math.max(...panels.map(panel => panel.now[0]));
  }
  await find_forces();
}
async function find_forces() {
  if (!forces || settings.own) return;
  const iterations = settings.direct ? 1 : settings.iterations;
  await ask_all("look", {iterations, blocks: 0}, (panel, found) => {
    panel.forces = joints_of(found.joints);
  });
}

async function look_inside(iteration, block) {
  if (!inside)
    await ask_all("look", {iterations: 0, blocks: 0}, (panel, found) => {
      panel.first_error = largest_error(joints_of(found.joints));
    });
  inside = {iteration, block};
  await ask_all("look", {iterations: iteration, blocks: block}, (panel, found) => {
    panel.joints = joints_of(found.joints);
    panel.blocks = found.blocks;
  });
}
async function next_inside(blockwise) {
  if (settings.own) return;
  playing = false;
  const last = settings.direct ? 1 : settings.iterations;
  if (inside?.iteration >= last) await steps(1);  // that step is done
  if (!inside) await look_inside(0, 0);  // where it begins, which says how many blocks there are
  const {iteration, block} = inside, blocks = panels.at(-1).blocks;
  const whole = !blockwise || settings.direct || block + 1 >= blocks;
  return whole ? look_inside(iteration + 1, 0) : look_inside(iteration, block + 1);
}

async function find_errors() {
  if (settings.own) return;
  const most = clamp(settings.iterations, 30, 200);
  await ask_all("errors", {most}, (panel, found) => { panel.errors = found; });
}

// A recording of the scene as it begins by itself tells the camera how far things go.
async function choose(name, wanted, {t = 0, iteration, block = 0} = {}) {
  entry = about.scenes.find(each => each.name === name) || about.scenes[0];
  const own = own_settings(about, entry), {engine} = panels.at(-1);
  settings = wanted || own;
  let trouble = "";
  try {
    await engine.ask("make", {name: entry.name, settings});
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    trouble = `Refused: ${error.message}. The scene begins with its own settings instead.`;
    settings = own;
  }
  const made = await engine.ask("make", {name: entry.name, settings: own});
  const every = 6, {frames, state} = await engine.ask(
    "record", {count: Math.round(3 / own.h), every}, 20000);
  scene = {runs: [{label: "the solution", dt: own.h * every, ...made, frames}]};
  measure(scene);
  scene.travel = 0;  // the live picture draws no way
  scene.alone = {now: state, scale: made.energy_scale};  // with its own settings, at the end
  for (const tab of $("scenes").children) {
    tab.setAttribute("aria-pressed", tab.name === entry.name);
    if (tab.name === entry.name)
      $("scenes").scrollLeft = tab.offsetLeft - $("scenes").offsetLeft - 60;
  }
  $("watch").textContent = entry.watch;
  for (const panel of panels) Object.assign(panel, {kept: [], kept_with: ""});
  look_home();
  await compare();
  await restart();
  refusal = trouble;
  await steps(Math.round(t / settings.h));
  if (iteration !== undefined && !settings.own) await look_inside(iteration, block);
}

async function change(name, value) {
  if (name === null) {
    settings = own_settings(about, entry);
    return restart();
  }
  const own = entry.begin[about.settings.indexOf(name)];
  if (value.toPrecision(5) === own.toPrecision(5)) value = own;  // as the field shows it
  if (unfit(name, value)) {
    wrong = name;
    refusal = `Refused: ${name} ${unfit(name, value)}; it stays ${in_words(name, settings[name])}.`;
    return;
  }
  const tried = {...settings, [name]: value};
  for (const [other, best] of name === "direct" ? Object.entries(with_direct) : [])
    tried[other] = value ? best : entry.begin[about.settings.indexOf(other)];
  try {
    for (const panel of alive())
      panel.driven = (await panel.engine.ask("set", {settings: tried})).driven;
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    for (const panel of alive()) await panel.engine.ask("set", {settings});
    wrong = name;
    refusal = `Refused: ${error.message}; it stays ${in_words(name, settings[name])}.`;
    return;
  }
  settings = tried;
  Object.assign(had, differences());
  wrong = refusal = "";
  straight = straight && time === 0;
  for (const panel of panels) panel.errors = null;
  // Beside a kept curve only whole runs are compared.
  const fresh = name === "ratio" || !alive().length || panels.some(panel => panel.kept.length);
  if (fresh) await restart();
  else if (inside) {
    inside = null;
    await look_inside(0, 0);
  }
}
