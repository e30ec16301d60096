"""
Drivers of type `bone`: the rotation of a joint from rest relative to another, or the distance of the two. Joints are
bones of the face's armature, or nodes of the file that became objects.

Blender's own variable for two bones measures the angle between them, not from rest, and has no sign. The relative
rotation is made of quaternions instead, one small driver for each component.
"""

from dataclasses import dataclass

import bpy
from mathutils import Matrix, Quaternion, Vector

from .format.plan import Source, Step

#: Custom property of a bone: the rotation from the frame of its glTF joint to its own, both at rest.
FRAME = "furrow_frame"

#: glTF's Y-up world in Blender's Z-up one.
_Y_TO_Z = Matrix(((1, 0, 0), (0, 0, -1), (0, 1, 0)))

#: Components w, x, y, z of the product of the conjugate of (a, b, c, d) and (e, f, g, h).
_PRODUCT = ("a*e+b*f+c*g+d*h", "a*f-b*e-c*h+d*g", "a*g+b*h-c*e-d*f", "a*h-b*g+c*f-d*e")


@dataclass(frozen=True)
class _Joint:
    owner: bpy.types.Object
    bone: str
    """Name of a bone of the owner; the owner itself where it is empty."""
    rest: Quaternion
    frame: Quaternion | None
    """From the frame of the glTF joint to Blender's, both at rest; None where it is not known."""


def can_measure(wrinkles, driver):
    """Whether the joints of a `bone` driver are there, and its axis is known in their frame."""
    joints = _joints(wrinkles, driver["joints"])
    return joints is not None and ("axis" not in driver or joints[1].frame is not None)


def _joints(wrinkles, names):
    """Two joints by name; None where they are neither bones of the face's armature nor imported nodes."""
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


def with_joints_measured(steps, wrinkles):
    """The steps, and before each that reads a joint those that measure it."""
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
    """Let a driver of Blender read a component of a joint's rotation, or the distance of two joints."""
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


def remember_frames(armature, rest_of):
    """
    Keep on each bone how the frame of its glTF joint lies in it, for the axes of drivers.

    `rest_of`: rotation of a joint at rest in the space of the skin, a 3 x 3 matrix, by the bone's name; None where it
    is no joint.
    """
    for bone in armature.data.bones:
        rest = rest_of(bone.name)
        if rest is not None:
            own = bone.matrix_local.to_3x3().inverted()
            bone[FRAME] = tuple((own @ _Y_TO_Z @ rest).to_quaternion())


def remember_nodes(wrinkles, names, objects):
    """Keep with a set which objects the joints of its drivers became, and how these stand in the world now, at rest."""
    for name in names:
        if name in objects:
            joint = wrinkles.joints.add()
            joint.name, joint.object = name, objects[name]
            joint.rest = _world(objects[name]).to_quaternion()


def _world(item):
    """Where an object stands. Blender itself knows only after the import."""
    parent = _world(item.parent) @ item.matrix_parent_inverse if item.parent else Matrix()
    return parent @ item.matrix_basis


def armature_of(face):
    """The armature that deforms a face; None where there is none."""
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
        # A quaternion and its negative are the same rotation.
        angle = f"2*atan2((b*({x:.7f})+c*({y:.7f})+d*({z:.7f}))*(1 if a>0 else -1),abs(a))"
    return [*steps, Step(name, "SCRIPTED", turned, angle)]
