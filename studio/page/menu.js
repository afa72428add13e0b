// A button that opens a list of buttons, for hands, keys and screen readers.
"use strict";
(function (kempe) {
  /** `button` shows and hides `list`; whatever is chosen there, Escape, or a press elsewhere closes it. */
  kempe.menu = function (button, list) {
    const show = (open) => {
      list.classList.toggle("open", open);
      button.setAttribute("aria-expanded", String(open));
    };
    button.setAttribute("aria-controls", list.id);
    show(false);
    button.addEventListener("click", () => {
      const open = !list.classList.contains("open");
      show(open);
      if (open) list.querySelector("button").focus();
    });
    list.addEventListener("click", (event) => { if (event.target.closest("button")) show(false); });
    document.addEventListener("pointerdown", ({ target }) => { if (!list.contains(target) && !button.contains(target)) show(false); });
    for (const node of [button, list])
      node.addEventListener("keydown", (event) => {
        const items = [...list.querySelectorAll("button")], step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
        if (!list.classList.contains("open") || (event.key !== "Escape" && !step)) return;
        event.preventDefault();
        event.stopPropagation();
        if (step) return items[(items.indexOf(document.activeElement) + step + items.length) % items.length].focus();
        show(false);
        button.focus();
      });
  };
})((globalThis.kempe = globalThis.kempe || {}));
