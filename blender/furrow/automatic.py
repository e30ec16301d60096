"""
Wrinkles made automatically, by the command `furrow auto`: it reads a file that Blender wrote, and writes one with
wrinkles.
"""

import shutil
import subprocess
import tempfile
from pathlib import Path

import bpy

from .format.container import GltfFile
from .format.document import EXTENSION, read_document
from .format.reader import FurrowError

INSTALL = (
    "install Node.js and run `npm install --global furrow-cli`, or name the command in the extension's preferences"
)


def command_path(preferred):
    """The command of the preferences, else the one on the path. Raises FurrowError where there is none."""
    found = shutil.which(bpy.path.abspath(preferred)) if preferred else shutil.which("furrow")
    if found is None:
        raise FurrowError(f"Furrow: the command {preferred or 'furrow'} is not there; {INSTALL}")
    return found


class AutomaticRun:
    """One run of the command on a face, beside Blender. `poll` until it is done, then `result`; `close` in any case."""

    def __init__(self, face, material, command, options):
        self.material = material
        self.folder = tempfile.TemporaryDirectory()
        folder = Path(self.folder.name)
        self.output = folder / "wrinkled.glb"
        _export(face, folder / "face.glb")
        words = [command, "auto", str(folder / "face.glb"), "-o", str(self.output), "--replace", *options]
        # A file, not a pipe: nobody reads while the command works.
        self.errors = folder / "errors.txt"
        with open(self.errors, "w") as errors:
            self.process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=errors)

    def poll(self):
        """Whether the command is done."""
        return self.process.poll() is not None

    def result(self):
        """The document that it wrote, and the file with its images. Raises FurrowError with what the command said."""
        if self.process.wait() != 0:
            said = self.errors.read_text(errors="replace").strip().splitlines()
            raise FurrowError(said[-1] if said else "Furrow: the command furrow auto failed; run it in a terminal")
        file = GltfFile(self.output)
        for material in file.json.get("materials", []):
            extension = material.get("extensions", {}).get(EXTENSION)
            if extension and material.get("name") == self.material.name:
                return read_document(extension, file.texture_count), file
        raise FurrowError(
            f"Furrow: furrow auto made no wrinkles for {self.material.name}; choose the material of the skin"
        )

    def close(self):
        """End the command if it still runs, and remove its files."""
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.folder.cleanup()


def _export(face, path):
    """Write one face with its armature; the selection is as before."""
    selected, active = bpy.context.selected_objects, bpy.context.view_layer.objects.active
    for item in selected:
        item.select_set(False)
    for item in (face, face.find_armature()):
        if item:
            item.select_set(True)
    bpy.context.view_layer.objects.active = face
    try:
        bpy.ops.export_scene.gltf(filepath=str(path), use_selection=True, export_animations=False)
    finally:
        for item in bpy.context.selected_objects:
            item.select_set(False)
        for item in selected:
            item.select_set(True)
        bpy.context.view_layer.objects.active = active
