// Where the camera stands and what it sees of a scene. `ask()` of the page paints soon.
"use strict";

// ------------------------------------------------------------------------------------ the camera
const camera = {yaw: 0, pitch: 0, zoom: 1, follow: false};  // one for both pictures

// Where the camera looks when it follows, and how much it must see across and upward: always the
// ground, too, so that a ball is seen to bounce and a shot to fly.
function followed(scene, bodies) {
  if (!camera.follow || !bodies.length || !scene.travellers.length) return null;
  const x = centre_of(scene, bodies), ground = grounds(bodies)[0], [across, upward] = scene.window;
  const floor = ground ? drop(ground, x)[1] : scene.low[1];
  const above = Math.max(x[1] - floor, 0), half = Math.max(upward, 0.6 * above);
  const y = clamp(floor + 0.6 * half, x[1] - 0.4 * half, x[1] + 0.4 * half);
  return {centre: [x[0], y, x[2]], across: Math.max(across, half), upward: half};
}

function view_of(scene, width, height, {yaw, pitch, zoom}, target = null) {
  const [sy, cy, sp, cp] = [Math.sin(yaw), Math.cos(yaw), Math.sin(pitch), Math.cos(pitch)];
  const view = {width, height, right: [cy, 0, -sy], up: [-sy * sp, cp, -cy * sp],
                back: [sy * cp, sp, cy * cp], focal: 1.6 * Math.max(width, height)};
  view.light = plus(plus([0, 0.85, 0], 0.45, view.back), -0.3, view.right);
  const shape = width / height;
  if (!target && scene.shape !== shape) {
    const from = look_from(scene.yaw, scene.centre, width, height);
    const [first, soon, whole] = [scene.first, scene.soon, scene.points].map(
      points => fit(from, points));
    const same = (one, other) => Math.abs(Math.log(one.distance / other.distance)) < 0.15 &&
      size(sub(one.centre, other.centre)) < 0.02 * other.distance;
    const second = same(soon, whole) ? whole : soon;
    Object.assign(scene, {shape, homes: [same(first, second) ? second : first, second, whole]});
  }
  const home = target ? null : home_at(scene.homes, scene.now);
  view.distance = (!target ? home.distance : view.focal * Math.max(
    target.across / (0.45 * width), target.upward / (0.4 * height))) / zoom;
  view.near = 0.02 * view.distance;
  view.centre = target ? target.centre : home.centre;
  view.reach = target ? 2.5 * target.across : scene.reach;
  view.eye = plus(view.centre, view.distance, view.back);
  return view;
}
const look_from = (yaw, centre, width, height) => view_of(null, width, height,
  {yaw, pitch: first_pitch, zoom: 1}, {centre, across: 1, upward: 1});
// The camera is close: from what a scene begins with it moves to what is seen after a second, and
// then to all of it, where these are of another size.
const home_at = ([first, second, whole], t) => t < 1
  ? between(first, second, clamp((t - 0.4) / 0.5, 0, 1))
  : between(second, whole, clamp((t - 1) / 1.2, 0, 1));
const between = (near, far, s) => ({
  centre: plus(near.centre, s * s * (3 - 2 * s), sub(far.centre, near.centre)),
  distance: near.distance + s * s * (3 - 2 * s) * (far.distance - near.distance)});
// Where to look from this direction, and from how far, so that all points are in the picture and
// fill it: once for the distance, then with the picture moved to the middle, below the caption.
function fit(view, points) {
  let centre = view.centre, distance = 0.01;
  for (let round = 0; round < 4; ++round) {
    const away = points.map(p => sub(p, centre));
    distance = away.reduce((far, d) => Math.max(far, dot(d, view.back) + view.focal * Math.max(
      Math.abs(dot(d, view.right)) / (0.49 * view.width),
      Math.abs(dot(d, view.up)) / (0.495 * view.height))), 0.01);
    if (round === 3) break;
    for (const axis of [view.right, view.up]) {
      const seen = away.map(d => dot(d, axis) / (distance - dot(d, view.back)));
      const [least, most] = [Math.min, Math.max].map(choose => seen.reduce((a, b) => choose(a, b)));
      centre = plus(centre, distance * (least + most) / 2, axis);
    }
  }
  return {centre, distance};
}
const first_pitch = 0.26;

// Where a point stands on the picture, and how far before the camera it is.
function project(view, p) {
  const d = sub(p, view.eye), depth = -dot(d, view.back), scale = view.focal / depth;
  return [view.width / 2 + scale * dot(d, view.right), view.height / 2 - scale * dot(d, view.up),
          depth];
}

// An outline on the picture, without the part that lies behind the camera.
function outline(view, points) {
  const ahead = points.map(p => dot(sub(view.eye, p), view.back) - view.near);
  if (ahead.every(depth => depth > 0)) return points.map(p => project(view, p));
  return points.flatMap((p, i) => {
    const j = (i + 1) % points.length, kept = ahead[i] > 0 ? [p] : [];
    if (ahead[i] > 0 !== ahead[j] > 0)
      kept.push(plus(p, ahead[i] / (ahead[i] - ahead[j]), sub(points[j], p)));
    return kept.map(p => project(view, p));
  });
}

// ------------------------------------------------------------------------- turned by hand
function look({yaw = camera.yaw, pitch = camera.pitch, zoom = camera.zoom}) {
  Object.assign(camera, {yaw, pitch: clamp(pitch, -0.3, 1.55), zoom: clamp(zoom, 0.2, 20)});
  ask();
}
const look_home = () => look({yaw: scene.yaw, pitch: first_pitch, zoom: 1});

// One finger turns, two zoom. take(e) may return what to do with a finger instead: {move, drop}.
function listen(canvas, take = () => null) {
  const fingers = new Map(), taken = new Map();
  const spread = ([a, b]) => Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
  canvas.onpointerdown = e => {
    canvas.setPointerCapture(e.pointerId);
    const held = !fingers.size && take(e);
    if (held) return taken.set(e.pointerId, held);
    fingers.set(e.pointerId, e);
  };
  canvas.onpointermove = e => {
    if (taken.has(e.pointerId)) return taken.get(e.pointerId).move(e);
    const old = fingers.get(e.pointerId), two = fingers.size === 2;
    if (!old) return;
    const was = two && spread([...fingers.values()]);
    fingers.set(e.pointerId, e);
    if (two) look({zoom: camera.zoom * spread([...fingers.values()]) / (was || 1)});
    else look({yaw: camera.yaw - (e.clientX - old.clientX) / 160,
               pitch: camera.pitch + (e.clientY - old.clientY) / 160});
  };
  canvas.onpointerup = canvas.onpointercancel = e => {
    if (taken.has(e.pointerId)) taken.get(e.pointerId).drop(e);
    taken.delete(e.pointerId);
    fingers.delete(e.pointerId);
  };
  canvas.ondblclick = look_home;
  canvas.addEventListener("keydown", e => {  // shift and an arrow turn, plus and minus zoom
    const turn = e.shiftKey && {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1],
                                ArrowDown: [0, -1]}[e.key];
    const zoom = {"+": 1.15, "-": 1 / 1.15}[e.key];
    if (turn) look({yaw: camera.yaw - 0.1 * turn[0], pitch: camera.pitch + 0.1 * turn[1]});
    else if (zoom) look({zoom: camera.zoom * zoom});
    else if (e.key === "0") look_home();
    else return;
    e.preventDefault();
    e.stopPropagation();
  });
  if (framed) canvas.style.touchAction = "pan-y";
  canvas.addEventListener("wheel", e => {
    if (framed && document.activeElement !== canvas) return;  // a click first, then the wheel
    e.preventDefault();
    look({zoom: camera.zoom * Math.exp(-clamp(e.deltaY, -100, 100) / 600)});
  }, {passive: false});
}
