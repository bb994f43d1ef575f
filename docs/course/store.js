// What a reader has written, kept in the browser: every region by its name, with the version of the
// workbook. Another tab sees a change at once. Where the browser keeps nothing, the page does.
const KEY = "joint-workbook/";

function get(name) {
  try {
    return JSON.parse(localStorage.getItem(KEY + name));
  } catch {  // something else has written it
    return null;
  }
}
function put(name, value) {
  try {
    localStorage.setItem(KEY + name, JSON.stringify(value));
  } catch {
    keep_in_page();  // docs/page.js
    put(name, value);
  }
}

/// {"1.3#2": lines} of what is kept of these regions.
export const kept = names => Object.fromEntries(
  names.map(name => [name, get(name)?.lines]).filter(([, lines]) => lines));
/// Keeps the lines of a region.
export const keep = (name, lines, version) => put(name, {version, lines});
export const forget = name => localStorage.removeItem(KEY + name);

/// Remembers that the tests have passed with these lines of an exercise, {"1.3#2": lines}.
export const mark = (id, lines, version) => put(`done/${id}`, {version, lines});
export const unmark = id => forget(`done/${id}`);
/// Whether the tests have passed with the lines that are kept now.
export function is_done(id, version) {
  const passed = get(`done/${id}`);
  return passed?.version === version &&
    JSON.stringify(kept(Object.keys(passed.lines))) === JSON.stringify(passed.lines);
}

/// The names of regions of a chapter that are kept and have no place in it any more.
export const homeless = (chapter, names) =>
  Object.keys(localStorage).filter(key => key.startsWith(`${KEY}${chapter}.`))
    .map(key => key.slice(KEY.length)).filter(name => !names.includes(name));

/// Calls changed(name) when another tab has kept or forgotten something.
export function listen(changed) {
  addEventListener("storage", ({key}) => {
    if (key?.startsWith(KEY)) changed(key.slice(KEY.length));
  });
}
