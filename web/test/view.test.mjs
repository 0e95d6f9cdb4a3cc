// SPDX-License-Identifier: Apache-2.0
// Looks at the pages that make_pages.cc writes, as a person would: QUOIN_PAGES=directory npm test
import assert from "node:assert/strict";
import { after, before, describe, it } from "node:test";
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { launch, open } from "./browser.mjs";
import { colorsOf, decodePng, differingPixels } from "./png.mjs";

const pages = process.env.QUOIN_PAGES;
assert.ok(pages, "QUOIN_PAGES names the directory of the pages");
const shots = process.env.QUOIN_SCREENSHOTS;

/** The canvas alone, without what lies over it. */
async function picture(page, name) {
  await page.addStyleTag({ content: "#app > :not(.stage) { visibility: hidden !important }" });
  const bytes = await page.screenshot({ animations: "disabled" });
  await page.evaluate(() => document.head.lastElementChild.remove());
  if (shots && name) {
    mkdirSync(shots, { recursive: true });
    writeFileSync(join(shots, `${name}.png`), bytes);
  }
  return decodePng(bytes);
}

/** Of the window, without its own coordinates of the middle of what is free: asks the page where a face is seen. */
async function whereFaceIs(page, part, face) {
  const at = await page.evaluate(
    ([part, face]) => {
      for (let y = 60; y < innerHeight - 60; y += 20) {
        for (let x = 20; x < innerWidth - 20; x += 20) {
          const seen = window.quoinView.pick(x, y);
          if (seen?.part === part && seen.face === face) return { x, y };
        }
      }
      return undefined;
    },
    [part, face],
  );
  assert.ok(at, `face ${face} of ${part} is seen somewhere`);
  return at;
}

describe("the view", () => {
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

  it("draws the solid in the colours of its inputs", async () => {
    await look("small", {}, async (page) => {
      assert.equal(await page.evaluate(() => window.quoinView.ready), true);
      assert.equal(await page.evaluate(() => window.quoinView.triangleCount), 24);
      assert.equal(await page.title(), "Block with a cavity");
      const colors = colorsOf(await picture(page, "small"));
      assert.ok(colors.share((r, g, b) => b > r + 25 && b > g + 8) > 0.08, "blue of the first input");
      assert.ok(colors.share((r, g, b) => r > b + 60 && g > b + 40) > 0.04, "sand of the second input");
      assert.ok(colors.share((r, g, b) => Math.min(r, g, b) > 220) > 0.3, "background");
    });
  });

  it("names the face in the middle, its plane and where it is from", async () => {
    await look("small", {}, async (page) => {
      await page.keyboard.press("1");
      await page.waitForTimeout(600);
      const at = await whereFaceIs(page, "block", 2);
      await page.mouse.click(at.x, at.y);
      const face = await page.evaluate(() => window.quoinView.picked());
      assert.equal(face.face, 2);
      assert.equal(face.plane, "3 y = 1/3 − 1/3");
      assert.equal(face.normal, "(0, −1, 0)");
      assert.deepEqual(face.origins, [
        { origin: 0, face: 2, name: "block.stl" },
        { origin: 1, face: 77, name: "tool <b>&amp;.stl" },
      ]);
      assert.match(await page.locator(".card").first().innerText(), /Face 2[^]*tool <b>&amp;\.stl, face 77/);
      const orange = colorsOf(await picture(page, "picked")).share((r, g, b) => r > g + 50 && g > b + 40);
      assert.ok(orange > 0.05, "the picked face is lit up");
      await page.keyboard.press("Escape");
      assert.equal(await page.evaluate(() => window.quoinView.picked()), undefined);
    });
  });

  it("picks every face from the side it looks to", async () => {
    const views = { 1: [2, "y = 0"], 2: [1, "x = 20"], 3: [5, "z = 20"] };
    await look("small", { reducedMotion: "reduce" }, async (page) => {
      for (const [key, [face, plane]] of Object.entries(views)) {
        await page.keyboard.press(key);
        const at = await page.evaluate(() => {
          const panel = document.querySelector(".panel").getBoundingClientRect();
          return { x: panel.left / 2, y: (62 + innerHeight - 68) / 2 };
        });
        const seen = await page.evaluate(({ x, y }) => window.quoinView.pick(x, y), at);
        assert.equal(seen?.face, face, `looking along view ${key}`);
        if (face !== 2) assert.equal(seen.plane, plane);
      }
    });
  });

  it("works out exact planes from the points that span them", async () => {
    await look("spanned", { reducedMotion: "reduce" }, async (page) => {
      const wedge = await whereFaceIs(page, "wedge", 3);
      const short = await whereFaceIs(page, "short", 3);
      await page.mouse.click(short.x, short.y);
      assert.match(await page.locator(".card").first().innerText(), /4 x \+ 7 y \+ 56 z = 34\n/);
      await page.mouse.click(wedge.x, wedge.y);
      const { plane } = await page.evaluate(() => window.quoinView.picked());
      const found = plane.match(/^(\d+) x \+ (\d+) y \+ (\d+) z = (\d+)(?:\/(\d+))?$/);
      assert.ok(found, plane);
      const [a, b, c, d, q] = found.slice(1).map((digits) => BigInt(digits ?? 1));
      // Through (7/2, 0, 0), (0, 2, 0) and (0, 0, t) with the double t that is nearest to 1/10.
      assert.equal(7n * a * q, 2n * d);
      assert.equal(2n * b * q, d);
      assert.equal(c * q * 3602879701896397n, d << 55n);
      assert.match(await page.locator(".card").first().innerText(), /Plane\s+≈ 0\.0285[^]*Exactly[^]*…[^]*Copy in full/);
      await page.getByText("Copy in full").click();
      await page.getByText("Copied").waitFor();
    });
  });

  it("cuts, and fills what it cuts", async () => {
    await look("small", {}, async (page) => {
      const whole = await picture(page);
      await page.keyboard.press("s");
      await page.keyboard.press("y");
      const cut = await picture(page, "section");
      assert.ok(differingPixels(whole, cut) > 0.05, "the cut changes the picture");
      const moved = await page.evaluate(() => window.quoinView.setSection("y", 0.8)).then(() => picture(page));
      assert.ok(differingPixels(cut, moved) > 0.03, "moving it changes the picture");
      await page.evaluate(() => window.quoinView.setSection("y", 0.5));
      // The cut runs through the cavity: looking in, its walls are seen, and no face behind the cap can be picked.
      const seen = await page.evaluate(() => {
        const found = new Set();
        for (let y = 60; y < innerHeight - 60; y += 10)
          for (let x = 10; x < innerWidth - 10; x += 10) {
            const face = window.quoinView.pick(x, y);
            if (face) found.add(face.face);
          }
        return [...found];
      });
      assert.ok(seen.some((face) => face >= 6), `a wall of the cavity among ${seen}`);
      await page.keyboard.press("s");
      await page.waitForTimeout(200);
      assert.ok(differingPixels(whole, await picture(page)) < 0.002, "as before when it is off");
    });
  });

  it("drags the cut by its arrow", async () => {
    await look("small", {}, async (page) => {
      await page.keyboard.press("s");
      await page.locator(".handle .grip").waitFor({ state: "visible", timeout: 30000 });
      const before = await page.locator(".dock .value").first().innerText();
      const grip = await page.locator(".handle .grip").boundingBox();
      await page.mouse.move(grip.x + grip.width / 2, grip.y + grip.height / 2);
      await page.mouse.down();
      await page.mouse.move(grip.x + 60, grip.y + 30, { steps: 4 });
      await page.mouse.up();
      await page.waitForFunction((text) => document.querySelector(".dock .value").innerText !== text, before, {
        timeout: 30000,
      });
    });
  });

  it("pulls parts and pieces apart, and hides them", async () => {
    await look("assembly", { reducedMotion: "reduce" }, async (page) => {
      const together = await picture(page, "assembly");
      await page.keyboard.press("a");
      const apart = await picture(page, "apart");
      assert.ok(differingPixels(together, apart) > 0.05);
      await page.evaluate(() => window.quoinView.setExplosion(0));
      await page.keyboard.press("f");
      const eyes = page.locator(".eye");
      assert.equal(await eyes.count(), 5);
      for (let i = 0; i < 5; ++i) await eyes.nth(i).click();
      assert.ok(colorsOf(await picture(page)).share((r, g, b) => Math.min(r, g, b) > 215) > 0.995, "nothing is left");
    });
  });

  it("shows edges, triangles and normals, in perspective and parallel", async () => {
    await look("assembly", {}, async (page) => {
      let last = await picture(page);
      for (const key of ["e", "w", "n", "o"]) {
        await page.keyboard.press(key);
        await page.waitForTimeout(150);
        const next = await picture(page);
        assert.ok(differingPixels(last, next) > 0.0005, `key ${key} changes the picture`);
        last = next;
      }
    });
  });

  it("measures between corners exactly", async () => {
    await look("far", { reducedMotion: "reduce" }, async (page) => {
      await page.keyboard.press("3");
      await page.keyboard.press("o");
      await page.keyboard.press("m");
      const box = await page.evaluate(() => {
        const middle = { x: document.querySelector(".panel").getBoundingClientRect().left / 2, y: (62 + innerHeight - 68) / 2 };
        const reach = (dx, dy) => {
          let n = 0;
          while (window.quoinView.pick(middle.x + 4 * (n + 1) * dx, middle.y + 4 * (n + 1) * dy)) ++n;
          return 4 * n;
        };
        const { x, y } = middle;
        return { left: x - reach(-1, 0), right: x + reach(1, 0), top: y - reach(0, -1), bottom: y + reach(0, 1) };
      });
      await page.mouse.click(box.left, box.top);
      await page.mouse.click(box.right, box.bottom);
      const measured = await page.evaluate(() => window.quoinView.measured());
      assert.deepEqual(measured.delta, [0.5, -0.25, 0]);
      assert.equal(measured.distance, Math.hypot(0.5, 0.25));
      assert.match(await page.locator(".card.measure").innerText(), /0\.5590169944 m[^]*\(1000000000, 1000000000\.25, /);
    });
  });

  it("is dark where the system is, and on request", async () => {
    await look("assembly", { colorScheme: "dark" }, async (page) => {
      const darkShare = async () => colorsOf(await picture(page)).share((r, g, b) => Math.max(r, g, b) < 60);
      assert.ok((await darkShare()) > 0.3);
      await page.keyboard.press("l");
      assert.ok((await darkShare()) < 0.1);
    });
  });

  it("fits a narrow window", async () => {
    await look("assembly", { viewport: { width: 360, height: 640 }, hasTouch: true, isMobile: true }, async (page) => {
      const colors = colorsOf(await picture(page, "narrow"));
      assert.ok(colors.share((r, g, b) => Math.min(r, g, b) < 215) > 0.1, "the solid is there");
      const width = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.equal(width, 360);
      const at = await whereFaceIs(page, "knob", 65);
      await page.touchscreen.tap(at.x, at.y);
      assert.equal((await page.evaluate(() => window.quoinView.picked())).face, 65);
      const toolbar = await page.locator(".toolbar").boundingBox();
      assert.ok(toolbar.x >= 0 && toolbar.x + toolbar.width <= 360);
    });
  });

  it("says so when there is nothing to show", async () => {
    await look("empty", {}, async (page) => {
      assert.match(await page.locator(".toast").innerText(), /nothing to show/);
      for (const key of ["f", "s", "a", "m", "n", "w", "1", "Escape"]) await page.keyboard.press(key);
    });
  });

  it("says in the page when WebGL is missing", async () => {
    const bare = await launch(["--disable-gpu", "--disable-3d-apis"]);
    try {
      const { page, close } = await open(bare, join(pages, "small.html"));
      assert.match(await page.locator("#message").innerText(), /cannot draw in 3D[^]*WebGL 2/);
      assert.equal(await page.evaluate(() => window.quoinView.ready), false);
      await close();
    } finally {
      await bare.close();
    }
  });

  it("says in the page when the file was cut short", async () => {
    const whole = readFileSync(join(pages, "assembly.html"), "utf8");
    const at = whole.indexOf('id="quoin-block-3"');
    const cut = join(pages, "cut.html");
    writeFileSync(cut, whole.slice(0, at + 60));
    await look("cut", {}, async (page) => {
      assert.match(await page.locator("#message").innerText(), /cannot be shown[^]*incomplete/);
    });
  });

  it("stays usable with a million triangles", { skip: !existsSync(join(pages, "large.html")), timeout: 300_000 }, async () => {
    const start = Date.now();
    await look("large", {}, async (page) => {
      const loaded = Date.now() - start;
      assert.equal(await page.evaluate(() => window.quoinView.triangleCount), 1_001_112);
      const frame = await page.evaluate(() => window.quoinView.frameTime(5));
      const pick = await page.evaluate(() => window.quoinView.pickTime(3));
      const heap = await page.evaluate(() => performance.memory?.usedJSHeapSize ?? 0);
      assert.notEqual(await page.evaluate(() => window.quoinView.pick(500, 400)), undefined);
      await picture(page, "large");
      console.log(
        `1,001,112 triangles, each a face, software GL: ready after ${loaded} ms, ${frame.toFixed(0)} ms a frame, ` +
          `${pick.toFixed(0)} ms a pick, heap ${(heap / 2 ** 20).toFixed(0)} MiB`,
      );
    });
  });
});
