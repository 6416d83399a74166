# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A picture of so many pixels of width, with 256 colours: smaller.py FROM.png TO.png WIDTH"""
import sys

from PIL import Image

with Image.open(sys.argv[1]) as image:
    width = int(sys.argv[3])
    small = image.convert("RGB").resize((width, image.height * width // image.width), Image.Resampling.LANCZOS)
small.quantize(256, dither=Image.Dither.NONE).save(sys.argv[2], optimize=True)
