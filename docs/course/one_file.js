// The one-file edition: the whole site and the compiler are in this file, packed. A page is shown
// in a frame; what it would load from beside it is put into it or gets the address of a blob.
"use strict";

const TYPES = {html: "text/html", css: "text/css", js: "text/javascript", svg: "image/svg+xml",
               png: "image/png", json: "application/json", txt: "text/plain"};
const files = new Map(), addresses = new Map();  // by their names in the site
const frame = document.createElement("iframe");
const plain = name => name.replace(/^\.\//, "");
const inline = script => script.replace(/<\/(?=script)/g, "<\\/");

/// What the pages and their scripts may ask for.
const site = window.site = {
  text: name => new TextDecoder().decode(files.get(plain(name))),
  blob(name, bytes = files.get(plain(name))) {
    return new Blob([bytes], {type: TYPES[name.split(".").at(-1)] || ""});
  },
  /// The address of a file, with its query behind the hash: a blob has no query.
  address(name) {
    const [, file, query, hash] = /^([^?#]*)\??([^#]*)#?(.*)$/.exec(name);
    if (!files.has(plain(file))) return name;
    if (!addresses.has(file))
      addresses.set(file, URL.createObjectURL(site.blob(file, moving(file))));
    const state = [query, hash].filter(Boolean).join("&");
    return addresses.get(file) + (state && `#${state}`);
  },
  /// A worker's script with the scripts that it imports.
  worker(name) {
    const whole = site.text(name).replace(/importScripts\((.*)\);/, (_, names) =>
      names.match(/[^", ]+/g).map(one => site.text(`course/${one}`)).join("\n"));
    return URL.createObjectURL(new Blob([whole], {type: TYPES.js}));
  },
  async pack(name) {
    return (await fetch(`data:;base64,${document.getElementById(name).textContent}`)).blob();
  },
};

/// A page that moves, with three.js in it: a blob has nothing beside it.
const moving = name => name.endsWith(".html") ? site.text(name).replace(
  /<script src="(?:\.\.\/)?three\.min\.js">/, () => `<script>${inline(site.text("three.min.js"))}`)
  : undefined;

/// A module that finds its neighbours by the names in the page's import map.
const module_of = name => "data:text/javascript," + encodeURIComponent(
  site.text(name).replace(/(from |import\()"\.\//g, '$1"course/'));

function modules() {
  const found = {};
  for (const name of files.keys())
    if (/^course\/[^/]*\.js$/.test(name)) found[name] = module_of(name);
  found["course/where.js"] = module_of("course/inside.js");
  return found;
}

/// A page of the site with its styles, scripts and pictures inside.
function whole(page) {
  return page
    .replace(/<link href="([^"]*\.css)"[^>]*>|<link rel="stylesheet" href="([^"]*)">/g,
             (_, one, other) => `<style>${site.text(one || other)}</style>`)
    .replace(/<script type="importmap">(.*?)<\/script>/, (_, map) => {
      const {imports} = JSON.parse(map);
      for (const name in imports)
        if (files.has(plain(imports[name]))) imports[name] = module_of(imports[name]);
      return `<script type="importmap">${JSON.stringify(
        {imports: {...imports, ...modules()}})}<\/script>`;
    })
    .replace(/<script type="module" src="([^"]*)"([^>]*)>/g, '<script type="module"$2>import "$1"')
    .replace(/<script(?: type="text\/javascript")? src="([^"]*)">/g,
             (_, name) => `<script>${inline(site.text(name))}`)
    .replace(/(<img [^>]*?src=")([^"]*)/g, (_, begin, name) => begin + site.address(name))
    .replace("<head>", `<head><script>window.address_inside = parent.site.address;<\/script>`);
}

/// Shows what stands behind the hash of the address: a page, and a place in it.
function show() {
  const wanted = decodeURIComponent(location.hash.slice(1)) || "index.html";
  const [, file, place] = /^([^?#]*)[?#]?(.*)$/.exec(wanted);
  if (/^(live|motion\/.*)\.html$/.test(file)) {  // these have nothing beside them
    frame.removeAttribute("srcdoc");
    frame.dataset.shows = "";
    frame.onload = null;
    frame.src = site.address(wanted);
    return;
  }
  if (frame.dataset.shows === file) return go_to(place);
  frame.dataset.shows = "";
  frame.onload = () => {
    const page = frame.contentDocument;
    frame.dataset.shows = file;
    document.title = page.title;
    page.addEventListener("click", follow);
    go_to(place);
  };
  frame.srcdoc = whole(site.text(files.has(file) ? file : "index.html"));
}
function go_to(place) {
  const target = place && frame.contentDocument.getElementById(place);
  if (!target) return frame.contentWindow.scrollTo(0, 0);
  for (let fold = target.closest("details"); fold; fold = fold.parentElement.closest("details"))
    fold.open = true;
  target.scrollIntoView();
  target.focus();
}

/// A link leads to a page of the site, or out of it into a window of its own.
function follow(event) {
  const link = event.target.closest("a[href]");
  if (!link || link.download || event.defaultPrevented || event.button) return;
  const address = link.getAttribute("href");
  if (/^blob:/.test(address)) return;
  if (/^\w+:/.test(address)) {
    link.target = "_blank";
    return;
  }
  if (/\.txt$/.test(address)) {  // a program, and no page
    link.href = site.address(address);
    link.target = "_blank";
    return;
  }
  event.preventDefault();
  if (address.startsWith("#")) return go_to(address.slice(1));
  location.hash = encodeURIComponent(address);
}

addEventListener("hashchange", show);
addEventListener("DOMContentLoaded", async () => {
  const bytes = await unpacked((await site.pack("site.xz")).stream());
  add_pack({add: (name, part) => files.set(name, part)}, bytes);
  document.getElementById("wait").replaceWith(frame);
  show();
});
