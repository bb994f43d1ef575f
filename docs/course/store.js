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

/// Remembers that the tests have passed with these lines, until they are changed.
export function keep_done(answers, version) {
  for (const [name, lines] of Object.entries(answers))
    localStorage.setItem(KEY + name, JSON.stringify({version, lines, done: true}));
}
export const is_done = (names, version) => names.every(name => {
  const kept = JSON.parse(localStorage.getItem(KEY + name) || "{}");
  return kept.done && kept.version === version;
});

export const forget = name => localStorage.removeItem(KEY + name);

/// The names of regions of a chapter that are kept and have no place in it any more.
export function homeless(chapter, names) {
  return Object.keys(localStorage).filter(key => key.startsWith(`${KEY}${chapter}.`))
    .map(key => key.slice(KEY.length)).filter(name => !names.includes(name));
}

/// Calls changed(name, lines) when another tab has kept something; lines are null where it forgot.
export function listen(changed) {
  addEventListener("storage", ({key, newValue}) => {
    if (key?.startsWith(KEY))
      changed(key.slice(KEY.length), newValue === null ? null : JSON.parse(newValue).lines);
  });
}
