"""
Drivers of type `bone`: the rotation of a joint from rest, relative to another joint, or their distance. Joints are
bones of the face's armature, or imported objects.

Blender's rotational difference variable is unsigned and not relative to rest. So small drivers compute the relative
rotation, one per quaternion component.
"""

from dataclasses import dataclass

import bpy
from mathutils import Matrix, Quaternion, Vector

from .format.plan import Source, Step

#: Custom property of a bone: rotation from its glTF joint's frame to its own, at rest.
FRAME = "furrow_frame"

#: Rotation from glTF's Y-up to Blender's Z-up.
_Y_TO_Z = Matrix(((1, 0, 0), (0, 0, -1), (0, 1, 0)))

#: Components w, x, y, z of the quaternion product conjugate(a, b, c, d) * (e, f, g, h).
_PRODUCT = ("a*e+b*f+c*g+d*h", "a*f-b*e-c*h+d*g", "a*g+b*h-c*e-d*f", "a*h-b*g+c*f-d*e")


@dataclass(frozen=True)
class _Joint:
    owner: bpy.types.Object
    bone: str
    """Name of the owner's bone, or empty for the owner itself."""
    rest: Quaternion
    frame: Quaternion | None
    """Rotation from the glTF joint's frame to Blender's, at rest; None if unknown."""


def can_measure(wrinkles, driver):
    """Whether a `bone` driver's joints exist, and its axis can be converted to Blender's frame."""
    joints = _joints(wrinkles, driver["joints"])
    return joints is not None and ("axis" not in driver or joints[1].frame is not None)


def _joints(wrinkles, names):
    """Find two joints by name. Returns None if they are neither bones of the face's armature nor imported objects."""
    armature = armature_of(wrinkles.face)
    bones = [armature.data.bones.get(name) for name in names] if armature else []
    if bones and all(bones):
        frames = [Quaternion(bone[FRAME]) if FRAME in bone else None for bone in bones]
        rests = [bone.matrix_local.to_quaternion() for bone in bones]
        return [_Joint(armature, *known) for known in zip((bone.name for bone in bones), rests, frames, strict=True)]
    nodes = [wrinkles.joints.get(name) for name in names]
    if all(node and node.object for node in nodes):
        return [_Joint(node.object, "", Quaternion(node.rest), _Y_TO_Z.to_quaternion()) for node in nodes]
    return None


def expand_joints(steps, wrinkles):
    """Insert steps that measure joints before the steps that read them."""
    out = []
    for step in steps:
        sources = []
        for source in step.sources:
            if source.kind == "joint":
                origin, joint, kind, axis = source.name
                out.extend(_measure(f"{step.name}j", *_joints(wrinkles, (origin, joint)), kind, axis))
                source = Source("step", f"{step.name}j")
            sources.append(source)
        out.append(Step(step.name, step.combine, sources, step.expression, step.curve, step.slope))
    return out


def read_joint(driver, measured):
    """Add a driver variable for a component of a joint's rotation, or for the distance of two joints."""
    kind, *joints = measured
    variable = driver.variables.new()
    variable.type = "LOC_DIFF" if kind == "distance" else "TRANSFORMS"
    for target, joint in zip(variable.targets, joints, strict=True):
        target.id = joint.owner
        target.bone_target = joint.bone
    if kind != "distance":
        target = variable.targets[0]
        target.transform_space = "WORLD_SPACE"
        target.rotation_mode = "QUATERNION"
        target.transform_type = f"ROT_{kind.upper()}"
    return variable


def store_frames(armature, rest_of):
    """
    Store the rotation of each bone's glTF joint on the bone, for drivers' axes.

    `rest_of`: function from a bone's name to the joint's rest rotation in skin space, a 3 x 3 matrix, or None.
    """
    for bone in armature.data.bones:
        rest = rest_of(bone.name)
        if rest is not None:
            inverse = bone.matrix_local.to_3x3().inverted()
            bone[FRAME] = tuple((inverse @ _Y_TO_Z @ rest).to_quaternion())


def store_nodes(wrinkles, names, objects):
    """Store the objects that drivers measure as joints in a set, with their current world rotations as rest."""
    for name in names:
        if name in objects:
            joint = wrinkles.joints.add()
            joint.name, joint.object = name, objects[name]
            joint.rest = _world(objects[name]).to_quaternion()


def _world(item):
    """Compute an object's world matrix, which Blender updates only after the import."""
    parent = _world(item.parent) @ item.matrix_parent_inverse if item.parent else Matrix()
    return parent @ item.matrix_basis


def armature_of(face):
    """Return the armature that deforms a face, or None."""
    return face.find_armature() if face else None


def _measure(name, origin, joint, kind, axis):
    if kind == "distance":
        return [Step(name, "SUM", [Source("measured", ("distance", origin, joint))])]
    both = [Source("measured", (component, item)) for item in (origin, joint) for component in "wxyz"]
    relative = [Step(f"{name}r{i}", "SCRIPTED", both, _PRODUCT[i]) for i in range(4)]
    rest = origin.rest.inverted() @ joint.rest
    known = {letter: f"({value:.7f})" for letter, value in zip("abcd", rest, strict=True)}
    letters = dict(zip("efgh", "abcd", strict=True))
    steps = list(relative)
    for i, product in enumerate(_PRODUCT):
        expression = "".join(known.get(c) or letters.get(c, c) for c in product)
        steps.append(Step(f"{name}q{i}", "SCRIPTED", [Source("step", step.name) for step in relative], expression))
    turned = [Source("step", f"{name}q{i}") for i in range(4)]
    if axis is None:
        angle = "2*atan2(sqrt(b*b+c*c+d*d),abs(a))"
    else:
        x, y, z = (joint.frame @ Vector(axis)).normalized()
        # Handles both signs: q and -q are the same rotation.
        angle = f"2*atan2((b*({x:.7f})+c*({y:.7f})+d*({z:.7f}))*(1 if a>0 else -1),abs(a))"
    return [*steps, Step(name, "SCRIPTED", turned, angle)]
