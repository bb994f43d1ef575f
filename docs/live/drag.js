// A finger or a key takes a body: a hand in the engine holds it by a soft joint.
"use strict";

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
function hold(panel, body, point) {
  const {x, axes} = panel.painted.bodies[body];
  straight = false;
  had.hand = true;
  held = {panel, body, point, local: axes.map(n => dot(n, sub(point, x)))};
  in_line(() => ask_all("grab", {body, point}));
  if (!playing) play(true);
}
function pull(point) {
  held.point = point;
  in_line(() => ask_all("move", {point}));
}
function let_go() { in_line(() => ask_all("let_go", {})).then(() => { held = null; ask(); }); }
const can_take = panel => panel.painted && !panel.stopped && !settings.own;

// On the picture enter takes a body, tab the next one, arrows pull it, escape lets go. Behind the
// last body tab leaves the picture as it does everywhere.
const pulls = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
function take_by_keys(panel, e) {
  if (!can_take(panel) || e.ctrlKey || e.metaKey || e.altKey) return;
  const {view, bodies} = panel.painted;
  const all = bodies.flatMap((body, k) => body.still || body.up >= 0 ? [] : [k]);
  const at = held?.keyed && held.panel === panel ? all.indexOf(held.body) : -1;
  const next = e.key === "Enter" ? (at + 1) % all.length
    : e.key === "Tab" && at >= 0 ? at + (e.shiftKey ? -1 : 1) : undefined;
  if (all[next] !== undefined) {
    hold(panel, all[next], bodies[all[next]].x);
    held.keyed = `body ${next + 1} of ${all.length}`;
  } else if (at >= 0 && pulls[e.key] && !e.shiftKey) {
    const pixels = 24 * -dot(sub(held.point, view.eye), view.back) / view.focal;
    const [x, y] = pulls[e.key];
    pull(plus(plus(held.point, x * pixels, view.right), y * pixels, view.up));
  } else {
    if (at >= 0 && (e.key === "Escape" || e.key === "Tab")) let_go();
    return;
  }
  e.preventDefault();
  e.stopImmediatePropagation();
}
function take(panel, e) {
  const found = can_take(panel) && under_finger(panel, e);
  if (!found) return null;
  const box = panel.canvas.getBoundingClientRect(), {view} = panel.painted;
  const point = at => point_at_depth({view}, at.clientX - box.left, at.clientY - box.top,
                                     found.depth);
  hold(panel, found.k, found.within ? point(e) : panel.painted.bodies[found.k].x);
  return {move: to => { if (held) pull(point(to)); }, drop: let_go};
}
