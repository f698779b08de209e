import { svelte } from "@sveltejs/vite-plugin-svelte";
import { defineConfig } from "vite";
import { fileURLToPath } from "node:url";
import { palette } from "./palette.plugin.mjs";

// The address of a served app, for `npm run dev`: what it prints at its start.
const served = process.env.WHOLESTRING_APP ?? "http://127.0.0.1:8480";

// The components that the report's pages share have no packages of their own.
const packages = fileURLToPath(new URL("node_modules/", import.meta.url));

export default defineConfig({
  plugins: [palette(), svelte()],
  resolve: { alias: ["three", "uplot"].map((find) => ({ find: new RegExp(`^${find}(?=$|/)`), replacement: packages + find })) },
  build: {
    outDir: "../../crates/app/assets",
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
});
