// SPDX-License-Identifier: MIT
declare module "graze/graze_wasm.wasm?url" {
  const address: string;
  export default address;
}
