// Paints a scene on a canvas: what lit.js draws, or flat faces; over it labels and the scale.
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
      found.push({n, middle: x, points: [[-u, -v], [u, -v], [u, v], [-u, v]].map(([s, t]) =>
        plus(plus(x, s, body.axes[i]), t, body.axes[j]))});
    }
  return found;
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
  if (!lit && !thing.line) thing.box = corners(thing);
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

// Flat, face by face from far to near, where nothing better can be drawn: middles decide what hides
// what. A shadow straight below each body tells how deep in the picture it is.
function paint_flat(pen, view, scene, things, colour_of, slab) {
  const below = p => slab ? drop(slab, p) : [p[0], scene.low[1], p[2]];
  pen.fillStyle = style("--panel");
  pen.fillRect(0, 0, view.width, view.height);
  pen.beginPath();
  for (const thing of things.length > 400 ? [] : things)
    if (!thing.line && thing.box) trace(pen, outline(view, hull(thing.box.map(below))));
  pen.globalAlpha = style("--shade");
  pen.fillStyle = style("--shadow");
  pen.fill();
  pen.globalAlpha = 1;
  const parts_of = thing => thing.faces?.map(face => ({...face, thing,
    depth: size(sub(view.eye, face.middle))})) || [{thing, n: upright[1], depth: thing.depth}];
  for (const {thing, n, points} of things.flatMap(parts_of).sort((a, b) => b.depth - a.depth)) {
    const light = clamp(0.25 + 0.48 * dot(n, view.light), 0.16, 0.85);
    pen.fillStyle = rgb(colour_of(thing), light);
    pen.strokeStyle = thing.line ? style("--line") : rgb(colour_of(thing), light - 0.15);
    pen.lineWidth = thing.line ? 2 : 1;
    trace_part(pen, thing, points);
    if (!thing.line) pen.fill();
    pen.stroke();
  }
}
// A polygon around points of a ground, seen from above.
function hull(points) {
  const half = sorted => sorted.reduce((kept, p) => {
    const turns = ([a, b]) => (b[0] - a[0]) * (p[2] - a[2]) - (b[2] - a[2]) * (p[0] - a[0]) <= 0;
    while (kept.length > 1 && turns(kept.slice(-2))) kept.pop();
    return [...kept, p];
  }, []);
  const sorted = points.sort((a, b) => a[0] - b[0] || a[2] - b[2]);
  return [...half(sorted), ...half([...sorted].reverse()).slice(1)];
}
// The outline of a thing that was prepared, or of one of its faces.
function trace_part(pen, thing, points = thing.ends) {
  pen.beginPath();
  if (thing.ball) pen.arc(...thing.disc, 0, 2 * Math.PI);
  else trace(pen, points);
}

// Bottom left the directions of x, y, z; bottom right a bar of known length at the centre's depth,
// and whether bodies are drawn larger than they are.
function paint_scale(pen, view, thick) {
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
  pen.textAlign = "right";
  if (thick > 1.05)
    pen.fillText(`bodies drawn up to ${thick.toPrecision(2)} times as large`, right, base + 13);
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

const FLAT = "Drawn flat: there is no graphics card, or no WebGL.";
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
  const things = [...bodies.filter(body => body.up < 0), ...(lit ? [] : lines_at(run, bodies))]
    .filter(thing => prepare(thing, view));
  const colour_of = ({still, odd}) => still ? colours.still
    : (odd ? every_second : colours)[run.label];
  if (lit) {
    render(view, scene, run, bodies, body => `rgb(${colour_of(body)})`);
    pen.drawImage(lit.canvas, 0, 0, width, height);
  } else paint_flat(pen, view, scene, things, colour_of, grounds(bodies)[0]);
  if (bodies.length) paint_way(pen, view, run, scene, time);
  paint_labels(pen, view, things);
  paint_scale(pen, view, scene.thick);
  const moving = thing => !thing.still && !thing.line, says = lit ? [] : [FLAT];
  if (run.stopped !== undefined)
    says.push(`stopped: not a number from t = ${run.stopped.toFixed(2)} s`);
  else if (time > end(run) + 1e-9) says.push(`ended at ${end(run).toFixed(2)} s`);
  if (bodies.some(moving) && !things.some(moving)) says.push("out of the picture");
  if (note.textContent !== says.join("\n")) note.textContent = says.join("\n");
  return {pen, view, bodies};
}
