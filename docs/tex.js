// Draws formulas with KaTeX. In node, when the site is built: node tex.js KATEX.js < formulas, a
// JSON list of [TeX, true for a display]; the answer is the list of drawings. On a page of a site
// that was built without node: every formula where it stands.
"use strict";
const options = display => ({displayMode: display, strict: "error"});
if (typeof document === "undefined") {
  const katex = require(process.argv[2]);
  const formulas = JSON.parse(require("fs").readFileSync(0, "utf8"));
  process.stdout.write(JSON.stringify(
    formulas.map(([tex, display]) => katex.renderToString(tex, options(display)))));
} else {
  for (const place of document.querySelectorAll(".tex"))
    katex.render(place.textContent, place, options(place.parentNode.className === "display"));
}
