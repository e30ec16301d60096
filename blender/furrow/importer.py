"""
Imports wrinkles together with Blender's glTF importer.

If the wrinkles have an error, the face is imported without them, and a warning is shown.
"""

import json
import struct

import bpy
from mathutils import Matrix

from .format.container import GltfFile
from .format.document import EXTENSION, read_document
from .format.reader import FurrowError
from .joints import armature_of, store_frames, store_nodes
from .material import insert_group
from .wrinkle_set import load_document, new_group, rebuild, store_meshes


class ImportHooks:
    """Hooks of one import. Blender calls the methods."""

    def __init__(self):
        self.file = None
        self.loaded = []
        self.nodes = {}
        self.meshes = {}

    def gather_import_material_after_hook(self, gltf_material, _vertex_color, material, gltf):
        """Create the images and the node group of a material's wrinkles, and insert the group into the material."""
        extension = (gltf_material.extensions or {}).get(EXTENSION)
        if extension is None:
            return
        tree = new_group(f"Wrinkles of {material.name}")
        try:
            errors = []
            self.file = self.file or GltfFile(gltf.filename)
            document = read_document(extension, self.file.texture_count, f'material "{material.name}"', errors.append)
            load_document(tree, document, self.file.image_of)
            rebuild(tree)
            insert_group(material, tree)
            self.loaded.append((material, tree))
            if EXTENSION in _animations(self.file):
                _warn(gltf, f'Furrow: key frames of activations in {gltf.filename} are skipped; animate "At Rest"')
            if errors:
                _warn(gltf, f"{errors[0]}; skipped drivers: {len(errors)}")
        except Exception as error:
            # Catches all exceptions, because no error in the wrinkles may stop the import of the face.
            _remove(tree)
            _warn(gltf, f"{_text(error)}; the face is imported without wrinkles")

    def gather_import_node_after_hook(self, _vnode, gltf_node, item, gltf):
        """Store the Blender object by the names of its glTF node and mesh, which drivers and shape corrections use."""
        if gltf_node is None:
            return
        if gltf_node.name is not None:
            self.nodes.setdefault(gltf_node.name, item)
        if gltf_node.mesh is not None:
            for name in (gltf.data.meshes[gltf_node.mesh].name, gltf_node.name):
                self.meshes.setdefault(name, item)

    def gather_import_scene_after_nodes_hook(self, _gltf_scene, _scene, gltf):
        """Build the drivers. Blender calls this method after it has created all objects, shape keys and bones."""
        for material, tree in self.loaded:
            try:
                tree.furrow.face = _face_of(material)
                _store_frames(self.file, tree.furrow.face)
                store_nodes(tree.furrow, _joints_of(tree.furrow), self.nodes)
                store_meshes(tree.furrow, self.meshes)
                rebuild(tree)
            except Exception as error:
                _warn(gltf, f"{_text(error)}; the wrinkles of {material.name} have no drivers")


def _animations(file):
    """Return the animations as JSON text. The caller searches it for pointers to the wrinkle extension."""
    return json.dumps(file.json.get("animations", []))


def _text(error):
    return str(error) if isinstance(error, FurrowError) else f"Furrow: {type(error).__name__}, {error}"


def _warn(gltf, text):
    gltf.log.warning(text, popup=True)


def _remove(tree):
    layers, areas = tree.furrow.layers, tree.furrow.areas
    images = {area.image for area in areas} | {layer.normal for layer in layers}
    bpy.data.node_groups.remove(tree)
    for image in images - {None}:
        if image.users == 0:
            bpy.data.images.remove(image)


def _face_of(material):
    """Return the first mesh object with the material. Prefers objects that have shape keys."""
    meshes = [
        item
        for item in bpy.data.objects
        if item.type == "MESH" and any(slot.material == material for slot in item.material_slots)
    ]
    return next((item for item in meshes if item.data.shape_keys), meshes[0] if meshes else None)


def _joints_of(wrinkles):
    drivers = [json.loads(driver.json) for driver in wrinkles.drivers]
    return list(dict.fromkeys(name for driver in drivers if driver["type"] == "bone" for name in driver["joints"]))


def _store_frames(file, face):
    """Compute the rest rotations of joints from the inverse bind matrices of skins, and store them on the bones."""
    armature = armature_of(face)
    if armature is None:
        return
    rests = {}
    for skin in file.json.get("skins", []):
        matrices = _inverse_binds(file, skin)
        for node, matrix in zip(skin["joints"], matrices, strict=False):
            rests[file.json["nodes"][node].get("name")] = matrix.inverted_safe().to_3x3().normalized()
    store_frames(armature, rests.get)


def _inverse_binds(file, skin):
    accessor = file.json["accessors"][skin["inverseBindMatrices"]] if "inverseBindMatrices" in skin else None
    if accessor is None:
        return []
    data = file.view(accessor["bufferView"])
    start = accessor.get("byteOffset", 0)
    matrices = []
    for i in range(accessor["count"]):
        numbers = struct.unpack_from("<16f", data, start + 64 * i)
        matrices.append(Matrix([numbers[row::4] for row in range(4)]))
    return matrices
