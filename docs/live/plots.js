// Curves on a canvas: one colour a panel, what was kept in grey behind them.
"use strict";

const floor = 1e-6;  // of the gap [m]: below it is rounding
const log10 = x => Math.log10(Math.max(x, floor));
const short = x => {  // a number for an axis or a reading
  if (!isFinite(x)) return String(x);
  if (x !== 0 && (Math.abs(x) >= 1e5 || Math.abs(x) < 1e-3)) return x.toExponential(1);
  return String(Number(x.toPrecision(3)));
};
const metres = x => x < floor ? "below 1 µm" : x < 1e-3 ? `${short(1e6 * x)} µm`
  : x < 1 ? `${short(1000 * x)} mm` : x < 1000 ? `${short(x)} m` : `${short(x / 1000)} km`;

// Logarithms of round values between two ends: whole decades, or less where there are few.
function log_ticks(low, high) {
  if (high - low > 2) return ticks(low, high, Math.min(4, high - low)).filter(x => x % 1 === 0);
  const found = [];
  for (let k = Math.floor(low); k <= high; ++k)
    for (const digit of [1, 2, 5]) found.push(k + Math.log10(digit));
  return found.filter(x => x >= low && x <= high);
}
// Round values between two ends, about `count` of them.
function ticks(low, high, count) {
  const raw = (high - low) / count || 1, ten = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].find(c => c * ten >= raw) * ten, found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high * (1 + 1e-12) + 1e-12; ++k)
    found.push(k * step);
  return found;
}

// Draws curves: [{points: [[x, y]], colour, dashed}], y being the logarithm where `log` is set.
function plot(canvas, {title, x, y, log, curves, x_unit}) {
  const width = canvas.clientWidth, height = canvas.clientHeight, pen = canvas.getContext("2d");
  if (!width || !height) return;
  canvas.width = Math.round(width * devicePixelRatio);
  canvas.height = Math.round(height * devicePixelRatio);
  pen.scale(devicePixelRatio, devicePixelRatio);
  pen.font = "12px system-ui, sans-serif";
  const titles = pen.measureText(title).width > width - 24 ? title.split("; ") : [title];
  const [left, right, top, bottom] = [64, width - 12, 20 + 12 * titles.length, height - 20];
  const at = ([px, py]) => [left + (px - x[0]) / (x[1] - x[0]) * (right - left),
                            bottom - (py - y[0]) / (y[1] - y[0]) * (bottom - top)];
  pen.fillStyle = style("--ink");
  pen.textBaseline = "middle";
  titles.forEach((words, k) => pen.fillText(words, 12, 12 + 14 * k, width - 24));
  pen.fillStyle = style("--quiet");
  pen.strokeStyle = style("--rule");
  pen.textAlign = "right";
  for (const value of log ? log_ticks(...y) : ticks(y[0], y[1], 3)) {
    const [, py] = at([x[0], value]);
    pen.fillText(log ? log(10 ** value) : short(value), left - 6, py);
    pen.beginPath();
    pen.moveTo(left, py);
    pen.lineTo(right, py);
    pen.stroke();
  }
  pen.textAlign = "center";
  for (const value of ticks(x[0], x[1], Math.max(2, width / 110)))
    pen.fillText(short(value) + (value === 0 || x_unit === "" ? "" : ` ${x_unit}`),
                 clamp(at([value, 0])[0], left, right - 12), height - 9);
  pen.textAlign = "left";
  pen.save();
  pen.beginPath();
  pen.rect(left, top - 6, right - left, bottom - top + 8);
  pen.clip();
  for (const {points, colour, dashed, dots} of curves) {
    pen.strokeStyle = pen.fillStyle = colour;
    pen.lineWidth = 1.6;
    pen.setLineDash(dashed ? [6, 5] : []);
    pen.beginPath();
    const stride = Math.ceil(points.length / (2 * width)) || 1;
    for (let i = 0; i < points.length; i += stride) {
      const [px, py] = at(points[i]);
      if (isFinite(py)) i ? pen.lineTo(px, py) : pen.moveTo(px, py);
    }
    pen.stroke();
    if (dots && points.length < 60)
      for (const [px, py] of points.map(at)) pen.fillRect(px - 2, py - 2, 4, 4);
  }
  pen.restore();
}

// The ends of an axis around these values.
function span(values, least) {
  const good = values.filter(isFinite);
  let low = Math.min(...good, 0), high = Math.max(...good, 0);
  if (!(high - low > least)) [low, high] = [low - least / 2, high + least / 2];
  const margin = 0.06 * (high - low);
  return [low - margin, high + margin];
}

const panel_colour = panel =>
  rgb(colours[panel.label], document.documentElement.dataset.theme === "dark" ? 0.68 : 0.5);

// One value of all samples of the panels over time, kept runs first. A sample is
// [time, gap, energy].
function over_time(canvas, panels, now, title, place, {log, least = 1e-9} = {}) {
  const x = [Math.max(0, now - 10), Math.max(10, now)];
  const value = sample => log ? log10(sample[place]) : sample[place];
  const curve = (samples, colour) => ({
    colour, points: samples.filter(one => one[0] >= x[0]).map(one => [one[0], value(one)])});
  const curves = [...panels.map(panel => curve(panel.kept, style("--kept"))),
                  ...panels.map(panel => curve(panel.samples, panel_colour(panel)))];
  const values = curves.flatMap(one => one.points.map(point => point[1]));
  const y = log ? [-6, Math.max(0, ...values.filter(isFinite).map(Math.ceil))] : span(values, least);
  if (parted_here()?.t >= x[0])
    curves.push({points: y.map(end => [parted.t, end]), colour: style("--ink"), dashed: true});
  const grey = panels[0].kept_with ? `; grey: kept, ${panels[0].kept_with}` : "";
  plot(canvas, {title: title + grey, x, y, log, curves, x_unit: "s"});
}

const plots = {
  gap: (canvas, panels, now) => over_time(canvas, panels, now, "largest gap", 1, {log: metres}),
  energy: (canvas, panels, now) =>
    over_time(canvas, panels, now, "energy gained since the beginning [J]", 2,
              {least: 1e-4 * panels[0].scale}),  // less is rounding
  errors(canvas, panels) {
    const bottom = -12;  // where rounding begins, about
    const curves = panels.flatMap(panel => {
      if (!panel.errors) return [];
      const {errors, rate} = panel.errors, from = Math.floor(errors.length / 3);
      const colour = panel_colour(panel), log = e => Math.max(Math.log10(e), bottom - 1);
      const predicted = errors.slice(from).map((_, k) => [from + k, log(errors[from] * rate ** k)]);
      return [{colour, dots: true, points: errors.map((e, k) => [k, log(e)])},
              ...(rate > 0 && errors.length > 4
                ? [{colour: style("--ink"), dashed: true, points: predicted}] : [])];
    });
    const values = curves.flatMap(one => one.points.map(point => point[1])), count = Math.max(
      1, ...panels.map(panel => panel.errors ? panel.errors.errors.length - 1 : 1));
    const y = values.length ? [Math.max(Math.min(...values) - 0.2, bottom),
                               Math.max(...values, bottom + 1) + 0.2] : [-3, 1];
    const rate = panels.map(panel => panel.errors && panel.errors.rate.toFixed(4)).join(" and ");
    const title = settings.direct
      ? "largest velocity error before and after the direct solver [m/s]"
      : `largest velocity error by iteration [m/s]; dashed: times ${rate} each`;
    plot(canvas, {title, x: [0, count], y, log: short, curves, x_unit: ""});
  },
};
