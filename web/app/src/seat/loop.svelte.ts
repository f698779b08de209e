// The one loop that draws: all charts, the profiles and the string in space, once for each picture of the browser.

import type { Connection } from "./connection.svelte";

interface Drawer {
  draw: () => void;
  connection: Connection | null;
}

/** Time over which pictures are counted, ms. */
const COUNTED = 1000;

export class Loop {
  /** Pictures in a second, and those of them that showed new samples on all strip charts. */
  frames = $state(0);
  updates = $state(0);
  /** What drawing took, of a picture, ms. */
  drawing_ms = $state(0);
  #drawers: Drawer[] = [];

  /** Draws this too; gives what ends it. */
  add(draw: () => void, connection: Connection | null): () => void {
    const drawer = { draw, connection };
    this.#drawers = [...this.#drawers, drawer];
    return () => {
      this.#drawers = this.#drawers.filter((other) => other !== drawer);
    };
  }

  /** Begins; gives what ends it. */
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
