// The page: panels, the run, the buttons.
"use strict";

let about, entry, settings, scene, panels = [];
let time = 0, playing = false, busy = false, asked = false, before = 0, owed = 0;
let inside = null;    // {iteration, block} while the page looks into a step
let straight = true;  // the run is what its address says: nothing was changed or dragged on the way
let view = "energy", wrong = "", refusal = "", looked = 0;

// One thing after the other: whoever wants something of the engines stands in line.
let line = Promise.resolve();
const in_line = job => line = line.then(job).catch(error => {
  refusal = error.message;
  if (!(error instanceof Refused)) console.error(error);
  ask();
});

// ---------------------------------------------------------------------------------- the run
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
function take_state(panel, {state}) {
  panel.now = Array.from(state.slice(0, 3));
  panel.run.frames = [Array.from(state.slice(3))];
}

async function restart() {
  time = owed = 0;
  inside = null;
  straight = true;
  wrong = refusal = "";
  for (const panel of panels)
    Object.assign(panel, {stopped: "", samples: [], errors: null, joints: null, us: 0, used: 0,
                          counted: 0});
  await ask_all("make", {name: entry.name, settings}, (panel, made) => {
    const known = scene.runs[0];
    panel.run = {label: panel.label, dt: 1, lines: made.lines, endless: known.endless,
                 bodies: made.bodies.map((body, k) => ({...known.bodies[k], ...body}))};
    take_state(panel, made);
  });
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
        panel.samples.push([...done.samples.slice(3 * k, 3 * k + 3), panel.us]);
      if (panel.samples.length > 20000) panel.samples.splice(0, 5000);
      panel.errors = panel.joints = null;
      take_state(panel, done);
    });
    count -= piece;
    time = Math.max(...panels.map(panel => panel.now[0]));
  }
}

async function look_inside(iteration, block) {
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
  if (!inside) return look_inside(0, 0);
  const {iteration, block} = inside, blocks = panels.at(-1).blocks;
  if (iteration >= last) {  // the step is done
    await steps(1);
    return look_inside(0, 0);
  }
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
  settings = wanted || settings_from(new URLSearchParams(), about, entry);
  const own = settings_from(new URLSearchParams(), about, entry), {engine} = panels.at(-1);
  const made = await engine.ask("make", {name: entry.name, settings: own});
  const every = 6, {frames} = await engine.ask(
    "record", {count: Math.round(3 / own.h), every}, 20000);
  scene = {runs: [{label: "the solution", dt: own.h * every, ...made, frames}]};
  measure(scene);
  scene.travel = 0;  // the live picture draws no way
  for (const tab of $("scenes").children) {
    tab.setAttribute("aria-pressed", tab.name === entry.name);
    if (tab.name === entry.name)
      $("scenes").scrollLeft = tab.offsetLeft - $("scenes").offsetLeft - 60;
  }
  $("watch").textContent = entry.watch;
  for (const panel of panels) panel.kept = [];
  look_home();
  await restart();
  await steps(Math.round(t / settings.h));
  if (iteration !== undefined && !settings.own) await look_inside(iteration, block);
}

async function change(name, value) {
  if (name === null) {
    settings = settings_from(new URLSearchParams(), about, entry);
    return restart();
  }
  const tried = {...settings, [name]: value};
  for (const [other, best] of name === "direct" ? Object.entries(with_direct) : [])
    tried[other] = value ? best : entry.begin[about.settings.indexOf(other)];
  try {
    for (const panel of alive()) await panel.engine.ask("set", {settings: tried});
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    for (const panel of alive()) await panel.engine.ask("set", {settings});
    wrong = name;
    refusal = error.message;
    return;
  }
  settings = tried;
  wrong = refusal = "";
  straight = straight && time === 0;
  for (const panel of panels) panel.errors = null;
  if (name === "ratio" || !alive().length) await restart();
  else if (inside) await look_inside(0, 0);
}

// ---------------------------------------------------------------------------------- in words
const per_panel = words => panels.map(panel =>
  (panels.length > 1 ? `${panel.label}: ` : "") + words(panel)).join("\n");

function reading() {
  return `t = ${time.toFixed(2)} s\n` + per_panel(({now, us}) =>
    `gap ${metres(now[1])} · energy ${now[2] > 0 ? "+" : ""}${short(now[2])} J · ` +
    `${us ? Math.round(us) : "…"} µs a step`);
}
// What there is to say, and whether it is bad.
function says() {
  const said = [];
  if (refusal) said.push(`Refused: ${refusal}`);
  for (const panel of panels) {
    const who = panels.length > 1 ? `${panel.label}: ` : "";
    const gained = panel.now && panel.now[2] / entry.energy_scale;
    if (panel.stopped) said.push(`${who}stopped at t = ${time.toFixed(2)} s: ${panel.stopped}`);
    else if (gained > 1)
      said.push(`${who}blown up: the bodies have gained ${short(gained)} times the energy that ` +
                "there was to gain. Set it right and press again.");
  }
  if (said.length) return [said.join("\n"), true];
  const talk = panels.find(panel => panel.printed)?.printed.trim().split("\n").at(-1);
  if (talk) return [`Your code prints: ${talk}`, false];
  if (settings.own) return ["The chapter's own loop moves the bodies: it knows no hand, and one " +
                            "cannot look into its steps.", false];
  if (!inside) return ["", false];
  const worst = panels.at(-1).joints?.reduce((most, one) => Math.max(most, one.error), 0) ?? 0;
  return [`Within the step from t = ${time.toFixed(2)} s, after iteration ${inside.iteration}` +
    (settings.direct ? " (the direct solver has one)" : ` of ${settings.iterations}`) +
    (inside.block ? ` and ${inside.block} of ${panels.at(-1).blocks} blocks more` : "") +
    `: the largest velocity error is ${short(worst)} m/s. Discs: green 1 mm/s, red 10 m/s; ` +
    "arrows: impulses; ringed: solved next.", false];
}

// ---------------------------------------------------------------------------------- painting
function show() {
  if (!scene || !panels.every(panel => panel.run)) return;
  for (const panel of panels) {
    panel.painted = draw(panel, scene, 0);
    if (inside && panel.joints && panel.painted) paint_inside(panel.painted, panel.joints);
  }
  plots.gap($("gap"), panels, time);
  plots[view]($("second"), panels, time);
  for (const button of $("views").children)
    button.setAttribute("aria-pressed", button.dataset.view === view);
  $("reading").textContent = reading();
  const [words, bad] = says();
  $("said").textContent = words;
  $("said").classList.toggle("bad", bad);
  const does = playing ? "Pause" : "Play";
  $("play").setAttribute("aria-label", does);
  $("play").querySelector("path").setAttribute("d", icons[does]);
}
function settled() {  // what changes only when something was pressed
  show_controls(settings, entry, about, wrong);
  const still = !playing && straight && time > 0;
  write_address({settings, view: view === "energy" ? "" : view,
                 theme: last_of(first_address, "theme"), t: still || inside ? time : undefined, iteration: inside?.iteration,
                 block: inside?.block}, about, entry);
}
function ask() {
  if (!asked) requestAnimationFrame(tick);
  asked = true;
}
function tick(now) {
  asked = false;
  if (playing && !busy) {
    owed = Math.min(owed + Math.max(now - before, 0) / 1000, 0.1);
    before = now;
    const count = Math.floor(owed / settings.h + 1e-9);
    if (count) {
      owed -= count * settings.h;
      busy = true;
      in_line(() => steps(count)).then(() => { busy = false; });
    }
  }
  if (view === "errors" && scene && !settings.own && (now - looked > 500 || !playing) &&
      alive().some(panel => !panel.errors)) {
    looked = now;
    in_line(find_errors).then(show);
  }
  show();
  if (playing) ask();
}
function play(on) {
  playing = on && alive().length > 0;
  before = performance.now();
  if (on) inside = null;
  settled();
  ask();
}
const then_show = job => in_line(job).then(() => { settled(); ask(); });

// ---------------------------------------------------------------------------------- dragging
// What is under a finger: the nearest body whose outline is, or whose centre is within 30 pixels.
function under_finger({painted, canvas}, e) {
  const box = canvas.getBoundingClientRect(), [x, y] = [e.clientX - box.left, e.clientY - box.top];
  let best = null;
  painted.bodies.forEach((body, k) => {
    if (body.still || body.up >= 0 || !body.depth) return;
    const at = project(painted.view, body.x), far = Math.hypot(at[0] - x, at[1] - y);
    const within = x > body.left && x < body.right && y > body.top && y < body.bottom;
    if ((within || far < 30) && (!best || far < best.far)) best = {k, far, depth: at[2], within};
  });
  return best;
}
// The point of the world under a finger, as deep in the picture as that.
function point_at_depth({view}, x, y, depth) {
  const metre = depth / view.focal;
  return plus(plus(plus(view.eye, -depth, view.back), (x - view.width / 2) * metre, view.right),
              (view.height / 2 - y) * metre, view.up);
}
function take(panel, e) {
  const found = panel.painted && !panel.stopped && !settings.own && under_finger(panel, e);
  if (!found) return null;
  const box = panel.canvas.getBoundingClientRect(), {view} = panel.painted;
  const point = at => point_at_depth({view}, at.clientX - box.left, at.clientY - box.top,
                                     found.depth);
  straight = false;
  const start = found.within ? point(e) : panel.painted.bodies[found.k].x;
  in_line(() => ask_all("grab", {body: found.k, point: start}));
  if (!playing) play(true);
  return {move: to => { in_line(() => ask_all("move", {point: point(to)})); },
          drop: () => { in_line(() => ask_all("let_go", {})); }};
}

// ---------------------------------------------------------------------------------- the page
function make_panel({label, wasm}) {
  const figure = document.createElement("figure");
  figure.innerHTML = `<figcaption><i></i></figcaption><p role="status"></p>` +
                     `<canvas tabindex="0" role="img"></canvas>`;
  const [caption, note, canvas] = figure.children;
  caption.append(label);
  caption.hidden = false;
  caption.firstChild.style.background = rgb(colours[label], 0.5);
  canvas.setAttribute("aria-label", `${label}: a picture that moves, its bodies can be dragged`);
  const panel = {label, figure, canvas, note, engine: new Engine(label, wasm), kept: [],
                 samples: [], now: [0, 0, 0], us: 0, stopped: ""};
  listen(canvas, e => take(panel, e));
  return panel;
}
async function from_address() {
  const address = read_address(), name = last_of(address, "scene");
  const found = about.scenes.find(each => each.name === name) ||
    about.scenes.find(each => each.opens.includes(data.chapter || 2));
  const wanted = settings_from(address, about, found);
  if (data.chapter && !name) {  // what the chapter's exercises do most in
    wanted.own = Number(found.own);
    if (data.chapter === 9) Object.assign(wanted, {direct: 1}, with_direct);
  }
  const number = key => address.has(key) ? Number(last_of(address, key)) : undefined;
  view = plots[last_of(address, "view")] ? last_of(address, "view") : "energy";
  await choose(found.name, wanted, {t: number("t"), iteration: number("iteration"),
                                    block: number("block")});
  return address;
}
const keys = {" ": () => play(!playing), ArrowRight: () => $("one").click(),
              i: () => $("iteration").click(), b: () => $("block").click()};

const data = JSON.parse($("data").textContent), first_address = read_address();
async function start() {
  dress(ask, last_of(first_address, "theme"));
  document.title = data.title;
  $("title").textContent = data.title;
  if (data.note) $("title").append(Object.assign(document.createElement("small"),
                                                 {textContent: data.note}));
  panels = data.modules.map(make_panel);
  $("stage").replaceChildren(...panels.map(panel => panel.figure));
  about = (await Promise.all(panels.map(panel => panel.engine.about))).at(-1);
  for (const each of about.scenes) {
    const tab = Object.assign(document.createElement("button"),
                              {textContent: each.title, name: each.name});
    tab.onclick = () => then_show(() => choose(each.name)).then(() => play(true));
    $("scenes").append(tab);
  }
  make_controls($("controls"), (name, value) => then_show(() => change(name, value)));
  $("play").onclick = () => play(!playing);
  $("again").onclick = () => then_show(restart).then(() => play(true));
  $("one").onclick = () => { playing = false; then_show(() => steps(1)); };
  $("iteration").onclick = () => then_show(() => next_inside(false));
  $("block").onclick = () => then_show(() => next_inside(true));
  $("keep").onclick = () => then_show(() => {
    for (const panel of panels) panel.kept = panel.samples;
    return restart();
  }).then(() => play(true));
  for (const button of $("views").children)
    button.onclick = () => { view = button.dataset.view; settled(); ask(); };
  document.onkeydown = e => {
    if (e.ctrlKey || e.metaKey || e.altKey || /INPUT|BUTTON|SUMMARY/.test(e.target.tagName)) return;
    if (!keys[e.key]) return;
    keys[e.key]();
    e.preventDefault();
  };
  onhashchange = () => then_show(from_address);
  await then_show(from_address);
  new ResizeObserver(show).observe($("left"));
  const linked = location.search || location.hash.includes("&");
  if (!linked && !data.chapter)
    ask_question($("question"), async (name, set, seconds) => {
      await then_show(() => choose(name, {...settings, ...set}));
      play(true);
      await new Promise(resolve => setTimeout(resolve, 1000 * seconds));
    }, ask);
  const resting = matchMedia("(prefers-reduced-motion: reduce)").matches;
  if (!first_address.has("t") && !first_address.has("iteration") && !resting) play(true);
  show();
  document.documentElement.dataset.ready = "yes";
}
start();
