"""
Where a wrinkle group stands in a material: between its textures and what they feed. It comes out for an export, and
goes back in.
"""

#: Custom property of a group's node that is out of its material.
_OUT = "furrow_out"


def group_node(material):
    """The node of a material's wrinkle group; None where it has none."""
    if material is None or material.node_tree is None:
        return None
    for node in material.node_tree.nodes:
        if node.type == "GROUP" and node.node_tree and node.node_tree.furrow.is_wrinkles:
            return node
    return None


def wrinkle_group(material):
    """The wrinkle group of a material; None where it has none."""
    node = group_node(material)
    return node.node_tree if node else None


def put_in(material, group):
    """
    Put the group into the material, where it is not there yet, and link what its sockets need. Existing links stay.
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


def take_out(material):
    """Restore the material as it was without wrinkles; the group's node stays, muted and without outputs."""
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
    node[_OUT] = True


def put_back(material):
    """Undo `take_out`; a material that has no Principled BSDF any more is left without."""
    node = group_node(material)
    if node is None or _OUT not in node or not _shaders(material.node_tree):
        return
    for key in (_OUT, "normal_map", "made_normal_map", "made_uv"):
        if key in node:
            del node[key]
    node.mute = False
    for link in [link for socket in node.inputs for link in socket.links]:
        material.node_tree.links.remove(link)
    put_in(material, node.node_tree)


def shader_node(tree):
    """The Principled BSDF that the output shows, else the first there is. Raises LookupError."""
    nodes = _shaders(tree)
    if not nodes:
        raise LookupError("the material has no Principled BSDF")
    return next((node for node in nodes if any(output.is_linked for output in node.outputs)), nodes[0])


def _shaders(tree):
    return [node for node in tree.nodes if node.type == "BSDF_PRINCIPLED"]


def _link(tree, node, name, target):
    """Put a pair of sockets of the group before a shader's socket, directly behind the texture that feeds it."""
    if name not in node.inputs:
        return
    if node.outputs[name].is_linked:
        return
    found = _behind_texture(target)
    if found is None:
        factor = target.default_value
        node.inputs[f"{name} Factor"].default_value = factor if isinstance(factor, float) else tuple(factor)
        tree.links.new(node.outputs[name], target)
        return
    source, targets = found
    tree.links.new(source, node.inputs[name])
    for socket in targets:
        tree.links.new(node.outputs[name], socket)


def _behind_texture(target):
    """
    The socket of a texture (or of its separated channel) from which a shader's socket is fed, and the sockets it goes
    to.
    """
    if not target.links:
        return None
    link = target.links[0]
    node = link.from_node
    if node.type != "TEX_IMAGE" and not (node.type == "SEPARATE_COLOR" and node.inputs[0].is_linked):
        for socket in node.inputs:
            found = _behind_texture(socket) if socket.type in ("RGBA", "VALUE") else None
            if found and found[0].node.type in ("TEX_IMAGE", "SEPARATE_COLOR"):
                return found
    return link.from_socket, [target]


def _link_normal(tree, node, shader):
    """The group stands between the normal texture and the Normal Map node; where there is none, one is made."""
    target = shader.inputs["Normal"]
    normal_map = target.links[0].from_node if target.links else None
    if normal_map is None or normal_map.type != "NORMAL_MAP":
        if target.links:
            # A bump, say: shown and exported by Blender; it takes no part in the mix.
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
    """What the normal texture is looked up by; else the texture coordinates that the mesh is rendered with."""
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
