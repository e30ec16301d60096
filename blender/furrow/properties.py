"""
Defines `node_group.furrow`, the properties of a node group that store a wrinkle set.

The set is stored in the group, so that Blender saves, links and appends the group, its images and its drivers together.
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
    ("replace", "Replace", "The map shows pores and wrinkles, and replaces the material's normal map"),
    ("detail", "Detail", "The map shows only wrinkles, and is added to the material's normal map"),
]
COMBINE = [
    ("sum", "Sum", "Add this area to the other areas of the layer"),
    ("max", "Maximum", "Use the maximum of this area and the other areas of the layer"),
]
CHANNELS = [(str(i), name, f"Channel {name} of the image") for i, name in enumerate("RGBA")]


def _rebuild(self, _context):
    """Rebuild nodes and drivers after a user or a script has changed a property."""
    from .wrinkle_set import is_loading, rebuild

    if not is_loading():
        rebuild(self.id_data)


def _rename(self, context):
    """Use the new name of an area in all drivers, then rebuild."""
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
    Create the getter and setter of a number that drivers read.

    The number is stored in the node group, as a custom property. Its name is `name` followed by the index of the area
    or input. If drivers read registered properties of their own group, Blender reports a dependency cycle. With custom
    properties, it does not.
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
    """A layer: maps of the skin with all its wrinkles fully visible."""

    name: StringProperty(name="Name", update=_rebuild)
    kind: EnumProperty(name="Kind", items=KINDS, update=_rebuild)
    normal: _image("Normal map in tangent space")
    normal_scale: FloatProperty(name="Scale", default=1, soft_min=0, soft_max=2, update=_rebuild)
    base_color: _image("Base colour of the fully wrinkled skin")
    roughness: _image("Roughness in channel G")
    occlusion: _image("Occlusion in channel R. Exported but not shown: the Principled BSDF has no such input")
    occlusion_strength: FloatProperty(name="Strength", default=1, min=0, max=1)
    height: _image("Height in channel R. Exported but not shown")
    height_amplitude: FloatProperty(
        name="Amplitude",
        default=0.001,
        min=0,
        max=1000,
        precision=5,
        description="Difference of height between black and white, metres",
    )
    blood: _image("Change of blood in channel B, where 0.5 means unchanged. Must be the same image as the occlusion")
    blood_amplitude: FloatProperty(name="Amplitude", default=0.3, min=0, max=2, update=_rebuild)
    onset: _image("Influence at which a wrinkle appears, in channel G. Must be the same image as occlusion and blood")
    onset_strength: FloatProperty(name="Strength", default=1, min=0, max=1, update=_rebuild)
    other: StringProperty(default="{}")


class FurrowArea(bpy.types.PropertyGroup):
    """An area: where one group of wrinkles of a layer appears."""

    name: StringProperty(name="Name", update=_rename)
    known_name: StringProperty(description="Name before the last change")
    layer: IntProperty(name="Layer", min=0, max=3, description="Index of the layer, from 0", update=_rebuild)
    image: _image("Weights of the area. White where wrinkles are fully visible")
    channel: EnumProperty(name="Channel", items=CHANNELS, update=_rebuild)
    combine: EnumProperty(name="Combine", items=COMBINE, update=_rebuild)
    activation: FloatProperty(
        name="At Rest",
        min=0,
        max=1,
        subtype="FACTOR",
        description="Activation without drivers. Drivers add to it",
        **_stored("rest", 0.0),
    )
    other: StringProperty(default="{}")


class FurrowDriver(bpy.types.PropertyGroup):
    """A driver, stored as JSON to keep fields that this extension does not support."""

    json: StringProperty()


class FurrowInput(bpy.types.PropertyGroup):
    """A number that drivers read, such as the age."""

    name: StringProperty()
    value: FloatProperty(name="Value", **_stored("input", 0.0))


class FurrowJoint(bpy.types.PropertyGroup):
    """An imported object that drivers read as a joint."""

    name: StringProperty()
    object: PointerProperty(type=bpy.types.Object)
    rest: FloatVectorProperty(size=4, description="World rotation at rest, a quaternion w, x, y, z")


class FurrowMesh(bpy.types.PropertyGroup):
    """An imported mesh to which shape corrections refer."""

    name: StringProperty()
    object: PointerProperty(type=bpy.types.Object)


class FurrowDelay(bpy.types.PropertyGroup):
    """Time constants of a delayed area, seconds."""

    area: IntProperty()
    attack: FloatProperty()
    release: FloatProperty()


class FurrowWrinkles(bpy.types.PropertyGroup):
    """A wrinkle set. Every node group has this property, but only groups with `is_wrinkles` use it."""

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
        type=bpy.types.Object,
        name="Face",
        description="Object whose shape keys and bones drive the wrinkles",
        update=_rebuild,
    )
    notes: StringProperty(description="Notes about exported data that Blender does not show, one per line")
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
