// SPDX-License-Identifier: Apache-2.0
import { defineConfig } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";

// One HTML file with script and style inside it for each kind of page: the templates that quoin/view writes into.
// `--mode picture`, `--mode sphere`, `--mode plan` and `--mode layers` build the pages of those names beside index.html.
export default defineConfig(({ mode }) => {
  const isFirst = mode === "production" || mode === "development";
  return {
    plugins: [viteSingleFile({ removeViteModuleLoader: true })],
    build: {
      target: "es2022",
      modulePreload: false,
      chunkSizeWarningLimit: 2000,
      reportCompressedSize: false,
      emptyOutDir: isFirst,
      rollupOptions: { input: isFirst ? "index.html" : `${mode}.html` },
    },
  };
});
