// SPDX-License-Identifier: MIT
// Scenes in time: recordings of boxes, and scenes whose objects have velocities. Frame 0 is what the file says.
import type { Graze, Recording, Scene } from "graze";

/** Objects that move straight on are shown for so many frames, each so many seconds after the one before. */
const framesOfVelocities = 601;
const secondsPerFrame = 1 / 60;

export interface Timeline {
  readonly frames: number;
  /** The ids of the objects that move. */
  readonly movers: Float64Array;
  /** What is to be said of a frame beside its number. */
  timeOf(frame: number): string;
  /** Moves the objects of the scene to where they are in a frame. Throws with the engine's message. */
  show(frame: number): void;
  close(): void;
}

/** The scene of a recording's boxes, and how they move. */
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

/** How the objects of a scene move that have velocities; nothing if none has. */
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
