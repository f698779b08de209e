// Bundles the page into crates/app/assets, where the server embeds it; with --check, compares the files there.
import { readdirSync, readFileSync, existsSync } from "node:fs";
import { gzipSync } from "node:zlib";
import { build } from "vite";

/** Largest total size of all files, compressed, bytes. */
const MOST = 1024 * 1024;

const assets = new URL("../../crates/app/assets/", import.meta.url);
const check = process.argv.includes("--check");
process.chdir(new URL(".", import.meta.url).pathname);
const made = await build({ logLevel: "warn", build: { write: !check } });
const files = new Map(made.output.map((file) => [file.fileName, Buffer.from(file.code ?? file.source)]));

let all = 0;
for (const [name, bytes] of files) {
  const size = gzipSync(bytes).length;
  all += size;
  if (!check) console.log(`${name}: ${(bytes.length / 1024).toFixed(0)} kB, ${(size / 1024).toFixed(0)} compressed`);
  else if (!existsSync(new URL(name, assets)) || !readFileSync(new URL(name, assets)).equals(bytes)) fail(`${name} differs from the build of web/app`);
}
if (check) for (const name of readdirSync(assets)) if (!files.has(name)) fail(`${name} is no longer made by web/app`);
if (all > MOST) fail(`${(all / 1024).toFixed(0)} kB compressed are more than ${MOST / 1024}`);

function fail(why) {
  console.error(`crates/app/assets: ${why}: run \`npm run bundle\` in web/app`);
  process.exitCode = 1;
}
