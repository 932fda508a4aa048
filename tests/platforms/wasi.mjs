// SPDX-License-Identifier: MIT
// node wasi.mjs PROGRAM ARGUMENT...: runs a program of WebAssembly, which sees the folder that it is started in.
import { readFileSync } from "node:fs";
import { WASI } from "node:wasi";

const wasi = new WASI({ version: "preview1", args: process.argv.slice(2), preopens: { ".": "." }, returnOnExit: true });
const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]), wasi.getImportObject());
process.exitCode = wasi.start(instance);
