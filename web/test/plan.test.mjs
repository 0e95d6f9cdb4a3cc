// SPDX-License-Identifier: Apache-2.0
// Looks at the plans that make_plans.cc writes, as a person would: QUOIN_PAGES=directory npm test
import assert from "node:assert/strict";
import { after, before, describe, it } from "node:test";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { launch, open } from "./browser.mjs";
import { decodePng, differingPixels } from "./png.mjs";

const pages = process.env.QUOIN_PAGES;
assert.ok(pages, "QUOIN_PAGES names the directory of the pages");
const shots = process.env.QUOIN_SCREENSHOTS;

async function picture(page, name) {
  await page.waitForTimeout(200);
  const bytes = await page.screenshot({ animations: "disabled" });
  if (shots && name) {
    mkdirSync(shots, { recursive: true });
    writeFileSync(join(shots, `${name}.png`), bytes);
  }
  return decodePng(bytes);
}

/** A pixel where the sphere shows a cell of the kind and index. */
function whereIs(page, kind, index) {
  return page.evaluate(
    ([kind, index]) => {
      const { left, top, width, height } = document.querySelector(".directions canvas").getBoundingClientRect();
      for (let y = top; y < top + height; y += 4)
        for (let x = left; x < left + width; x += 4) {
          const cell = window.quoinView.pick(x, y);
          if (cell?.kind === kind && cell.index === index) return { x, y };
        }
      return undefined;
    },
    [kind, index],
  );
}

const offsets = (page) => page.evaluate(() => window.quoinView.offsets());

describe("plans", () => {
  let browser;
  before(async () => (browser = await launch()));
  after(() => browser?.close());

  async function look(name, options, action) {
    const { page, problems, close } = await open(browser, join(pages, `${name}.html`), options);
    try {
      await action(page);
      assert.deepEqual(problems, [], "console errors and requests");
    } finally {
      await close();
    }
  }

  it("play the steps", async () => {
    await look("plan", {}, async (page) => {
      assert.equal(await page.evaluate(() => window.quoinView.steps()), 2);
      const together = await picture(page, "plan");
      assert.match(await page.locator(".caption").innerText(), /Step 1 of 2: <top> along \(0, 0, 1\)/);
      await page.keyboard.press("ArrowRight");
      const [low, middle, top] = await offsets(page);
      assert.deepEqual([low, middle], [[0, 0, 0], [0, 0, 0]]);
      assert.ok(top[2] > 1 && top[0] === 0);
      assert.match(await page.locator(".caption").innerText(), /Step 2 of 2: middle/);
      await page.keyboard.press("ArrowRight");
      assert.ok((await offsets(page))[1][2] > 1);
      assert.ok(differingPixels(together, await picture(page, "plan-apart")) > 0.01);
      await page.getByRole("button", { name: "Play" }).click();
      await page.waitForFunction(() => window.quoinView.time() > 0.3 && window.quoinView.time() < 1);
      await page.getByRole("button", { name: "Pause" }).click();
    });
  });

  it("offer alternatives", async () => {
    await look("plan", {}, async (page) => {
      await page.getByRole("button", { name: "middle, <top> along (0, 0, 1)" }).click();
      assert.equal(await page.evaluate(() => window.quoinView.steps()), 2);
      await page.evaluate(() => window.quoinView.seek(1));
      const [low, middle, top] = await offsets(page);
      assert.deepEqual(low, [0, 0, 0]);
      assert.deepEqual(middle, top);
      assert.match(await page.locator(".caption").innerText(), /Step 2 of 2: <top>/);
    });
  });

  it("show who stops whom in a cell", async () => {
    await look("plan", {}, async (page) => {
      const arcs = () => page.locator(".graph .arc").count();
      assert.equal(await arcs(), 3);
      const edge = await whereIs(page, "edge", 0);
      await page.mouse.click(edge.x, edge.y);
      assert.equal((await page.evaluate(() => window.quoinView.picked())).kind, "edge");
      assert.equal(await arcs(), 1);
      assert.match(await page.locator(".cell").innerText(), /Edge 0[^]*These sets can move:[^]*middle/);
      const top = await whereIs(page, "point", 0);
      await page.mouse.click(top.x, top.y);
      assert.match(await page.locator(".cell").innerText(), /Vertex 0[^]*\(0, 0, 1\)/);
      const before = await picture(page, "plan-cell");
      await page.locator(".cell").getByRole("button", { name: "middle, <top>" }).click();
      assert.equal(await page.locator(".graph .node.lit").count(), 2);
      assert.ok(differingPixels(before, await picture(page, "plan-try")) > 0.005, "the set moves away");
      await page.locator(".graph .node").first().hover();
      assert.match(await page.locator(".graph .told").innerText(), /low would meet middle, <top>\./);
      await page.keyboard.press("Escape");
      assert.equal(await page.evaluate(() => window.quoinView.picked()), undefined);
    });
  });

  it("say what stays together, and show nothing of nothing", async () => {
    await look("held", {}, async (page) => {
      assert.match(await page.locator(".caption").innerText(), /No set of parts can move/);
      assert.equal(await page.locator(".directions").count(), 0);
      await picture(page, "held");
    });
    await look("no_plan", {}, async (page) => {
      assert.equal(await page.evaluate(() => window.quoinView.ready), true);
      for (const key of ["ArrowRight", "ArrowLeft", " ", "l", "Escape"]) await page.keyboard.press(key);
    });
  });

  it("fit a narrow window, and the dark", async () => {
    await look("plan", { viewport: { width: 360, height: 640 }, colorScheme: "dark" }, async (page) => {
      const controls = await page.locator(".controls").boundingBox();
      assert.ok(controls.x >= 0 && controls.x + controls.width <= 360);
      await picture(page, "plan-narrow");
    });
  });

  it("say so when the file was cut short", async () => {
    const whole = readFileSync(join(pages, "plan.html"), "utf8");
    for (const mark of ['"graphs"', "quoin-map"]) {
      writeFileSync(join(pages, "cut_plan.html"), whole.slice(0, whole.lastIndexOf(mark) + 20));
      await look("cut_plan", {}, async (page) => {
        assert.match(await page.locator("#message").innerText(), /cannot be shown[^]*incomplete/);
      });
    }
  });
});
