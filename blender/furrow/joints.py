"""
Evaluates drivers of type `bone`, which read two joints.

A joint is a bone of the face's armature, or an imported object. The driver reads the distance between two joints, or
the change of their relative rotation since the rest pose. Blender's driver variable for rotational differences ignores
the rest pose, and its angle has no sign. Therefore small drivers compute the relative rotation as a quaternion, one
driver per component.
"""

from dataclasses import dataclass

import bpy
from mathutils import Matrix, Quaternion, Vector

from .format.plan import Source, Step

#: Custom property of a bone: rotation from the frame of the glTF joint to the frame of the bone, in the rest pose.
FRAME = "furrow_frame"

#: Rotation from glTF's Y-up to Blender's Z-up.
_Y_TO_Z = Matrix(((1, 0, 0), (0, 0, -1), (0, 1, 0)))

#: Components w, x, y, z of the quaternion product `conjugate((a, b, c, d)) * (e, f, g, h)`.
_PRODUCT = ("a*e+b*f+c*g+d*h", "a*f-b*e-c*h+d*g", "a*g+b*h-c*e-d*f", "a*h-b*g+c*f-d*e")


@dataclass(frozen=True)
class _Joint:
    owner: bpy.types.Object
    bone: str
    """Name of the bone if `owner` is an armature. Empty if the owner itself is the joint."""
    rest: Quaternion
    """Rest rotation: of a bone in the space of its armature, of an object in world space."""
    frame: Quaternion | None
    """Rotation from the glTF joint's frame to the frame of the bone or object, in the rest pose. None if unknown."""


def can_measure(wrinkles, driver):
    """Return whether a `bone` driver's joints exist, and whether its axis can be converted to the frame of the bone."""
    joints = _joints(wrinkles, driver["joints"])
    return joints is not None and ("axis" not in driver or joints[1].frame is not None)


def _joints(wrinkles, names):
    """
    Find two joints by name.

    Returns None unless both are bones of the face's armature, or both are imported objects.
    """
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
    """Replace sources of kind `joint` by additional steps, which compute the rotation or the distance."""
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
    """
    Add a driver variable and return it.

    `measured`: `(component, joint)` for a component w, x, y or z of a joint's rotation, or
    `("distance", joint, joint)`.
    """
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
    Store the property `FRAME` on the bones of glTF joints. With it, `_measure` converts the axis of a driver from the
    frame of the glTF joint to the frame of the bone.

    `rest_of`: function that takes the name of a bone, and returns the rest rotation of its glTF joint in skin space, a
    3 x 3 matrix. It returns None for bones that are no joints.
    """
    for bone in armature.data.bones:
        rest = rest_of(bone.name)
        if rest is not None:
            inverse = bone.matrix_local.to_3x3().inverted()
            bone[FRAME] = tuple((inverse @ _Y_TO_Z @ rest).to_quaternion())


def store_nodes(wrinkles, names, objects):
    """
    Store the imported objects that drivers read as joints. Their current world rotations become their rest rotations.

    `names`: names of joints. `objects`: imported objects by the name of their glTF node.
    """
    for name in names:
        if name in objects:
            joint = wrinkles.joints.add()
            joint.name, joint.object = name, objects[name]
            joint.rest = _world(objects[name]).to_quaternion()


def _world(item):
    """Return the world matrix of an object. During an import, Blender's own world matrix is not up to date."""
    parent = _world(item.parent) @ item.matrix_parent_inverse if item.parent else Matrix()
    return parent @ item.matrix_basis


def armature_of(face):
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
        # The sign of the angle must not depend on the sign of the quaternion: q and -q are the same rotation.
        angle = f"2*atan2((b*({x:.7f})+c*({y:.7f})+d*({z:.7f}))*(1 if a>0 else -1),abs(a))"
    return [*steps, Step(name, "SCRIPTED", turned, angle)]
