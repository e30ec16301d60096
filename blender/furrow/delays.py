"""
Drivers of type `time`. A driver of Blender remembers no earlier frame; a handler does, after each change of the frame.

It writes how far the activation of each delayed area is behind what its drivers say into a property of the node group
(`LATE`), which a step adds (`rig.py`). Blender then evaluates once more what reads it, before it draws or renders.
Without the extension, and while the frame stands still, skin moves without delay.
"""

import math

import bpy
from bpy.app.handlers import persistent

from .format.plan import activation_name
from .rig import LATE, STEPS

#: Of each node group: the time of its last frame in seconds, and the activations that were shown, by area.
_last = {}


@persistent
def follow(scene, depsgraph):
    """Let delayed activations follow their drivers for the time since the frame before."""
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
            # Backwards, skin is as its drivers say. Motion blur goes back too, by parts of a frame.
            value = shown.get(delay.area, target) if seconds > -1 / rate else target
            if seconds > 0:
                constant = delay.attack if target > value else delay.release
                value = target + (value - target) * math.exp(-seconds / constant) if constant > 0 else target
            shown[delay.area] = value
            _set_late(tree, delay.area, value - target)
        _last[tree.session_uid] = (now if seconds > 0 or seconds <= -1 / rate else before, shown)


@persistent
def rest(*_):
    """Before a file is saved: nothing would end a delay where the extension is not installed."""
    for tree in bpy.data.node_groups:
        for delay in tree.furrow.delays:
            _set_late(tree, delay.area, 0.0)


def _set_late(tree, area, value):
    name = f"{LATE}{area}"
    if tree.get(name) != value:
        tree[name] = value
        tree.update_tag()


def register():
    bpy.app.handlers.frame_change_post.append(follow)
    bpy.app.handlers.save_pre.append(rest)


def unregister():
    bpy.app.handlers.save_pre.remove(rest)
    bpy.app.handlers.frame_change_post.remove(follow)
