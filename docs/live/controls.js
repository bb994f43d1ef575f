// The settings as sliders, numbers and ticks, and the address that holds them all.
"use strict";

// Name in the address, words, unit, slider [least, most, step], and how many stand open.
const controls = [
  {name: "beta", words: "beta", unit: "fraction of the error fed back in a step",
   range: [0, 2.5, 0.05]},
  {name: "iterations", words: "iterations", unit: "a step", range: [1, 300, 1]},
  {name: "h", words: "h", unit: "step [ms]", range: [1, 50, 0.5], scale: 1000},
  {name: "substeps", words: "substeps", unit: "of each step", range: [1, 20, 1]},
  {name: "warm", words: "warm start", tick: true},
  {name: "projections", words: "projections", unit: "of the positions after a step",
   range: [0, 20, 1]},
  {name: "relaxation", words: "relaxation", unit: "factor of every impulse", range: [0.1, 1.95, 0.05]},
  {name: "frequency", words: "soft frequency", unit: "[Hz], 0 is hard", range: [0, 30, 0.5]},
  {name: "damping", words: "soft damping", unit: "ratio", range: [0, 3, 0.1]},
  {name: "direct", words: "direct solver <small>sets beta, newton, leapfrog</small>", tick: true},
  {name: "newton", words: "newton", unit: "on the positions, direct solver", range: [0, 12, 1]},
  {name: "added_inertia", words: "more inertia", unit: "direct solver, Eq. 9-14", range: [0, 16, 1]},
  {name: "leapfrog", words: "leapfrog <small>second order in time</small>", tick: true},
  {name: "ratio", words: "mass ratio", unit: "of one body, for a new run", range: [-2, 4, 0.1],
   log: true},
  {name: "tilt", words: "gravity", unit: "tilted by [degrees]", range: [-90, 90, 1]},
  {name: "speed", words: "motor speed", unit: "[rad/s or m/s]", motor: true},
  {name: "strength", words: "motor strength", unit: "[N m or N]", motor: true},
];
const own_loop = {name: "own", words: "the chapter's own loop <small>its exercises alone</small>",
                  tick: true};
controls.push(own_loop);
const open_controls = 3;
// What goes with the direct solver: as chapter 9 uses it.
const with_direct = {beta: 1, newton: 8, leapfrog: 1};

// A value with its unit, as its field shows it.
function in_words(name, value) {
  const scale = controls.find(control => control.name === name)?.scale;
  return scale ? `${short(scale * value)} ms` : short(value);
}
// Why a value cannot be one of a setting, beyond what the engine checks; "" if it can.
const MOST = {iterations: 10000, substeps: 1000, projections: 1000, newton: 100};
function unfit(name, value) {
  if (!isFinite(value)) return "must be a number";
  if (name in MOST && !(Number.isInteger(value) && value <= MOST[name]))
    return `must be a whole number of at most ${MOST[name]}`;
  if (name === "h" && !(value > 0)) return "must be more than 0 ms";
  return name === "h" && value > 1 ? "must be at most 1000 ms" : "";
}

// What the address says, "?..." and "#..." alike: the latter has the last word.
function read_address() {
  return new URLSearchParams([location.search.slice(1), location.hash.slice(1)]
    .filter(Boolean).join("&"));
}
const OTHER_NAMES = ["scene", "t", "iteration", "block", "view", "theme", "only", "lit"];
const last_of = (address, name) => address.getAll(name).at(-1);

// The settings that a scene begins with, and with what the address changes of them; told(words) is
// called for what is no number.
const own_settings = (about, entry) =>
  Object.fromEntries(about.settings.map((name, k) => [name, entry.begin[k]]));
function settings_from(address, about, entry, told) {
  const settings = own_settings(about, entry);
  for (const name of about.settings)
    if (address.has(name)) {
      const value = number_from(address, name, settings[name], told), trouble = unfit(name, value);
      if (!trouble) settings[name] = value;
      else told(`The address says ${name}=${value}, which ${trouble}: it is ` +
                `${in_words(name, settings[name])}.`);
    }
  return settings;
}
// A number of the address; `other` where it is none, or not within its bounds.
function number_from(address, name, other, told, least = -Infinity, most = Infinity) {
  const word = last_of(address, name), value = Number(word);
  if (word === undefined) return other;
  if (word.trim() !== "" && value >= least && value <= most && isFinite(value)) return value;
  told(`The address says ${name}=${word}, which ` +
       (word.trim() === "" || isNaN(value) ? "is no number" : `must be from ${least} to ${most}`) +
       `: it is ${other === undefined ? "left out" : other}.`);
  return other;
}
// The settings for another scene: those that were changed go along, but for what belongs to one.
const of_one_scene = ["ratio", "speed", "strength"];
function settings_kept(settings, about, from, to) {
  const kept = own_settings(about, to);
  about.settings.forEach((name, k) => {
    if (settings[name] !== from.begin[k] && !of_one_scene.includes(name)) kept[name] = settings[name];
  });
  return to.own ? kept : {...kept, own: 0};
}

// The whole state in the address, as little as tells it.
function write_address(state, about, entry) {
  const parts = [`scene=${entry.name}`];
  about.settings.forEach((name, k) => {
    if (state.settings[name] !== entry.begin[k])
      parts.push(`${name}=${Number(state.settings[name].toPrecision(12))}`);
  });
  for (const name of ["view", "theme", "only"]) if (state[name]) parts.push(`${name}=${state[name]}`);
  if (state.t !== undefined) parts.push(`t=${Number(state.t.toPrecision(9))}`);
  if (state.iteration !== undefined) parts.push(`iteration=${state.iteration}`);
  if (state.block) parts.push(`block=${state.block}`);
  const hash = `#${parts.join("&")}`;
  try {
    if (hash !== location.hash) history.replaceState(null, "", hash);
  } catch { /* some browsers allow so many in a while: the next one will do */ }
}

// Makes the form once. changed(name, value) is called for every change.
function make_controls(form, changed) {
  const more = Object.assign(document.createElement("details"), {id: "more"});
  more.innerHTML = "<summary>more settings</summary>";
  controls.forEach((control, k) => {
    const label = document.createElement("label");
    label.innerHTML = `<span>${control.words} <small>${control.unit || ""}</small></span>` +
      (control.tick ? `<input type="checkbox">`
        : `<input type="range" aria-label="${control.words}"><input type="number" step="any">`);
    label.classList.toggle("tick", Boolean(control.tick));
    label.dataset.name = control.name;
    const [, first, second] = label.children;
    if (control.tick) first.onchange = () => changed(control.name, first.checked ? 1 : 0);
    else {
      first.oninput = () => {
        const value = control.log ? 10 ** first.value : Number(first.value);
        changed(control.name, Number(value.toPrecision(3)) / (control.scale || 1));
      };
      second.onchange = () => changed(control.name, second.value.trim() === "" ? NaN
        : Number(second.value) / (control.scale || 1));
    }
    (k < open_controls ? form : more).append(label);
    control.label = label;
  });
  const back = Object.assign(document.createElement("button"),
                             {type: "button", textContent: "reset settings"});
  back.onclick = () => changed(null);
  form.append(more, back);
  form.onsubmit = e => e.preventDefault();
}

// Why a setting has no effect beside the others, by its name.
function idle(name, {direct, own, frequency}) {
  const of_loop = ["beta", "iterations", "h", "warm", "projections", "ratio",
                   "relaxation", "tilt", "own"];
  if (own && !of_loop.includes(name)) return "the chapter's own loop does not use it";
  if (!direct && ["newton", "added_inertia"].includes(name)) return "for the direct solver alone";
  return !frequency && name === "damping" ? "soft frequency is 0: hard" : "";
}
// Shows settings in the form. `wrong` is the name of what was refused, or "".
function show_controls(settings, entry, about, wrong) {
  for (const control of controls) {
    const {label, name} = control, [, first, second] = label.children;
    label.classList.toggle("off", (control.motor && !entry.motor) ||
                                  (control === own_loop && !entry.own));
    label.classList.toggle("bad", wrong === name);
    label.title = idle(name, settings);
    for (const input of label.querySelectorAll("input")) input.disabled = label.title !== "";
    const value = settings[name] * (control.scale || 1);
    if (control.tick) {
      first.checked = value !== 0;
      continue;
    }
    let range = control.range;
    if (control.motor) {
      const most = 5 * Math.abs(entry.begin[about.settings.indexOf(name)]);
      range = [name === "speed" ? -most : 0, most, most / 100];
    }
    Object.assign(first, {min: range[0], max: range[1], step: range[2]});
    first.value = control.log ? Math.log10(value) : value;
    if (document.activeElement !== second || wrong !== name)
      second.value = Number(value.toPrecision(5));
  }
}
