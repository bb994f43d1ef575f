// The live page with the reader's code over the solution's, below an exercise that was checked.
import * as engine from "./engine.js";
import * as where from "./where.js";

const base64 = bytes => {
  let text = "";
  for (let k = 0; k < bytes.length; k += 1 << 15)
    text += String.fromCharCode(...bytes.subarray(k, k + (1 << 15)));
  return btoa(text);
};

/// The reader's code of some exercises; all else, and what is not written yet, is the solution's.
function mixed(chapter, text, ids) {
  const solution = answers_in(chapter.solution);
  return replaced(text, region =>
    ids.includes(region.id) && !is_open(region) ? null : solution[name_of(region)]);
}
const is_written = (text, id) =>
  regions(text).some(region => region.id === id && !is_open(region));

/// Builds the module; returns a frame with the page, or null where it cannot move anything yet. A
/// course without solutions waits until all exercises are written.
/// \param ids the exercises whose code is the reader's
/// \param report what the page is to know of the check: {right} or {report: a sentence}
export async function live_frame(chapter, text, exercise, ids, report) {
  if (!engine.manifest.sizes["live.xz"] || !is_written(text, exercise)) return null;
  if (!chapter.solution && regions(text).some(is_open)) return null;
  const whole = chapter.solution ? mixed(chapter, text, ids) : text;
  const rest = chapter.solution ? chapter.ids.filter(id => !ids.includes(id)) : [];
  const built = await engine.build_live(chapter, whole);
  if (!built.wasm) throw new Error(`The scene cannot be built:\n${built.printed}`);
  const page = await where.text("live.html");
  const library = '<script src="three.min.js"></script>';  // a frame of its own has nothing beside
  const three = page.includes(library) ? await where.text("three.min.js") : "";
  const slot = /(<script type="application\/json" id="data">)([^<]*)(<\/script>)/;
  const data = JSON.parse(slot.exec(page)[2]);
  data.modules.unshift({label: "yours", wasm: base64(built.wasm)});
  const others = rest.length ? `; the solution's ${rest.join(" ")}` : "";
  Object.assign(data, {chapter: chapter.number, exercise, ...report, back: undefined, note: "your " +
    chapter.ids.filter(id => !rest.includes(id)).join(" ") + others});
  const words = JSON.stringify(data).replace(/</g, "\\u003c");
  const made = page.replace(slot, (_, begin, __, end) => begin + words + end)
    .replace(library, () => `<script>${three}</script>`);
  const dark = document.documentElement.classList.contains("dark-mode");
  const address = URL.createObjectURL(new Blob([made], {type: "text/html"}));
  return Object.assign(document.createElement("iframe"), {
    title: "A scene that moves with your code", className: "live",
    src: `${address}#theme=${dark ? "dark" : "light"}`});
}
