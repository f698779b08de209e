// The single drawing loop: all charts, the profiles and the string in space, once per frame of the browser.

import type { Connection } from "./connection.svelte";

interface Drawer {
  draw: () => void;
  connection: Connection | null;
}

/** Time over which frames are counted, ms. */
const COUNTED = 1000;

export class Loop {
  /** Frames per second, and those with new samples on all strip charts. */
  frames = $state(0);
  updates = $state(0);
  /** Drawing time per frame, ms. */
  drawing_ms = $state(0);
  #drawers: Drawer[] = [];

  /** Adds a drawing function; returns the function that removes it. */
  add(draw: () => void, connection: Connection | null): () => void {
    const drawer = { draw, connection };
    this.#drawers = [...this.#drawers, drawer];
    return () => {
      this.#drawers = this.#drawers.filter((other) => other !== drawer);
    };
  }

  /** Starts the loop; returns the function that stops it. */
  start(): () => void {
    let [request, since, frames, updates, spent, seen] = [0, performance.now(), 0, 0, 0, -1];
    const picture = () => {
      request = requestAnimationFrame(picture);
      const begin = performance.now();
      let next = seen;
      for (const { draw, connection } of this.#drawers) {
        draw();
        if (connection?.samples) next = connection.samples.next + connection.samples.epoch;
      }
      const now = performance.now();
      frames++;
      if (next !== seen) updates++;
      seen = next;
      spent += now - begin;
      if (now - since < COUNTED) return;
      const second = (now - since) / 1000;
      [this.frames, this.updates, this.drawing_ms] = [frames / second, updates / second, spent / frames];
      const log = document.documentElement.dataset;
      log.frames = this.frames.toFixed(1);
      log.updates = this.updates.toFixed(1);
      log.drawing = this.drawing_ms.toFixed(2);
      [since, frames, updates, spent] = [now, 0, 0, 0];
    };
    request = requestAnimationFrame(picture);
    return () => cancelAnimationFrame(request);
  }
}
