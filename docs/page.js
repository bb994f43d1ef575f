// What the site's pages do beside being read: motions play where their pictures stand, and follow
// the switch between light and dark.
"use strict";

const dark = () => document.documentElement.classList.contains("dark-mode");
const themed = link => link.href.replace(/&theme=\w+/, "") + `&theme=${dark() ? "dark" : "light"}`;

document.addEventListener("click", event => {
  const link = event.target.closest("a.recording");
  if (!link || event.ctrlKey || event.metaKey || event.button) return;
  event.preventDefault();
  const frame = document.createElement("iframe");
  Object.assign(frame, {src: themed(link) + "&play=1", title: link.getAttribute("aria-label")});
  const place = link.closest("figure");
  place.classList.add("playing");
  link.replaceWith(frame);
  const whole = Object.assign(document.createElement("a"),
                              {href: themed(link), textContent: " In a page of its own"});
  place.querySelector("figcaption").append(whole);
});

// Frames that stand in the page from the beginning get the theme once it is known, and again.
function dress_frames() {
  for (const frame of document.querySelectorAll("iframe[data-src]")) {
    const [file, hash] = frame.dataset.src.split("#");
    const wanted = `${file}${file.includes("?") ? "&" : "?"}theme=${dark() ? "dark" : "light"}`
      + (hash ? `#${hash}` : "");
    if (frame.getAttribute("src") !== wanted) frame.src = wanted;
  }
}
new MutationObserver(dress_frames).observe(document.documentElement,
                                           {attributes: true, attributeFilter: ["class"]});
document.addEventListener("DOMContentLoaded", dress_frames);

// On paper everything is light.
let kept = "";
addEventListener("beforeprint", () => {
  kept = document.documentElement.className;
  document.documentElement.className = "light-mode";
});
addEventListener("afterprint", () => { document.documentElement.className = kept; });
