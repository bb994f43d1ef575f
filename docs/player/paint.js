// Paints a scene on a canvas: ground, shadows, bodies, lines, labels and the scale.
"use strict";

// -------------------------------------------------------------------------------------- painting
const style = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const parts = name => [1, 3, 5].map(at => parseInt(style(name).slice(at, at + 2), 16));  // #rrggbb
const colours = {yours: parts("--yours"), "the solution": parts("--solution"),
                 still: parts("--still"), line: parts("--line")};
const every_second = {yours: parts("--yours-next"), "the solution": parts("--solution-next")};
const rgb = (colour, light) => {  // light 0 .. 1: darker than the colour below 0.5, paler above
  const s = 2 * light - 1;
  return `rgb(${colour.map(c => Math.round(c + s * (s < 0 ? 0.75 * c : 0.55 * (255 - c))))})`;
};
const trace = (pen, points) => {
  points.forEach((p, i) => i ? pen.lineTo(p[0], p[1]) : pen.moveTo(p[0], p[1]));
  pen.closePath();
};

// The faces of a box for which wanted(n, x) holds: n looks outwards, x is the middle.
function faces(body, wanted) {
  const found = [];
  for (let k = 0; k < 3; ++k)
    for (const side of [1, -1]) {
      const n = body.axes[k].map(c => side * c), x = plus(body.x, body.half[k], n);
      if (!wanted(n, x)) continue;
      const i = (k + 1) % 3, j = (k + 2) % 3, u = side * body.half[i], v = body.half[j];
      found.push({n, points: [[-u, -v], [u, -v], [u, v], [-u, v]].map(([s, t]) =>
        plus(plus(x, s, body.axes[i]), t, body.axes[j]))});
    }
  return found;
}
const circle = Array.from({length: 24}, (_, i) => i * Math.PI / 12);
const ring = ball => ({points: circle.map(angle => plus(
  plus(ball.x, ball.half[0] * Math.cos(angle), upright[2]), ball.half[0] * Math.sin(angle),
  upright[0]))});

// The ground: the top of a slab that is recorded as one, else as low as anything ever gets. Its
// lines fade outwards and stand still in the world, so that one sees what moves. A shadow straight
// below each body tells how deep in the picture it is. It is painted first and hides nothing.
function ground_of(scene, run, bodies) {
  const slab = grounds(bodies)[0];
  if (!slab) return {origin: [0, scene.low[1], 0], u: upright[0], v: upright[2], n: upright[1],
                     ends: [Infinity, Infinity], drop: p => [p[0], scene.low[1], p[2]]};
  const [i, j] = [0, 1, 2].filter(k => k !== slab.up), n = slab.axes[slab.up];
  const up = n.map(c => Math.sign(n[1]) * c);
  return {origin: plus(slab.x, slab.half[slab.up], up), u: slab.axes[i], v: slab.axes[j], n: up,
          ends: run.endless ? [Infinity, Infinity] : [slab.half[i], slab.half[j]],
          drop: p => drop(slab, p)};
}
function paint_ground(pen, view, scene, run, bodies) {
  const cell = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500].find(
    c => view.reach / c < 14 && (c >= 1 || view.reach < 1.4)) || 1000;
  const ground = ground_of(scene, run, bodies), {origin, u, v, ends} = ground;
  const n = Math.ceil(view.reach / cell) + 2, from = sub(view.centre, origin);
  const [cu, cv] = [u, v].map(axis => Math.round(dot(axis, from) / cell) * cell);
  const fades = Array.from({length: 10}, () => new Path2D());
  const node = (s, t) => project(view, plus(plus(origin, s, u), t, v));
  const cut = (x, k) => clamp(x, -ends[k], ends[k]);
  const piece = (level, s1, t1, s2, t2) => {
    const a = node(cut(s1, 0), cut(t1, 1)), b = node(cut(s2, 0), cut(t2, 1));
    if (Math.min(a[2], b[2]) < view.near) return;  // in pieces, so leaving one out is enough
    fades[level].moveTo(a[0], a[1]);
    fades[level].lineTo(b[0], b[1]);
  };
  for (let i = -n; i <= n; ++i)
    for (let j = -n; j < n; ++j) {
      const level = Math.floor(10 * (1 - Math.hypot(i, j + 0.5) / n));
      if (level < 0) continue;
      const [s, t] = [cu + i * cell, cv + i * cell];
      const [at, up] = [j * cell, (j + 1) * cell];
      if (Math.abs(s) <= ends[0]) piece(level, s, cv + at, s, cv + up);
      if (Math.abs(t) <= ends[1]) piece(level, cu + at, t, cu + up, t);
    }
  pen.strokeStyle = style("--grid");
  fades.forEach((fade, level) => { pen.globalAlpha = 0.05 * (level + 1); pen.stroke(fade); });
  if (isFinite(ends[0])) {  // where it ends
    pen.globalAlpha = 0.35;
    pen.beginPath();
    trace(pen, outline(view, [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(
      ([s, t]) => plus(plus(origin, s * ends[0], u), t * ends[1], v))));
    pen.stroke();
  }
  pen.beginPath();
  for (const body of bodies.length > 400 ? [] : bodies)  // a crowd casts none, to stay smooth
    if (body.up < 0)
      for (const face of body.ball ? [ring(body)] : faces(body, n => n[1] > 0))
        trace(pen, outline(view, face.points.map(ground.drop)));
  pen.globalAlpha = style("--shade");
  pen.fillStyle = style("--shadow");
  if (dot(ground.n, sub(view.eye, origin)) > 0) pen.fill();
  pen.globalAlpha = 1;
}

// The way that the travellers have come, where it is long.
function paint_way(pen, view, run, scene, time) {
  if (scene.travel < 4) return;
  const last = Math.min(time, end(run)), count = Math.ceil(120 * last / scene.end) || 1;
  const points = Array.from({length: count + 1}, (_, i) =>
    project(view, centre_of(scene, bodies_at(run, last * i / count))));
  pen.beginPath();
  points.forEach((p, i) => {
    if (p[2] > view.near)
      i && points[i - 1][2] > view.near ? pen.lineTo(p[0], p[1]) : pen.moveTo(p[0], p[1]);
  });
  pen.strokeStyle = rgb(colours[run.label], 0.65);
  pen.globalAlpha = 0.7;
  pen.lineWidth = 1.2;
  pen.setLineDash([5, 4]);
  pen.stroke();
  pen.setLineDash([]);
  pen.globalAlpha = 1;
}

// Works out what of a thing is to be seen: its outlines on the picture, its depth, its frame.
// Returns false when it is behind the camera or out of the picture.
function prepare(thing, view) {
  let points = outline(view, [thing.x]);
  thing.depth = size(sub(view.eye, thing.x));
  thing.under = [];
  if (thing.line) points = thing.ends = outline(view, thing.ends);
  else if (thing.ball)
    points = points.flatMap(([x, y, depth]) => {
      const r = Math.max(thing.half[0] * view.focal / depth, 2.5);  // [pixels], never lost to view
      thing.disc = [x, y, r];
      return [[x - r, y - r], [x + r, y + r]];
    });
  else {
    thing.faces = faces(thing, (n, x) => dot(n, sub(view.eye, x)) > 0);
    for (const face of thing.faces) face.points = outline(view, face.points);
    points = thing.faces.flatMap(face => face.points);
  }
  const xs = points.map(p => p[0]), ys = points.map(p => p[1]);
  [thing.left, thing.right] = [Math.min(...xs) - 1, Math.max(...xs) + 1];
  [thing.top, thing.bottom] = [Math.min(...ys) - 1, Math.max(...ys) + 1];
  return thing.right > 0 && thing.left < view.width && thing.bottom > 0 && thing.top < view.height;
}

function paint(pen, thing, view, colour) {
  if (thing.line) {
    pen.strokeStyle = rgb(colours.line, 0.5);
    pen.lineWidth = clamp(2.4 * view.distance / thing.depth, 1, 8);
    pen.beginPath();
    trace(pen, thing.ends);
    pen.stroke();
  } else if (thing.ball) {
    const [x, y, r] = thing.disc;
    const shade = pen.createRadialGradient(x - 0.3 * r, y - 0.4 * r, 0, x, y, r);
    [0.9, 0.62, 0.43, 0.22].forEach((light, i) => shade.addColorStop(i / 3, rgb(colour, light)));
    pen.fillStyle = shade;
    pen.beginPath();
    pen.arc(x, y, r, 0, 2 * Math.PI);
    pen.fill();
  } else {
    const large = thing.right - thing.left > 24;  // a small one gets bolder instead of edges
    for (const {n, points} of thing.faces) {
      const light = clamp(0.25 + 0.48 * dot(n, view.light), 0.16, 0.85);
      pen.fillStyle = rgb(colour, light);
      pen.strokeStyle = rgb(colour, large ? light - 0.1 : light);
      pen.lineWidth = large ? 0.8 : 1.3;
      pen.beginPath();
      trace(pen, points);
      pen.fill();
      pen.stroke();
    }
  }
}

// Bottom left the directions of x, y, z; bottom right a bar of known length at the centre's depth.
function paint_scale(pen, view) {
  pen.strokeStyle = pen.fillStyle = style("--quiet");
  pen.lineWidth = 1.5;
  pen.font = "12px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  const x = 42, y = view.height - 40, metre = view.focal / view.distance;
  const fits = c => c * metre > 16 && c * metre < 0.6 * view.width;
  const length = [1, 10, 100, 0.1].find(fits) || 1000;
  const right = view.width - 20, left = right - length * metre, base = view.height - 22;
  pen.beginPath();
  upright.forEach((n, k) => {
    const [dx, dy] = [dot(n, view.right), -dot(n, view.up)];
    pen.moveTo(x, y);
    pen.lineTo(x + 20 * dx, y + 20 * dy);
    if (Math.hypot(dx, dy) > 0.2) pen.fillText("xyz"[k], x + 29 * dx, y + 29 * dy);
  });
  for (const [px, py] of [[left, -4], [left, 4], [left, 0], [right, 0], [right, -4], [right, 4]])
    py === -4 ? pen.moveTo(px, base + py) : pen.lineTo(px, base + py);
  pen.stroke();
  pen.fillText(`${length} m`, (left + right) / 2, base - 13);
}

// The names of those bodies that have one, above them.
function paint_labels(pen, view, things) {
  pen.font = "14px system-ui, sans-serif";
  pen.textAlign = "center";
  pen.textBaseline = "bottom";
  pen.fillStyle = style("--ink");
  for (const thing of things)
    if (thing.label) pen.fillText(thing.label, (thing.left + thing.right) / 2, thing.top - 4);
}

// Paints a run at a time; returns what else may be painted over it, null for a canvas without size.
function draw({canvas, run, note}, scene, time) {
  const width = canvas.clientWidth, height = canvas.clientHeight, pen = canvas.getContext("2d");
  if (!width || !height) return null;
  canvas.width = Math.round(width * devicePixelRatio);  // clears it, too
  canvas.height = Math.round(height * devicePixelRatio);
  pen.scale(devicePixelRatio, devicePixelRatio);
  pen.lineJoin = pen.lineCap = "round";
  const bodies = bodies_at(run, time);
  const view = view_of(scene, width, height, camera, followed(scene, bodies));
  const things = [...bodies.filter(body => body.up < 0), ...lines_at(run, bodies)]
    .filter(thing => prepare(thing, view));
  paint_ground(pen, view, scene, run, bodies);
  if (bodies.length) paint_way(pen, view, run, scene, time);
  for (const thing of painters_order(things, view.eye))
    paint(pen, thing, view, thing.still ? colours.still
      : (thing.odd ? every_second : colours)[run.label]);
  paint_labels(pen, view, things);
  paint_scale(pen, view);
  const moving = thing => !thing.still && !thing.line, says = [];
  if (run.stopped !== undefined)
    says.push(`stopped: not a number from t = ${run.stopped.toFixed(2)} s`);
  else if (time > end(run) + 1e-9) says.push(`ended at ${end(run).toFixed(2)} s`);
  if (bodies.some(moving) && !things.some(moving)) says.push("out of the picture");
  if (note.textContent !== says.join("\n")) note.textContent = says.join("\n");
  return {pen, view, bodies};
}
