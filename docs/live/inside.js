// Within a step: each joint coloured by what is left of its velocity error, impulses as arrows.
"use strict";

const numbers_of_joint = 10;  // body1, body2, place, error, impulse, next

// From little error to much: dark to bright would be lost on the bodies, so the size tells it too.
const error_colours = ["--little-error", "--some-error", "--much-error"].map(parts);
// Where an error stands among those of its step: 1 as large as the largest at the beginning, 0 a
// thousandth of that and less.
function error_place(error, first) {
  return clamp(1 + Math.log10(Math.max(error, 1e-12) / Math.max(first, 1e-9)) / 3, 0, 1);
}
const largest_error = joints => joints.reduce((most, one) => Math.max(most, one.error), 0);
function error_colour(of_first) {
  const place = 2 * of_first, k = Math.min(Math.floor(place), 1), s = place - k;
  const [from, to] = error_colours.slice(k, k + 2);
  return `rgb(${from.map((c, i) => Math.round(c + s * (to[i] - c)))})`;
}

function joints_of(numbers) {
  const found = [];
  for (let k = 0; k < numbers.length; k += numbers_of_joint) {
    const part = Array.from(numbers.slice(k, k + numbers_of_joint));
    found.push({place: part.slice(2, 5), error: part[5], impulse: part.slice(6, 9),
                next: part[9] === 1});
  }
  return found;
}

// The head of an arrow, shorter where the arrow is.
function arrow_head(pen, [x1, y1], [x2, y2], whole) {
  const length = Math.hypot(x2 - x1, y2 - y1), head = Math.min(12, 0.5 * whole);
  if (!(length > 0 && whole > 3)) return;
  const [u, v] = [(x2 - x1) / length, (y2 - y1) / length];
  pen.beginPath();
  for (const side of [-1, 1]) {
    pen.moveTo(x2, y2);
    pen.lineTo(x2 - head * (u + side * 0.5 * v), y2 - head * (v - side * 0.5 * u));
  }
  pen.stroke();
}

const on_picture = ({width, height}, [x, y]) => x > 5 && x < width - 5 && y > 5 && y < height - 5;
// How long an arrow is for an impulse of 1 N s [m]: the longest has 70 pixels, or fewer where one
// would leave the picture.
function arrow_reach(view, joints) {
  const largest = Math.max(...joints.map(joint => size(joint.impulse)), 1e-12);
  let reach = 70 * view.distance / view.focal / largest;
  for (const {place, impulse} of joints.filter(one => on_picture(view, project(view, one.place))))
    while (!on_picture(view, project(view, plus(place, reach, impulse)))) reach *= 0.9;
  return reach;
}
// Paints over a picture; the first argument is what draw() of the player returned.
function paint_impulses({pen, view}, joints) {
  const reach = arrow_reach(view, joints);
  for (const {place, impulse} of joints)
    stroke(pen, view, [place, plus(place, reach, impulse)], "--ink", {width: 2.2, head: true});
}
function paint_inside(painted, joints, first) {
  const {pen, view} = painted;
  paint_impulses(painted, joints);
  for (const {place, error, next} of joints) {
    const at = project(view, place), much = error_place(error, first);
    if (at[2] < view.near) continue;
    pen.strokeStyle = style("--ink");
    pen.fillStyle = error_colour(much);
    pen.lineWidth = next ? 3 : 1;
    pen.beginPath();
    pen.arc(at[0], at[1], 4 + 5 * much + (next ? 2 : 0), 0, 2 * Math.PI);
    pen.fill();
    pen.stroke();
  }
}
