"""
Inserts wrinkle groups into materials, and detaches them during exports.

A wrinkle group is a node group between the textures and the shader. It mixes wrinkles into the values of the textures.
"""

#: Custom property that marks the node of a detached group.
_DETACHED = "furrow_out"


def group_node(material):
    """Return the node of a material that holds its wrinkle group, or None."""
    if material is None or material.node_tree is None:
        return None
    for node in material.node_tree.nodes:
        if node.type == "GROUP" and node.node_tree and node.node_tree.furrow.is_wrinkles:
            return node
    return None


def wrinkle_group(material):
    """Return a material's wrinkle group, or None."""
    node = group_node(material)
    return node.node_tree if node else None


def insert_group(material, group):
    """
    Insert a wrinkle group into a material, and link the group's sockets to the textures and the shader.

    If the material already has a wrinkle group, links the sockets of that group instead. Outputs that are already
    linked stay as they are. Returns the group's node. Raises LookupError if the material has no Principled BSDF.
    """
    tree = material.node_tree
    shader = shader_node(tree)
    node = group_node(material)
    if node is None:
        node = tree.nodes.new("ShaderNodeGroup")
        node.name = node.label = "Wrinkles"
        node.node_tree = group
        node.width = 180
        node.location = (shader.location.x - 260, shader.location.y + 260)
    _link(tree, node, "Base Color", shader.inputs["Base Color"])
    _link(tree, node, "Roughness", shader.inputs["Roughness"])
    _link_normal(tree, node, shader)
    return node


def detach_group(material):
    """Restore the material without wrinkles. The node of the group stays, but is muted and has no linked outputs."""
    node = group_node(material)
    tree = material.node_tree
    for output in node.outputs:
        source = node.inputs[output.name]
        before = source.links[0].from_socket if source.links else None
        for target in [link.to_socket for link in output.links]:
            _replace(tree, before, target)
    normal_map = tree.nodes.get(node.get("normal_map", ""))
    if normal_map:
        normal_map.inputs["Strength"].default_value = node.inputs["Normal Scale"].default_value
        if node.get("made_normal_map"):
            tree.nodes.remove(normal_map)
    uv = tree.nodes.get(node.get("made_uv", ""))
    if uv:
        tree.nodes.remove(uv)
    node.mute = True
    node[_DETACHED] = True


def reattach_group(material):
    """Undo `detach_group`. Does nothing if the material no longer has a Principled BSDF."""
    node = group_node(material)
    if node is None or _DETACHED not in node or not _shaders(material.node_tree):
        return
    for key in (_DETACHED, "normal_map", "made_normal_map", "made_uv"):
        if key in node:
            del node[key]
    node.mute = False
    for link in [link for socket in node.inputs for link in socket.links]:
        material.node_tree.links.remove(link)
    insert_group(material, node.node_tree)


def shader_node(tree):
    """Return the Principled BSDF with linked outputs, or the first one. Raises LookupError if there is none."""
    nodes = _shaders(tree)
    if not nodes:
        raise LookupError("the material has no Principled BSDF")
    return next((node for node in nodes if any(output.is_linked for output in node.outputs)), nodes[0])


def _shaders(tree):
    return [node for node in tree.nodes if node.type == "BSDF_PRINCIPLED"]


def _link(tree, node, name, target):
    """
    Insert the group between a texture and the socket that reads the texture.

    `name`: name of a group input. The group output with the same name adds wrinkles to this value.
    `target`: the shader's socket, to which the texture is linked directly or through other nodes.
    """
    if name not in node.inputs:
        return
    if node.outputs[name].is_linked:
        return
    found = _find_texture(target)
    if found is None:
        factor = target.default_value
        node.inputs[f"{name} Factor"].default_value = factor if isinstance(factor, float) else tuple(factor)
        tree.links.new(node.outputs[name], target)
        return
    source, targets = found
    tree.links.new(source, node.inputs[name])
    for socket in targets:
        tree.links.new(node.outputs[name], socket)


def _find_texture(target):
    """
    Find the texture, or the separated channel of a texture, on which `target` depends.

    Returns the output socket of the texture or channel, and a list with the input socket that reads it. This input is
    `target`, or belongs to a node between texture and `target`. Without a texture, returns the socket linked to
    `target`, and `[target]`. Returns None if `target` is not linked.
    """
    if not target.links:
        return None
    link = target.links[0]
    node = link.from_node
    if node.type != "TEX_IMAGE" and not (node.type == "SEPARATE_COLOR" and node.inputs[0].is_linked):
        for socket in node.inputs:
            found = _find_texture(socket) if socket.type in ("RGBA", "VALUE") else None
            if found and found[0].node.type in ("TEX_IMAGE", "SEPARATE_COLOR"):
                return found
    return link.from_socket, [target]


def _link_normal(tree, node, shader):
    """Insert the group between the normal texture and the Normal Map node. Creates the Normal Map node if missing."""
    target = shader.inputs["Normal"]
    normal_map = target.links[0].from_node if target.links else None
    if normal_map is None or normal_map.type != "NORMAL_MAP":
        if target.links:
            # Wrinkles mix only with a normal texture. Another node, such as Bump, stays, and normals get no wrinkles.
            return
        normal_map = tree.nodes.new("ShaderNodeNormalMap")
        normal_map.location = (node.location.x, node.location.y - 320)
        tree.links.new(normal_map.outputs[0], target)
        node["made_normal_map"] = True
    color = normal_map.inputs["Color"]
    if not node.outputs["Normal"].is_linked:
        node["normal_map"] = normal_map.name
        node.inputs["Normal Scale"].default_value = normal_map.inputs["Strength"].default_value
        normal_map.inputs["Strength"].default_value = 1
        source = color.links[0].from_socket if color.links else None
        if source:
            tree.links.new(source, node.inputs["Normal"])
        tree.links.new(node.outputs["Normal"], color)
    if not node.inputs["UV"].is_linked:
        tree.links.new(_coordinates(tree, node, normal_map), node.inputs["UV"])


def _coordinates(tree, node, normal_map):
    """
    Return the socket with the texture coordinates of the normal texture.

    If the texture has none, adds a node with the UV map of the Normal Map node.
    """
    source = node.inputs["Normal"].links[0].from_node if node.inputs["Normal"].links else None
    if source and source.type == "TEX_IMAGE" and source.inputs["Vector"].is_linked:
        return source.inputs["Vector"].links[0].from_socket
    uv = tree.nodes.new("ShaderNodeUVMap")
    uv.uv_map = normal_map.uv_map
    uv.location = (node.location.x - 220, node.location.y - 200)
    node["made_uv"] = uv.name
    return uv.outputs[0]


def _replace(tree, source, target):
    for link in list(target.links):
        tree.links.remove(link)
    if source:
        tree.links.new(source, target)
