// SPDX-FileCopyrightText: The scree authors
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
// Colour maps. All but the first are paths in Oklab (Ottosson 2020), where equal distances look equally different.
"use strict";

const viridis = [[68, 1, 84], [72, 40, 120], [62, 74, 137], [49, 104, 142], [38, 130, 142], [31, 158, 137], [53, 183, 121],
                 [110, 206, 88], [181, 222, 43], [253, 231, 37]];

function between(table, share) {
  const x = Math.min(Math.max(share, 0), 1) * (table.length - 1), k = Math.min(Math.floor(x), table.length - 2);
  return table[k].map((low, c) => low + (x - k) * (table[k + 1][c] - low));
}

// sRGB, from 0 to 255, of a lightness (0 to 1), a chroma and a hue (degrees) of Oklab. Chroma that a screen cannot show is
// reduced; lightness and hue stay.
function fromOklab(lightness, chroma, hue) {
  const angle = hue / 180 * Math.PI;
  for (let c = chroma;; c *= 0.97) {
    const a = c * Math.cos(angle), b = c * Math.sin(angle);
    const [l, m, s] = [lightness + 0.3963377774 * a + 0.2158037573 * b, lightness - 0.1055613458 * a - 0.0638541728 * b,
                       lightness - 0.0894841775 * a - 1.2914855480 * b].map((x) => x ** 3);
    const rgb = [4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s, -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                 -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s];
    if (c > 1e-3 && rgb.some((x) => x < 0 || x > 1)) continue;
    return rgb.map((x) => Math.min(Math.max(x, 0), 1)).map((x) => 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055));
  }
}

const maps = {
  viridis: (share) => between(viridis, share),
  // Lightness grows evenly from 0.25 to 0.95 while the hue goes from blue over red to yellow.
  heat: (share) => fromOklab(0.25 + 0.7 * share, 0.19 * Math.sin(Math.PI * (0.12 + 0.76 * share)), 285 + 180 * share),
  // Both halves lose lightness at the same rate: for quantities with a sign, with limits on both sides of zero.
  "blue to red": (share) => fromOklab(0.95 - 0.9 * Math.abs(share - 0.5), 0.36 * Math.abs(share - 0.5), share < 0.5 ? 255 : 28),
  grey: (share) => fromOklab(0.2 + 0.75 * share, 0, 0),
};
// Of bodies: seven hues of one lightness, after the grey of walls.
const ofBody = (body) => body === 0 ? fromOklab(0.72, 0.12, 75) : body === 1 ? [158, 158, 158] : fromOklab(0.6, 0.13, 250 + 137 * (body - 2));

function colour(map, share) {
  return maps[map](Math.min(Math.max(share, 0), 1)).map(Math.round);
}
