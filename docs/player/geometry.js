// Bodies and lines of a recorded run, and what of a scene the camera has to keep in view. Shared by
// docs/motion.html and the live page; tools/pictures/pages.py puts it into both.
"use strict";

// ---------------------------------------------------------------- small vectors, arrays of three
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const plus = (a, s, b) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];  // a + s b
const size = a => Math.sqrt(dot(a, a));
const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
const times = (s, a) => a.map(c => s * c);
const unit = a => { const length = size(a); return length > 1e-9 ? times(1 / length, a) : null; };
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]];
const upright = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

// A body's own three axes in the world: the columns of its rotation matrix.
const turned = (w, x, y, z) => [
  [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
  [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
  [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]];
const world = (body, a) => body.axes.reduce((p, n, k) => plus(p, a[k], n), body.x);
const along = (body, a) => sub(world(body, a), body.x);  // a direction of the body's own
const reach_along = (body, n) =>
  body.axes.reduce((sum, axis, k) => sum + Math.abs(dot(axis, n)) * body.half[k], 0);

// ------------------------------------------------------------------------------ what is recorded
const end = run => (run.frames.length - 1) * run.dt;

// All bodies at time t. Between two frames places are mixed, and quaternions too, then made unit
// length again: with frames this close that cannot be told from turning at constant speed.
function bodies_at(run, t) {
  const place = clamp(t / run.dt, 0, run.frames.length - 1), i = Math.floor(place), s = place - i;
  const a = run.frames[i], b = run.frames[i + 1] || a;
  return !a ? [] : run.bodies.map((body, k) => {
    const o = 7 * k, at = (j, sign) => a[o + j] + s * (sign * b[o + j] - a[o + j]);
    let same = 0;  // q and -q are one rotation: go the short way
    for (let j = 3; j < 7; ++j) same += a[o + j] * b[o + j];
    const q = [3, 4, 5, 6].map(j => at(j, same < 0 ? -1 : 1)), length = Math.hypot(...q) || 1;
    return {ball: body.ball, still: body.still, half: body.half, odd: k % 2 === 1,
            label: body.label, up: body.up, x: [at(0, 1), at(1, 1), at(2, 1)],
            axes: turned(...q.map(c => c / length))};
  });
}

// The lines as thin bodies with two ends.
const lines_at = (run, bodies) => (bodies.length ? run.lines : []).map(
  ([one, anchor1, two, anchor2]) => {
    const ends = [world(bodies[one], anchor1), world(bodies[two], anchor2)];
    return {line: true, ends, x: ends[0]};
  });

const corners = body => [0, 1, 2, 3, 4, 5, 6, 7].map(bits =>
  (body.ball ? upright : body.axes).reduce(
    (p, n, k) => plus(p, bits >> k & 1 ? body.half[k] : -body.half[k], n), body.x));

// A thin static slab beside which all else is small is the ground: a grid, no body to look at.
// Returns which of its axes points up, 0 .. 2, or -1.
function up_axis(body, axes, extent) {
  const k = axes.findIndex(n => Math.abs(n[1]) > 0.7);
  const across = Math.min(...body.half.filter((_, i) => i !== k));
  return k < 0 || body.ball || body.half[k] > 0.1 * across || 2 * across < 0.6 * extent ? -1 : k;
}

// Measures a scene once: which bodies never move, and which points the camera has to keep in view.
// A run that blows up must not shrink everything else to a dot. So the solution's run (or the only
// one) counts as far as 30 times the size of its first frame, and yours a little beyond that run.
// Where nothing is ever faster than 200 m/s nothing has blown up: what flies far flies far.
function measure(scene) {
  const grow = points => {
    scene.points = scene.points.concat(points);
    [scene.low, scene.high] = [Math.min, Math.max].map(choose => [0, 1, 2].map(
      k => scene.points.reduce((c, p) => choose(c, p[k]), scene.points[0][k])));
    scene.centre = scene.low.map((c, k) => (c + scene.high[k]) / 2);
  };
  const live = scene.runs.filter(run => run.frames.length).reverse();
  for (const run of live)
    run.bodies.forEach((body, k) => {
      const pose = frame => String(frame.slice(7 * k, 7 * k + 7)), first = pose(run.frames[0]);
      body.still = run.frames.every(frame => pose(frame) === first);
      body.ball = body.kind === "ball";
      body.half = body.size.map(edge => edge / 2);
    });
  const solid = (run, t) => bodies_at(run, t).filter(body => body.up < 0).flatMap(corners);
  for (const run of live) {
    run.bodies.forEach(body => { body.up = -1; });
    const first = bodies_at(run, 0), moving = first.filter(body => !body.still).flatMap(corners);
    const along = k => moving.map(p => p[k]);
    const extent = moving.length ? Math.max(...[0, 2].map(
      k => Math.max(...along(k)) - Math.min(...along(k)))) : Infinity;
    run.bodies.forEach((body, k) => {
      if (body.still) body.up = up_axis(body, first[k].axes, extent);
    });
  }
  for (const run of live) run.endless = endless(run);
  scene.points = [];
  grow(solid(live[0], 0).concat(under(live[0], solid(live[0], 0))));
  const start = size(sub(scene.high, scene.low));
  scene.now = Infinity;  // a page that knows the time says it
  live.forEach((run, i) => {
    const stride = Math.ceil(run.frames.length * run.bodies.length / 4000), found = [];
    const far = fastest(run) < 200 ? Infinity : 15;
    const reach = (i ? 0.8 : far) * size(sub(scene.high, scene.low)), centre = scene.centre;
    for (let frame = 0; frame < run.frames.length; frame += stride)
      found.push(...solid(run, frame * run.dt));
    grow(found.filter(p => size(sub(p, centre)) < reach));
  });
  const [wide, , deep] = sub(scene.high, scene.low);
  scene.reach = 0.75 * Math.hypot(wide, deep);
  const whole = size(sub(scene.high, scene.low)), {centre} = scene;
  const during = (from, to) => {  // where things are then, as far as that is in the picture
    const stride = to > 2 ? Math.ceil(live[0].frames.length * live[0].bodies.length / 4000) : 1;
    const found = live[0].frames.flatMap((_, k) => {
      const t = k * live[0].dt;
      return t < from || t > to || k % stride ? [] : solid(live[0], t);
    }).filter(p => size(sub(p, centre)) < 0.75 * whole);
    return found.length ? found : scene.points;
  };
  const across = wide >= deep ? 0 : Math.PI / 2;  // the long side lies across the picture
  const tall = innerHeight > 1.3 * innerWidth, picture = tall ? [360, 540] : [1250, 490];
  const shown = bodies_at(live[0], 1).filter(body => body.up < 0);
  const [yaw, cover] = [0.42, 0.85, -0.42, -0.85].map(
    aside => [aside - across, covered(shown, look_from(aside - across, centre, ...picture),
                                      during(0.85, 1.15))]).reduce(
    (best, one) => one[1] > 1.15 * best[1] ? one : best);
  scene.yaw = yaw;
  scene.thick = Math.max(...live.map(run => thicken(run, Math.sqrt(0.2 / cover))));
  if (scene.thick > 1)  // bodies reach farther now; what the scene measures stays as it is
    scene.points = scene.points.concat(during(0, Infinity));
  scene.first = during(0, 0.85);  // what the camera shows until it has moved on
  scene.soon = during(0.85, 1.15);
  find_travellers(scene, live[0], start);
  scene.end = Math.max(...live.map(end));
  scene.step = scene.runs.at(-1).dt;
}

// Draws thin bodies up to so many times as large as they are, so that they can be seen, but none
// into those that it is joined to, and none where there is a ground. Returns the largest factor.
function thicken(run, most) {
  const bodies = bodies_at(run, 0), pairs = [], wide = run.bodies.map(() => 1e9);
  if (grounds(bodies).length) return 1;
  run.lines.forEach(([one, , two], k) => {
    if (one !== two) pairs.push([one, two]);
    else if (run.lines[k + 1] && k % 2 === 0) pairs.push([one, run.lines[k + 1][0]]);
  });
  for (const pair of pairs) {
    const [p, q] = pair.map(k => bodies[k]), d = sub(q.x, p.x), room = 0.98 * size(d);
    const reach = [p, q].reduce((sum, body) => sum + (body.ball ? body.half[0] : Math.min(
      ...body.axes.map((n, k) => body.half[k] * size(d) / (Math.abs(dot(n, d)) || 1e-9)))), 0);
    for (const k of pair) wide[k] = Math.min(wide[k], room / reach);
  }
  const factors = wide.map(one => one < 1e9 ? clamp(most, 1, Math.max(1, one)) : 1);
  run.bodies.forEach((body, k) => { body.half = times(factors[k], body.half); });
  return Math.max(...factors);
}

// The part of a picture that bodies cover from there, if none hides another.
function covered(bodies, view, points) {
  const {distance} = fit(view, points), area = body => body.ball ? Math.PI * body.half[0] ** 2
    : body.axes.reduce((sum, n, k) => sum + 4 * Math.abs(dot(n, view.back)) *
        body.half[(k + 1) % 3] * body.half[(k + 2) % 3], 0);
  return bodies.reduce((sum, body) => sum + area(body), 0) * (view.focal / distance) ** 2
    / view.width / view.height;
}

// The places below these points on the ground of a run; none where it has no ground.
const grounds = bodies => bodies.filter(body => body.up >= 0);
function drop(ground, p) {
  const n = ground.axes[ground.up];
  const top = plus(ground.x, Math.sign(n[1]) * ground.half[ground.up], n);
  return [p[0], top[1] - (n[0] * (p[0] - top[0]) + n[2] * (p[2] - top[2])) / n[1], p[2]];
}
// True when bodies go over the edge of the ground and stay above it: there it goes on, undrawn.
function endless(run) {
  const ground = grounds(bodies_at(run, 0))[0];
  if (!ground) return true;
  const sides = [0, 1, 2].filter(k => k !== ground.up);
  const beyond = run.frames.flatMap(frame => run.bodies.flatMap((body, k) => {
    const p = frame.slice(7 * k, 7 * k + 3), d = sub(p, ground.x);
    return !body.still && sides.some(i => Math.abs(dot(ground.axes[i], d)) > ground.half[i])
      ? [p[1] - drop(ground, p)[1]] : [];
  }));
  return beyond.length > 0 && beyond.every(height => height > 0);
}
const under = (run, points) => grounds(bodies_at(run, 0)).slice(0, 1).flatMap(
  ground => points.map(p => drop(ground, p)));

// The greatest speed of a body from frame to frame [m/s].
const fastest = run => run.frames.reduce((most, frame, i) => run.bodies.reduce((best, _, k) =>
  i ? Math.max(best, size(sub(frame.slice(7 * k, 7 * k + 3),
                              run.frames[i - 1].slice(7 * k, 7 * k + 3))) / run.dt) : 0, most), 0);

// Which bodies travel farthest: the camera can go with them. `start` is the size of the first
// frame. What is outside of the picture has blown up and is not counted.
function find_travellers(scene, run, start) {
  const reach = size(sub(scene.high, scene.low));
  const ways = run.bodies.map((body, k) => {
    const path = body.still ? [] : run.frames.map(frame => frame.slice(7 * k, 7 * k + 3))
      .filter(p => size(sub(p, scene.centre)) < reach);
    return path.length ? Math.hypot(...[0, 1, 2].map(
      i => Math.max(...path.map(p => p[i])) - Math.min(...path.map(p => p[i])))) : 0;
  });
  const way = Math.max(...ways);
  scene.travellers = ways.flatMap((each, k) => each > 0 && each >= 0.5 * way ? [k] : []);
  scene.travel = way / start;
  const spread = [0, 0];  // across and upward, of the travellers about their centre
  const stride = Math.ceil(run.frames.length / 200);
  for (let frame = 0; frame < run.frames.length; frame += stride) {
    const bodies = bodies_at(run, frame * run.dt), x = centre_of(scene, bodies);
    for (const p of scene.travellers.flatMap(k => corners(bodies[k]))) {
      const d = sub(p, x);
      if (size(d) > reach) continue;
      spread[0] = Math.max(spread[0], Math.hypot(d[0], d[2]));
      spread[1] = Math.max(spread[1], Math.abs(d[1]));
    }
  }
  scene.window = [Math.max(1.6 * spread[0], 0.08 * way), Math.max(1.6 * spread[1], 0.04 * way)];
}
function centre_of(scene, bodies) {
  const those = bodies.filter((_, k) => scene.travellers.includes(k));
  return those.reduce((sum, body) => plus(sum, 1 / those.length, body.x), [0, 0, 0]);
}
