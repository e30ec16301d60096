"""Makes automatic wrinkles: exports a face, runs the command `furrow auto` on the file, and reads the result."""

import shutil
import subprocess
import tempfile
from pathlib import Path

import bpy

from .format.container import GltfFile
from .format.document import EXTENSION, read_document
from .format.reader import FurrowError

INSTALL = (
    "install Node.js and run `npm install --global furrow-cli`, "
    "or set the command's path in the extension's preferences"
)


def command_path(preferred):
    """
    Return the path of the command `furrow`. Raises FurrowError if it is missing.

    `preferred`: path from the preferences. If it is empty, `furrow` is looked up on PATH.
    """
    found = shutil.which(bpy.path.abspath(preferred)) if preferred else shutil.which("furrow")
    if found is None:
        raise FurrowError(f"Furrow: missing command, got {preferred or 'furrow'}; {INSTALL}")
    return found


class AutomaticRun:
    """
    Runs the command in the background.

    Call `poll` until the command is done, then `result`. Always call `close` at the end.
    """

    def __init__(self, face, material, command, options):
        self.material = material
        self.folder = tempfile.TemporaryDirectory()
        folder = Path(self.folder.name)
        self.output = folder / "wrinkled.glb"
        _export(face, folder / "face.glb")
        words = [command, "auto", str(folder / "face.glb"), "-o", str(self.output), "--replace", *options]
        # Errors go to a file. A pipe would fill up, because nothing reads it, and a full pipe blocks the command.
        self.errors = folder / "errors.txt"
        with open(self.errors, "w") as errors:
            self.process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=errors)

    def poll(self):
        return self.process.poll() is not None

    def result(self):
        """
        Return the JSON of the wrinkle extension, and the GltfFile that contains its images.

        If the command failed, raises FurrowError with the last line of its error output.
        """
        if self.process.wait() != 0:
            lines = self.errors.read_text(errors="replace").strip().splitlines()
            raise FurrowError(lines[-1] if lines else "Furrow: furrow auto failed without output; run it in a terminal")
        file = GltfFile(self.output)
        for material in file.json.get("materials", []):
            extension = material.get("extensions", {}).get(EXTENSION)
            if extension and material.get("name") == self.material.name:
                return read_document(extension, file.texture_count), file
        raise FurrowError(f"Furrow: furrow auto made no wrinkles for {self.material.name}; select the skin's material")

    def close(self):
        """Kill the command if it is still running, and remove its files."""
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.folder.cleanup()


def _export(face, path):
    """Export a face with its armature. Restores the selection afterwards."""
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
