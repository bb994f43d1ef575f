// The reader's file, out of the page and into it: the very file that ./wb and ./wb grade take.
import {at} from "./where.js";

export function element(tag, more = {}, ...children) {
  const made = Object.assign(document.createElement(tag), more);
  made.append(...children);
  return made;
}

/// Shown where the browser keeps nothing (course.css).
export const unkept = () => element("span", {
  className: "unkept",
  textContent: "This browser keeps nothing of what you write: export the file before you leave."});

/// \param file a function that returns the file
/// \param replace called with other lines and a question; returns a button that undoes it, or null
/// \param homeless regions that are kept and have no place in this version
export function offer_file(place, chapter, file, replace, homeless) {
  const name = chapter.path.split("/").at(-1);
  const said = element("p", {className: "said"});
  said.setAttribute("role", "status");
  const chosen = element("input", {type: "file", accept: ".cpp", hidden: true});
  const out = () => {
    const link = element("a", {download: name, href: URL.createObjectURL(
      new Blob([file()], {type: "text/x-c++src"}))});
    link.click();
    URL.revokeObjectURL(link.href);
  };
  chosen.onchange = async () => {
    const text = (await chosen.files[0].text()).replace(/\r\n?/g, "\n");
    chosen.value = "";
    const found = answers_in(text), wanted = Object.keys(answers_in(chapter.stub));
    const taken = wanted.filter(region => region in found);
    if (!taken.length) {
      said.textContent = `${name}: no exercise of this chapter is in that file.`;
      return;
    }
    const ids = all => [...new Set(all.map(region => region.split("#")[0]))].join(" ");
    const undo = replace(Object.fromEntries(taken.map(region => [region, found[region]])),
                         `Put the file in place of your work in ${ids(taken)}?`);
    if (!undo) return;
    into.after(undo);
    undo.addEventListener("click", () => { said.textContent = ""; });
    const left = wanted.filter(region => !taken.includes(region));
    const bare = words => replaced(words, () => []);
    said.textContent = `${ids(taken)}: taken from the file.` +
      (left.length ? ` Not in it: ${ids(left)}.` : "") +
      (bare(text) === bare(chapter.stub) ? "" : " Changes outside the exercises were left out.");
  };
  const into = element("button", {type: "button", textContent: `Import ${name}`,
                                  onclick: () => chosen.click()});
  place.append(
    element("h3", {textContent: `Your file: ${name}`}),
    element("p", {textContent: "Where the text says ./wb test or ./wb hint, press Check or Hint " +
                               "at the exercise. Where it says ./wb see or ./wb live, look at " +
                               "the scene below a checked exercise. ./wb run and ./wb plot " +
                               "need a terminal."}),
    element("p", {}, element("span", {className: "kept",
                                      textContent: "What you write is kept in this browser. "}),
            unkept(), ` The file is the one that ./wb takes as ${chapter.path}. `,
            element("a", {href: at("course/licences.txt"),
                          textContent: "Licences of compiler and editor"})),
    element("p", {className: "buttons"},
            element("button", {type: "button", textContent: `Export ${name}`, onclick: out}),
            into, chosen),
    said);
  if (homeless.length)
    said.textContent = `This version has no place for what you wrote in ${homeless.join(", ")}. ` +
      "It is still kept in this browser.";
}
