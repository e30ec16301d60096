"""
The extension FURROW_wrinkle_maps without Blender: its JSON, its files, and its drivers as many small ones. Imports no
bpy.
"""
