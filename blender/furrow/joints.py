"""
Drivers of type `bone`: the rotation of a pose bone from rest relative to another, or the distance of the two.

Blender's own variable for two bones measures the angle between them, not from rest, and has no sign. The relative
rotation is made of quaternions instead, one small driver for each component.
"""

from mathutils import Matrix, Quaternion, Vector

from .format.plan import Source, Step

#: Custom property of a bone: the rotation from the frame of its glTF joint to its own, both at rest.
FRAME = "furrow_frame"

#: glTF's Y-up world in Blender's Z-up one.
_Y_TO_Z = Matrix(((1, 0, 0), (0, 0, -1), (0, 1, 0)))

#: Components w, x, y, z of the product of the conjugate of (a, b, c, d) and (e, f, g, h).
_PRODUCT = ("a*e+b*f+c*g+d*h", "a*f-b*e-c*h+d*g", "a*g+b*h-c*e-d*f", "a*h-b*g+c*f-d*e")


def can_measure(face, driver):
    """Whether the joints of a `bone` driver are bones of the face's armature, and its axis is known in their frame."""
    armature = armature_of(face)
    if armature is None:
        return False
    bones = [armature.data.bones.get(name) for name in driver["joints"]]
    return all(bones) and ("axis" not in driver or FRAME in bones[1])


def with_joints_measured(steps, face):
    """The steps, and before each that reads a joint those that measure it."""
    out = []
    for step in steps:
        sources = []
        for source in step.sources:
            if source.kind == "joint":
                out.extend(_measure(f"{step.name}j", armature_of(face), *source.name))
                source = Source("step", f"{step.name}j")
            sources.append(source)
        out.append(Step(step.name, step.combine, sources, step.expression, step.curve, step.slope))
    return out


def read_bone(driver, armature, name):
    """Let a driver of Blender read a component of a bone's rotation, or the distance of two bones."""
    variable = driver.variables.new()
    if len(name) == 3:
        variable.type = "LOC_DIFF"
        for target, bone in zip(variable.targets, name[1:], strict=True):
            target.id = armature
            target.bone_target = bone
        return variable
    component, bone = name
    variable.type = "TRANSFORMS"
    target = variable.targets[0]
    target.id = armature
    target.bone_target = bone
    target.transform_space = "WORLD_SPACE"
    target.rotation_mode = "QUATERNION"
    target.transform_type = f"ROT_{component.upper()}"
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


def armature_of(face):
    """The armature that deforms a face; None where there is none."""
    return face.find_armature() if face else None


def _measure(name, armature, origin, joint, kind, axis):
    if kind == "distance":
        return [Step(name, "SUM", [Source("bone", ("distance", origin, joint))])]
    both = [Source("bone", (component, bone)) for bone in (origin, joint) for component in "wxyz"]
    relative = [Step(f"{name}r{i}", "SCRIPTED", both, _PRODUCT[i]) for i in range(4)]
    rests = [armature.data.bones[bone].matrix_local.to_3x3() for bone in (origin, joint)]
    rest = (rests[0].inverted() @ rests[1]).to_quaternion()
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
        x, y, z = (Quaternion(armature.data.bones[joint][FRAME]) @ Vector(axis)).normalized()
        # A quaternion and its negative are the same rotation.
        angle = f"2*atan2((b*({x:.7f})+c*({y:.7f})+d*({z:.7f}))*(1 if a>0 else -1),abs(a))"
    return [*steps, Step(name, "SCRIPTED", turned, angle)]
