// SPDX-License-Identifier: MIT
// graze itself: the C++ library as WebAssembly. A report page contains it; otherwise it is fetched.
import createGraze, { type Graze } from "graze";
import wasmAddress from "graze/graze_wasm.wasm?url";

export async function loadEngine(): Promise<Graze> {
  const inPage = document.getElementById("graze-wasm")?.textContent;
  if (inPage !== undefined && inPage !== null) return createGraze({ wasmBinary: await unpacked(inPage) });
  return createGraze({ locateFile: () => wasmAddress });
}

/** Decodes base64 and decompresses gzip. */
async function unpacked(base64: string): Promise<Uint8Array> {
  const packed = Uint8Array.from(atob(base64.trim()), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The message of an exception from the engine. */
export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
