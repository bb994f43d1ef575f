// A finger takes a body: a hand in the engine holds it by a soft joint.
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
function take(panel, e) {
  const found = panel.painted && !panel.stopped && !settings.own && under_finger(panel, e);
  if (!found) return null;
  const box = panel.canvas.getBoundingClientRect(), {view} = panel.painted;
  const point = at => point_at_depth({view}, at.clientX - box.left, at.clientY - box.top,
                                     found.depth);
  straight = false;
  held = true;
  const start = found.within ? point(e) : panel.painted.bodies[found.k].x;
  in_line(() => ask_all("grab", {body: found.k, point: start}));
  if (!playing) play(true);
  return {move: to => { in_line(() => ask_all("move", {point: point(to)})); },
          drop: () => { in_line(() => ask_all("let_go", {})).then(() => { held = false; }); }};
}
