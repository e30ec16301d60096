"""
Drivers of type `time`. Blender's drivers have no memory of earlier frames, so a handler runs after each frame change.

The handler stores, for each delayed area, the difference between the delayed and the current activation in a property
of the node group (`LATE`). A driver adds this difference to the activation (`rig.py`). Blender evaluates that driver
again before it draws or renders. Without the extension, or while the frame stays the same, there are no delays.
"""

import math

import bpy
from bpy.app.handlers import persistent

from .format.plan import activation_name
from .rig import LATE, STEPS

#: By node group: time of the last frame in seconds, and delayed activations by area.
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
            # Going back by a frame or more resets delays. Motion blur goes back by parts of a frame.
            value = shown.get(delay.area, target) if seconds > -1 / rate else target
            if seconds > 0:
                constant = delay.attack if target > value else delay.release
                value = target + (value - target) * math.exp(-seconds / constant) if constant > 0 else target
            shown[delay.area] = value
            _set_late(tree, delay.area, value - target)
        _last[tree.session_uid] = (now if seconds > 0 or seconds <= -1 / rate else before, shown)


@persistent
def clear_delays(*_):
    """Clear delays before saving. In a Blender without the extension, nothing would ever end them."""
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
