// Where lines must not break: browsers part an option behind its hyphens (`--` from `units`), and a comma or a bracket
// from the formula before it.
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
  for (const math of document.querySelectorAll("main math:not([display='block'])")) {
    const { nextSibling: after } = math;
    if (after?.nodeType !== Node.TEXT_NODE) continue;
    const mark = /^[,.;:?!)\]’”]+/.exec(after.data)?.[0];
    if (!mark) continue;
    after.data = after.data.slice(mark.length);
    const place = document.createComment("");
    math.replaceWith(place);
    place.replaceWith(whole(math, mark));
  }
})();
