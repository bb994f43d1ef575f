// What the tests say of an exercise, in the words of ./wb test (tools/judge/grade.py and
// tools/learn/testing.py).
"use strict";
if (typeof module !== "undefined") Object.assign(globalThis, require("./regions.js"));

const DONE = "done", OPEN = "not written yet", WAITS = "waits for", WRONG = "wrong";
const ENDLESS = "it did not end within 2 seconds";
const WORST = [DONE, WAITS, OPEN, WRONG];
const MOST_LINES = 12;  // of what an answer prints

/// A sentence in lines of at most `width`; with `hyphens` a line may end behind one.
function wrapped(words, width, first = "", rest = first, hyphens = false) {
  const pieces = words.trim().split(/\s+/).flatMap(word =>
    hyphens ? word.split(/(?<=[a-z]{2}-)(?=[a-z]{2})/i).map((part, k) => [part, k > 0])
      : [[word, false]]);
  let line = first, empty = true;
  const out = [];
  for (const [piece, joined] of pieces) {
    const gap = empty || joined ? "" : " ";
    if (!empty && line.length + gap.length + piece.length > width) {
      out.push(line);
      line = rest + piece;
    } else {
      line += gap + piece;
    }
    empty = false;
  }
  return [...out, line].join("\n");
}
const folded = (words, margin = 0) => wrapped(words, 78, " ".repeat(margin));
const indented = (words, margin = 4) =>
  words.split("\n").map(line => line && " ".repeat(margin) + line).join("\n");

// ---- crashes ------------------------------------------------------------------------------------

/// What the first pattern that fits makes of a text; `words`: those of tools/judge/crashes.py.
function meant(text, words, flags = "") {
  for (const [pattern, meaning] of words) {
    const match = new RegExp(pattern, flags).exec(text);
    if (match) return meaning.replace(/\\(\d)/g, (_, k) => match[k] || "");
  }
  return "";
}
/// What was thrown, or said by a crash, in plain words.
const plainly = (text, words) => meant(text, words.meanings, "m") || text;
// How a module stops, by the signal that stops a program; libc++ says what is wrong with an index.
const STOPS = [[/call stack|recursion/i, "stack is full"], [/out of bounds/, "SIGSEGV"],
               [/by zero/, "SIGFPE"], [/unreachable/, "SIGILL"]];
const LIBRARY = /^.*_LIBCPP_ASSERT '.*' failed/;
function crash(result, words) {
  if (result.ended === "endless")
    return `${ENDLESS}: a loop without an end?`;
  if (result.ended === "exit")
    return "the program ended in the middle of a test: does the code call exit()?";
  const said = result.printed.split("\n").filter(line => LIBRARY.test(line)).join("\n");
  if (/index|front|back|out-of-bounds/.test(said))
    return plainly("_M_range_check", words);
  if (/std::clamp/.test(said)) return plainly("Assertion '!(__hi < __lo)'", words);
  const signal = STOPS.find(([pattern]) => pattern.test(result.words));
  return plainly(signal ? signal[1] : result.words, words);
}
const own = printed => printed.split("\n").filter(line => !LIBRARY.test(line)).join("\n").trim();

// ---- grades -------------------------------------------------------------------------------------

/// A report that no test has written: where the exercise is, and the next command.
function with_place(text, chapter, file, id) {
  const lines = file.split("\n"), all = regions(file).filter(region => region.id === id);
  let place = place_of(file, chapter.path, id) +
    all.slice(1).map(region => ` or :${region.begin}`).join("");
  for (const [beginning, clue] of Object.entries(chapter.words.clues)) {
    if (!new RegExp(`^(?:${beginning})`).test(text)) continue;
    const fit = all.filter(region => {
      let head = region.begin;
      while (head > 0 && !/^\w/.test(lines[head])) --head;
      const body = region.lines.slice(region.lines.findIndex(line => !/^\s*\/\//.test(line)));
      return new RegExp(clue).test([...lines.slice(head, region.begin), ...body].join("\n"));
    });
    if (fit.length !== 1) continue;
    place = `${chapter.path}:${fit[0].begin}`;
    break;
  }
  return `${wrapped(text, 76, "", "", true)}\n\nWhere: ${place}\nNext:  ./wb hint ${id}`;
}

/// How far an exercise is, from the results of its tests (docs/course/runner.js).
/// \param file the text that was compiled
function graded(id, results, chapter, file) {
  const grade = {id, status: DONE, detail: "", tests: 0, failures: [], printed: ""};
  const worse = (status, detail = "") => {
    if (WORST.indexOf(status) > WORST.indexOf(grade.status)) Object.assign(grade, {status, detail});
  };
  for (const result of results) {
    ++grade.tests;
    if (result.ended === "passed") continue;
    const open = /exercise (\d+\.\d+) is not written yet/.exec(result.words);
    if (open && result.ended === "thrown") {
      open[1] === id ? worse(OPEN) : worse(WAITS, open[1]);
      continue;
    }
    worse(WRONG);
    let report = result.words.trim();
    if (result.ended !== "failed") {
      const plain = result.ended === "thrown" ? plainly(report, chapter.words)
        : crash(result, chapter.words);
      const thrown = result.ended === "thrown" && plain === report;
      report = with_place(thrown ? `it threw an exception: ${plain}` : plain, chapter, file, id);
    }
    grade.failures.push({name: result.name, report, printed: result.printed});
  }
  grade.printed = own((grade.failures[0] || results[0])?.printed || "");
  return grade;
}

/// The report with the sentence on units under what is likely, before it says where.
function with_units(report, sentence) {
  const at = report.indexOf("\nWhere: ");
  const [words, rest] = at < 0 ? [report, ""] : [report.slice(0, at), report.slice(at + 8)];
  const lines = wrapped(sentence, 76, "", " ".repeat("Units: ".length), true);
  return `${words.trimEnd()}\n${lines}\n\nWhere: ${rest}`;
}
/// Should a wrong exercise be asked for its units?
const wants_units = ({status, failures}) => status === WRONG &&
  failures[0].report.startsWith("Exercise") && !failures[0].report.includes("Likely mistake:");
/// The sentence on units in the results of the units' tests.
function units_in(results) {
  const said = results.map(one => one.words.split(/\s+/).join(" ").trim())
    .find(words => words.includes("Units: ")) || "";
  return /\^-?\d{2}/.test(said)
    ? "Units: none that make sense: a variable is read that was never set." : said;
}

/// The mistake that a report names; "" if none.
function named(report) {
  const found = /Likely mistake: ([^]*?)(?=\n\s*\n|\nWhere: |$)/.exec(report);
  return found ? found[1].split(/\s+/).join(" ").trim() : "";
}
/// A sentence on another mistake: one that a later test names, in another region than the first
/// report, or where that names none. "" if there is none.
function second_mistake([first, ...others]) {
  const where = report => (report.split("Where: ")[1] || "").split("\n")[0];
  const other = others.find(({report}) => named(report) &&
    (where(report) !== where(first.report) || !named(first.report)));
  return other
    ? `Another test names a mistake at ${where(other.report)}: ${named(other.report)}` : "";
}

/// What there is to say of a grade, as text for a terminal.
function told(grade, chapter, file) {
  const {id, status, failures} = grade;
  const of = status === WAITS ? ` ${grade.detail}` : "";
  const out = [`${id}  ${chapter.titles[id] || ""}: ${status}${of}`];
  const lines = grade.printed ? grade.printed.split("\n") : [];
  if (lines.length) out.push("  your code prints:");
  out.push(...lines.slice(0, MOST_LINES).map(line => `    | ${line}`));
  if (lines.length > MOST_LINES) out.push(`    | ... ${lines.length - MOST_LINES} lines more`);
  if (status === OPEN) {
    const mine = regions(file).filter(region => region.id === id);
    if (!mine.every(is_untouched))
      out.push(`  it is begun; todo("${id}"); still stands in its place:`,
               `  ${place_of(file, chapter.path, id)}`);
  } else if (status === WAITS) {
    out.push(`  it calls ${grade.detail}, which is not written yet: ./wb test ${grade.detail}`);
  } else if (status === WRONG) {
    const name = failures[0].name.startsWith(id) ? failures[0].name.slice(id.length).trim()
      : failures[0].name;
    if (name) out.push(folded(name, 2) + "\n");
    out.push(indented(failures[0].report));
    const more = failures.length - 1;
    if (more)
      out.push(`\n  ${more} more of its ${grade.tests} tests ${more === 1 ? "fails" : "fail"}; ` +
               "mend this one first.");
    const other = second_mistake(failures);
    if (other) out.push(folded(other, 2));
  } else {
    out.push(`${grade.tests} tests passed.`);
  }
  return out.join("\n");
}

/// The compiler's errors without mere warnings and notes on other libraries.
function errors_of(printed) {
  let before = false, aside = false;
  return printed.split("\n").filter(line => {
    if (/^\S+:\d+:\d+: note:/.test(line)) aside = before || line.startsWith("/");
    else if (/^\S/.test(line))  // else it belongs to the line before
      before = aside = /^In file included|^\S+:\d+:\d+: warning:/.test(line);
    return !aside;
  }).join("\n").trim();
}

/// What the compiler says of a file, and the line of its first error.
function refused(printed, chapter, file) {
  const path = chapter.path.replace(/[.]/g, "\\.");
  const error = new RegExp(`${path}:(\\d+):\\d+: (?:fatal )?error: (.*)`).exec(printed);
  const line = error ? Number(error[1]) : 0;
  const inside = regions(file).find(region => region.begin <= line && line <= region.end + 2);
  const first = printed.split(/^(?=\S+:\d+:\d+: error: )/m).slice(0, 2).join("");
  const meaning = meant(first, chapter.words.refused);
  const missing = [...new Set([...printed.matchAll(/undefined symbol: (.+)/g)].map(at => at[1]))];
  const out = [`${chapter.path}: does not compile\n`];
  if (missing.length)
    out.push(folded(`These functions are not there, or not with these arguments: ` +
                    `${missing.join("; ")}.`, 2));
  if (inside) out.push(`  The first error lies in exercise ${inside.id}, line ${line}.`);
  if (meaning) out.push(folded(`Likely mistake: ${meaning}`, 2));
  if (inside) out.push(`  Next: mend it, then ./wb test ${inside.id}\n`);
  if (!missing.length) out.push(indented(errors_of(printed)));
  return {text: out.join("\n"), line, words: error ? error[2] : "", id: inside?.id};
}

if (typeof module !== "undefined")
  module.exports = {graded, told, refused, wants_units, with_units, units_in};
