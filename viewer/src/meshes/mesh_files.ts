// SPDX-License-Identifier: MIT
// Reads files of triangles with three's loaders: STL, OBJ, PLY, glTF and GLB. The format is told by the content.
import * as THREE from "three";
import type { GLTFParser, GLTFLoaderPlugin } from "three/addons/loaders/GLTFLoader.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { OBJLoader } from "three/addons/loaders/OBJLoader.js";
import { PLYLoader } from "three/addons/loaders/PLYLoader.js";
import { STLLoader } from "three/addons/loaders/STLLoader.js";

import { messageOf } from "../engine";
import { MeshBuilder, turnedUp, type MeshData, type MeshSource } from "./mesh_data";

type Format = "STL" | "OBJ" | "PLY" | "glTF";

const extensions = /\.(stl|obj|ply|gltf|glb)$/i;

/** Whether a file is for this tab, by its name. */
export function isMeshFile(file: File): boolean {
  return extensions.test(file.name);
}

/** The parts of all files of triangles among those that were dropped together; the others are what they may refer to.
 * Throws an Error that names the file and what is wrong with it. */
export async function meshesOf(files: readonly File[]): Promise<MeshSource> {
  const named = files.filter(isMeshFile);
  const main = named.length > 0 ? named : files.slice(0, 1);
  const parts: MeshData[] = [];
  for (const file of main) {
    try {
      parts.push(...(await partsOf(file, files)));
    } catch (error) {
      throw new Error(`${file.name}: ${messageOf(error)}`);
    }
  }
  return { name: main.map(({ name }) => name).join(", "), parts };
}

async function partsOf(file: File, files: readonly File[]): Promise<MeshData[]> {
  const content = await file.arrayBuffer();
  const format = formatOf(new Uint8Array(content));
  if (format === undefined) throw new Error("it is not a mesh; the formats are STL, OBJ, PLY, glTF and GLB");
  let parts: MeshData[];
  try {
    parts = format === "glTF" ? await partsOfScene(content, files) : partsOfContent(format, content, file.name);
  } catch (error) {
    if (error instanceof MissingFile) throw error;
    throw new Error(`it is not a valid ${format} file: ${explained(error)}`);
  }
  const filled = parts.filter(({ faces }) => faces.length > 0);
  if (filled.length === 0) throw new Error(`there are no triangles in it`);
  checkCoordinates(filled);
  return filled;
}

/** Told by the first bytes; a binary STL, which begins with anything, by its length. */
function formatOf(bytes: Uint8Array): Format | undefined {
  const start = new TextDecoder().decode(bytes.subarray(0, 2000)).replace(/^\ufeff/, "").trimStart();
  if (start.startsWith("glTF")) return "glTF";
  if (/^ply\s/.test(start)) return "PLY";
  const isBinaryStl = bytes.length >= 84 && bytes.length === 84 + 50 * new DataView(bytes.buffer, bytes.byteOffset).getUint32(80, true);
  if (isBinaryStl || /^solid\b/i.test(start)) return "STL";
  if (start.startsWith("{")) return "glTF";
  return /^(#.*|\s*|mtllib .*|[og] .*)*^v\s/m.test(start) ? "OBJ" : undefined;
}

function partsOfContent(format: Format, content: ArrayBuffer, name: string): MeshData[] {
  const own = name.replace(extensions, "");
  if (format === "STL") return [partOf(own, [{ geometry: new STLLoader().parse(content) }])];
  if (format === "PLY") {
    const geometry = new PLYLoader().parse(content);
    return geometry.index === null ? [] : [partOf(own, [{ geometry }])];
  }
  const group = new OBJLoader().parse(new TextDecoder().decode(content));
  return group.children.flatMap((child, place) => (child instanceof THREE.Mesh ? [partOf(child.name || `${own} ${place + 1}`, [{ geometry: child.geometry as THREE.BufferGeometry }])] : []));
}

/** The parts of a glTF scene, with all transforms applied, and turned from y up to z up. */
async function partsOfScene(content: ArrayBuffer, files: readonly File[]): Promise<MeshData[]> {
  const manager = new THREE.LoadingManager();
  const addresses = new Map(files.map((file) => [file.name, URL.createObjectURL(file)]));
  manager.setURLModifier((url) => {
    if (/^(data|blob):/.test(url)) return url;
    const name = decodeURIComponent(url.split("/").at(-1) ?? url);
    const address = addresses.get(name);
    if (address === undefined) throw new MissingFile(`it refers to ${name}; drop that file together with it`);
    return address;
  });
  const loader = new GLTFLoader(manager).register((parser) => new Bare(parser));
  try {
    const { scene, parser } = await loader.parseAsync(content, "");
    scene.updateMatrixWorld(true);
    return [...piecesByPart(scene, parser)].map(([part, pieces], place) => turnedUp(partOf(part.name || `part ${place + 1}`, pieces)));
  } finally {
    for (const address of addresses.values()) URL.revokeObjectURL(address);
  }
}

class MissingFile extends Error {}

/** Materials and their pictures are not needed. */
class Bare implements GLTFLoaderPlugin {
  readonly name = "graze_bare";
  constructor(readonly parser: GLTFParser) {}

  loadMaterial(): Promise<THREE.Material> {
    return Promise.resolve(new THREE.MeshBasicMaterial());
  }
}

interface Piece {
  readonly geometry: THREE.BufferGeometry;
  readonly matrix?: THREE.Matrix4;
}

/** The pieces of each mesh of the file: its primitives, and copies by instancing. */
function piecesByPart(scene: THREE.Object3D, { associations }: GLTFParser): Map<THREE.Object3D, Piece[]> {
  const found = new Map<THREE.Object3D, Piece[]>();
  scene.traverse((object) => {
    if (!(object instanceof THREE.Mesh)) return;
    const { parent } = object;
    const own = associations.get(object);
    const isPrimitive = parent !== null && own?.primitives !== undefined && associations.get(parent)?.meshes === own.meshes;
    const part = isPrimitive ? parent : object;
    const pieces = found.get(part) ?? [];
    found.set(part, pieces);
    const geometry = object.geometry as THREE.BufferGeometry;
    if (!(object instanceof THREE.InstancedMesh)) {
      pieces.push({ geometry, matrix: object.matrixWorld });
      return;
    }
    for (let i = 0; i < object.count; ++i) {
      const matrix = new THREE.Matrix4();
      object.getMatrixAt(i, matrix);
      pieces.push({ geometry, matrix: matrix.premultiply(object.matrixWorld) });
    }
  });
  return found;
}

function partOf(name: string, pieces: readonly Piece[]): MeshData {
  const builder = new MeshBuilder();
  for (const piece of pieces) addPiece(builder, piece);
  return builder.data(name);
}

/** Faces keep their outside if the matrix mirrors. */
function addPiece(builder: MeshBuilder, { geometry, matrix = new THREE.Matrix4() }: Piece): void {
  const positions = geometry.getAttribute("position") as THREE.BufferAttribute | undefined;
  if (positions === undefined) return;
  const place = new THREE.Vector3();
  let first = -1;
  for (let i = 0; i < positions.count; ++i) {
    place.fromBufferAttribute(positions, i).applyMatrix4(matrix);
    const vertex = builder.vertex(place.x, place.y, place.z);
    if (i === 0) first = vertex;
  }
  const { index } = geometry;
  const corners = index?.count ?? positions.count;
  const corner = (i: number): number => first + (index?.getX(i) ?? i);
  const isMirrored = matrix.determinant() < 0;
  for (let i = 0; i + 2 < corners; i += 3) {
    if (isMirrored) builder.face(corner(i), corner(i + 2), corner(i + 1));
    else builder.face(corner(i), corner(i + 1), corner(i + 2));
  }
}

function checkCoordinates(parts: readonly MeshData[]): void {
  for (const { name, vertices } of parts) {
    const wrong = vertices.findIndex((value) => !Number.isFinite(value));
    if (wrong >= 0) throw new Error(`vertex ${Math.floor(wrong / 3)} of ${name} has a coordinate that is missing or not a finite number`);
  }
}

/** What a loader says, in the words of someone who has a file. */
function explained(error: unknown): string {
  const message = messageOf(error).replace(/^THREE\.\w+: /, "");
  if (/DRACO|Meshopt/i.test(message)) return "its triangles are compressed; export it without compression";
  if (error instanceof RangeError) return "it ends before its last triangle";
  return message;
}
