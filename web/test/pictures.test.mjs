// SPDX-License-Identifier: Apache-2.0
// Looks at the pictures that make_pictures.cc writes, as a person would: QUOIN_PAGES=directory npm test
import assert from "node:assert/strict";
import { after, before, describe, it } from "node:test";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { launch, open } from "./browser.mjs";
import { colorsOf, decodePng, differingPixels } from "./png.mjs";

const pages = process.env.QUOIN_PAGES;
assert.ok(pages, "QUOIN_PAGES names the directory of the pages");
const shots = process.env.QUOIN_SCREENSHOTS;

async function picture(page, name) {
  await page.waitForTimeout(150);
  const bytes = await page.screenshot({ animations: "disabled" });
  if (shots && name) {
    mkdirSync(shots, { recursive: true });
    writeFileSync(join(shots, `${name}.png`), bytes);
  }
  return decodePng(bytes);
}

/** A pixel where the page shows the cell, once two looks agree: a page that has just opened may still be laid out. */
async function whereIs(page, kind, index) {
  let at = await firstPixelOf(page, kind, index);
  for (let look = 0; look < 20; ++look) {
    await page.waitForTimeout(100);
    const again = await firstPixelOf(page, kind, index);
    if (at && again?.x === at.x && again.y === at.y) return at;
    at = again;
  }
  assert.fail(`${kind} ${index} is seen somewhere`);
}

function firstPixelOf(page, kind, index) {
  return page.evaluate(
    ([kind, index]) => {
      const step = kind === "face" ? 18 : 9;
      for (let y = 70; y < innerHeight - 80; y += step)
        for (let x = 12; x < innerWidth - 12; x += step) {
          const cell = window.quoinView.pick(x, y);
          if (cell?.kind === kind && cell.index === index) return { x, y };
        }
      return undefined;
    },
    [kind, index],
  );
}

const picked = (page) => page.evaluate(() => window.quoinView.picked());
const near = (r, g, b) => (x, y, z) => Math.abs(x - r) + Math.abs(y - g) + Math.abs(z - b) < 24;

describe("pictures", () => {
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

  /** A drawing by itself, as XML. */
  async function lookAtSvg(name, options, action) {
    const context = await browser.newContext({ viewport: { width: 1000, height: 1000 }, colorScheme: "light", ...options });
    const page = await context.newPage();
    await page.goto(pathToFileURL(join(pages, `${name}.svg`)).href);
    try {
      assert.equal(await page.evaluate(() => document.querySelector("parsererror")?.textContent), undefined);
      assert.equal(await page.evaluate(() => document.documentElement.tagName), "svg");
      await action(page);
    } finally {
      await context.close();
    }
  }

  it("are drawings that browsers read, light or dark", async () => {
    for (const name of ["nested", "lines", "circles", "many", "blank"]) {
      await lookAtSvg(name, {}, async (page) => {
        assert.ok(colorsOf(await picture(page, `${name}-svg`)).share(near(251, 251, 252)) > 0.02, "paper");
      });
    }
    await lookAtSvg("nested", { colorScheme: "dark" }, async (page) => {
      const colors = colorsOf(await picture(page, "nested-svg-dark"));
      assert.ok(colors.share(near(27, 31, 37)) > 0.1, "dark paper");
    });
  });

  it("fill faces with holes, and circles where they belong", async () => {
    await lookAtSvg("nested", {}, async (page) => {
      const fills = await page.evaluate(() => {
        const faces = [...document.querySelectorAll(".faces path")];
        const at = (face, x, y) => face.isPointInFill(new DOMPoint(x, y));
        const ring = faces.find((face) => face.querySelector("title").textContent.startsWith("Face 1"));
        const box = ring.getBBox();
        const place = (u, v) => [box.x + (box.width * u) / 10, box.y + (box.height * v) / 10];
        return [at(ring, ...place(1, 5)), at(ring, ...place(3, 5)), at(ring, ...place(5, 5)), at(ring, ...place(12, 5))];
      });
      assert.deepEqual(fills, [true, false, false, false]);
    });
    await lookAtSvg("circles", {}, async (page) => {
      const boxes = await page.evaluate(() =>
        [...document.querySelectorAll(".faces path")].map((face) => {
          const { x, width, height } = face.getBBox();
          return { x, width, height };
        }),
      );
      const [left, both, right] = boxes;
      // Unit circles around (0, 0) and (1, 0), to within the rounding of a hundredth of a pixel.
      const unit = both.width;
      assert.ok(Math.abs(left.height - 2 * unit) < 0.1 && Math.abs(right.height - 2 * unit) < 0.1);
      assert.ok(Math.abs(both.height - Math.sqrt(3) * unit) < 0.1);
      assert.ok(Math.abs(left.x + left.width - (both.x + both.width / 2)) < 0.1, "the left part ends where circles cross");
    });
  });

  it("say what is under the pointer, and keep what is clicked", async () => {
    await look("nested", {}, async (page) => {
      assert.equal(await page.title(), "Nested <b>squares</b> & more");
      assert.deepEqual(await page.evaluate(() => window.quoinView.counts), { face: 5, edge: 15, point: 16 });
      const blank = await picture(page, "nested");
      const at = await whereIs(page, "face", 2);
      await page.mouse.move(at.x, at.y);
      await page.locator(".card.passing").waitFor({ state: "visible" });
      assert.match(await page.locator(".card.passing").innerText(), /Face 2[^]*part 2[^]*Material\s+brass[^]*ring 1, ring 2/);
      await page.mouse.click(at.x, at.y);
      assert.equal((await picked(page)).index, 2);
      assert.equal(await page.locator(".card.passing").isVisible(), false, "one card for one cell");
      assert.ok(differingPixels(blank, await picture(page, "nested-picked")) > 0.03, "it lights up");
      const edge = await whereIs(page, "edge", 0);
      await page.mouse.move(edge.x, edge.y);
      await page.waitForFunction(() => window.quoinView.hovered()?.kind === "edge");
      assert.match(await page.locator(".card.passing").innerText(), /Edge 0[^]*Curve\s+ring 0[^]*Between faces/);
      const point = await whereIs(page, "point", 2);
      await page.mouse.click(point.x, point.y);
      assert.match(await page.locator(".card").last().innerText(), /Vertex 2[^]*\(1, 9\)[^]*Lone point of\s+face 1/);
      await page.keyboard.press("Escape");
      assert.equal(await picked(page), undefined);
    });
  });

  it("zoom to the pointer, move, and come back", async () => {
    await look("lines", {}, async (page) => {
      const whole = await picture(page, "lines");
      const before = await page.evaluate(() => window.quoinView.pick(500, 400));
      await page.mouse.move(500, 400);
      for (let i = 0; i < 5; ++i) await page.mouse.wheel(0, -200);
      await page.waitForTimeout(200);
      const after = await page.evaluate(() => window.quoinView.pick(500, 400));
      assert.deepEqual(after, before, "the cell under the pointer stays there");
      assert.ok(differingPixels(whole, await picture(page, "lines-near")) > 0.05);
      await page.mouse.down();
      await page.mouse.move(300, 300, { steps: 4 });
      await page.mouse.up();
      assert.equal(await picked(page), undefined, "dragging is no click");
      await page.mouse.move(640, 760); // over the tools
      await page.keyboard.press("f");
      await page.waitForTimeout(300);
      assert.ok(differingPixels(whole, await picture(page)) < 0.02, "all as before");
    });
  });

  it("obey keys alone", async () => {
    await look("nested", {}, async (page) => {
      let last = await picture(page);
      for (const key of ["v", "e", "c", "t", "t", "c", "e", "v", "l", "+", "ArrowLeft", "i"]) {
        await page.keyboard.press(key);
        const next = await picture(page);
        assert.ok(differingPixels(last, next) > 0.0003, `key ${key} changes the picture`);
        last = next;
      }
      await page.keyboard.press("2");
      assert.deepEqual([(await picked(page)).kind, (await picked(page)).index], ["edge", 0]);
      await page.keyboard.press("p");
      assert.equal((await picked(page)).index, 14);
      await page.keyboard.press("n");
      assert.equal((await picked(page)).index, 0);
      await page.keyboard.press("?");
      await page.locator("dialog.help").waitFor({ state: "visible" });
    });
  });

  it("stay usable with many cells", async () => {
    await look("many", {}, async (page) => {
      const counts = await page.evaluate(() => window.quoinView.counts);
      assert.ok(counts.edge > 2000, `${counts.edge} edges`);
      const start = Date.now();
      for (let i = 0; i < 10; ++i) {
        await page.mouse.move(400 + 9 * i, 400);
        await page.mouse.wheel(0, -40);
        await page.evaluate(() => new Promise(requestAnimationFrame));
      }
      const took = (Date.now() - start) / 10;
      await picture(page, "many");
      console.log(`${counts.face} faces, ${counts.edge} edges, ${counts.point} vertices: ${took.toFixed(0)} ms a step`);
    });
  });

  it("show the faces of a sphere where they are", async () => {
    await look("octants", { reducedMotion: "reduce" }, async (page) => {
      assert.deepEqual(await page.evaluate(() => window.quoinView.counts), { face: 9, edge: 4, point: 6 });
      const colors = colorsOf(await picture(page, "sphere"));
      assert.ok(colors.share((r, g, b) => r > b + 90 && g > b + 70) > 0.02, "the golden cap");
      const cap = await whereIs(page, "face", 8);
      await page.mouse.move(cap.x, cap.y);
      await page.locator(".card.passing").waitFor({ state: "visible" });
      assert.match(await page.locator(".card.passing").innerText(), /Face 8[^]*cap[^]*gold <leaf>/);
      await page.mouse.click(cap.x, cap.y);
      assert.equal((await picked(page)).index, 8);
      const around = await whereIs(page, "face", 7);
      await page.mouse.move(around.x, around.y);
      await page.waitForFunction(() => window.quoinView.hovered()?.index === 7);
      await whereIs(page, "edge", 3);
      await whereIs(page, "point", 0);
    });
  });

  it("turn the sphere until a cell is seen", async () => {
    await look("octants", { reducedMotion: "reduce" }, async (page) => {
      const front = await picture(page);
      await page.keyboard.press("3"); // the vertex on the axis x
      for (let i = 0; i < 3; ++i) await page.keyboard.press("n"); // that on the axis -x
      assert.equal((await picked(page)).index, 3);
      await page.waitForTimeout(400);
      const at = await whereIs(page, "point", 3);
      assert.ok(Math.hypot(at.x - 494, at.y - 397) < 30, `in the middle: ${at.x}, ${at.y}`);
      assert.ok(differingPixels(front, await picture(page, "sphere-turned")) > 0.1);
      for (const key of ["ArrowLeft", "ArrowUp", "x", "v", "e", "c", "t", "l", "-"]) {
        const last = await picture(page);
        await page.keyboard.press(key);
        await page.waitForTimeout(200);
        assert.ok(differingPixels(last, await picture(page)) > 0.0002, `key ${key} changes the picture`);
      }
    });
  });

  it("let the sphere turn by itself", async () => {
    await look("octants", { reducedMotion: "reduce" }, async (page) => {
      await page.keyboard.press("a");
      const first = await picture(page);
      await page.waitForTimeout(1500);
      assert.ok(differingPixels(first, await picture(page)) > 0.01);
      await page.keyboard.press("a");
      await page.waitForTimeout(1500);
      const still = await picture(page);
      await page.waitForTimeout(500);
      assert.ok(differingPixels(still, await picture(page)) < 0.002);
    });
  });

  it("may be empty, or of one face", async () => {
    for (const name of ["blank", "no_sphere", "bare_sphere"]) {
      await look(name, {}, async (page) => {
        assert.equal(await page.evaluate(() => window.quoinView.ready), true);
        for (const key of ["f", "n", "p", "1", "2", "3", "v", "+", "ArrowUp", "Escape"]) await page.keyboard.press(key);
        await picture(page, name);
      });
    }
  });

  it("fit a narrow window, and fingers", async () => {
    await look("nested", { viewport: { width: 360, height: 640 }, hasTouch: true, isMobile: true }, async (page) => {
      const at = await whereIs(page, "face", 1);
      await page.touchscreen.tap(at.x, at.y);
      await page.waitForFunction(() => window.quoinView.picked()?.index === 1);
      const toolbar = await page.locator(".toolbar").boundingBox();
      assert.ok(toolbar.x >= 0 && toolbar.x + toolbar.width <= 360);
      await picture(page, "nested-narrow");
    });
  });

  it("say so when the file was cut short", async () => {
    for (const [name, mark] of [["nested", '<g class="edges">'], ["nested", '"edges"'], ["octants", "quoin-map"]]) {
      const whole = readFileSync(join(pages, `${name}.html`), "utf8");
      writeFileSync(join(pages, "cut_picture.html"), whole.slice(0, whole.lastIndexOf(mark) + 60));
      await look("cut_picture", {}, async (page) => {
        assert.match(await page.locator("#message").innerText(), /cannot be shown[^]*incomplete/);
      });
    }
  });
});
