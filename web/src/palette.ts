// SPDX-License-Identifier: Apache-2.0

export type Rgb = [number, number, number];

const calm: Rgb[] = [
  [125, 158, 198], // steel blue
  [218, 157, 112], // apricot
  [142, 182, 138], // sage
  [202, 139, 150], // dusty rose
  [167, 155, 203], // lavender
  [217, 192, 116], // sand
  [110, 178, 173], // teal
  [182, 143, 110], // clay
  [154, 168, 178], // slate
  [199, 160, 202], // mauve
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
