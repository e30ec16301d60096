"""Builds node trees by formulas. Each function takes sockets or numbers, adds a node, and returns its output socket."""

import bpy


class Graph:
    """Adds nodes to a tree, placed to the right of their inputs."""

    def __init__(self, tree):
        self.tree = tree
        self.columns = {}
        self.rows = {}

    def node(self, kind, inputs=(), label="", **settings):
        """Add a node, e.g. "ShaderNodeMath", with inputs linked or set by index. Returns the node."""
        node = self.tree.nodes.new(kind)
        node.label = label
        for name, value in settings.items():
            setattr(node, name, value)
        column = 0
        for index, value in dict(inputs if isinstance(inputs, dict) else enumerate(inputs)).items():
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, node.inputs[index])
                column = max(column, self.columns.get(value.node.name, 0) + 1)
            elif value is not None:
                node.inputs[index].default_value = value
        row = self.rows.get(column, 0)
        self.rows[column] = row + 1
        self.columns[node.name] = column
        node.location = (200 * column, -190 * row)
        return node

    def math(self, operation, *inputs, clamp=False, label=""):
        """Compute a number by ShaderNodeMath."""
        return self.node("ShaderNodeMath", inputs, label, operation=operation, use_clamp=clamp).outputs[0]

    def vector(self, operation, *inputs, label=""):
        """Compute a vector by ShaderNodeVectorMath, or a number for DOT_PRODUCT and LENGTH."""
        node = self.node("ShaderNodeVectorMath", [], label, operation=operation)
        column = 0
        for index, value in enumerate(inputs):
            # SCALE has its factor in the fourth input.
            socket = node.inputs[3 if operation == "SCALE" and index == 1 else index]
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, socket)
                column = max(column, self.columns.get(value.node.name, 0) + 1)
            else:
                socket.default_value = value
        self.columns[node.name] = column
        return node.outputs["Value" if operation in ("DOT_PRODUCT", "LENGTH") else "Vector"]

    def combine(self, x, y, z, label=""):
        """Combine three numbers to a vector."""
        return self.node("ShaderNodeCombineXYZ", (x, y, z), label).outputs[0]

    def separate(self, vector):
        """Separate a vector into three numbers."""
        return self.node("ShaderNodeSeparateXYZ", (vector,)).outputs

    def texture(self, image, uv, label, extension="REPEAT"):
        """Sample an image. Returns colour and alpha."""
        node = self.node("ShaderNodeTexImage", (uv,), label, image=image, extension=extension)
        return node.outputs

    def total(self, values, operation="ADD"):
        """Combine numbers by addition or another operation. Returns 0 for no values."""
        values = list(values)
        if not values:
            return 0.0
        result = values[0]
        for value in values[1:]:
            result = self.math(operation, result, value)
        return result
