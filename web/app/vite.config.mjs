import { svelte } from "@sveltejs/vite-plugin-svelte";
import { defineConfig } from "vite";
import { palette } from "./palette.plugin.mjs";

// The address of a served app, for `npm run dev`: what it prints at its start.
const served = process.env.WHOLESTRING_APP ?? "http://127.0.0.1:8480";

export default defineConfig({
  plugins: [palette(), svelte()],
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
