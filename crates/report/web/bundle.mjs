// Bundles the pages' programs and looks into ../assets, where Rust takes them from; with --check, says whether they are
// what is there already.
import { readFileSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const assets = new URL("../assets/", import.meta.url);
const here = new URL("./", import.meta.url).pathname;

const { outputFiles } = await build({
  entryPoints: { report: "src/main.js", sweep: "src/sweep.js" },
  absWorkingDir: here,
  outdir: "out",
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  charset: "utf8",
  legalComments: "inline",
  write: false,
  // The components beside the app have no packages of their own.
  nodePaths: [`${here}node_modules`],
});

const files = new Map(outputFiles.map((file) => [file.path.split("/").pop(), file.text]));
const licence = (name) =>
  `${name}\n\n${readFileSync(new URL(`node_modules/${name}/LICENSE`, import.meta.url), "utf8").trim()}\n`;
files.set("licences.txt", ["uplot", "three"].map(licence).join("\n").replaceAll("\r", ""));

const check = process.argv.includes("--check");
for (const [name, text] of files) {
  const path = new URL(name, assets);
  if (!check) {
    writeFileSync(path, text);
    console.log(`${name}: ${(text.length / 1024).toFixed(0)} kB`);
  } else if (readFileSync(path, "utf8") !== text) {
    console.error(`crates/report/assets/${name} is not what web/ makes: run \`npm run bundle\` in crates/report/web`);
    process.exitCode = 1;
  }
}
