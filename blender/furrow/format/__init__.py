"""Reads and writes FURROW_wrinkle_maps in glTF files, and plans drivers. Does not import bpy."""
