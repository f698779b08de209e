// Bundles the page without a server into target/playground, with the engine in WebAssembly, whose file is the argument.
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { build } from "vite";

const engine = resolve(process.argv[2]);
const folder = fileURLToPath(new URL("../../target/playground/", import.meta.url));
process.chdir(fileURLToPath(new URL(".", import.meta.url)));
await build({ mode: "alone", logLevel: "warn" });
const bytes = readFileSync(engine);
// Compressed here, because not every file server compresses.
writeFileSync(`${folder}engine.bin`, gzipSync(bytes, { level: 9 }));

const kB = (bytes) => (bytes / 1024).toFixed(0).padStart(6);
let all = 0;
for (const name of readdirSync(folder)) {
  const file = readFileSync(folder + name);
  const whole = name === "engine.bin" ? bytes.length : file.length;
  const size = name === "engine.bin" ? file.length : gzipSync(file, { level: 9 }).length;
  all += size;
  console.log(`${kB(whole)} kB, ${kB(size)} compressed: ${name}`);
}
console.log(`${kB(all)} kB compressed in all: ${folder}`);
