// What browsers typeset wrongly. They part an option behind its hyphens (`--` from `units`), 1e-3 behind its own, a
// number from its per cent, and a formula from the bracket before it and from the comma or the bracket behind it.
// Chromium leaves room behind a small root.
"use strict";
(() => {
  const whole = (...nodes) => {
    const span = document.createElement("span");
    span.className = "whole";
    span.append(...nodes);
    return span;
  };
  for (const code of document.querySelectorAll("main :not(pre) > code")) {
    if (code.children.length > 0 || !code.textContent.includes("-")) continue;
    // A word that is longer than a narrow screen must break somewhere.
    const words = code.textContent.split(/(\s+)/).map((word) => (/-/.test(word) && word.length < 32 ? whole(word) : word));
    code.replaceChildren(...words);
  }
  const texts = document.createTreeWalker(document.querySelector("main"), NodeFilter.SHOW_TEXT);
  const powers = [];
  for (let text = texts.nextNode(); text; text = texts.nextNode()) {
    if (text.parentElement.closest("code, math, script, style")) continue;
    if (/\d %/.test(text.data)) text.data = text.data.replace(/(\d) %/g, "$1\u00a0%");
    if (/\de-\d/.test(text.data)) powers.push(text);
  }
  for (const text of powers) {
    const parts = text.data.split(/([\d.]+e-\d+)/).map((part, at) => (at % 2 === 1 ? whole(part) : part));
    text.replaceWith(...parts);
  }
  for (const math of document.querySelectorAll("main math:not([display='block'])")) {
    const { previousSibling: before, nextSibling: after } = math;
    const opened = before?.nodeType === Node.TEXT_NODE ? (/[(\[‘“]+$/.exec(before.data)?.[0] ?? "") : "";
    const closed = after?.nodeType === Node.TEXT_NODE ? (/^[,.;:?!)\]’”]+/.exec(after.data)?.[0] ?? "") : "";
    if (opened + closed === "") continue;
    if (opened) before.data = before.data.slice(0, -opened.length);
    if (closed) after.data = after.data.slice(closed.length);
    const place = document.createComment("");
    math.replaceWith(place);
    place.replaceWith(whole(opened, math, closed));
  }
  document.fonts.ready.then(() => {
    const roots = [...document.querySelectorAll("main msqrt")].map((root) => {
      const em = parseFloat(getComputedStyle(root).fontSize);
      const room = root.getBoundingClientRect().right - root.lastElementChild.getBoundingClientRect().right;
      return [root, room / em];
    });
    for (const [root, room] of roots) if (room > 0.2) root.style.marginInlineEnd = `${0.1 - room}em`;
  });
})();
