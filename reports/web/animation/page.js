// The page of an animated linkage: puts picture, arrows, polygons and plots together, and gives them buttons and keys.
"use strict";
(function (kempe) {
  const { one, html } = kempe.elements;
  const motion = new kempe.Motion(JSON.parse(one("scene").textContent)), picture = one("picture");
  const player = new kempe.Player(motion, picture), arrows = new kempe.Arrows(motion, picture);
  const polygons = motion.kinds.map((kind) => new kempe.Polygon(motion, kind));
  player.followers.push((moment) => arrows.show(moment), ...polygons.map((polygon) => (moment) => polygon.show(moment)));
  new kempe.Plots(motion, player);

  const keys = {
    " ": () => player.run(!player.isRunning),
    ArrowLeft: () => player.stopAt(player.moment - 1),
    ArrowRight: () => player.stopAt(player.moment + 1),
    n: () => one("names").click(),
  };

  /** A button, and its first letter as a key, that switch arrows of a kind and their polygon. */
  function giveButton(kind) {
    const button = one(kind.name), polygon = polygons.find((each) => each.kind.name === kind.name);
    button.onclick = () => {
      const isOn = button.getAttribute("aria-pressed") !== "true";
      button.setAttribute("aria-pressed", isOn);
      arrows.turn(kind, isOn);
      polygon?.turn(isOn);
      one("polygons").hidden = !polygons.some((each) => each.isOn);
      player.show(player.moment);
    };
    keys[kind.name[0]] = () => button.click();
  }
  arrows.kinds().forEach(giveButton);

  addEventListener("keydown", (event) => {
    const { target, key } = event;
    if (event.ctrlKey || event.altKey || event.metaKey || target.tagName === "SELECT") return;
    if ((["BUTTON", "INPUT"].includes(target.tagName) && key === " ") || (target.id === "moment" && key.startsWith("Arrow"))) return;  // they act themselves
    const act = keys[key.length === 1 ? key.toLowerCase() : key];
    if (!act) return;
    event.preventDefault();
    act();
  });

  // Where the motion stands out, to go there.
  const { marks } = motion.scene.motion;
  one("marksbox").hidden = marks.length === 0;
  one("marks").replaceChildren(...marks.map(({ at, words }) => {
    const item = html("li"), button = html("button", `step ${+motion.stepAt(at).toFixed(2)}`);
    button.type = "button";
    button.onclick = () => player.stopAt(Math.round(at));
    item.append(button, ` ${words}`);
    return item;
  }));

  // Places that were asked for, to go there.
  for (const button of document.querySelectorAll("#wantedbox button")) button.onclick = () => player.stopAt(Math.round(button.dataset.moment));

  // An address that ends in #40 opens the page at that moment, standing still.
  const asked = /^#(\d+)$/.exec(location.hash);
  player.show(asked ? Math.min(+asked[1], motion.last) : 0);
  if (!asked && !matchMedia("(prefers-reduced-motion: reduce)").matches) player.run(true);
})((globalThis.kempe = globalThis.kempe || {}));
