"""
A wrinkle set as Blender properties of its node group, `node_group.furrow`, so that the group, its images and its
drivers are saved, linked and appended together.
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
    ("replace", "Replace", "The map has pores and wrinkles, and replaces the material's normal map"),
    ("detail", "Detail", "The map has only wrinkles, added to the material's normal map"),
]
COMBINE = [
    ("sum", "Sum", "Added to other areas of the layer"),
    ("max", "Maximum", "Maximum with other areas of the layer"),
]
CHANNELS = [(str(i), name, f"Channel {name} of the image") for i, name in enumerate("RGBA")]


def _rebuild(self, _context):
    """Rebuild after a change by the user or a script."""
    from .wrinkle_set import is_loading, rebuild

    if not is_loading():
        rebuild(self.id_data)


def _rename(self, context):
    """Rename the area in drivers."""
    from .format.edit import rename_area

    wrinkles = self.id_data.furrow
    if self.known_name and self.known_name != self.name:
        for driver in wrinkles.drivers:
            driver.json = json.dumps(rename_area([json.loads(driver.json)], self.known_name, self.name)[0])
    self.known_name = self.name
    _rebuild(self, context)


def _preview(self, _context):
    from .rig import show_preview

    show_preview(self.id_data)


def _stored(name, default):
    """
    Create the getter and setter of a number that drivers read. It is stored as a custom property of the node group,
    numbered by the item's index.

    Blender reports a dependency cycle for drivers that read a group's registered properties, but not for custom ones.
    """

    def key(self):
        return f"{name}{int(self.path_from_id().rsplit('[', 1)[1][:-1])}"

    def get(self):
        return self.id_data.get(key(self), default)

    def set_(self, value):
        self.id_data[key(self)] = float(value)
        self.id_data.update_tag()

    return {"get": get, "set": set_}


def _image(description):
    return PointerProperty(type=bpy.types.Image, description=description, update=_rebuild)


class FurrowLayer(bpy.types.PropertyGroup):
    """Maps of the fully wrinkled skin."""

    name: StringProperty(name="Name", update=_rebuild)
    kind: EnumProperty(name="Kind", items=KINDS, update=_rebuild)
    normal: _image("Tangent-space normals")
    normal_scale: FloatProperty(name="Scale", default=1, soft_min=0, soft_max=2, update=_rebuild)
    base_color: _image("Base colour, fully wrinkled")
    roughness: _image("Roughness in G")
    occlusion: _image("Occlusion in R; exported but not shown, because Blender traces light")
    occlusion_strength: FloatProperty(name="Strength", default=1, min=0, max=1)
    height: _image("Height in R; exported but not shown")
    height_amplitude: FloatProperty(
        name="Amplitude", default=0.001, min=0, max=1000, precision=5, description="Height from black to white, metres"
    )
    blood: _image("Change of blood in B, 0.5 = unchanged; must be the same image as the occlusion")
    blood_amplitude: FloatProperty(name="Amplitude", default=0.3, min=0, max=2, update=_rebuild)
    other: StringProperty(default="{}")


class FurrowArea(bpy.types.PropertyGroup):
    """Area of one group of wrinkles."""

    name: StringProperty(name="Name", update=_rename)
    known_name: StringProperty(description="Name before a change")
    layer: IntProperty(name="Layer", min=0, max=3, description="Index of the layer, from 0", update=_rebuild)
    image: _image("Weights: white where wrinkles are fully visible")
    channel: EnumProperty(name="Channel", items=CHANNELS, update=_rebuild)
    combine: EnumProperty(name="Combine", items=COMBINE, update=_rebuild)
    activation: FloatProperty(
        name="At Rest",
        min=0,
        max=1,
        subtype="FACTOR",
        description="Resting activation. Drivers add to it",
        **_stored("rest", 0.0),
    )
    other: StringProperty(default="{}")


class FurrowDriver(bpy.types.PropertyGroup):
    """A driver as JSON, which keeps fields that Blender does not support."""

    json: StringProperty()


class FurrowInput(bpy.types.PropertyGroup):
    """A number read by drivers, such as the age."""

    name: StringProperty()
    value: FloatProperty(name="Value", **_stored("input", 0.0))


class FurrowJoint(bpy.types.PropertyGroup):
    """An imported object that drivers measure as a joint."""

    name: StringProperty()
    object: PointerProperty(type=bpy.types.Object)
    rest: FloatVectorProperty(size=4, description="World rotation at rest, a quaternion w, x, y, z")


class FurrowMesh(bpy.types.PropertyGroup):
    """An imported mesh used in shape corrections."""

    name: StringProperty()
    object: PointerProperty(type=bpy.types.Object)


class FurrowDelay(bpy.types.PropertyGroup):
    """A driver of type `time`: time constants of an area, seconds."""

    area: IntProperty()
    attack: FloatProperty()
    release: FloatProperty()


class FurrowWrinkles(bpy.types.PropertyGroup):
    """The wrinkle set of a node group. Other groups have no layers."""

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
    preview: BoolProperty(name="Preview", description="Show only the active area, fully wrinkled", update=_preview)
    face: PointerProperty(
        type=bpy.types.Object, name="Face", description="Object with the driving shape keys and bones", update=_rebuild
    )
    notes: StringProperty(description="Exported data that Blender does not show, one per line")
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
