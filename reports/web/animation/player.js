// Moves the picture of an animated linkage from moment to moment: play, slider, and a point taken by hand.
"use strict";
(function (kempe) {
  const { one } = kempe.elements;
  const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

  class Player {
    constructor(motion, picture) {
      Object.assign(this, { motion, picture, moment: 0, isRunning: false, held: null });
      this.names = [...picture.querySelectorAll(".name")];
      this.followers = [];  // what else follows the moment: functions of its number
      this.direction = 1;
      this.slider = one("moment");
      this.slider.oninput = () => this.stopAt(+this.slider.value);
      one("play").onclick = () => this.run(!this.isRunning);
      one("names").onchange = (event) => this.names.forEach((name) => (name.style.display = event.target.checked ? "" : "none"));
      this.obeyTheHand();
    }

    show(moment) {
      const { scene } = this.motion;
      this.moment = moment;
      for (let body = 1; body <= this.motion.bodies; body++) {
        const [x, y, angle] = this.motion.frame(body, moment);
        one(`body${body}`).setAttribute("transform", `translate(${x} ${y}) rotate(${(angle * 180) / Math.PI})`);
      }
      this.names.forEach((name, point) => {
        const [x, y] = this.motion.place(point, moment);
        name.setAttribute("x", x + scene.offset);
        name.setAttribute("y", y - scene.offset);
      });
      for (const point of scene.traced) {
        const [x, y] = this.motion.place(point, moment), dot = one(`dot${point}`);
        dot.setAttribute("cx", x);
        dot.setAttribute("cy", y);
        one(`place${point}`).textContent = `(${this.coordinate(x)}, ${this.coordinate(-y)}) ${scene.unit}`;
      }
      for (const follow of this.followers) follow(moment);
      const step = one("step");
      step.textContent = `step ${+scene.moments[moment][0].toFixed(2)} of ${step.dataset.all}`;
      this.slider.value = moment;
      this.slider.setAttribute("aria-valuetext", step.textContent);
    }

    coordinate(value) {
      const { decimals } = this.motion.scene, text = value.toFixed(decimals);
      return +text === 0 ? (0).toFixed(decimals) : text;  // never -0.00
    }

    run(isRunning) {
      this.isRunning = isRunning;
      const play = one("play");
      play.textContent = isRunning ? "Pause" : "Play";
      play.setAttribute("aria-pressed", isRunning);
      if (!isRunning) return;
      let at = this.moment, before = null;  // at: between the moments
      const frame = (time) => {
        if (!this.isRunning) return;
        if (before !== null) {
          at = this.onward(at, (time - before) / 1000);
          this.show(Math.round(at));
        }
        before = time;
        requestAnimationFrame(frame);
      };
      requestAnimationFrame(frame);
    }

    /** Where the motion is some seconds later: around again where it closes, back and forth where it does not. */
    onward(at, seconds) {
      const { scene, last } = this.motion, ahead = at + (this.direction * seconds * last * one("speed").value) / scene.seconds;
      if (scene.closed) return ((ahead % last) + last) % last;
      if (ahead > last) this.direction = -1;
      if (ahead < 0) this.direction = 1;
      const turned = ahead > last ? 2 * last - ahead : Math.abs(ahead);
      return Math.min(last, Math.max(0, turned));
    }

    stopAt(moment) {
      this.run(false);
      this.show(Math.min(this.motion.last, Math.max(0, moment)));
    }

    /** A point taken by hand leads the linkage to the moment, of those that follow each other from here, that brings it nearest. */
    obeyTheHand() {
      const { picture } = this;
      picture.addEventListener("pointerdown", (event) => {
        this.held = this.pointAt(this.onPicture(event));
        if (this.held === null) return;
        this.run(false);
        picture.setPointerCapture(event.pointerId);
        event.preventDefault();
      });
      picture.addEventListener("pointermove", (event) => {
        if (this.held !== null) this.show(this.momentNearest(this.onPicture(event)));
      });
      for (const end of ["pointerup", "pointercancel"]) picture.addEventListener(end, () => (this.held = null));
    }

    onPicture(event) {
      const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.picture.getScreenCTM().inverse());
      return [x, y];
    }

    /** The moving point that can be taken at a place; null if none is near. */
    pointAt(place) {
      let nearest = null, least = 4 * this.motion.scene.offset;
      for (const point of this.motion.movingPoints) {
        const away = distance(this.motion.place(point, this.moment), place);
        if (away < least) [nearest, least] = [point, away];
      }
      return nearest;
    }

    momentNearest(place) {
      const { last, scene } = this.motion, reach = Math.max(2, Math.round(last / 8));
      let nearest = this.moment, least = Infinity;
      for (let ahead = -reach; ahead <= reach; ahead++) {
        let moment = this.moment + ahead;
        if (scene.closed) moment = ((moment % last) + last) % last;
        else if (moment < 0 || moment > last) continue;
        // Of moments equally near, the one that is fewer steps away.
        const away = distance(this.motion.place(this.held, moment), place) + 1e-9 * Math.abs(ahead);
        if (away < least) [nearest, least] = [moment, away];
      }
      return nearest;
    }
  }

  kempe.Player = Player;
})((globalThis.kempe = globalThis.kempe || {}));
