// A reader's code beside the solution: the scenes in which it moves the bodies differently, since
// when, and in which row of which joint; the solution as an outline over the reader's bodies.
"use strict";

const LONG = 4, SHORT = 1;    // what is compared: of the scene that comes first, of the others [s]
const MOST_COMPARED = 1000;   // steps
const EQUAL = 1e-6;           // places [m] and quaternions: rounding grows to less in that time
let parting = [];             // the scenes with a difference, {found, own, far}
let all_compared = false;     // no other scene has one
let parted = null;            // the difference() of the scene that is shown
let parted_with = "";         // and the settings for which it was found
let rested = false;           // this run has stopped where the reader's bodies leave the picture

// What is known of the run that is shown, unless a setting or a hand has changed it.
const is_compared = () => parted_with === JSON.stringify(settings);
const parted_here = () => straight && is_compared() ? parted : null;
const compared = () => panels.length === 2 && Boolean(data.chapter);

// The poses of all bodies after each step, as far as the code comes.
async function recorded({engine}, name, settings, count, patience) {
  try {
    await engine.ask("make", {name, settings}, patience);
    return await engine.ask("record", {count, every: 1}, patience);
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    return {frames: [], ended: error.message};
  }
}
// Which body is farthest from its place in another frame, and how far [m].
function farthest(frame, other) {
  let most = {body: 0, far: 0};
  for (let k = 0; 7 * k < frame.length; ++k) {
    const [p, q] = [frame, other].map(one => one.slice(7 * k, 7 * k + 3)), far = size(sub(p, q));
    if (!(far <= most.far)) most = {body: k, far};
  }
  return most;
}
// What parts the two codes in a scene: {step, t} after which the bodies are elsewhere, or one code
// has ended; all poses; how far the bodies are apart after each step. null where nothing does.
async function find_difference(name, settings, seconds) {
  const count = Math.min(Math.round(seconds / settings.h), MOST_COMPARED);
  const began = performance.now(), right = await recorded(panels[1], name, settings, count);
  const slow = 3000 + 10 * (performance.now() - began);  // a busy machine is no code without end
  const mine = await recorded(panels[0], name, settings, count, slow);
  const both = mine.frames.slice(0, right.frames.length);
  const step = both.findIndex((frame, k) =>
    !frame.every((x, i) => Math.abs(x - right.frames[k][i]) < EQUAL));
  if (step < 0 && (!mine.ended || right.ended)) return null;
  const found = {name, settings, ended: mine.ended || "", step: step < 0 ? both.length : step};
  found.t = found.step * settings.h;
  if (step < 0) return {...found, t: Math.max(found.t - settings.h, 0)};  // it began that step
  found.poses_at = k => [both[k], right.frames[k]];
  found.apart = both.map((frame, k) => farthest(frame, right.frames[k]).far);
  found.far = Math.max(...found.apart);
  return found;
}
const differences_found = new Map();
function difference(...of) {
  const key = JSON.stringify(of);
  if (!differences_found.has(key)) differences_found.set(key, find_difference(...of));
  return differences_found.get(key);
}

// Of all rows of the solution the one whose error is larger by most with the reader's poses.
async function find_row({name, settings, poses_at}, step) {
  const [, {engine}] = panels, poses = poses_at(step), {body, far} = farthest(...poses);
  if (!poses[0].every(isFinite)) return {body, row: null, t: step * settings.h};
  await engine.ask("make", {name, settings});
  await engine.ask("steps", {count: step});
  const [mine, right] = await Promise.all(poses.map(async one => {
    const {rows} = await engine.ask("rows", {poses: one});
    return Array.from({length: rows.length / 9},
                      (_, k) => Array.from(rows.slice(9 * k, 9 * k + 9)));
  }));
  let most = null;
  for (const [joint, row, body1, body2, error, moves, ...direction] of mine) {
    const other = right.find(one => one[0] === joint && one[1] === row)?.[4] || 0;
    const more = Math.abs(error) - Math.abs(other);
    if (more > Math.max(EQUAL, 0.05 * far) && !(more <= most?.more))
      most = {joint, row, body1, body2, error, other, moves, direction, more};
  }
  return {body, row: most, t: step * settings.h};
}

// The scenes in which the codes part; those that the chapter opens come first.
async function find_where_they_part(usual) {
  parting = [];
  if (!compared()) return;
  for (const found of [usual, ...about.scenes.filter(each => each !== usual)])
    for (const own of !found.own ? [0] : data.chapter === 6 ? [1, 2, 0] : [1, 0]) {
      if (parting.some(one => one.found === found)) continue;
      const settings = {...own_settings(about, found), ...of_chapter(own)};
      const one = await difference(found.name, settings, found === usual ? LONG : SHORT);
      if (one) parting.push({found, own, far: one.far, ended: one.ended && !one.poses_at});
      if (parting.filter(one => one.ended).length > 2) return;  // each may have taken a second
    }
  all_compared = true;
}
// The first in which it can be seen, else the first.
const first_parting = () => parting.find(({far}) => !(far < 0.1)) || parting[0];

// Whether most of the bodies that move are outside of what the camera keeps in view.
function has_left(frame) {
  const beyond = 0.1 * scene_size(), {low, high, runs: [{bodies}]} = scene;
  const moving = bodies.flatMap((body, k) => body.still ? [] : [frame.slice(7 * k, 7 * k + 3)]);
  return 2 * moving.filter(x => !x.every(
    (c, i) => c > low[i] - beyond && c < high[i] + beyond)).length > moving.length;
}
// The scene as it is about to begin; the engines are to make it anew.
async function compare() {
  if (!compared()) return;
  parted = await difference(entry.name, settings, LONG);
  parted_with = JSON.stringify(settings);
  if (parted?.poses_at && !parted.where) {
    const seen = parted.apart.findIndex(far => !(far < 0.01 * scene_size()));
    const out = parted.apart.findIndex((_, k) => has_left(parted.poses_at(k)[0]));
    parted.until = out < 0 ? Infinity : out - 1;
    for (const step of [parted.step, seen, parted.until]) {  // joints may open later
      const later = step > parted.step && step <= parted.until && step < Infinity;
      if (parted.where && !later) continue;
      const where = await find_row(parted, step);
      if (!parted.where?.row && (where.row || !parted.where)) parted.where = where;
    }
  }
  $("parted").textContent = parting_words();
  for (const tab of $("scenes").children)
    tab.classList.toggle("parts", parting.some(({found}) => found.name === tab.name));
}
// How many of so many steps to play: where the reader's bodies leave the picture the run rests.
function steps_shown(count) {
  if (!(parted_here()?.until < Infinity) || rested) return count;
  const left = Math.max(0, parted.until - Math.round(time / settings.h));
  if (left) return Math.min(count, left);
  rested = true;
  play(false);
  return 0;
}

// ---------------------------------------------------------------------------------- in words
function row_words({row, moves, direction}) {
  const axis = direction.findIndex(c => Math.abs(c) > 0.999 * size(direction));
  return (row ? `row ${row}` : "one-sided row") +
    (axis < 0 ? "" : `, ${moves ? "along" : "about"} ${"xyz"[axis]},`);
}
const amount = ({moves}, error) => !(Math.abs(error) < 1e3) ? "beyond all bounds"
  : moves ? metres(Math.abs(error))
  : Math.abs(error) < 1e-6 ? "below 1e-6 rad" : `${short(Math.abs(error))} rad`;

function parting_words() {
  const elsewhere = parting.some(({found}) => found.name !== entry.name);
  const said = [];
  if (!parted && (elsewhere || !all_compared)) {
    said.push("In this scene your code moves the bodies as the solution does" +
              (elsewhere ? ", but not in those with a dot." : "."));
  } else if (!parted) {
    said.push("Your code moves the bodies of every scene as the solution does." +
              (data.report ? " None of them reaches what the check has found." : ""));
  } else {
    const when = `at t = ${parted.t.toFixed(2)} s (step ${parted.step})`;
    const next = parted.apart?.[parted.until + 1], {row} = parted.where || {};
    const from = `Your code parts from the solution ${when}`;
    if (!parted.poses_at) said.push(`Your code stops ${when}: ${parted.ended.replace(/\.$/, "")}.`);
    else if (!parted.poses_at(parted.step)[0].every(isFinite))
      said.push(`${from}: the places of your bodies are no numbers any more.`);
    else if (row)
      said.push(from + (parted.where.t > parted.t ? ", and at " +
                        `t = ${parted.where.t.toFixed(2)} s it is seen` : ",") +
                ` at the ringed joint: the error of its ${row_words(row)} is ` +
                `${amount(row, row.error)}, the solution's ${amount(row, row.other)}.`);
    else said.push(`${from}, at the ringed body. No joint opens there.`);
    if (parted.far < 0.02 * scene_size())
      said.push(`Within ${LONG} s no body is more than ${metres(parted.far)} from its place: too ` +
                "little to be seen.");
    if (parted.until < Infinity)
      said.push(`It is shown up to t = ${(parted.until * settings.h).toFixed(2)} s` +
                (next < Infinity ? ": a step later one of your bodies is " +
                 `${next < 1e3 ? metres(next) : "over a kilometre"} from its place.` : "."));
    if (data.right) said.push("The check finds your code right: rounding may grow to that.");
    if (elsewhere) said.push("They part in the other scenes with a dot, too.");
  }
  return said.join(" ") + (data.report ? `\n${data.report}` : "");
}

// ---------------------------------------------------------------------------------- painting
function paint_outline({pen, view}, run) {
  const bodies = bodies_at(run, 0);
  pen.strokeStyle = panel_colour({label: run.label});
  pen.lineWidth = 2;
  for (const thing of [...bodies.filter(body => !body.still && body.up < 0),
                       ...lines_at(run, bodies)]) {
    if (!prepare(thing, view)) continue;
    for (const face of thing.faces || [{}]) {
      trace_part(pen, thing, face.points);
      pen.stroke();
    }
  }
}
// Where the joint is that parted first: between these bodies.
function place_of_parting(run, bodies) {
  const {body, row} = parted.where, mark = row && run.marks[row.joint];
  const line = row && !run.marks.length && run.lines[row.joint];
  if (mark) return world(bodies[mark[0]], mark[1]);
  if (!line) return bodies[row ? row.body2 : body].x;
  const [p, q] = [world(bodies[line[0]], line[1]), world(bodies[line[2]], line[3])];
  return plus(p, 0.5, sub(q, p));
}
// A ring around that joint, from that moment on: where the reader's bodies are, or, once they have
// left the picture, the solution's.
function paint_parting({pen, view, bodies}, run, other) {
  if (!parted_here()?.where || (time < parted.t - 1e-9 && !rested)) return;
  const at = [bodies, bodies_at(other, 0)].map(all => project(view, place_of_parting(run, all)))
    .find(p => on_picture(view, p));
  if (!at) return;
  pen.font = "600 14px system-ui, sans-serif";
  pen.textAlign = at[0] > view.width / 2 ? "right" : "left";
  pen.textBaseline = "middle";
  const words = `parted at ${parted.t.toFixed(2)} s`;
  const x = at[0] + (at[0] > view.width / 2 ? -22 : 22);
  for (const [colour, width] of [["--panel", 6], ["--ink", 2.5]]) {
    pen.strokeStyle = style(colour);
    pen.lineWidth = width;
    pen.beginPath();
    pen.arc(at[0], at[1], 15, 0, 2 * Math.PI);
    pen.stroke();
    if (width > 3) pen.strokeText(words, x, at[1]);
  }
  pen.fillStyle = style("--ink");
  pen.fillText(words, x, at[1]);
}
