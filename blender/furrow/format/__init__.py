"""FURROW_wrinkle_maps without Blender: JSON, files and the plan of small drivers. Does not import bpy."""
