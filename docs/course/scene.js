// The live page with the reader's code beside the solution's, below an exercise that is right.
import * as engine from "./engine.js";
import * as where from "./where.js";

const base64 = bytes => {
  let text = "";
  for (let k = 0; k < bytes.length; k += 1 << 15)
    text += String.fromCharCode(...bytes.subarray(k, k + (1 << 15)));
  return btoa(text);
};

/// What is not written yet is taken from the solution.
function mixed(chapter, text) {
  const solution = answers_in(chapter.solution), mine = regions(text);
  const open = new Set(mine.filter(is_open).map(region => region.id));
  return {ids: chapter.ids.filter(id => !open.has(id)),
          text: replaced(text, region => open.has(region.id) ? solution[name_of(region)] : null)};
}

/// Builds the module and shows the page in a frame; an exercise that is wrong elsewhere in the file
/// moves the bodies wrongly, too. In a course without solutions it waits until all are written.
export async function show_live(place, chapter, text, exercise) {
  if (!engine.manifest.sizes["live.xz"]) return;
  const {ids, text: whole} = mixed(chapter, text);
  if (!chapter.solution && ids.length < chapter.ids.length) return;
  const built = await engine.build_live(chapter, whole);
  if (!built.wasm) throw new Error(`The scene cannot be built:\n${built.printed}`);
  const page = await where.text("live.html");
  const slot = /(<script type="application\/json" id="data">)([^<]*)(<\/script>)/;
  const data = JSON.parse(slot.exec(page)[2]);
  data.modules.unshift({label: "yours", wasm: base64(built.wasm)});
  Object.assign(data, {chapter: chapter.number, exercise, note: `your ${ids.join(" ")}`,
                       back: undefined});
  const words = JSON.stringify(data).replace(/</g, "\\u003c");
  const made = page.replace(slot, (_, begin, __, end) => begin + words + end);
  const dark = document.documentElement.classList.contains("dark-mode");
  const address = URL.createObjectURL(new Blob([made], {type: "text/html"}));
  place.replaceChildren(Object.assign(document.createElement("iframe"), {
    title: "A scene that moves with your code", className: "live",
    src: `${address}#theme=${dark ? "dark" : "light"}`}));
}
