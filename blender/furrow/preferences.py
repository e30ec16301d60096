"""Defines the preferences of the extension."""

import bpy


class FurrowPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    command: bpy.props.StringProperty(
        name="furrow",
        subtype="FILE_PATH",
        description="Path of the command that makes automatic wrinkles. If empty, the command is searched on PATH",
    )

    def draw(self, _context):
        self.layout.prop(self, "command")
        self.layout.label(text="Install it with Node.js: npm install --global furrow-cli")


def preferred_command(context):
    """Return the path of the command `furrow` from the preferences, or an empty string."""
    addon = context.preferences.addons.get(__package__)
    return addon.preferences.command if addon and addon.preferences else ""


def register():
    bpy.utils.register_class(FurrowPreferences)


def unregister():
    bpy.utils.unregister_class(FurrowPreferences)
