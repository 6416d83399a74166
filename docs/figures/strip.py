# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Cuts the four small pictures of the front page, docs/figures/strip, out of others: python3 docs/figures/strip.py"""
from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
HEIGHT = 115  # pixels
CUT = {  # a picture and the part of it: left, top, right, bottom
    "drum": ("examples/drum/figures/figure_24.png", (756, 316, 1074, 523)),
    "column": ("docs/figures/gallery/column_collapse.png", (66, 180, 262, 254)),
    "silo": ("docs/figures/gallery/silo.png", (255, 34, 391, 262)),
    "terrain": ("docs/figures/gallery/terrain.png", (418, 255, 702, 414)),
}


def main():
    folder = ROOT / "docs/figures/strip"
    folder.mkdir(exist_ok=True)
    for name, (source, box) in CUT.items():
        with Image.open(ROOT / source) as image:
            part = image.convert("RGB").crop(box)
        small = part.resize((part.width * HEIGHT // part.height, HEIGHT), Image.Resampling.LANCZOS)
        small.quantize(256, dither=Image.Dither.NONE).save(folder / f"{name}.png", optimize=True)


if __name__ == "__main__":
    main()
