// SPDX-License-Identifier: MIT
import { createGraze } from "graze";

const graze = await createGraze();
const ball = { type: "sphere", center: [0, 3], radius: 1 };
globalThis.answer = graze.distance(ball, { type: "half_space", normal: [0, 1], offset: 0 });
