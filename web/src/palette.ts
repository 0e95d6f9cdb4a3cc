// SPDX-License-Identifier: Apache-2.0

export type Rgb = [number, number, number];

// No orange: that is what is picked.
const calm: Rgb[] = [
  [125, 158, 198], // steel blue
  [219, 197, 128], // sand
  [142, 182, 138], // sage
  [202, 139, 150], // dusty rose
  [167, 155, 203], // lavender
  [110, 178, 173], // teal
  [176, 182, 118], // moss
  [154, 168, 178], // slate
  [199, 160, 202], // mauve
  [152, 192, 208], // sky
];

/** Colour of faces of input `index`, 0 to 255 each: ten chosen ones, then hues a golden angle apart. */
export function originColor(index: number): Rgb {
  if (index < calm.length) return calm[index];
  const hue = (index * 137.50776) % 360;
  const lightness = 0.62 + 0.1 * ((index % 3) - 1);
  const channel = (offset: number) => {
    const k = (offset + hue / 30) % 12;
    return Math.round(255 * (lightness - 0.17 * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [channel(0), channel(8), channel(4)];
}

export function cssColor(color: Rgb): string {
  return `rgb(${color[0]} ${color[1]} ${color[2]})`;
}
