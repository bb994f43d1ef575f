// What every page that shows motion begins with: its address, its theme, its icons.
"use strict";

const $ = id => document.getElementById(id);
const query = new URLSearchParams(`${location.search.slice(1)}&${location.hash.slice(1)}`);
const framed = self !== top;  // inside another page: leave scrolling to it, do not start unasked
document.documentElement.classList.toggle("framed", framed);
const icons = {Play: "M7 4l13 8-13 8z", Pause: "M6 4h4v16H6zM14 4h4v16h-4z",
               "Play again": "M12 5V1L6 6l6 5V7a5.5 5.5 0 1 1-5.5 5.5h-2A7.5 7.5 0 1 0 12 5z"};

// What the site's own switch has stored, if this browser lets one page of a disk see it of another.
function stored_theme(dark) {
  try {
    const other = dark ? "prefers-light-mode-in-dark-mode" : "prefers-dark-mode-in-light-mode";
    return localStorage.getItem(other) === "true" ? (dark ? "light" : "dark") : "";
  } catch { return ""; }
}

// Light or dark, as the address says, the site's switch, or the system.
function dress(repaint, wanted = query.get("theme")) {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const apply = () => {
    document.documentElement.dataset.theme = wanted || stored_theme(dark.matches) ||
      (dark.matches ? "dark" : "light");
    repaint();
  };
  dark.onchange = apply;
  apply();
}
