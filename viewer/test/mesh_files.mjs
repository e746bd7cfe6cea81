// SPDX-License-Identifier: MIT
// Files of triangles, written for the tests of the viewer.

const corners = Array.from({ length: 8 }, (_, i) => [i & 1, (i >> 1) & 1, i >> 2]);
const sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

/** A cube with a corner at `from`, a point or the same number for all coordinates, and two triangles a side. */
export function cube(from = 0, size = 1) {
  const vertices = corners.map((corner) => corner.map((value, axis) => (from[axis] ?? from) + size * value));
  return { vertices, faces: sides.flatMap(([a, b, c, d]) => [[a, b, c], [a, c, d]]) };
}

/** A bumpy sheet of 2 (width - 1)^2 faces. */
export function sheet(width) {
  const at = (row, column) => row * width + column;
  const vertices = Array.from({ length: width * width }, (_, i) => [i % width, Math.floor(i / width), 3 * Math.sin(i % width / 9) * Math.cos(i / width / 7)]);
  const faces = [];
  for (let row = 1; row < width; ++row) {
    for (let column = 1; column < width; ++column) {
      faces.push([at(row - 1, column - 1), at(row - 1, column), at(row, column)], [at(row - 1, column - 1), at(row, column), at(row, column - 1)]);
    }
  }
  return { vertices, faces };
}

export function binaryStl({ vertices, faces }) {
  const bytes = Buffer.alloc(84 + 50 * faces.length);
  bytes.write("solid, although it is binary");
  bytes.writeUInt32LE(faces.length, 80);
  faces.forEach((face, i) => face.flatMap((vertex) => vertices[vertex]).forEach((value, k) => bytes.writeFloatLE(value, 84 + 50 * i + 12 + 4 * k)));
  return bytes;
}

export function textStl({ vertices, faces }) {
  const facets = faces.map((face) => `facet normal 0 0 0\nouter loop\n${face.map((vertex) => `vertex ${vertices[vertex].join(" ")}`).join("\n")}\nendloop\nendfacet`);
  return `solid cube\n${facets.join("\n")}\nendsolid cube\n`;
}

export function ply({ vertices, faces }) {
  return ["ply", "format ascii 1.0", `element vertex ${vertices.length}`, "property float x", "property float y", "property float z",
    `element face ${faces.length}`, "property list uchar int vertex_indices", "end_header",
    ...vertices.map((vertex) => vertex.join(" ")), ...faces.map((face) => `3 ${face.join(" ")}`), ""].join("\n");
}

/** An object for each mesh, by name. */
export function obj(meshes) {
  let first = 1;
  return Object.entries(meshes).map(([name, { vertices, faces }]) => {
    const lines = [`o ${name}`, ...vertices.map((vertex) => `v ${vertex.join(" ")}`), ...faces.map((face) => `f ${face.map((vertex) => vertex + first).join(" ")}`)];
    first += vertices.length;
    return lines.join("\n");
  }).join("\n");
}

/** A glTF with a node for each entry of `nodes` ({ name, mesh, ...transform }), and its buffer; a mesh is a list of
 * primitives. */
export function gltf(meshes, nodes, uri) {
  const accessors = [];
  const bufferViews = [];
  const chunks = [];
  let length = 0;
  const add = (bytes, accessor) => {
    bufferViews.push({ buffer: 0, byteOffset: length, byteLength: bytes.length });
    chunks.push(bytes);
    length += bytes.length;
    return accessors.push({ bufferView: bufferViews.length - 1, ...accessor }) - 1;
  };
  const primitive = ({ vertices, faces }) => ({
    attributes: {
      POSITION: add(Buffer.from(Float32Array.from(vertices.flat()).buffer), { componentType: 5126, count: vertices.length, type: "VEC3", min: [0, 0, 0], max: [1, 1, 1] }),
    },
    indices: add(Buffer.from(Uint32Array.from(faces.flat()).buffer), { componentType: 5125, count: 3 * faces.length, type: "SCALAR" }),
    material: 0,
  });
  const json = {
    asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: nodes.map((_, i) => i) }], nodes,
    meshes: meshes.map((primitives, i) => ({ name: `mesh${i}`, primitives: primitives.map(primitive) })),
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }], textures: [{ source: 0 }], images: [{ uri: "missing.png" }],
    accessors, bufferViews, buffers: [{ byteLength: length, ...(uri === undefined ? {} : { uri }) }],
  };
  return { json, buffer: Buffer.concat(chunks) };
}

export function glb(meshes, nodes) {
  const { json, buffer } = gltf(meshes, nodes);
  const text = Buffer.from(JSON.stringify(json));
  const padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, " ")]);
  const head = Buffer.alloc(20);
  head.write("glTF");
  [2, 28 + padded.length + buffer.length, padded.length].forEach((value, i) => head.writeUInt32LE(value, 4 + 4 * i));
  head.write("JSON", 16);
  const second = Buffer.alloc(8);
  second.writeUInt32LE(buffer.length, 0);
  second.write("BIN\0", 4);
  return Buffer.concat([head, padded, second, buffer]);
}
