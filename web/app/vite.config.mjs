import { svelte } from "@sveltejs/vite-plugin-svelte";
import { defineConfig } from "vite";
import { fileURLToPath } from "node:url";

// The address of a served app, for `npm run dev`. It is started with `--plain-address --port 8480`, because Node does not
// find names under `localhost`, and entered at `127.0.0.1`, whose cookie reaches the port of Vite too.
const served = process.env.WHOLESTRING_APP ?? "http://127.0.0.1:8480";

// The components shared with the pages of reports have no packages of their own: they use those of this folder.
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

/** Module for requests of the page, by the mode of the build: `alone`, its own engine, otherwise the server. */
const asked = (mode) => fileURLToPath(new URL(`src/${mode === "alone" ? "alone" : "served"}/asked.ts`, import.meta.url));

export default defineConfig(({ mode }) => ({
  base: mode === "alone" ? "./" : "/",
  define: { __ALONE__: String(mode === "alone") },
  resolve: { alias: { "#asked": asked(mode) } },
  worker: { format: "es", rollupOptions: { output: { entryFileNames: "[name].js" } } },
  plugins: [packagesOfComponents, svelte()],
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
