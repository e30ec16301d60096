"""Adds shader nodes to a node tree, with one short call for each node."""

import bpy


class Graph:
    """
    Adds nodes to a tree. Each node is placed to the right of the nodes that it reads. Nodes of `vector` are an
    exception: they are placed in the first column.

    Methods take constants, or output sockets of other nodes, as inputs. All methods except `node` return output sockets
    of the new node.
    """

    def __init__(self, tree):
        self.tree = tree
        self.columns = {}
        self.rows = {}

    def node(self, kind, inputs=(), label="", **settings):
        """
        Add a node and return it.

        `kind`: type of the node, such as "ShaderNodeMath". `inputs`: sockets to link or constants to set, as a list or
        as a dict by index. `settings`: properties of the node.
        """
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
        """Compute a number with ShaderNodeMath."""
        return self.node("ShaderNodeMath", inputs, label, operation=operation, use_clamp=clamp).outputs[0]

    def vector(self, operation, *inputs, label=""):
        """Compute a vector with ShaderNodeVectorMath. DOT_PRODUCT and LENGTH compute a number."""
        node = self.node("ShaderNodeVectorMath", [], label, operation=operation)
        column = 0
        for index, value in enumerate(inputs):
            # The factor of SCALE is the node's fourth input.
            socket = node.inputs[3 if operation == "SCALE" and index == 1 else index]
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, socket)
                column = max(column, self.columns.get(value.node.name, 0) + 1)
            else:
                socket.default_value = value
        self.columns[node.name] = column
        return node.outputs["Value" if operation in ("DOT_PRODUCT", "LENGTH") else "Vector"]

    def combine(self, x, y, z, label=""):
        return self.node("ShaderNodeCombineXYZ", (x, y, z), label).outputs[0]

    def separate(self, vector):
        return self.node("ShaderNodeSeparateXYZ", (vector,)).outputs

    def texture(self, image, uv, label, extension="REPEAT"):
        """Sample an image. Returns the sockets of colour and alpha."""
        node = self.node("ShaderNodeTexImage", (uv,), label, image=image, extension=extension)
        return node.outputs

    def total(self, values, operation="ADD"):
        """Combine any number of values by addition or another operation. Returns 0 without values."""
        values = list(values)
        if not values:
            return 0.0
        result = values[0]
        for value in values[1:]:
            result = self.math(operation, result, value)
        return result
