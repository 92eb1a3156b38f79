#!/usr/bin/env python3
"""How much the colours of pictures vary: variance.py LEAST PICTURE...

Prints for each picture the standard deviations of red - green and blue - green, added up, in the rows between the
window's panel and its keys. Fails if a sum is below LEAST: nothing but ground and shadows is drawn, or nothing at all.
"""
import sys

import numpy
from PIL import Image

least, low = float(sys.argv[1]), 0
for path in sys.argv[2:]:
    picture = numpy.asarray(Image.open(path).convert("RGB"), float)
    red, green, blue = numpy.moveaxis(picture[len(picture) // 2:len(picture) * 17 // 20], 2, 0)
    varies = (red - green).std() + (blue - green).std()
    print(f"{path} {varies:.1f}")
    low += int(varies < least)
sys.exit(low > 0)
