// Leads through the instant centres: at each step what is known by then, and the two lines that give the next one.
"use strict";
(function (kempe) {
  const { one } = kempe.elements;
  const picture = one("centres"), steps = [...document.querySelectorAll("#steps li")];
  const known = [...document.querySelectorAll("#joints li")].map((item) => item.dataset.centre);
  const lines = [...picture.querySelectorAll("g.lines")], marks = [...picture.querySelectorAll("[data-centres]")];
  let count = steps.length;  // so many steps are shown; the last of them is told unless all are
  let isAll = true;

  const isInPicture = (name) => marks.some((mark) => mark.dataset.centres.split(" ").includes(name));

  function show(number, all = false) {
    count = Math.min(steps.length, Math.max(0, number));
    isAll = all;
    const step = isAll || count === 0 ? null : steps[count - 1];
    const found = new Set([...known, ...steps.slice(0, count).map((item) => item.dataset.centre)]);
    const now = step?.dataset.centre, used = new Set(step?.dataset.uses.split(" ").filter(Boolean));
    for (const group of lines) {
      group.classList.toggle("now", group.dataset.centre === now);
      group.classList.toggle("away", !isAll && group.dataset.centre !== now);
    }
    for (const mark of marks) {
      const told = mark.dataset.centres.split(" ").filter((name) => found.has(name));
      mark.classList.toggle("away", told.length === 0);
      mark.classList.toggle("now", told.includes(now));
      mark.classList.toggle("through", told.some((name) => used.has(name)));
      if (mark.tagName === "text" && !mark.dataset.inset) mark.textContent = told.join(", ");
    }
    steps.forEach((item, i) => {
      item.classList.toggle("now", item === step);
      item.classList.toggle("away", i >= count);
    });
    one("told").textContent = step ? `${now}: ${step.querySelector("span").textContent}${isInPicture(now) ? "" : ", outside the picture"}` : isAll ? "all centres" : "the centres that joints give";
    one("back").disabled = !isAll && count === 0;
    one("next").disabled = !isAll && count === steps.length;
  }

  const next = () => show(isAll ? 0 : count + 1);
  const back = () => show(isAll ? steps.length : count - 1);
  one("next").onclick = next;
  one("back").onclick = back;
  one("all").onclick = () => show(steps.length, true);
  steps.forEach((item, i) => (item.querySelector("button").onclick = () => show(i + 1)));
  addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const act = { ArrowRight: next, ArrowLeft: back, a: () => show(steps.length, true) }[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });

  // An address that ends in #3 opens the page at that step.
  const asked = /^#(\d+)$/.exec(location.hash);
  if (asked) show(Number(asked[1]));
  else show(steps.length, true);
})((globalThis.kempe = globalThis.kempe || {}));
