// What the site's pages do beside being read: motions play where their pictures stand, and follow
// the switch between light and dark.
"use strict";

// What the browser may not keep, or has no room for, the page remembers until it is left.
function keep_in_page() {
  const kept = Object.create({getItem(name) { return this[name] ?? null; },
                              setItem(name, words) { this[name] = words; },
                              removeItem(name) { delete this[name]; }});
  try { Object.assign(kept, localStorage); } catch { /* it may not be read, either */ }
  Object.defineProperty(window, "localStorage", {value: kept, configurable: true});
  document.documentElement.dataset.unkept = "yes";
}
try {
  localStorage.setItem("joint-workbook", "");
} catch {
  keep_in_page();
}

const dark = () => document.documentElement.classList.contains("dark-mode");
// In the one-file edition, pages of their own are at other addresses.
const address_of = name => (window.address_inside || String)(name);
const themed = link => link.getAttribute("href").replace(/&theme=\w+/, "")
  + `&theme=${dark() ? "dark" : "light"}`;

document.addEventListener("click", event => {
  const link = event.target.closest("a.recording");
  if (!link || event.ctrlKey || event.metaKey || event.button) return;
  event.preventDefault();
  const frame = document.createElement("iframe");
  Object.assign(frame, {src: address_of(themed(link) + "&play=1"),
                        title: link.getAttribute("aria-label")});
  const place = link.closest("figure");
  place.classList.add("playing");
  link.replaceWith(frame);
  const whole = Object.assign(document.createElement("a"),
                              {href: themed(link), textContent: " In a page of its own"});
  place.querySelector("figcaption").append(whole);
});

// Frames that stand in the page from the beginning get the theme once it is known, and again. Those
// of experiments are loaded while they are near the window, and forgotten far from it.
const near = new IntersectionObserver(seen => {
  for (const {target, isIntersecting} of seen) target.dataset.near = isIntersecting;
  dress_frames();
}, {rootMargin: "600px"});
function dress_frames() {
  for (const frame of document.querySelectorAll("iframe[data-src]")) {
    near.observe(frame);
    if (frame.dataset.near !== "true") {
      if (frame.dataset.near && frame.src) frame.removeAttribute("src");
      continue;
    }
    const [file, hash] = frame.dataset.src.split("#");
    const theme = `${file.includes("?") ? "&" : "?"}theme=${dark() ? "dark" : "light"}`;
    const wanted = address_of(file + theme + (hash ? `#${hash}` : ""));
    if (frame.getAttribute("src") !== wanted) frame.src = wanted;
  }
}
new MutationObserver(dress_frames).observe(document.documentElement,
                                           {attributes: true, attributeFilter: ["class"]});
document.addEventListener("DOMContentLoaded", dress_frames);

// A link of a sentence shows its moment in the scene behind it.
document.addEventListener("click", event => {
  const link = event.target.closest("a[data-experiment]");
  if (!link || event.ctrlKey || event.metaKey || event.button) return;
  event.preventDefault();
  const frame = document.querySelector(`#${link.dataset.experiment} iframe`);
  frame.dataset.src = `${link.getAttribute("href")}&only=${frame.dataset.only}`;
  frame.dataset.near = "true";
  dress_frames();
  frame.scrollIntoView({block: "nearest"});
});

// What is wider than its place scrolls with the keys, too.
function reach() {
  for (const one of document.querySelectorAll(
    ".fragment, .tex, .drawing, .memproto, .memdoc table, .memdoc tbody, " +
    "table.markdownTable, table.markdownTable tbody")) {
    const wide = one.scrollWidth > one.clientWidth + 1 &&
      /auto|scroll/.test(getComputedStyle(one).overflowX);
    if (wide !== one.hasAttribute("tabindex"))
      wide ? one.setAttribute("tabindex", "0") : one.removeAttribute("tabindex");
  }
}
addEventListener("DOMContentLoaded", reach);
addEventListener("load", reach);
addEventListener("resize", reach);
document.addEventListener("toggle", reach, true);  // a fold has opened

// On paper everything is light.
let kept = "";
addEventListener("beforeprint", () => {
  kept = document.documentElement.className;
  document.documentElement.className = "light-mode";
});
addEventListener("afterprint", () => { document.documentElement.className = kept; });
