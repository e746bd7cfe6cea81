// SPDX-License-Identifier: MIT
import { fileURLToPath } from "node:url";

import { defineConfig } from "vite";

const root = fileURLToPath(new URL("..", import.meta.url));
/** The package of the WebAssembly module, as `./dev web` builds it. */
const engine = process.env["GRAZE_PACKAGE"] ?? `${root}/build/web/package`;

export default defineConfig({
  base: "./",
  resolve: {
    alias: [
      { find: /^graze$/, replacement: `${engine}/graze.js` },
      { find: /^graze\/(.*)$/, replacement: `${engine}/$1` },
    ],
  },
  server: { fs: { allow: [root, engine] } },
  build: {
    outDir: `${root}/build/web/viewer`,
    emptyOutDir: true,
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 2000,
    rollupOptions: { output: { inlineDynamicImports: true } },
  },
});
