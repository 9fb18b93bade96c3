// Builds the page: static files that work below any address.
import { defineConfig } from "vite";

export default defineConfig({
  root: "www",
  base: "./",
  build: { outDir: "dist", emptyOutDir: true, target: ["chrome111", "firefox114", "safari16.4"] },
  worker: { format: "es" },
});
