// Joints over the picture: anchors, axes, limits and motors, and the spring of a hand.
"use strict";

// A line through points of the world; nothing where one of them is behind the camera. Filled: the
// area within it, too, pale.
function stroke(pen, view, points, colour, {width = 1.6, dashes = [], head, filled} = {}) {
  const seen = points.map(p => project(view, p));
  if (seen.some(p => p[2] < view.near)) return;
  pen.strokeStyle = style(colour);
  pen.lineWidth = width;
  pen.setLineDash(dashes);
  pen.beginPath();
  seen.forEach(([x, y], i) => i ? pen.lineTo(x, y) : pen.moveTo(x, y));
  pen.stroke();
  pen.setLineDash([]);
  if (head) arrow_head(pen, seen.at(-2), seen.at(-1), Math.hypot(
    seen.at(-1)[0] - seen[0][0], seen.at(-1)[1] - seen[0][1]));
  if (!filled) return;
  pen.globalAlpha = 0.25;
  pen.fillStyle = style(colour);
  pen.fill();
  pen.globalAlpha = 1;
}
// A circle of so many pixels around a point; filled: a dot.
function spot(pen, view, p, colour, pixels, filled) {
  const [x, y, depth] = project(view, p);
  if (depth < view.near) return;
  pen.strokeStyle = pen.fillStyle = style(colour);
  pen.lineWidth = 1.6;
  pen.beginPath();
  pen.arc(x, y, pixels, 0, 2 * Math.PI);
  filled ? pen.fill() : pen.stroke();
}

// The part of a circle about an axis from one angle to another.
function arc(at, axis, zero, radius, from, to) {
  const other = cross(axis, zero), count = Math.ceil(Math.abs(to - from) / 0.15) + 1;
  return Array.from({length: count + 1}, (_, i) => {
    const angle = from + i / count * (to - from);
    return plus(plus(at, radius * Math.cos(angle), zero), radius * Math.sin(angle), other);
  });
}
// Limits and motor of a hinge, on the side where the second body is while the angle is 0.
function paint_hinge({pen, view}, at, axis, zero, joint) {
  const flat = plus(zero, -dot(zero, axis), axis);
  const way = unit(flat) || unit(cross(axis, Math.abs(axis[0]) < 0.7 ? upright[0] : upright[1]));
  const radius = 0.7 * Math.max(size(flat), 0.3), {lower, upper} = joint;
  if (lower !== null && upper !== null) {
    const turn = Math.min(upper - lower, 2 * Math.PI);
    stroke(pen, view, [at, ...arc(at, axis, way, radius, lower, lower + turn), at], "--limit",
           {width: 2.5, filled: true});
  }
  for (const end of [lower, upper])
    if (end !== null)
      stroke(pen, view, [at, arc(at, axis, way, 1.1 * radius, end, end)[0]], "--limit",
             {width: 2.5});
  if (joint.strength > 0 && joint.speed !== 0)
    stroke(pen, view, arc(at, axis, way, 0.45 * radius, 0, 2 * Math.sign(joint.speed)), "--motor",
           {width: 3.5, head: true});
}
// Of a slider: its line, as far as it may go.
function paint_slider({pen, view}, at, axis, joint) {
  const metre = view.distance / view.focal, far = 60 * metre;
  const [from, to] = [joint.lower ?? -far, joint.upper ?? far];
  stroke(pen, view, [plus(at, from, axis), plus(at, to, axis)], "--limit",
         {width: 2, dashes: joint.lower === null ? [6, 4] : []});
  const side = unit(cross(axis, view.back)) || view.up;
  for (const end of [joint.lower, joint.upper])
    if (end !== null)
      stroke(pen, view, [-7, 7].map(pixels => plus(plus(at, end, axis), pixels * metre, side)),
             "--limit", {width: 2});
  if (joint.strength > 0 && joint.speed !== 0) {
    const beside = plus(at, 12 * metre, side), way = 40 * metre * Math.sign(joint.speed);
    stroke(pen, view, [beside, plus(beside, way, axis)], "--motor", {width: 3.5, head: true});
  }
}

// Paints over a picture; the first argument is what draw() of the player returned.
function paint_joints(painted, run, driven) {
  const {pen, view, bodies} = painted, few = run.marks.length < 40;
  for (const [one, anchor1, two, anchor2, axis] of lit ? [] : run.marks) {
    const [p, q] = [world(bodies[one], anchor1), world(bodies[two], anchor2)];
    const wide = Math.min(...[one, two].map(k => Math.max(...bodies[k].half)));
    const n = few && unit(along(bodies[one], axis));
    if (n) {
      stroke(pen, view, [plus(q, -0.7 * wide, n), plus(q, 0.7 * wide, n)], "--joint",
             {dashes: [5, 4]});
    }
    const pixels = clamp(0.6 * wide * view.focal / view.distance, 0.8, 4);
    stroke(pen, view, [p, q], "--joint");
    if (pixels > 2) spot(pen, view, p, "--joint", pixels, false);
    spot(pen, view, q, "--joint", pixels / 2, true);
  }
  for (const [one, anchor1, two, anchor2] of lit ? [] : run.lines.slice(2 * run.marks.length))
    for (const p of [world(bodies[one], anchor1), world(bodies[two], anchor2)])
      spot(pen, view, p, "--joint", 2.5, true);
  for (const joint of few ? driven : []) {
    const body = bodies[joint.body], at = world(body, joint.at), axis = along(body, joint.axis);
    if (size(joint.zero)) paint_hinge(painted, at, axis, along(body, joint.zero), joint);
    else paint_slider(painted, at, axis, joint);
  }
}

// The spring of a hand, from its body to where the hand is.
function paint_hand({pen, view, bodies}, {body, point, local}) {
  const from = world(bodies[body], local), way = sub(point, from);
  const side = unit(cross(way, view.back));
  const wide = side && 5 * view.distance / view.focal;
  const zigzag = Array.from({length: 13}, (_, i) => plus(
    plus(from, i / 12, way), side && i % 12 ? (i % 2 ? wide : -wide) : 0, side || way));
  stroke(pen, view, zigzag, "--panel", {width: 5});
  stroke(pen, view, zigzag, "--ink", {width: 2.2});
  spot(pen, view, point, "--ink", 6, true);
}
