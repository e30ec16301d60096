"""Compares pictures by FLIP (P. Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", 2020).

    python compare.py REFERENCE.png LEFT TOP WIDTH HEIGHT DIFFERENCE.png PICTURE.png...

Prints the mean FLIP error of each picture within the crop as JSON, 0 (equal) to 1. Writes a map of the last picture's errors to DIFFERENCE.png.
"""
import json
import sys

import flip_evaluator
import numpy as np
from PIL import Image

BACKGROUND = 40


def read(path, box):
    image = Image.open(path).convert('RGBA')
    plain = Image.new('RGBA', image.size, (BACKGROUND, BACKGROUND, BACKGROUND, 255))
    plain.alpha_composite(image)
    return np.asarray(plain.convert('RGB').crop(box), np.float32) / 255


def main():
    reference, left, top, width, height, difference, *pictures = sys.argv[1:]
    left, top, width, height = (int(value) for value in (left, top, width, height))
    box = (left, top, left + width, top + height)
    expected = read(reference, box)
    means = []
    for picture in pictures:
        shown, mean, _ = flip_evaluator.evaluate(expected, read(picture, box), 'LDR')
        means.append(float(mean))
    Image.fromarray((np.clip(shown, 0, 1) * 255).astype(np.uint8)).save(difference)
    print(json.dumps(means))


if __name__ == '__main__':
    main()
