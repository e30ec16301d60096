"""
Delays the activations of areas that have a driver of type `time`.

Blender's drivers have no memory of earlier frames, so a handler runs whenever the frame changes. For each delayed
area, it computes the difference between the delayed and the undelayed activation. It stores the difference in the node
group, in a custom property whose name begins with `LATE`. A driver in `rig.py` adds this difference to the activation.
Blender evaluates the driver before it draws or renders. A Blender without this extension does not delay activations.
"""

import math

import bpy
from bpy.app.handlers import persistent

from .format.plan import activation_name
from .rig import LATE, STEPS

#: For each node group: the time of the last frame in seconds, and delayed activations by area index.
_last = {}


@persistent
def update_delays(scene, depsgraph):
    """Advance delayed activations by the time since the last frame."""
    rate = scene.render.fps / scene.render.fps_base
    now = scene.frame_current_final / rate
    for tree in bpy.data.node_groups:
        delays = tree.furrow.delays
        steps = tree.evaluated_get(depsgraph).nodes.get(STEPS) if delays else None
        if steps is None:
            continue
        before, shown = _last.get(tree.session_uid, (math.inf, {}))
        seconds = now - before
        for delay in delays:
            target = steps[activation_name(delay.area)]
            # A jump back by one frame or more ends the delay. Motion blur jumps back by less, and must not end it.
            value = shown.get(delay.area, target) if seconds > -1 / rate else target
            if seconds > 0:
                constant = delay.attack if target > value else delay.release
                value = target + (value - target) * math.exp(-seconds / constant) if constant > 0 else target
            shown[delay.area] = value
            _set_late(tree, delay.area, value - target)
        _last[tree.session_uid] = (now if seconds > 0 or seconds <= -1 / rate else before, shown)


@persistent
def clear_delays(*_):
    """Clear the differences before a file is saved, because a Blender without the extension would not update them."""
    for tree in bpy.data.node_groups:
        for delay in tree.furrow.delays:
            _set_late(tree, delay.area, 0.0)


def _set_late(tree, area, value):
    name = f"{LATE}{area}"
    if tree.get(name) != value:
        tree[name] = value
        tree.update_tag()


def register():
    bpy.app.handlers.frame_change_post.append(update_delays)
    bpy.app.handlers.save_pre.append(clear_delays)


def unregister():
    bpy.app.handlers.save_pre.remove(clear_delays)
    bpy.app.handlers.frame_change_post.remove(update_delays)
