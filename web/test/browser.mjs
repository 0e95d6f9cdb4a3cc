// SPDX-License-Identifier: Apache-2.0
// Opens pages in a headless Chromium that draws in software and may not reach any network.
import { chromium } from "playwright-core";
import { pathToFileURL } from "node:url";

const executablePath = process.env.CHROMIUM || "/usr/bin/chromium";
const flags = [
  "--no-sandbox",
  "--use-gl=angle",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
];

export async function launch(furtherFlags = []) {
  return chromium.launch({ executablePath, headless: true, args: [...flags, ...furtherFlags] });
}

/** A page that has finished loading; `problems` collects console errors, exceptions and attempts to reach a network. */
export async function open(browser, file, options = {}) {
  const context = await browser.newContext({
    viewport: { width: 1280, height: 800 },
    colorScheme: "light",
    offline: true,
    ...options,
  });
  const page = await context.newPage();
  const problems = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) problems.push(`${message.type()}: ${message.text()}`);
  });
  page.on("pageerror", (error) => problems.push(`exception: ${error.message}`));
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) problems.push(`request: ${request.url()}`);
  });
  await page.goto(pathToFileURL(file).href, { timeout: 120_000 });
  await page.waitForFunction(() => window.quoinView !== undefined, undefined, { timeout: 120_000 });
  return { page, problems, close: () => context.close() };
}
