// SPDX-License-Identifier: MIT
// Measures one step of moving boxes in the module: node bindings/wasm/bench.mjs [BOXES [STEPS]]. A step moves every
// box, in JavaScript, and finds all overlapping pairs. Cubes of side 1 fill a tenth of a cube, in which they bounce
// around, each moving by at most 0.1 along each axis: the world "brownian" of `graze bench`.
import { loadGraze } from "./test/native.mjs";

const [count, steps] = [10000, 300].map((usual, i) => Number(process.argv[2 + i] ?? usual));
const side = Math.cbrt(count * 10);
const graze = await loadGraze();

let seed = 1;
const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
const places = Float32Array.from({ length: 3 * count }, () => random() * side);
const speeds = Float32Array.from({ length: 3 * count }, () => (random() - 0.5) * 0.2);

/** Moves all centers by one step. */
function move() {
  for (let i = 0; i < places.length; ++i) {
    places[i] += speeds[i];
    if (places[i] < 0 || places[i] > side) speeds[i] = -speeds[i];
  }
}

/** Writes the boxes around the centers. */
function writeBoxes(boxes) {
  for (let i = 0; i < count; ++i) {
    for (let k = 0; k < 3; ++k) {
      boxes[6 * i + k] = places[3 * i + k] - 0.5;
      boxes[6 * i + 3 + k] = places[3 * i + k] + 0.5;
    }
  }
}

/** The median time of a step in milliseconds, after some warm-up steps. */
function timed(name, step) {
  const times = [];
  let pairs = 0;
  for (let i = -30; i < steps; ++i) {
    move();
    const start = performance.now();
    pairs = step();
    if (i >= 0) times.push(performance.now() - start);
  }
  times.sort((a, b) => a - b);
  const [median, most] = [times[steps >> 1], times[Math.floor(steps * 0.95)]];
  console.log(`${name}: ${median.toFixed(2)} ms (95 % below ${most.toFixed(2)} ms), ${pairs} pairs`);
}

console.log(`${count} boxes in 3D, ${steps} steps, median of a step:`);
for (const order of ["any", "sorted"]) {
  const finder = new graze.PairFinder(3, count);
  timed(`PairFinder, pairs ${order}`, () => {
    writeBoxes(finder.boxes);
    return finder.find({ order }).length / 2;
  });
}
const boxes = new Float32Array(6 * count);
const scene = new graze.Scene(3);
writeBoxes(boxes);
const ids = scene.addBoxes(boxes);
timed("Scene, moved and updated", () => {
  writeBoxes(boxes);
  scene.moveBoxes(ids, boxes);
  const { began, stayed } = scene.update();
  return (began.length + stayed.length) / 2;
});
