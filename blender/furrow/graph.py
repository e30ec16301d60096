"""Nodes of a group, written as formulas: sockets and plain numbers go in, sockets come out."""

import bpy


class Graph:
    """Adds nodes to a tree. Columns follow from what a node reads, so that the group can be read from left to right."""

    def __init__(self, tree):
        self.tree = tree
        self.columns = {}
        self.rows = {}

    def node(self, kind, inputs=(), label="", **settings):
        """A node of a type, e.g. "ShaderNodeMath", its inputs linked or set by index; the node."""
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
        """A number by ShaderNodeMath."""
        return self.node("ShaderNodeMath", inputs, label, operation=operation, use_clamp=clamp).outputs[0]

    def vector(self, operation, *inputs, label=""):
        """A vector by ShaderNodeVectorMath, or a number where the operation gives one."""
        node = self.node("ShaderNodeVectorMath", [], label, operation=operation)
        column = 0
        for index, value in enumerate(inputs):
            # SCALE reads its factor from the fourth input.
            socket = node.inputs[3 if operation == "SCALE" and index == 1 else index]
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, socket)
                column = max(column, self.columns.get(value.node.name, 0) + 1)
            else:
                socket.default_value = value
        self.columns[node.name] = column
        return node.outputs["Value" if operation in ("DOT_PRODUCT", "LENGTH") else "Vector"]

    def combine(self, x, y, z, label=""):
        """Three numbers as a vector."""
        return self.node("ShaderNodeCombineXYZ", (x, y, z), label).outputs[0]

    def separate(self, vector):
        """A vector as three numbers."""
        return self.node("ShaderNodeSeparateXYZ", (vector,)).outputs

    def texture(self, image, uv, label, extension="REPEAT"):
        """Colour and alpha of an image at texture coordinates."""
        node = self.node("ShaderNodeTexImage", (uv,), label, image=image, extension=extension)
        return node.outputs

    def total(self, values, operation="ADD", none=0.0):
        """All numbers added up, or the largest of them; a plain number where there are none."""
        values = list(values)
        if not values:
            return none
        result = values[0]
        for value in values[1:]:
            result = self.math(operation, result, value)
        return result
