"""
Builds the Blender drivers of a wrinkle group.

Each step of the plan (`format/plan.py`) is a custom property with a driver. The properties belong to a node named
"Steps": `nodes["Steps"]["d0l1"]` is the second link of the first driver, and `nodes["Steps"]["a3"]` is the activation
of the fourth area. Inputs of shader nodes have drivers that read the activations. Custom properties of the group store
other numbers: `["rest3"]` is the resting activation of the fourth area, and `["late3"]` is the difference between its
delayed and undelayed activation (`delays.py`).

Steps must not be properties of the group. Before Blender evaluates drivers of nodes, another thread reads and writes
back all driven properties of the group (`BKE_animsys_eval_driver_unshare`). In Blender 4.5 and 5.0, this reverts
computed steps about once in fifty changes of a shape key.
"""

import json

import bpy

from .format.plan import plan_drivers, shown_name
from .joints import can_measure, expand_joints, read_joint

STEPS = "Steps"

#: Name prefix of custom properties, followed by the index of an area. Each property is the difference between the
#: area's delayed and undelayed activation.
LATE = "late"

#: Key frames of a driver that multiplies by 1. They are extrapolated linearly.
_UNIT = ((0, 0), (1, 1))


def build_drivers(tree, activations):
    """
    Replace all drivers of a group by those of its wrinkle set.

    `activations`: result of `build_nodes`. Returns the plan.
    """
    _clear(tree)
    wrinkles = tree.furrow
    face = wrinkles.face
    mesh = face.data if face and face.type == "MESH" else None
    keys = mesh.shape_keys if mesh else None
    targets = [block.name for block in keys.key_blocks if block != keys.reference_key] if keys else []
    areas = [area.name for area in wrinkles.areas]
    drivers = [json.loads(driver.json) for driver in wrinkles.drivers]
    plan = plan_drivers(drivers, areas, targets, lambda driver: can_measure(wrinkles, driver))
    _declare_inputs(wrinkles, plan.inputs)
    for area in wrinkles.areas:
        # The setter creates the custom property that drivers read.
        area.activation = area.activation
    _declare_delays(tree, plan.delays)
    steps = expand_joints(plan.steps, wrinkles)
    node = tree.nodes.new("NodeFrame")
    node.name = node.label = STEPS
    for step in steps:
        node[step.name] = 0.0
    for step in steps:
        curve = tree.driver_add(_path(step.name))
        _set_up(curve, step.combine, step.expression)
        for source, name in zip(step.sources, "abcdefgh" if step.expression else _names(step), strict=False):
            _read(curve.driver, name, source, tree, keys)
        _shape(curve, step)
    for area, (name, index) in activations.items():
        curve = tree.nodes[name].inputs[index].driver_add("default_value")
        _set_up(curve, "SUM")
        _variable(curve.driver, "a", "NODETREE", tree, _path(shown_name(area, plan.delays)))
        _key(curve, (), "CONSTANT")
    tree.update_tag()
    return plan


def activation_of(tree, area):
    """Return the current activation of an area. `area`: index."""
    steps = tree.nodes.get(STEPS)
    return steps.get(_shown(tree, area), 0.0) if steps else 0.0


def show_preview(tree):
    """If `preview` is set, show only the active area, with activation 1, and mute the drivers of shader nodes."""
    if tree.animation_data is None:
        return
    wrinkles = tree.furrow
    chosen = _path(_shown(tree, wrinkles.active_area))
    for curve in tree.animation_data.drivers:
        if not curve.data_path.endswith(".default_value"):
            continue
        curve.mute = wrinkles.preview
        if wrinkles.preview:
            owner = tree.path_resolve(curve.data_path.rsplit(".", 1)[0])
            path = curve.driver.variables[0].targets[0].data_path
            owner.default_value = 1.0 if path == chosen else 0.0
    tree.update_tag()


def _shown(tree, area):
    return shown_name(area, {delay.area for delay in tree.furrow.delays})


def _clear(tree):
    if tree.animation_data:
        for curve in list(tree.animation_data.drivers):
            tree.animation_data.drivers.remove(curve)


def _path(step):
    return f'nodes["{STEPS}"]["{step}"]'


def _names(step):
    return [f"v{i}" for i in range(len(step.sources))]


def _set_up(curve, kind, expression=""):
    curve.driver.type = kind
    if expression:
        curve.driver.expression = expression


def _shape(curve, step):
    if step.slope is not None:
        _key(curve, [(x, y * step.slope) for x, y in _UNIT], "LINEAR")
    else:
        _key(curve, step.curve or (), "CONSTANT")


def _key(curve, points, extrapolation):
    """
    Set the key frames of a driver's F-curve, which map the value of the driver.

    `points`: (input, output). Without points, the value is not changed.
    """
    for modifier in list(curve.modifiers):
        curve.modifiers.remove(modifier)
    curve.keyframe_points.clear()
    curve.keyframe_points.add(len(points))
    for key, (x, y) in zip(curve.keyframe_points, points, strict=True):
        key.co = (x, y)
        key.interpolation = "LINEAR"
    curve.extrapolation = extrapolation
    curve.update()


def _read(driver, name, source, tree, keys):
    if source.kind == "target":
        block = bpy.utils.escape_identifier(source.name)
        _variable(driver, name, "KEY", keys, f'key_blocks["{block}"].value')
    elif source.kind == "step":
        _variable(driver, name, "NODETREE", tree, _path(source.name))
    elif source.kind == "rest":
        _variable(driver, name, "NODETREE", tree, f'["rest{source.name}"]')
    elif source.kind == "late":
        _variable(driver, name, "NODETREE", tree, f'["{LATE}{source.name}"]')
    elif source.kind == "input":
        index = tree.furrow.inputs.find(source.name)
        _variable(driver, name, "NODETREE", tree, f'["input{index}"]')
    else:
        read_joint(driver, source.name).name = name


def _variable(driver, name, id_type, owner, path):
    variable = driver.variables.new()
    variable.name = name
    target = variable.targets[0]
    target.id_type = id_type
    target.id = owner
    target.data_path = path


def _declare_inputs(wrinkles, inputs):
    """Store the list of inputs in the wrinkle set. Existing inputs keep their values."""
    values = {item.name: item.value for item in wrinkles.inputs}
    wrinkles.inputs.clear()
    for name, initial in inputs.items():
        item = wrinkles.inputs.add()
        item.name = name
        item.value = values.get(name, initial)


def _declare_delays(tree, delays):
    """Store the delayed areas in the wrinkle set. Their delayed activations start equal to the undelayed ones."""
    tree.furrow.delays.clear()
    for area, (attack, release) in delays.items():
        item = tree.furrow.delays.add()
        item.area, item.attack, item.release = area, attack, release
        tree[f"{LATE}{area}"] = 0.0
