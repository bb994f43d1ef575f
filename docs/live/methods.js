// The methods beside each other on the scene as it is set: time of a step, gap, energy, and the
// distance from a reference. A row of the table sets its method.
"use strict";

const SECONDS = 5, PIECES = 60, TIMED = 5;  // so many answers a run, and times: their median
// As ./wb compare calls them (comparison/compare.cpp); reduced coordinates are not in the module.
const ITERATED = {direct: 0, leapfrog: 0, projections: 0, relaxation: 1, warm: 0, substeps: 1};
const DIRECT = {...ITERATED, direct: 1, beta: 1, newton: 8, added_inertia: 0, leapfrog: 1};
const METHODS = {
  "10 iterations, warm": {...ITERATED, iterations: 10, warm: 1, beta: 0.1},
  "30 iterations": {...ITERATED, iterations: 30, beta: 0.2},
  "4 substeps of 8": {...ITERATED, iterations: 8, substeps: 4, beta: 1},
  "16 substeps of 2": {...ITERATED, iterations: 2, substeps: 16, beta: 1},
  "direct, velocities only": {...DIRECT, newton: 0},
  "direct, no added inertia": DIRECT,
  "the default": {...DIRECT, added_inertia: 8},
  "the default, 4 substeps": {...DIRECT, added_inertia: 8, substeps: 4},
  "direct, 4 substeps, warm": {...DIRECT, substeps: 4, warm: 1, leapfrog: 0},
};

// A whole run in pieces, so that no answer is late. {us, gap, energy, frames} or {failed}.
async function run_method(engine, set, parts = 1) {
  const h = settings.h / parts, every = Math.max(1, Math.round(SECONDS / PIECES / settings.h));
  const out = {gap: 0, frames: []}, times = Array(TIMED).fill(0);
  try {
    await engine.ask("make", {name: entry.name, settings: {...settings, own: 0, ...set, h}});
    for (let n = 0; n < PIECES; ++n) {
      const {samples, used, state} = await engine.ask("steps", {count: every * parts}, 20000);
      for (let k = 0; k < samples.length; k += 3) out.gap = Math.max(out.gap, samples[k + 1]);
      times[Math.floor(n * TIMED / PIECES)] += 1000 * used / every * TIMED / PIECES;
      out.energy = state[2];
      out.frames.push(state.slice(3));
      if (!isFinite(state[2])) return {failed: "numbers without end"};
    }
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    return {failed: error.message};
  }
  return {...out, us: times.sort((a, b) => a - b)[Math.floor(TIMED / 2)]};
}
// The greatest distance of a body in two runs, as long as it is below `most`; until which frame.
function distance(one, other, most, frames = Infinity) {
  let far = 0, n = 0;
  for (; n < Math.min(one.length, other.length, frames); ++n) {
    let now = 0;
    for (let k = 0; k < one[n].length; k += 7)
      now = Math.max(now, Math.hypot(...[0, 1, 2].map(c => one[n][k + c] - other[n][k + c])));
    if (!(now <= most)) break;
    far = Math.max(far, now);
  }
  return {far, n};
}
// The direct solver in shorter and shorter steps, until two runs agree to a third of the wish.
async function find_reference(engine, wish) {
  let coarse, fine, agreed = {far: 0, n: 0};
  const began = performance.now();
  for (let parts = 4; parts <= 32 && performance.now() - began < 5000; parts *= 2) {
    [coarse, fine] = [fine, await run_method(engine, METHODS["direct, no added inertia"], parts)];
    if (fine.failed) break;
    if (coarse) agreed = distance(coarse.frames, fine.frames, wish / 3);
    if (agreed.n === fine.frames.length) break;
  }
  return {...agreed, frames: fine.frames || []};
}

// Runs all of them in a module of its own, beside the one that plays.
async function compare_methods(table, use) {
  const {label, bytes} = panels.at(-1).engine, engine = Object.create(Engine.prototype);
  Object.assign(engine, {label, bytes});
  await engine.begin();
  const wish = 1e-3 * scene_size(), rows = [];
  table.hidden = false;
  const show_rows = words => {
    table.innerHTML = `<caption>${words}</caption><tr><th>method<th>µs a step<th>widest gap` +
      "<th>from the reference<th>energy, J";
    const good = rows.filter(row => !row.failed && row.gap <= wish);
    const best = good.sort((a, b) => a.us - b.us)[0];
    for (const row of rows) {
      const line = table.insertRow(), button = document.createElement("button");
      line.classList.toggle("best", row === best);
      button.textContent = row.name;
      button.title = "Set this method and begin again";
      button.onclick = () => use(METHODS[row.name]);
      line.insertCell().append(button);
      const cells = row.failed ? [row.failed] : [short(Number(row.us.toPrecision(2))), metres(row.gap),
        row.distance === null ? "—" : isFinite(row.distance) ? metres(row.distance) : "far off",
        short(row.energy)];
      for (const cell of cells) line.insertCell().textContent = cell;
      if (row.failed) line.lastChild.colSpan = 4;
    }
    return best;
  };
  show_rows("looking for a reference …");
  const reference = await find_reference(engine, wish);
  for (const [name, set] of Object.entries(METHODS)) {
    const found = await run_method(engine, set);
    const {far, n} = found.failed ? {} : distance(found.frames, reference.frames, Infinity,
                                                  reference.n);
    rows.push({name, ...found, distance: !reference.n ? null : n < reference.n ? Infinity : far});
    show_rows(`measuring: ${rows.length} of ${Object.keys(METHODS).length} …`);
  }
  const best = show_rows("");
  const held = short(reference.n * SECONDS / PIECES);
  const until = reference.n ? `The reference holds for ${held} s, to ` +
    `${metres(reference.far)}.` : "There is no reference: refinements of the step do not agree.";
  table.caption.textContent = `${entry.title}, ${SECONDS} s, step ${in_words("h", settings.h)}: ` +
    (best ? `the shortest step with gaps below ${metres(wish)} has: ${best.name}.`
      : `none keeps gaps below ${metres(wish)}.`) + ` ${until} The times are those of this browser.`;
  engine.worker.terminate();
}
