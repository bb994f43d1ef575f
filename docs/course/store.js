// What a reader has written, kept in the browser: every region by its name, with the version of the
// workbook. Another tab sees a change at once.
const KEY = "joint-workbook/";

/// {"1.3#2": lines} of what is kept of these regions.
export function kept(names) {
  const found = {};
  for (const name of names) {
    const words = localStorage.getItem(KEY + name);
    if (words !== null) found[name] = JSON.parse(words).lines;
  }
  return found;
}

/// Keeps the lines of a region; false where the browser keeps nothing.
export function keep(name, lines, version) {
  try {
    localStorage.setItem(KEY + name, JSON.stringify({version, lines}));
    return true;
  } catch {
    return false;
  }
}

/// Remembers that the tests have passed with these lines of an exercise, {"1.3#2": lines}.
export function mark(id, lines, version) {
  localStorage.setItem(`${KEY}done/${id}`, JSON.stringify({version, lines}));
}
/// Whether the tests have passed with the lines that are kept now.
export function is_done(id, version) {
  const passed = JSON.parse(localStorage.getItem(`${KEY}done/${id}`) || "{}");
  return passed.version === version && Object.entries(passed.lines).every(
    ([name, lines]) => JSON.stringify(kept([name])[name]) === JSON.stringify(lines));
}

export const forget = name => localStorage.removeItem(KEY + name);

/// The names of regions of a chapter that are kept and have no place in it any more.
export function homeless(chapter, names) {
  return Object.keys(localStorage).filter(key => key.startsWith(`${KEY}${chapter}.`))
    .map(key => key.slice(KEY.length)).filter(name => !names.includes(name));
}

/// Calls changed(name) when another tab has kept or forgotten something.
export function listen(changed) {
  addEventListener("storage", ({key}) => {
    if (key?.startsWith(KEY)) changed(key.slice(KEY.length));
  });
}
