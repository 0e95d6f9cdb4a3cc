// SPDX-License-Identifier: Apache-2.0
import { defineConfig } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";

// One HTML file with script and style inside it: the template that quoin/view/page.cc writes scenes into.
export default defineConfig({
  plugins: [viteSingleFile({ removeViteModuleLoader: true })],
  build: { target: "es2022", modulePreload: false, chunkSizeWarningLimit: 2000, reportCompressedSize: false },
});
