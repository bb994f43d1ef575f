// The page: what it says, what it paints, its buttons.
"use strict";

// ---------------------------------------------------------------------------------- in words
const per_panel = words => panels.map(panel =>
  (panels.length > 1 ? `${panel.label}: ` : "") + words(panel)).join("\n");

function joules({now, scale}) {
  const energy = Math.abs(now[2]) < 1e-9 * scale ? 0 : now[2];  // the rest is rounding
  return (energy > 0 ? "+" : "") + short(energy);
}
function reading() {
  const slow = playing && pace.rate < 0.97 ? `, ${pace.rate.toPrecision(2)} of real time` : "";
  return `t = ${time.toFixed(2)} s${slow}\n` + per_panel(panel =>
    panel.stopped ? "stopped" : !isFinite(panel.now[2]) ? "not a number" :
    `gap ${metres(panel.now[1])} · energy ${joules(panel)} J · ` +
    `${panel.us ? Math.round(panel.us) : "…"} µs a step`);
}
// Why a run went wrong: the reader's code, the scene's own settings, changed ones, or a hand.
const by_hand_alone = (panel, fault) =>
  !fault(scene.alone) && Object.keys(panel.faults.get(fault)).join() === "hand";
function cause(panel, fault) {
  if (panel.label === "yours" && panels.some(one => !one.stopped && !failed(one)))
    return "Your code does that: the solution holds with the same settings.";
  const {hand, ...settings} = panel.faults.get(fault);
  const names = Object.entries(settings).map(words => words.join(" "));
  if (fault(scene.alone) || !(hand || names.length))
    return `The scene's own settings do that: change ${names.length ? "others" : "one"}, then ` +
           "press “again”.";
  if (!names.length) return "Your hand did that, not the settings: press the button “again”.";
  const [what, them] = names.length === 1 ? [`the setting ${names[0]} does`, "it"]
    : [`one or more of the changed settings (${names.join(", ")}) do`, "them"];
  return hand ? `Your hand did that, or ${what}: press “again” and touch nothing to see.`
    : `${what[0].toUpperCase()}${what.slice(1)} that: change ${them} back, then press “again”.`;
}
// What there is to say, and whether it is bad.
function says() {
  const said = [];
  if (refusal) said.push(refusal);
  for (const panel of panels) {
    const who = panels.length > 1 ? `${panel.label}: ` : "";
    const gained = panel.now[2] / panel.scale;
    if (panel.stopped)
      said.push(`${who}stopped at t = ${panel.now[0].toFixed(2)} s: ${panel.stopped}`);
    else if (!isFinite(panel.now[2]))
      said.push(`${who}the places are no numbers any more. ${cause(panel, blown_up)}`);
    else if (blown_up(panel))
      said.push(`${who}${by_hand_alone(panel, blown_up) ? "" : "blown up: "}the bodies have gained ` +
                (gained > 1e6 ? "more than a million" : short(gained)) +
                ` times the energy that the scene began with. ${cause(panel, blown_up)}`);
    else if (torn(panel))
      said.push(`${who}the joints do not hold: they are ${metres(panel.now[1])} apart, ` +
                `${short(100 * panel.now[1] / scene_size())} % of the scene's size. ${cause(panel, torn)}`);
  }
  if (said.length) return [said.join("\n"), true];
  if (held?.keyed)
    return [`You hold ${held.keyed}: arrows pull it, tab takes the next one, escape lets go.`,
            false];
  const talk = panels.find(panel => panel.printed)?.printed.trim().split("\n").at(-1);
  if (talk) return [`Your code prints: ${talk}`, false];
  if (settings.own)
    return ["The chapter's own loop moves the bodies: it knows no hand, so that none can be " +
            "dragged, and one cannot look into its steps.", false];
  if (!inside) return ["", false];
  const {joints, first_error, blocks} = panels.at(-1);
  const part = inside.block && " A block disturbs its neighbours: between two iterations the error " +
    "may rise.";
  return [`Within the step from t = ${time.toFixed(2)} s, after iteration ${inside.iteration}` +
    (settings.direct ? " (the direct solver has one)" : ` of ${settings.iterations}`) +
    (inside.block ? ` and ${inside.block} of ${blocks} blocks more` : "") +
    `: the largest velocity error is ${short(largest_error(joints || []))} m/s, at the step's ` +
    `beginning it was ${short(first_error)}.${part || ""} Discs: red as large as that, green a ` +
    "thousandth of it; arrows: impulses; ringed: solved next.", false];
}

// ---------------------------------------------------------------------------------- painting
function show() {
  if (!scene || !panels.every(panel => panel.run)) return;
  scene.now = time;
  for (const panel of panels) {
    panel.painted = draw(panel, scene, 0);
    if (!panel.painted) continue;
    if (compared()) paint_outline(panel.painted, panels[1].run);
    if (inside && panel.joints) paint_inside(panel.painted, panel.joints, panel.first_error);
    else if (isFinite(panel.now[2])) {
      paint_joints(panel.painted, panel.run, panel.driven);
      if (forces && panel.forces) paint_impulses(panel.painted, panel.forces);
    }
    if (compared()) paint_parting(panel.painted, panel.run, panels[1].run);
    if (held?.panel === panel) paint_hand(panel.painted, held);
  }
  plots.gap($("gap"), panels, time);
  plots[view]($("second"), panels, time);
  for (const button of $("views").children)
    button.setAttribute("aria-pressed", button.dataset.view === view);
  $("reading").textContent = reading();
  $("hand").hidden = Boolean(settings.own);
  $("parted").hidden = !is_compared();
  const [words, bad] = says();
  if ($("said").textContent !== words) $("said").textContent = words;  // each change is read out
  $("said").classList.toggle("bad", bad);
  const does = playing ? "Pause" : "Play";
  $("play").setAttribute("aria-label", does);
  $("play").querySelector("path").setAttribute("d", icons[does]);
}
function settled() {  // what changes only when something was pressed
  show_controls(settings, entry, about, wrong);
  const still = !playing && straight && time > 0;
  write_address({settings, view: view === "energy" ? "" : view,
                 theme: last_of(first_address, "theme"), only: only?.name,
                 t: still || inside ? time : undefined,
                 iteration: inside?.iteration, block: inside?.block}, about, entry);
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
    if (now - pace.wall > 1000) {
      if (time > pace.time) pace.rate = 1000 * (time - pace.time) / (now - pace.wall);
      Object.assign(pace, {wall: now, time});
    }
    if (panels.every(gone)) play(false);  // there is nothing to be seen any more
    const count = playing ? steps_shown(Math.floor(owed / settings.h + 1e-9)) : 0;
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
  pace = {rate: 1, wall: before, time};
  if (on) inside = null;
  settled();
  ask();
}
const then_show = job => in_line(job).then(() => { settled(); ask(); });

// ---------------------------------------------------------------------------------- the page
function make_panel({label, wasm}) {
  const figure = document.createElement("figure");
  figure.innerHTML = `<figcaption><i></i></figcaption><p role="status"></p>` +
                     `<canvas tabindex="0" role="application"></canvas>`;
  const [caption, note, canvas] = figure.children;
  caption.append(label);
  caption.hidden = false;
  caption.firstChild.style.background = rgb(colours[label], 0.5);
  canvas.setAttribute("aria-label", `${label}: a picture that moves. Enter takes a body, arrows ` +
                                    "pull it, shift and arrows turn the picture.");
  const panel = {label, figure, canvas, note, engine: new Engine(label, wasm), kept: [],
                 samples: [], now: [0, 0, 0], us: 0, stopped: ""};
  canvas.addEventListener("keydown", e => take_by_keys(panel, e));
  canvas.addEventListener("blur", () => { if (held?.keyed) let_go(); });
  listen(canvas, e => take(panel, e));
  return panel;
}
async function from_address() {
  const address = read_address(), name = last_of(address, "scene"), said = [];
  let found = about.scenes.find(each => each.name === name);
  const opened_by = page => about.scenes.find(each => each.opens.includes(String(page)));
  const usual = opened_by(data.exercise) || opened_by(data.chapter || 2);
  if (name && !found) said.push(`There is no scene ${name}: this is ${usual.title}.`);
  const told = words => said.push(words);
  for (const key of new Set(address.keys()))
    if (!about.settings.includes(key) && !OTHER_NAMES.includes(key))
      told(`The address says ${key}, which is no name here: it is left out.`);
  let own = null;
  if (data.chapter && !name) {
    await find_where_they_part(usual);
    ({found, own} = first_parting() || {found: usual, own: Number(usual.own)});
  }
  found ||= usual;
  const wanted = settings_from(address, about, found, told);
  if (own !== null) Object.assign(wanted, of_chapter(own));
  view = plots[last_of(address, "view")] ? last_of(address, "view") : "energy";
  const t = number_from(address, "t", undefined, told, 0, 1000);
  const last = wanted.direct ? 1 : wanted.iterations;
  await choose(found.name, wanted, {
    t, iteration: number_from(address, "iteration", undefined, told, 0, last),
    block: number_from(address, "block", undefined, told, 0, 1e4)});
  refusal = [refusal, ...said].filter(Boolean).join(" ");
  return address;
}
// What a chapter's exercises do most in, besides a scene.
const of_chapter = own => data.chapter === 9 ? {direct: 1, ...with_direct}
  : own > 1 ? {own: 1, frequency: 60, damping: 5, substeps: 4}  // the soft step of exercise 6.4
  : data.chapter === 6 && own ? {own, warm: 1, projections: 1} : {own};

const keys = {" ": () => play(!playing), ArrowRight: () => $("one").click(),
              i: () => $("iteration").click(), b: () => $("block").click()};

const data = JSON.parse($("data").textContent), first_address = read_address();
// The one setting that a page around this one asks for.
const only = controls.find(control => control.name === last_of(first_address, "only"));
async function start() {
  dress(ask, last_of(first_address, "theme"));
  document.title = data.title;
  $("title").textContent = only && framed ? "" : data.title;
  if (data.back && !framed) $("title").append(Object.assign(document.createElement("a"), data.back));
  if (framed)
    $("title").append(Object.assign(document.createElement("a"), {
      textContent: "all settings and curves", href: "#", target: "_top", onclick() {
        this.href = location.href.replace(/[?&]theme=\w+/, "").replace(/&only=\w+/, "");
      }}));
  if (data.note) $("title").append(Object.assign(document.createElement("small"),
                                                 {textContent: data.note}));
  panels = data.modules.map(make_panel);
  document.documentElement.classList.toggle("beside", panels.length > 1);
  $("stage").replaceChildren(...panels.map(panel => panel.figure));
  if (compared()) {  // one picture for both
    const [mine, right] = panels.map(panel => panel.figure);
    right.hidden = true;
    const swatch = right.querySelector("i");
    Object.assign(swatch.style, {background: "none", border: `2px solid ${
      rgb(colours["the solution"], 0.5)}`});
    mine.firstChild.append(", solid", swatch, "the solution, outline");
  }
  about = (await Promise.all(panels.map(panel => panel.engine.about))).at(-1);
  for (const each of about.scenes) {
    const tab = Object.assign(document.createElement("button"),
                              {textContent: each.title, name: each.name});
    tab.onclick = () => then_show(() => choose(each.name, settings_kept(settings, about, entry,
                                                                        each)))
      .then(() => play(true));
    $("scenes").append(tab);
  }
  make_controls($("controls"), (name, value) => then_show(() => change(name, value)));
  if (only) {
    document.documentElement.classList.add("only");
    document.documentElement.classList.toggle("within", first_address.has("iteration"));
    $("controls").prepend(only.label);
  }
  $("play").onclick = () => play(!playing);
  $("again").onclick = () => then_show(restart).then(() => play(true));
  $("one").onclick = () => { playing = false; then_show(() => steps(1)); };
  $("iteration").onclick = () => then_show(() => next_inside(false));
  $("block").onclick = () => then_show(() => next_inside(true));
  $("forces").onclick = () => {
    forces = !forces;
    $("forces").setAttribute("aria-pressed", forces);
    then_show(find_forces);
  };
  $("compare").onclick = () => {
    play(false);
    $("compare").disabled = true;
    in_line(() => compare_methods($("methods"), set => then_show(() => {
      settings = {...settings, own: 0, ...set};
      return restart();
    }).then(() => play(true)))).then(() => { $("compare").disabled = false; });
  };
  $("keep").onclick = () => then_show(() => {
    const words = Object.entries(differences()).map(pair => pair.join(" ")).join(", ");
    for (const panel of panels)
      Object.assign(panel, {kept: panel.samples, kept_with: words || "the scene's own settings"});
    return restart();
  }).then(() => play(true));
  for (const button of $("views").children)
    button.onclick = () => { view = button.dataset.view; settled(); ask(); };
  // A button that the mouse has pressed gives the keys back; one that a key has reached keeps space.
  document.addEventListener("click", e => e.detail && e.target.closest("button")?.blur());
  document.onkeydown = e => {
    if (e.ctrlKey || e.metaKey || e.altKey || e.shiftKey ||
        /INPUT|SUMMARY/.test(e.target.tagName)) return;
    if (!keys[e.key] || (e.key === " " && e.target.tagName === "BUTTON")) return;
    keys[e.key]();
    e.preventDefault();
  };
  onhashchange = () => then_show(from_address);
  await then_show(from_address);
  new ResizeObserver(show).observe($("stage"));
  const linked = location.search || first_address.has("scene");
  if (!linked && !data.chapter && !framed) {
    const skip = ask_question($("question"), async (name, set, seconds) => {
      const own = own_settings(about, about.scenes.find(each => each.name === name));
      await then_show(() => choose(name, {...own, ...set}));
      play(true);
      const over = () => entry.name !== name ||
        panels.some(blown_up);
      while (time < seconds && playing && !over())
        await new Promise(resolve => setTimeout(resolve, 20));
      if (seconds && entry.name === name) {
        play(false);  // while the chain is still to be seen
        const seen = () => time >= seconds || over() || !alive().length;
        await then_show(async () => { while (!seen()) await steps(1); });  // energy swings
      }
      show();
    }, ask);
    $("scenes").addEventListener("click", skip);  // it is about one scene
  }
  const resting = matchMedia("(prefers-reduced-motion: reduce)").matches;
  if (!first_address.has("t") && !first_address.has("iteration") && !resting) {
    if (compared() && framed)  // a short motion is not to be over before it is seen
      new IntersectionObserver(([{isIntersecting}], observer) => {
        if (!isIntersecting) return;
        observer.disconnect();
        play(true);
      }, {threshold: 0.5}).observe($("stage"));
    else play(true);
  }
  show();
  document.documentElement.dataset.ready = "yes";
}
start();
