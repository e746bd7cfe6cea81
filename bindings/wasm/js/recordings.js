// SPDX-License-Identifier: MIT
// Recordings of moving boxes.
import { Held, wholeNumber } from "./core.js";

class Recording extends Held {
  constructor(core, handle, source) {
    super(core, handle);
    const { scene, objectsType, count, frames, dimension } = JSON.parse(core.checked(handle.head()));
    const world = core.reader(dimension).box();
    Object.assign(this, { source, scene, objectsType, count, frames, dimension, world });
  }

  boxes(frame) {
    this.core.checked(this.handle.read(wholeNumber(frame, "frame")));
    const first = this.handle.boxesAddress() / 4;
    return this.core.module.HEAPF32.slice(first, first + 2 * this.dimension * this.count);
  }
}

export const recordingParts = (core) => ({
  readRecording: (content, name = "recording") =>
    new Recording(core, core.checked(core.module.Recording.make(content, name)), name),
});
