// SPDX-License-Identifier: Apache-2.0
// Looks at the clouds that make_layers.cc writes, as a person would: QUOIN_PAGES=directory npm test
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

const shown = (page) => page.evaluate(() => window.quoinView.shown());
const value = (page) => page.evaluate(() => window.quoinView.value());
const placeOfPair = (page, pair) => page.evaluate((p) => window.quoinView.placeOfPair(p), pair);
const numberOf = async (page, name) => (await page.locator(".counts dt", { hasText: name }).locator("+ dd").innerText()).trim();

describe("clouds", () => {
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

  it("show what is there at a value", async () => {
    await look("layers", {}, async (page) => {
      assert.equal(await value(page), 3);
      const expected = [[4, 0, 0, 1], [4, 6, 0, 1], [4, 6, 3, 1], [4, 6, 4, 1], [4, 0, 0, 1]];
      const betti = [["4", "0", "0"], ["1", "3", "0"], ["1", "0", "0"], ["1", "0", "1"], ["1", "0", "0"]];
      const pictures = [];
      for (let i = 0; i < expected.length; ++i) {
        await page.evaluate((v) => window.quoinView.setValue(v), i);
        assert.deepEqual(Object.values(await shown(page)), expected[i], `value ${i}`);
        for (const [k, name] of ["Components", "Tunnels", "Voids"].entries()) assert.equal(await numberOf(page, name), betti[i][k]);
        assert.equal(await page.getByLabel("Radius", { exact: true }).nth(1).inputValue(), String(i));
        pictures.push(await picture(page, `layers-${i}`));
      }
      for (let i = 1; i < pictures.length; ++i) assert.ok(differingPixels(pictures[i - 1], pictures[i]) > 0.003, `picture ${i}`);
    });
  });

  it("follow the slider, what is typed, the keys and Play", async () => {
    await look("layers", {}, async (page) => {
      const slider = page.locator("input[type=range]");
      await slider.fill("0");
      assert.equal(await value(page), 0);
      await slider.fill("510"); // half of the radius 4
      assert.equal(await value(page), 2);
      await slider.fill("1010");
      assert.equal(await value(page), 4);
      const [root, square] = [page.locator("input[type=text]").first(), page.locator("input[type=text]").last()];
      await root.fill("1.5");
      await root.press("Enter");
      assert.equal(await value(page), 1);
      await square.fill("9");
      await square.press("Enter");
      assert.equal(await value(page), 3);
      await square.fill("nine");
      await square.press("Enter");
      assert.equal(await square.getAttribute("aria-invalid"), "true");
      assert.equal(await value(page), 3);
      await square.blur();
      await page.keyboard.press("ArrowLeft");
      assert.equal(await value(page), 2);
      await page.evaluate(() => window.quoinView.setValue(0));
      await page.getByRole("button", { name: "Play" }).click();
      await page.waitForFunction(() => window.quoinView.value() > 0);
      await page.getByRole("button", { name: "Pause" }).click();
    });
  });

  it("go to the birth and the death of a class", async () => {
    await look("layers", {}, async (page) => {
      const at = await placeOfPair(page, 7); // the void
      await page.mouse.move(at.x, at.y);
      assert.match(await page.locator(".told").innerText(), /voids[^]*Radius at birth\s*3[^]*Radius at death\s*4/);
      await page.evaluate(() => window.quoinView.setValue(0));
      await page.mouse.click(at.x, at.y);
      assert.equal(await value(page), 3);
      await page.mouse.click(at.x, at.y);
      assert.equal(await value(page), 4);
      await page.locator(".told").getByRole("button", { name: "Birth" }).click();
      assert.equal(await value(page), 3);
      await picture(page, "layers-pair");
      const stays = await placeOfPair(page, 0);
      await page.mouse.click(stays.x, stays.y);
      assert.match(await page.locator(".told").innerText(), /components[^]*never/);
    });
  });

  it("hide layers, and tell points", async () => {
    await look("layers", {}, async (page) => {
      const whole = await picture(page);
      await page.getByRole("button", { name: "Show </script>" }).click();
      assert.ok(differingPixels(whole, await picture(page)) > 0.01);
      await page.getByRole("button", { name: "Show Critical" }).click();
      const at = await page.evaluate(() => window.quoinView.placeOfPoint(1));
      await page.mouse.click(at.x, at.y);
      const card = await page.locator(".card").innerText();
      assert.match(card, /Point 11[^]*\(2, 0, 0\)/);
      await page.locator(".ring").waitFor({ state: "visible" });
      await picture(page, "layers-point");
      await page.keyboard.press("Escape");
      assert.ok(!(await page.locator(".card").isVisible()));
    });
  });

  it("show what a point owns alone, and where a class is born and dies", async () => {
    await look("owned_layers", {}, async (page) => {
      const drawn = () => page.evaluate(() => Object.values(window.quoinView.drawn()));
      const click = async (point) => {
        const at = await page.evaluate((p) => window.quoinView.placeOfPoint(p), point);
        await page.mouse.click(at.x, at.y);
      };
      const rings = (n) => page.waitForFunction((k) => [...document.querySelectorAll(".ring")].filter((ring) => !ring.hidden).length === k, n);
      assert.deepEqual(await drawn(), [4, 2, 1, 0, 3]);
      await click(4); // a saddle, and its ways to the maximum
      assert.deepEqual(await drawn(), [4, 1, 1, 2, 2]);
      assert.match(await page.locator(".card").innerText(), /Saddle 17[^]*≈ \(1, 2, 0\.1\)[^]*Distance\s*0 to 1[^]*Surfaces\s*2[^]*Ways\s*2/);
      await picture(page, "owned-saddle");
      await page.evaluate(() => window.quoinView.setValue(0));
      assert.deepEqual(await drawn(), [4, 0, 0, 0, 0]);
      await page.evaluate(() => window.quoinView.setValue(3));
      await click(7); // the maximum, and all that leads to it
      assert.deepEqual(await drawn(), [4, 2, 1, 3, 3]);
      assert.match(await page.locator(".told").innerText(), /Distance at birth\s*2[^]*at death\s*3/);
      await page.keyboard.press("Escape");
      assert.deepEqual(await drawn(), [4, 2, 1, 0, 3]);
      await rings(0);
      const at = await placeOfPair(page, 1);
      await page.mouse.click(at.x, at.y);
      assert.equal(await value(page), 2);
      await rings(2);
    });
  });

  it("show a plane from above, without values", async () => {
    await look("flat_layers", {}, async (page) => {
      assert.equal(await page.locator("input[type=range]").count(), 0);
      assert.equal(await page.locator(".diagram").count(), 0);
      const at = await page.evaluate(() => window.quoinView.placeOfPoint(0));
      assert.equal(await page.evaluate(({ x, y }) => window.quoinView.pick(x, y), at), 0);
      await page.mouse.click(at.x, at.y);
      assert.match(await page.locator(".card").innerText(), /\(0\.1, 0\.1, 0\)/);
      await picture(page, "flat-layers");
    });
  });

  it("stay interactive with 540 000 points", async (test) => {
    await look("cloud", {}, async (page) => {
      assert.equal((await shown(page)).Points, 540_000);
      await picture(page, "cloud");
      const [change, still, moving] = await page.evaluate(() => {
        const view = window.quoinView;
        view.frameTime(1);
        const start = performance.now();
        for (let i = 0; i < 5; ++i) view.setValue(600 + i);
        return [(performance.now() - start) / 5, view.frameTime(3), view.movingFrameTime(5)];
      });
      test.diagnostic(`a change of the value ${change.toFixed(1)} ms, a frame ${still.toFixed(0)} ms, while it moves ${moving.toFixed(0)} ms`);
      assert.ok(moving < 1500, "without a graphics device, on a busy machine");
      const at = await page.evaluate(() => window.quoinView.placeOfPoint(1234));
      assert.notEqual(await page.evaluate(({ x, y }) => window.quoinView.pick(x, y), at), undefined);
      await page.mouse.move(400, 400);
      await page.mouse.down();
      await page.mouse.move(460, 420, { steps: 4 });
      await page.mouse.up();
    });
  });

  it("fit a narrow window, and the dark", async () => {
    await look("layers", { viewport: { width: 360, height: 640 }, colorScheme: "dark" }, async (page) => {
      const controls = await page.locator(".controls").boundingBox();
      assert.ok(controls.x >= 0 && controls.x + controls.width <= 360);
      await picture(page, "layers-narrow");
    });
  });

  it("show nothing of nothing, and say so when the file was cut short", async () => {
    await look("no_layers", {}, async (page) => {
      assert.equal(await page.evaluate(() => window.quoinView.ready), true);
      assert.match(await page.locator(".heading").innerText(), /nothing to show/);
      for (const key of ["ArrowRight", "ArrowLeft", " ", "l", "f", "o", "1", "Escape"]) await page.keyboard.press(key);
    });
    const whole = readFileSync(join(pages, "layers.html"), "utf8");
    for (const mark of ['"layers"', "quoin-block-2"]) {
      writeFileSync(join(pages, "cut_layers.html"), whole.slice(0, whole.lastIndexOf(mark) + 20));
      await look("cut_layers", {}, async (page) => {
        assert.match(await page.locator("#message").innerText(), /cannot be shown[^]*incomplete/);
      });
    }
  });
});
