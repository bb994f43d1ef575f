// Search in the words of all pages. tools/website/words.py writes search_words.js, which calls
// search_words({pages: [[file, title], ...], places: [[number of the page, anchor, heading], ...],
// words: {word: [places behind the last one, weight, ...]}, common: [...], synonyms: {word: other
// words}}); it is loaded when somebody begins to type, as a script, so that it works from a disk,
// too. An anchor that begins with "-" begins with the name of its page.
"use strict";

let index = null, asked = false;
function search_words(loaded) {
  index = loaded;
  index.list = Object.keys(index.words).sort();
  index.stop = new Set(index.common);
  find();
}

// {place: weight} of the words that are this one, or begin with it: those count a quarter.
function hits_of(word) {
  const found = new Map();
  for (const known of index.list) {
    const share = known === word ? 1 : known.startsWith(word) ? 0.25 : 0;
    const hits = share ? index.words[known] : [];
    for (let i = 0, place = 0; i < hits.length; i += 2) {
      place += hits[i];
      found.set(place, Math.max(found.get(place) || 0, share * hits[i + 1]));
    }
  }
  return found;
}
// The words to look up in place of one that no page has: its two halves, or its beginning.
function instead_of(word) {
  for (let k = 4; k < word.length - 3; ++k) {
    const halves = [word.slice(0, k), word.slice(k)];
    if (halves.every(half => index.words[half])) return halves;
  }
  for (let k = word.length - 1; k >= 4; --k)
    if (index.list.some(known => known.startsWith(word.slice(0, k)))) return [word.slice(0, k)];
  return [];
}

// The best places: those that have most of the question's words, rare words counting more.
function places_of(question) {
  const asked_for = question.toLowerCase().normalize("NFKD").match(/\d+[.-]\d+|[a-z0-9_]+/g) || [];
  const words = asked_for.filter(word => !index.stop.has(word)), sums = new Map();
  const wanted = words.length ? words : asked_for;
  for (const word of wanted) {
    const also = (index.synonyms[word] || "").split(" ").filter(Boolean);
    let found = hits_of(word);
    if (!found.size && !also.length) also.push(...instead_of(word));
    for (const other of also)  // a place with all of a synonym's words has the word
      for (const [place, weight] of hits_of(other))
        found.set(place, (found.get(place) || 0) + weight / also.length);
    const rare = Math.log(1 + index.places.length / (1 + found.size));
    for (const [place, weight] of found) {
      const [sum, count] = sums.get(place) || [0, 0];
      sums.set(place, [sum + rare * weight, count + 1]);
    }
  }
  const worth = ([, [sum, count]]) => sum * (count / wanted.length) ** 2;
  return [...sums].sort((a, b) => worth(b) - worth(a) || a[0] - b[0]).slice(0, 12)
                  .map(([number]) => {
                    const [page, place, heading] = index.places[number];
                    const [file, title] = index.pages[page];
                    const anchor = place.startsWith("-") ? file.slice(0, -5) + place : place;
                    return [anchor ? `${file}#${anchor}` : file, title, heading];
                  });
}

function find() {
  const field = document.getElementById("search"), list = document.getElementById("found");
  const question = field.value.trim();
  list.hidden = question.length < 2;
  if (list.hidden) return;
  if (!asked) {
    asked = true;
    const script = document.createElement("script");
    script.src = (window.address_inside || String)(field.dataset.words);
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
  if (!found.length) list.innerHTML = "<li><em>no page has these words</em></li>";
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
