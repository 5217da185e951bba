// SPDX-License-Identifier: MIT
// Gives the style sheet the height of the header, of which the picture's depends.
function followHeader() {
  const header = document.querySelector("header"), { style } = document.documentElement;
  const tell = () => style.setProperty("--header", `${header.getBoundingClientRect().height}px`);
  new ResizeObserver(tell).observe(header);
  tell();
}
