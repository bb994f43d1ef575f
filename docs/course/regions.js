// The regions of an exercise file, as tools/base/exercises.py reads them.
"use strict";

const BEGIN = /^\s*\/\/ begin \[exercise (\d+\.\d+)\]\s*$/;
const END = /^\s*\/\/ end \[exercise (\d+\.\d+)\]\s*$/;

/// All whole regions of a text: {id, place, begin, end, lines}. `begin` is the index of the line
/// after the begin marker, `end` that of the end marker; `place` counts those that share an id.
function regions(text) {
  const found = [], lines = text.split("\n"), count = {};
  let open = null;
  lines.forEach((line, k) => {
    const begin = BEGIN.exec(line), end = END.exec(line);
    if (begin) open = {id: begin[1], begin: k + 1};
    if (end && open?.id === end[1]) {
      const place = count[open.id] = (count[open.id] || 0) + 1;
      found.push({...open, place, end: k, lines: lines.slice(open.begin, k)});
      open = null;
    }
  });
  return found;
}

/// The text with the lines of every region replaced by change(region), or kept for null.
function replaced(text, change) {
  const lines = text.split("\n");
  for (const region of regions(text).reverse()) {
    const made = change(region);
    if (made) lines.splice(region.begin, region.end - region.begin, ...made);
  }
  return lines.join("\n");
}

const name_of = region => `${region.id}#${region.place}`;
/// Fills the regions of a text with those of answers, {"1.3#2": lines}.
const filled = (text, answers) => replaced(text, region => answers[name_of(region)]);
/// {"1.3#2": lines} of a text.
const answers_in = text =>
  Object.fromEntries(regions(text).map(region => [name_of(region), region.lines]));

const code_of = line => line.split("//")[0];
const is_open = region => region.lines.some(line => /\btodo\("/.test(code_of(line)));
function is_untouched(region) {
  const code = region.lines.map(line => code_of(line).trim()).filter(Boolean);
  return code.length === 1 && code[0] === `todo("${region.id}");`;
}

/// "path:line" of an exercise in a file: its first todo, else where it begins.
function place_of(text, path, id) {
  const lines = text.split("\n");
  for (const words of [`todo("${id}")`, `// begin [exercise ${id}]`]) {
    const k = lines.findIndex(line => code_of(line).includes(words) || line.trim() === words);
    if (k >= 0) return `${path}:${k + 1}`;
  }
  return path;
}

if (typeof module !== "undefined")
  module.exports = {regions, replaced, filled, answers_in, name_of, is_open, is_untouched, place_of,
                    code_of};
