"""
A wrinkle set as Blender's properties. They belong to the node group that shows the set, `node_group.furrow`, so that
the group, its images and its drivers are saved, linked and appended together.
"""

import json

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

KINDS = [
    ("replace", "Replace", "The map has pores and wrinkles, and replaces the material's normals"),
    ("detail", "Detail", "The map has wrinkles alone, which are laid over the material's normals"),
]
COMBINE = [
    ("sum", "Sum", "Added to other areas of the layer"),
    ("max", "Maximum", "The larger of this and other areas of the layer counts"),
]
CHANNELS = [(str(i), name, f"Channel {name} of the image") for i, name in enumerate("RGBA")]


def _rebuild(self, _context):
    """After a change of structure, by the user or a script."""
    from .wrinkle_set import is_loading, rebuild

    if not is_loading():
        rebuild(self.id_data)


def _rename(self, context):
    """Drivers name areas; they follow."""
    from .format.edit import with_area_renamed

    wrinkles = self.id_data.furrow
    if self.known_name and self.known_name != self.name:
        for driver in wrinkles.drivers:
            driver.json = json.dumps(with_area_renamed([json.loads(driver.json)], self.known_name, self.name)[0])
    self.known_name = self.name
    _rebuild(self, context)


def _preview(self, _context):
    from .rig import show_preview

    show_preview(self.id_data)


def _stored(name, usual):
    """
    Getter and setter of a number that drivers read: a custom property of the node group, numbered as the item is in its
    collection.

    Blender takes drivers of a group that read its registered properties for a circle; custom properties are told apart.
    """

    def key(self):
        return f"{name}{int(self.path_from_id().rsplit('[', 1)[1][:-1])}"

    def get(self):
        return self.id_data.get(key(self), usual)

    def set_(self, value):
        self.id_data[key(self)] = float(value)
        self.id_data.update_tag()

    return {"get": get, "set": set_}


def _image(description):
    return PointerProperty(type=bpy.types.Image, description=description, update=_rebuild)


class FurrowLayer(bpy.types.PropertyGroup):
    """The maps of the fully wrinkled skin."""

    name: StringProperty(name="Name", update=_rebuild)
    kind: EnumProperty(name="Kind", items=KINDS, update=_rebuild)
    normal: _image("Tangent-space normals")
    normal_scale: FloatProperty(name="Scale", default=1, soft_min=0, soft_max=2, update=_rebuild)
    base_color: _image("Skin colour, fully wrinkled")
    roughness: _image("Roughness in G")
    occlusion: _image("Occlusion in R; exported, not shown: Blender's lights are traced")
    occlusion_strength: FloatProperty(name="Strength", default=1, min=0, max=1)
    height: _image("Height in R; exported, not shown")
    height_amplitude: FloatProperty(
        name="Amplitude", default=0.001, min=0, max=1000, precision=5, description="Metres from black to white"
    )
    blood: _image("More or less blood in B, half is as at rest; the same image as the occlusion")
    blood_amplitude: FloatProperty(name="Amplitude", default=0.3, min=0, max=2, update=_rebuild)
    other: StringProperty(default="{}")


class FurrowArea(bpy.types.PropertyGroup):
    """Where one group of wrinkles lies."""

    name: StringProperty(name="Name", update=_rename)
    known_name: StringProperty(description="The name before it is changed")
    layer: IntProperty(name="Layer", min=0, max=3, description="Whose wrinkles it shows, from 0", update=_rebuild)
    image: _image("Weights: white where wrinkles are fully visible")
    channel: EnumProperty(name="Channel", items=CHANNELS, update=_rebuild)
    combine: EnumProperty(name="Combine", items=COMBINE, update=_rebuild)
    activation: FloatProperty(
        name="At Rest",
        min=0,
        max=1,
        subtype="FACTOR",
        description="Resting activation, to which drivers add",
        **_stored("rest", 0.0),
    )
    other: StringProperty(default="{}")


class FurrowDriver(bpy.types.PropertyGroup):
    """One driver of the file, as JSON: what Blender cannot express stays as it was."""

    json: StringProperty()


class FurrowInput(bpy.types.PropertyGroup):
    """A number that drivers read, such as the age."""

    name: StringProperty()
    value: FloatProperty(name="Value", **_stored("input", 0.0))


class FurrowJoint(bpy.types.PropertyGroup):
    """A node of the file that drivers measure, and that is no bone."""

    name: StringProperty()
    object: PointerProperty(type=bpy.types.Object)
    rest: FloatVectorProperty(size=4, description="Its rotation at rest in the world, a quaternion w, x, y, z")


class FurrowMesh(bpy.types.PropertyGroup):
    """A mesh of the file that corrections of shapes name."""

    name: StringProperty()
    object: PointerProperty(type=bpy.types.Object)


class FurrowDelay(bpy.types.PropertyGroup):
    """A driver of type `time`: the constants of an area in seconds."""

    area: IntProperty()
    attack: FloatProperty()
    release: FloatProperty()


class FurrowWrinkles(bpy.types.PropertyGroup):
    """The wrinkle set of a node group. `layers` is empty in all other groups."""

    is_wrinkles: BoolProperty()
    layers: CollectionProperty(type=FurrowLayer)
    areas: CollectionProperty(type=FurrowArea)
    drivers: CollectionProperty(type=FurrowDriver)
    inputs: CollectionProperty(type=FurrowInput)
    joints: CollectionProperty(type=FurrowJoint)
    meshes: CollectionProperty(type=FurrowMesh)
    delays: CollectionProperty(type=FurrowDelay)
    active_layer: IntProperty()
    active_area: IntProperty(update=_preview)
    preview: BoolProperty(
        name="Preview", description="Show the chosen area fully wrinkled, and no other", update=_preview
    )
    face: PointerProperty(
        type=bpy.types.Object, name="Face", description="Whose shape keys and bones drive the wrinkles", update=_rebuild
    )
    notes: StringProperty(description="What is kept for the export and not shown, one per line")
    other: StringProperty(default="{}")


CLASSES = (FurrowLayer, FurrowArea, FurrowDriver, FurrowInput, FurrowJoint, FurrowMesh, FurrowDelay, FurrowWrinkles)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.NodeTree.furrow = PointerProperty(type=FurrowWrinkles)


def unregister():
    del bpy.types.NodeTree.furrow
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
