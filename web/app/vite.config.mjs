import { svelte } from "@sveltejs/vite-plugin-svelte";
import { defineConfig } from "vite";
import { fileURLToPath } from "node:url";
import { palette } from "./palette.plugin.mjs";

// The address of a served app, for `npm run dev`: what it prints at its start.
const served = process.env.WHOLESTRING_APP ?? "http://127.0.0.1:8480";

// The components that the report's pages share have no packages of their own: theirs are those of this folder.
const here = fileURLToPath(new URL("index.html", import.meta.url));
const packagesOfComponents = {
  name: "packages-of-components",
  enforce: "pre",
  resolveId: {
    filter: { id: /^(three|uplot)($|\/)/ },
    handler(source, importer, options) {
      return importer?.includes("/web/components/") ? this.resolve(source, here, { ...options, skipSelf: true }) : null;
    },
  },
};

/** Whom the page asks, by the mode of the build: `alone`, an engine of its own, else the server that has served it. */
const asked = (mode) => fileURLToPath(new URL(`src/${mode === "alone" ? "alone" : "served"}/asked.ts`, import.meta.url));

export default defineConfig(({ mode }) => ({
  base: mode === "alone" ? "./" : "/",
  define: { __ALONE__: String(mode === "alone") },
  resolve: { alias: { "#asked": asked(mode) } },
  worker: { format: "es", rollupOptions: { output: { entryFileNames: "[name].js" } } },
  plugins: [palette(), packagesOfComponents, svelte()],
  build: {
    outDir: mode === "alone" ? "../../target/playground" : "../../crates/app/assets",
    emptyOutDir: true,
    target: "es2022",
    modulePreload: { polyfill: false },
    cssCodeSplit: false,
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 1200,
    rollupOptions: {
      output: {
        entryFileNames: "app.js",
        chunkFileNames: "[name].js",
        assetFileNames: (asset) => (asset.names?.[0]?.endsWith(".css") ? "app.css" : "[name][extname]"),
      },
    },
  },
  server: { proxy: { "/api": { target: served, ws: true, changeOrigin: true } } },
}));
