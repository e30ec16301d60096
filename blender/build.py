"""
Build the .zip of the extension: `npm run build:blender`, or `python3 blender/build.py -o furrow.zip`.

Blender has a command for this, but the Python module bpy does not. The same sources give the same bytes.
"""

import argparse
import re
import sys
import tomllib
import zipfile
from pathlib import Path

HERE = Path(__file__).parent
SOURCE = HERE / "furrow"

#: Regular expressions for the required fields of a manifest (Blender manual, "Extensions", schema 1.0.0).
REQUIRED = {
    "schema_version": r"1\.0\.0",
    "id": r"[a-z_]\w*",
    "version": r"\d+\.\d+\.\d+",
    "name": r".{2,64}",
    "tagline": r".{2,63}[^.]",
    "maintainer": r".+",
    "type": r"add-on",
    "blender_version_min": r"(4\.[2-9]|[5-9]\.\d)\.\d+",
}


def find_problems(manifest):
    problems = [
        f"{field} is {manifest.get(field)!r}, allowed: {rule}"
        for field, rule in REQUIRED.items()
        if not (isinstance(manifest.get(field), str) and re.fullmatch(rule, manifest[field]))
    ]
    licences = manifest.get("license")
    if not licences or not all(re.fullmatch(r"SPDX:[\w.+-]+", item) for item in licences):
        problems.append(f"license is {licences!r}, allowed: a list of SPDX:...")
    for name, reason in manifest.get("permissions", {}).items():
        if len(reason) > 64 or reason.endswith("."):
            problems.append(
                f"reason of permission {name} is {reason!r}, allowed: at most 64 characters without a full stop"
            )
    return problems


def build(output=None):
    """Write the .zip and return its path. Raises ValueError if the manifest is invalid."""
    manifest = tomllib.loads((SOURCE / "blender_manifest.toml").read_text("utf-8"))
    problems = find_problems(manifest)
    if problems:
        raise ValueError("; ".join(problems))
    path = Path(output) if output else HERE / "dist" / f"{manifest['id']}-{manifest['version']}.zip"
    path.parent.mkdir(parents=True, exist_ok=True)
    files = [file for file in SOURCE.rglob("*") if file.is_file() and "__pycache__" not in file.parts]
    contents = {file.relative_to(SOURCE).as_posix(): file.read_bytes() for file in files}
    contents["LICENSE"] = (HERE.parent / "LICENSE").read_bytes()
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(contents):
            archive.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), contents[name], zipfile.ZIP_DEFLATED)
    return path


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Build the extension for Blender")
    parser.add_argument("-o", "--output", help="the .zip (default: blender/dist/ID-VERSION.zip)")
    try:
        print(build(parser.parse_args().output))
    except ValueError as error:
        sys.exit(f"blender_manifest.toml: {error}; correct it")
