// Search in the words of all pages. tools/website/words.py writes search_words.js, which calls
// search_words({places: [[address, page, heading], ...], words: {word: [place, times, ...]}});
// it is loaded when somebody begins to type, as a script, so that it works from a disk, too.
"use strict";

let index = null, asked = false;
function search_words(loaded) {
  index = loaded;
  index.list = Object.keys(index.words).sort();
  find();
}

// The places in which every word of the question occurs, as itself or as the beginning of another.
function places_of(question) {
  const wanted = question.toLowerCase().normalize("NFKD").match(/[a-z0-9_]+/g) || [];
  let sums = null;
  for (const word of wanted) {
    const found = new Map();
    for (const known of index.list) {
      const weight = known === word ? 4 : known.startsWith(word) ? 1 : 0;
      const hits = weight ? index.words[known] : [];
      for (let i = 0; i < hits.length; i += 2)
        found.set(hits[i], (found.get(hits[i]) || 0) + weight * hits[i + 1]);
    }
    sums = sums === null ? found
      : new Map([...found].filter(([place]) => sums.has(place))
                          .map(([place, sum]) => [place, sum + sums.get(place)]));
  }
  return [...(sums || [])].sort((a, b) => b[1] - a[1] || a[0] - b[0]).slice(0, 12)
                          .map(([place]) => index.places[place]);
}

function find() {
  const field = document.getElementById("search"), list = document.getElementById("found");
  const question = field.value.trim();
  list.hidden = question.length < 2;
  if (list.hidden) return;
  if (!asked) {
    asked = true;
    const script = document.createElement("script");
    script.src = field.dataset.words;
    document.head.append(script);
  }
  if (!index) return;
  const found = places_of(question);
  list.replaceChildren(...found.map(([address, page, heading]) => {
    const item = document.createElement("li"), link = document.createElement("a");
    link.href = address;
    link.append(heading || page);
    if (heading) {
      const small = document.createElement("small");
      small.textContent = page;
      link.append(small);
    }
    item.append(link);
    return item;
  }));
  if (!found.length) list.innerHTML = "<li><em>no page has all of these words</em></li>";
}

document.addEventListener("DOMContentLoaded", () => {
  const field = document.getElementById("search"), list = document.getElementById("found");
  if (!field) return;
  field.oninput = find;
  field.onkeydown = event => {
    const links = [...list.querySelectorAll("a")];
    if (event.key === "Enter" && links.length) links[0].click();
    if (event.key === "ArrowDown" && links.length) { links[0].focus(); event.preventDefault(); }
    if (event.key === "Escape") { field.value = ""; find(); }
  };
  document.addEventListener("click", event => {
    if (!event.target.closest("#MSearchBox")) list.hidden = true;
  });
  document.addEventListener("keydown", event => {
    if (event.key === "/" && !/INPUT|TEXTAREA/.test(event.target.tagName)) {
      field.focus();
      event.preventDefault();
    }
  });
  const asked_for = new URLSearchParams(location.search).get("search");
  if (asked_for) { field.value = asked_for; find(); }
});
