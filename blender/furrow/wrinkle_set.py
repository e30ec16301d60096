"""Converts wrinkle sets between JSON and Blender properties, and rebuilds nodes and drivers."""

import json
from contextlib import contextmanager

import bpy

from .format.document import read_document
from .format.edit import meshes_of, rename_joints, rename_meshes
from .format.reader import FurrowError
from .images import file_from_image, image_from_file
from .material import detach_group, group_node, reattach_group
from .rig import build_drivers, show_preview
from .shading import build_nodes

#: Maps of a layer. Each entry has four names: Blender property and JSON field of the image, then Blender property and
#: JSON field of the number that scales the map.
MAPS = (
    ("normal", "normalTexture", "normal_scale", "scale"),
    ("base_color", "baseColorTexture", None, None),
    ("roughness", "roughnessTexture", None, None),
    ("occlusion", "occlusionTexture", "occlusion_strength", "strength"),
    ("height", "heightTexture", "height_amplitude", "amplitude"),
    ("blood", "bloodTexture", "blood_amplitude", "amplitude"),
    ("onset", "onsetTexture", "onset_strength", "strength"),
)
_SLOTS = [slot for _, slot, _, _ in MAPS]
_loading = 0


def new_group(name):
    """Create a wrinkle group: a node group with an empty wrinkle set."""
    tree = bpy.data.node_groups.new(name, "ShaderNodeTree")
    tree.furrow.is_wrinkles = True
    return tree


def load_document(tree, document, image_of):
    """
    Fill the wrinkle set of a group from a document that `read_document` has checked.

    `image_of`: function that returns the ImageFile of a texture index. Raises FurrowError if an image is invalid.
    """
    images = {}

    def image(info, is_data=True):
        key = (info["index"], is_data)
        if key not in images:
            if "slice" in info:
                raise FurrowError("Furrow: unsupported texture, got a KTX 2 array; pack the face without --ktx2")
            images[key] = image_from_file(image_of(info["index"]), is_data)
        return images[key]

    wrinkles = tree.furrow
    with _loading_properties():
        for item in document["layers"]:
            layer = wrinkles.layers.add()
            layer.name, layer.kind = item["name"], item["kind"]
            for prop, slot, number, field in MAPS:
                if slot in item:
                    setattr(layer, prop, image(item[slot], prop != "base_color"))
                    if number:
                        setattr(layer, number, item[slot][field])
            layer.other = _other_fields(item, "name", "kind", *_SLOTS)
        for prop, _, _, _ in MAPS:
            _check_sizes([getattr(layer, prop) for layer in wrinkles.layers if getattr(layer, prop)])
        for item in document["areas"]:
            area = wrinkles.areas.add()
            area.name, area.layer, area.combine = item["name"], item["layer"], item["combine"]
            area.image, area.channel, area.activation = image(item["texture"]), str(item["channel"]), item["activation"]
            area.other = _other_fields(item, "name", "layer", "combine", "texture", "channel", "activation")
        for item in document["drivers"]:
            wrinkles.drivers.add().json = json.dumps(item)
        wrinkles.other = _other_fields(document, "layers", "areas", "drivers")


def _check_sizes(images):
    """Check that maps of one kind have the same size, because game engines put them into one texture array."""
    sizes = {tuple(image.size) for image in images}
    if len(sizes) > 1:
        found = ", ".join(f"{width} x {height}" for width, height in sorted(sizes))
        raise FurrowError(f"Furrow: maps of one kind differ in size, got {found}, allowed: one size; scale them")


def document_of(tree):
    """
    Return the extension's JSON for a wrinkle group, and a list of ImageFile. Texture indices refer to this list.

    Raises FurrowError if an image is missing.
    """
    wrinkles = tree.furrow
    files = []

    def texture(image, owner):
        if image is None:
            raise FurrowError(f"Furrow: {owner} has no image; choose one or remove it")
        file = file_from_image(image)
        if file not in files:
            files.append(file)
        return {"index": files.index(file)}

    layers = []
    for layer in wrinkles.layers:
        item = {"name": layer.name, "kind": layer.kind}
        for prop, slot, number, field in MAPS:
            if prop == "normal" or getattr(layer, prop):
                item[slot] = texture(getattr(layer, prop), f'the normal map of layer "{layer.name}"')
                if number:
                    item[slot][field] = _round_float(getattr(layer, number))
        layers.append({**item, **json.loads(layer.other)})
    areas = []
    for area in wrinkles.areas:
        item = {
            "name": area.name,
            "layer": area.layer,
            "texture": texture(area.image, f'area "{area.name}"'),
            "channel": int(area.channel),
            "combine": area.combine,
            "activation": _round_float(area.activation),
        }
        areas.append({**item, **json.loads(area.other)})
    # Objects may have been renamed since the import.
    names = {joint.name: joint.object.name for joint in wrinkles.joints if joint.object}
    drivers = rename_joints([json.loads(driver.json) for driver in wrinkles.drivers], names)
    other = json.loads(wrinkles.other)
    if "shapes" in other:
        other["shapes"] = rename_meshes(other["shapes"], _mesh_names(wrinkles))
    root = {"layers": layers, "areas": areas, "drivers": drivers, **other}
    return read_document(root, len(files), f'material group "{tree.name}"'), files


def store_meshes(wrinkles, objects):
    """
    Store the objects of the meshes to which shape corrections refer.

    `objects`: imported objects by their name in the file.
    """
    for name in meshes_of(json.loads(wrinkles.other).get("shapes")):
        if name in objects:
            mesh = wrinkles.meshes.add()
            mesh.name, mesh.object = name, objects[name]


def _mesh_names(wrinkles):
    """Return new names by old names, for meshes that were renamed in Blender."""
    objects = {mesh.name: mesh.object for mesh in wrinkles.meshes if mesh.object}
    return {old: item.data.name for old, item in objects.items() if old not in (item.name, item.data.name)}


def materials_of(tree):
    found = []
    for material in bpy.data.materials:
        node = group_node(material)
        if node and node.node_tree == tree:
            found.append(material)
    return found


def rebuild(tree):
    """Build the nodes and drivers of a wrinkle group again, after its properties have changed."""
    wrinkles = tree.furrow
    materials = materials_of(tree)
    # Detaches the group first, because removing one of its sockets would also remove the links of the socket.
    for material in materials:
        detach_group(material)
    with _loading_properties():
        activations = build_nodes(tree)
        plan = build_drivers(tree, activations)
        wrinkles.notes = "\n".join(_notes(wrinkles, plan))
    if wrinkles.preview:
        show_preview(tree)
    for material in materials:
        reattach_group(material)


def is_loading():
    """Return whether `load_document` or `rebuild` is setting properties. Their update callbacks must not rebuild."""
    return _loading > 0


@contextmanager
def _loading_properties():
    global _loading
    _loading += 1
    try:
        yield
    finally:
        _loading -= 1


def _notes(wrinkles, plan):
    notes = [f"Not shown: {note}" for note in plan.unsupported]
    maps = [
        f"{name} of {layer.name}"
        for layer in wrinkles.layers
        for name in ("occlusion", "height")
        if getattr(layer, name)
    ]
    notes += [f"Not shown: {name}" for name in maps]
    notes += [f'"{name}" is missing on {wrinkles.face.name if wrinkles.face else "the face"}' for name in plan.missing]
    return notes


def _other_fields(item, *known):
    return json.dumps({key: value for key, value in item.items() if key not in known})


def _round_float(value):
    """Round to 7 significant digits, the precision of Blender's 32-bit floats."""
    return float(f"{value:.7g}")
