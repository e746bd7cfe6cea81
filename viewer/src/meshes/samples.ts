// SPDX-License-Identifier: MIT
// Meshes that the page makes by itself.
import { MeshBuilder, type MeshData, type MeshSource } from "./mesh_data";

const turn = 2 * Math.PI;

/** A closed gear about the z axis: teeth with flat tops, and a bore. Its first tooth points along x. */
function gear(name: string, teeth: number, [x, y, z]: readonly [number, number, number], angle: number): MeshData {
  const steps = 10 * teeth;
  const half = 0.25;
  const bore = 0.35;
  const builder = new MeshBuilder();
  const ring = (radius: (phase: number) => number, height: number): number[] =>
    Array.from({ length: steps }, (_, i) => {
      const phase = (turn * i) / steps;
      const reach = radius(phase);
      return builder.vertex(x + reach * Math.cos(phase + angle), y + reach * Math.sin(phase + angle), z + height);
    });
  const tooth = (phase: number): number => 1 + 0.12 * (Math.tanh(2.2 * Math.cos(teeth * phase)) / Math.tanh(2.2));
  const [lowOut, highOut, highIn, lowIn] = [ring(tooth, -half), ring(tooth, half), ring(() => bore, half), ring(() => bore, -half)];
  const rings = [lowOut, highOut, highIn, lowIn, lowOut];
  for (let band = 0; band < 4; ++band) {
    for (let i = 0; i < steps; ++i) {
      const next = (i + 1) % steps;
      const [a, b, c, d] = [rings[band]?.[i], rings[band]?.[next], rings[band + 1]?.[next], rings[band + 1]?.[i]];
      builder.quad(a ?? 0, b ?? 0, c ?? 0, d ?? 0);
    }
  }
  return builder.data(name);
}

/** A closed tube around a curve, given by its points for a parameter from 0 to 1. */
function tube(name: string, curve: (share: number) => [number, number, number], radius: number, along: number, around: number): MeshData {
  const builder = new MeshBuilder();
  const at = (i: number): readonly number[] => curve(i / along);
  const rows: number[][] = [];
  for (let i = 0; i < along; ++i) {
    const place = at(i);
    const way = unit(minus(at(i + 1), at(i - 1)));
    // The second difference leads into the bend, which keeps the frame from turning around the curve.
    const bend = minus(minus(at(i + 1), place), minus(place, at(i - 1)));
    const side = unit(minus(bend, scaled(way, inner(bend, way))));
    const up = [
      (way[1] ?? 0) * (side[2] ?? 0) - (way[2] ?? 0) * (side[1] ?? 0),
      (way[2] ?? 0) * (side[0] ?? 0) - (way[0] ?? 0) * (side[2] ?? 0),
      (way[0] ?? 0) * (side[1] ?? 0) - (way[1] ?? 0) * (side[0] ?? 0),
    ];
    rows.push(Array.from({ length: around }, (_, k) => {
      const [right, high] = [radius * Math.cos((turn * k) / around), radius * Math.sin((turn * k) / around)];
      const point = place.map((value, axis) => value + right * (side[axis] ?? 0) + high * (up[axis] ?? 0));
      return builder.vertex(point[0] ?? 0, point[1] ?? 0, point[2] ?? 0);
    }));
  }
  for (let i = 0; i < along; ++i) {
    const [row, next] = [rows[i] ?? [], rows[(i + 1) % along] ?? []];
    for (let k = 0; k < around; ++k) {
      const beside = (k + 1) % around;
      builder.quad(row[k] ?? 0, row[beside] ?? 0, next[beside] ?? 0, next[k] ?? 0);
    }
  }
  return builder.data(name);
}

const minus = (a: readonly number[], b: readonly number[]): number[] => a.map((value, axis) => value - (b[axis] ?? 0));
const scaled = (a: readonly number[], factor: number): number[] => a.map((value) => value * factor);
const inner = (a: readonly number[], b: readonly number[]): number => a.reduce((sum, value, axis) => sum + value * (b[axis] ?? 0), 0);
const unit = (a: readonly number[]): number[] => scaled(a, 1 / (Math.hypot(...a) || 1));

/** A trefoil of a hundred thousand faces, and a ring around one of its strands. */
function knot(): MeshData[] {
  const trefoil = tube("trefoil", (share) => {
    const angle = turn * share;
    const reach = 1.2 + 0.55 * Math.cos(3 * angle);
    return [reach * Math.cos(2 * angle), reach * Math.sin(2 * angle), 1 + 0.62 * Math.sin(3 * angle)];
  }, 0.24, 1000, 50);
  const ring = tube("ring", (share) => [1.75 + 0.5 * Math.cos(turn * share), 0.42 * Math.sin(turn * share), 1 + 0.5 * Math.sin(turn * share)], 0.09, 96, 24);
  return [trefoil, ring];
}

/** A ball whose radius depends on the direction: rows from pole to pole. */
function pebble(name: string, center: readonly number[], radius: (across: number, down: number) => number, rows: number, isKept: (row: number, column: number) => boolean = () => true): MeshData {
  const builder = new MeshBuilder();
  const around = 2 * rows;
  const [x = 0, y = 0, z = 0] = center;
  const vertices = Array.from({ length: rows - 1 }, (_, row) =>
    Array.from({ length: around }, (_, column) => {
      const [down, across] = [(Math.PI * (row + 1)) / rows, (turn * column) / around];
      const reach = radius(across, down);
      return builder.vertex(x + reach * Math.sin(down) * Math.cos(across), y + reach * Math.sin(down) * Math.sin(across), z + reach * Math.cos(down));
    }),
  );
  const [top, bottom] = [builder.vertex(x, y, z + radius(0, 0)), builder.vertex(x, y, z - radius(0, Math.PI))];
  for (let column = 0; column < around; ++column) {
    const next = (column + 1) % around;
    builder.face(top, vertices[0]?.[column] ?? 0, vertices[0]?.[next] ?? 0);
    builder.face(bottom, vertices[rows - 2]?.[next] ?? 0, vertices[rows - 2]?.[column] ?? 0);
    for (let row = 0; row + 2 < rows; ++row) {
      if (!isKept(row, column)) continue;
      const [upper, lower] = [vertices[row] ?? [], vertices[row + 1] ?? []];
      builder.quad(upper[column] ?? 0, lower[column] ?? 0, lower[next] ?? 0, upper[next] ?? 0);
    }
  }
  return builder.data(name);
}

/** A pebble with two holes, a patch that is turned inside out, and a fin. */
function broken(): MeshData[] {
  const isHole = (row: number, column: number): boolean => (row - 12) ** 2 + (column - 34) ** 2 < 26 || (Math.abs(row - 18) < 3 && column > 56);
  const shape = pebble("pebble", [0, 0, 1.2], (across, down) => 1 + 0.14 * Math.sin(3 * across) * Math.sin(down) ** 2 + 0.1 * Math.cos(2 * down), 32, (row, column) => !isHole(row, column));
  const faces = Array.from(shape.faces);
  const center = (face: number): number[] => [0, 1, 2].map((axis) => [0, 1, 2].reduce((sum, corner) => sum + (shape.vertices[3 * (faces[face + corner] ?? 0) + axis] ?? 0) / 3, 0));
  for (let face = 0; face < faces.length; face += 3) {
    const [x = 0, y = 0, z = 0] = center(face);
    if (Math.hypot(x + 0.75, y + 0.62, z - 1.2) < 0.34) [faces[face + 1], faces[face + 2]] = [faces[face + 2] ?? 0, faces[face + 1] ?? 0];
  }
  // A fin on an edge that already has two faces.
  const fin = shape.vertices.length / 3;
  const [a = 0, b = 0] = [faces[3], faces[4]];
  const tip = [0, 1, 2].map((axis) => (shape.vertices[3 * a + axis] ?? 0) * 0.75 + (shape.vertices[3 * b + axis] ?? 0) * 0.75 - (axis === 2 ? 0.6 : 0));
  return [{ name: "pebble", vertices: Float64Array.from([...shape.vertices, ...tip]), faces: Uint32Array.from([...faces, a, b, fin]) }];
}

/** Hills over a square, which is not closed, and a ball above them. */
function terrain(): MeshData[] {
  const [width, size] = [120, 5];
  const builder = new MeshBuilder();
  const height = (x: number, y: number): number => 0.45 * Math.sin(1.6 * x + 0.4) * Math.cos(1.3 * y) + 0.25 * Math.sin(2.7 * y + x) + 0.06 * Math.sin(7 * x) * Math.sin(6 * y);
  for (let row = 0; row < width; ++row) {
    for (let column = 0; column < width; ++column) {
      const [x, y] = [size * (column / (width - 1) - 0.5), size * (row / (width - 1) - 0.5)];
      const corner = builder.vertex(x, y, 0.8 + height(x, y));
      if (row > 0 && column > 0) builder.quad(corner - width - 1, corner - width, corner, corner - 1);
    }
  }
  return [pebble("ball", [-0.35, -0.65, 1.85], () => 0.6, 24), { ...builder.data("terrain"), isSheet: true }];
}

/** Sources by name, the default first; the first part is the one that is moved. */
export const samples: Readonly<Record<string, () => MeshSource>> = {
  gears: () => ({ name: "gears", parts: [gear("right gear", 10, [1.58, 0, 1.2], 0.06), gear("left gear", 10, [-0.46, 0, 1.2], turn / 20)] }),
  knot: () => ({ name: "knot", parts: knot().reverse() }),
  broken: () => ({ name: "broken", parts: broken() }),
  terrain: () => ({ name: "terrain", parts: terrain() }),
};
