// SPDX-License-Identifier: Apache-2.0
// The pixels of screenshots: 8-bit RGB or RGBA without interlacing.
import { inflateSync } from "node:zlib";

export function decodePng(bytes) {
  let at = 8;
  let header;
  const data = [];
  while (at < bytes.length) {
    const length = bytes.readUInt32BE(at);
    const type = bytes.toString("latin1", at + 4, at + 8);
    const chunk = bytes.subarray(at + 8, at + 8 + length);
    if (type === "IHDR") header = { width: chunk.readUInt32BE(0), height: chunk.readUInt32BE(4), channels: chunk[9] === 6 ? 4 : 3 };
    if (type === "IDAT") data.push(chunk);
    at += 12 + length;
  }
  return { ...header, pixels: unfilter(inflateSync(Buffer.concat(data)), header) };
}

function unfilter(raw, { width, height, channels }) {
  const stride = width * channels;
  const out = Buffer.alloc(stride * height);
  for (let y = 0; y < height; ++y) {
    const filter = raw[y * (stride + 1)];
    for (let x = 0; x < stride; ++x) {
      const left = x >= channels ? out[y * stride + x - channels] : 0;
      const up = y > 0 ? out[(y - 1) * stride + x] : 0;
      const corner = x >= channels && y > 0 ? out[(y - 1) * stride + x - channels] : 0;
      const guess = [0, left, up, (left + up) >> 1, paeth(left, up, corner)][filter];
      out[y * stride + x] = raw[y * (stride + 1) + 1 + x] + guess;
    }
  }
  return out;
}

function paeth(left, up, corner) {
  const p = left + up - corner;
  const [a, b, c] = [Math.abs(p - left), Math.abs(p - up), Math.abs(p - corner)];
  return a <= b && a <= c ? left : b <= c ? up : corner;
}

export function colorsOf(image) {
  return {
    /** Part of the picture, 0 to 1, whose colour satisfies `is(r, g, b)`. */
    share(is) {
      let count = 0;
      for (let i = 0; i < image.pixels.length; i += image.channels) {
        if (is(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2])) ++count;
      }
      return count / (image.width * image.height);
    },
  };
}

/** Part of the picture, 0 to 1, where two pictures are clearly not the same. */
export function differingPixels(a, b) {
  let count = 0;
  for (let i = 0; i < a.pixels.length; i += a.channels) {
    const difference = [0, 1, 2].reduce((sum, k) => sum + Math.abs(a.pixels[i + k] - b.pixels[i + k]), 0);
    if (difference > 30) ++count;
  }
  return count / (a.width * a.height);
}
