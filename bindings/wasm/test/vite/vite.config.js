// SPDX-License-Identifier: MIT
export default { base: "./", build: { target: "esnext", modulePreload: false } };
