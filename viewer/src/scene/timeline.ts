// SPDX-License-Identifier: MIT
// Motion in scenes: recordings of boxes, and scenes whose objects have velocities. Frame 0 is the content of the file.
import type { Graze, Recording, Scene } from "graze";

/** The number of frames for objects with velocities, and the seconds between frames. */
const framesOfVelocities = 601;
const secondsPerFrame = 1 / 60;

export interface Timeline {
  readonly frames: number;
  /** The ids of the moving objects. */
  readonly movers: Float64Array;
  /** Text shown beside the number of a frame. */
  timeOf(frame: number): string;
  /** Moves the objects of the scene to their positions in a frame. Throws with the engine's message. */
  show(frame: number): void;
  close(): void;
}

/** The scene of a recording's boxes, and their motion. */
export function openRecording(graze: Graze, content: Uint8Array, name: string): { scene: Scene; timeline: Timeline } {
  const recording: Recording = graze.readRecording(content, name);
  const scene = new graze.Scene(recording.dimension);
  try {
    const movers = scene.addBoxes(recording.boxes(0));
    const timeline = {
      frames: recording.frames,
      movers,
      timeOf: () => "",
      show: (frame: number) => scene.moveBoxes(movers, recording.boxes(frame)),
      close: () => recording.delete(),
    };
    return { scene, timeline };
  } catch (error) {
    scene.delete();
    recording.delete();
    throw error;
  }
}

/** The motion of a scene's objects with velocities; undefined if none has one. */
export function timelineOf(scene: Scene): Timeline | undefined {
  const movers = Float64Array.from(scene.velocities(), ({ id }) => id);
  if (movers.length === 0) return undefined;
  return {
    frames: framesOfVelocities,
    movers,
    timeOf: (frame) => `${(frame * secondsPerFrame).toFixed(2)} s`,
    show: (frame) => scene.moveToTime(frame * secondsPerFrame),
    close: () => undefined,
  };
}
