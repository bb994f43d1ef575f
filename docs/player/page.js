// What every page that shows motion begins with: its address, its theme, its icons.
"use strict";

const $ = id => document.getElementById(id);
const query = new URLSearchParams(location.search);
const framed = self !== top;  // inside another page: leave scrolling to it, do not start unasked
const icons = {Play: "M7 4l13 8-13 8z", Pause: "M6 4h4v16H6zM14 4h4v16h-4z",
               "Play again": "M12 5V1L6 6l6 5V7a5.5 5.5 0 1 1-5.5 5.5h-2A7.5 7.5 0 1 0 12 5z"};

// Light or dark, as the address says or the system prefers.
function dress(repaint, wanted = query.get("theme")) {
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const apply = () => {
    document.documentElement.dataset.theme = wanted || (dark.matches ? "dark" : "light");
    repaint();
  };
  dark.onchange = apply;
  apply();
}
