"""
Builds the shader nodes of a wrinkle group (formulas: docs/FURROW_wrinkle_maps.md, "Mixing").

The nodes compute the influence of each layer from the weights and activations of its areas. Onset maps delay the
influence. The nodes then mix normals, base colour, roughness and blood by these influences, before lighting. The inputs
of the group are the material's values without wrinkles, and the outputs are the values with wrinkles. Normals are
colours in tangent space. The Normal Map node of the material decodes them.
"""

from .graph import Graph

#: Optical depth of one unit of blood for red, green and blue light.
BLOOD_ABSORPTION = (0.35, 1.0, 0.89)

#: Sockets of the group: type, default value, and kinds of maps. The group has a socket if a layer has a map of one of
#: these kinds. A socket without kinds is always present.
SOCKETS = {
    "Base Color": ("NodeSocketColor", (1, 1, 1, 1), ("base_color", "blood")),
    "Roughness": ("NodeSocketFloat", 1.0, ("roughness",)),
    "Normal": ("NodeSocketColor", (0.5, 0.5, 1, 1), ()),
}
FACTORS = {"Base Color Factor": "Base Color", "Roughness Factor": "Roughness"}


def build_nodes(tree):
    """
    Build the nodes of a wrinkle group.

    Returns, by area index, the node input that takes the area's activation: a pair (node name, input index).
    """
    wrinkles = tree.furrow
    _declare(tree, [name for name, (_, _, maps) in SOCKETS.items() if not maps or _has(wrinkles, maps)])
    tree.nodes.clear()
    graph = Graph(tree)
    inputs = graph.node("NodeGroupInput").outputs
    activations = {}
    tile = graph.vector("FRACTION", inputs["UV"], label="repeat")
    images = _area_images(graph, wrinkles, tile)
    influences = [
        _delayed(graph, layer, _influence(graph, wrinkles, index, images, activations), inputs["UV"])
        for index, layer in enumerate(wrinkles.layers)
    ]
    outputs = graph.node("NodeGroupOutput")
    normal = _mixed_normal(graph, wrinkles, influences, inputs)
    tree.links.new(normal, outputs.inputs["Normal"])
    if "Base Color" in outputs.inputs:
        tree.links.new(_mixed_color(graph, wrinkles, influences, inputs), outputs.inputs["Base Color"])
    if "Roughness" in outputs.inputs:
        rough = [
            (graph.separate(graph.texture(layer.roughness, inputs["UV"], layer.name)[0])[1], influence)
            for layer, influence in zip(wrinkles.layers, influences, strict=True)
            if layer.roughness
        ]
        mixed = _mixed_number(graph, inputs["Roughness"], rough)
        factor = graph.math("MULTIPLY", mixed, inputs["Roughness Factor"])
        tree.links.new(factor, outputs.inputs["Roughness"])
    outputs.location.x = 200 * (max(graph.columns.values()) + 1)
    return activations


def _has(wrinkles, maps):
    return any(getattr(layer, name) for layer in wrinkles.layers for name in maps)


def _declare(tree, names):
    """Create the missing sockets of the group and remove unneeded ones. The others keep their links and values."""
    sockets = {(name, "OUTPUT"): SOCKETS[name] for name in names}
    sockets |= {(name, "INPUT"): SOCKETS[name] for name in names}
    sockets |= {(factor, "INPUT"): SOCKETS[name] for factor, name in FACTORS.items() if name in names}
    sockets[("Normal Scale", "INPUT")] = ("NodeSocketFloat", 1.0, ())
    sockets[("UV", "INPUT")] = ("NodeSocketVector", (0, 0, 0), ())
    for item in list(tree.interface.items_tree):
        if (item.name, item.in_out) not in sockets:
            tree.interface.remove(item)
    existing = {(item.name, item.in_out) for item in tree.interface.items_tree}
    for (name, in_out), (kind, default, _) in sockets.items():
        if (name, in_out) not in existing:
            socket = tree.interface.new_socket(name, in_out=in_out, socket_type=kind)
            socket.default_value = (1, 1, 1, 1) if name == "Base Color Factor" else default


def _area_images(graph, wrinkles, uv):
    """Create one texture node for each image of areas. Returns their sockets by image name."""
    images = {}
    for area in wrinkles.areas:
        if area.image and area.image.name not in images:
            images[area.image.name] = graph.texture(area.image, uv, "areas", "EXTEND")
    return images


def _influence(graph, wrinkles, layer, images, activations):
    """
    Build the influence of a layer: `max(min(1, sum(w * a)), max(w * a))`, with weight w and activation a of an area.

    The sum is over areas with `combine` "sum", and the maximum over areas with `combine` "max". Stores in
    `activations` where each area's activation must be written.
    """
    sums, largest = [], []
    members = [(i, area) for i, area in enumerate(wrinkles.areas) if area.layer == layer and area.image]
    for name, (color, alpha) in images.items():
        in_image = [(i, area) for i, area in members if area.image.name == name]
        for mode in ("sum", "max"):
            in_color = [(i, a) for i, a in in_image if a.combine == mode and a.channel != "3"]
            for i, area in in_image:
                if area.combine == mode and area.channel == "3":
                    node = graph.node("ShaderNodeMath", (alpha, 0.0), area.name, operation="MULTIPLY")
                    activations[i] = (node.name, 1)
                    (sums if mode == "sum" else largest).append(node.outputs[0])
            # A vector holds the activations of up to three areas of an image, one per channel. Areas that share a
            # channel need several vectors.
            while in_color:
                chosen = {a.channel: (i, a) for i, a in reversed(in_color)}
                in_color = [pair for pair in in_color if pair not in chosen.values()]
                label = ", ".join(area.name for _, area in sorted(chosen.values()))
                weights = graph.node("ShaderNodeCombineXYZ", (0.0, 0.0, 0.0), label)
                for channel, (i, _) in chosen.items():
                    activations[i] = (weights.name, int(channel))
                if mode == "sum":
                    sums.append(graph.vector("DOT_PRODUCT", color, weights.outputs[0]))
                else:
                    products = graph.separate(graph.vector("MULTIPLY", color, weights.outputs[0]))
                    largest.extend(products[int(channel)] for channel in chosen)
    label = f"influence of {wrinkles.layers[layer].name}"
    total = graph.math("ADD", graph.total(sums), 0.0, clamp=True, label=label)
    return graph.total([total, *largest], "MAXIMUM")


def _delayed(graph, layer, influence, uv):
    """
    Delay the influence of a layer by its onset map (docs/FURROW_wrinkle_maps.md, "Onset").

    Computes `I + strength * (t * (2 - t) - I)` with `t = clamp(1 - (1 - I) / max(1 - onset, 1 / 255))`.
    """
    if not layer.onset:
        return influence
    onset = graph.separate(graph.texture(layer.onset, uv, layer.name)[0])[1]
    span = graph.math("MAXIMUM", graph.math("SUBTRACT", 1.0, onset), 1 / 255)
    missing = graph.math("DIVIDE", graph.math("SUBTRACT", 1.0, influence), span)
    t = graph.math("SUBTRACT", 1.0, missing, clamp=True)
    curve = graph.math("MULTIPLY", t, graph.math("SUBTRACT", 2.0, t))
    change = graph.math("SUBTRACT", curve, influence)
    return graph.math("MULTIPLY_ADD", change, layer.onset_strength, influence, label=f"onset of {layer.name}")


def _shares(graph, influences):
    if len(influences) < 2:
        return influences
    total = graph.math("MAXIMUM", graph.total(influences), 1.0)
    return [graph.math("DIVIDE", influence, total) for influence in influences]


def _unpacked(graph, color, scale):
    """Decode a normal from 0..1 to -1..1, and multiply its x and y by `scale`."""
    normal = graph.vector("MULTIPLY_ADD", color, (2, 2, 2), (-1, -1, -1))
    return normal if scale == 1 else _scaled(graph, normal, scale)


def _scaled(graph, normal, scale):
    return graph.vector("MULTIPLY", normal, graph.combine(scale, scale, 1.0))


def _mixed_normal(graph, wrinkles, influences, inputs):
    base = _unpacked(graph, inputs["Normal"], 1.0)
    layers = [
        (
            layer,
            _unpacked(graph, graph.texture(layer.normal, inputs["UV"], layer.name)[0], layer.normal_scale),
            influence,
        )
        for layer, influence in zip(wrinkles.layers, influences, strict=True)
        if layer.normal
    ]
    replacing = [(normal, influence) for layer, normal, influence in layers if layer.kind == "replace"]
    mixed = base
    for (normal, _), share in zip(replacing, _shares(graph, [influence for _, influence in replacing]), strict=True):
        difference = graph.vector("SUBTRACT", normal, base)
        mixed = graph.vector("ADD", mixed, graph.vector("SCALE", difference, share))
    mixed = graph.vector("NORMALIZE", mixed)
    slope = None
    for layer, normal, influence in layers:
        if layer.kind == "detail":
            factor = graph.math("DIVIDE", influence, graph.separate(normal)[2])
            scaled = graph.vector("SCALE", normal, factor)
            slope = scaled if slope is None else graph.vector("ADD", slope, scaled)
    if slope is not None:
        mixed = _reoriented(graph, mixed, graph.vector("NORMALIZE", _with_z_1(graph, slope)))
    mixed = graph.vector("NORMALIZE", _scaled(graph, mixed, inputs["Normal Scale"]))
    return graph.vector("MULTIPLY_ADD", mixed, (0.5, 0.5, 0.5), (0.5, 0.5, 0.5))


def _with_z_1(graph, slope):
    x, y, _ = graph.separate(slope)
    return graph.combine(x, y, 1.0)


def _reoriented(graph, base, detail):
    """
    Add the normal of a detail map to a base normal by reoriented normal mapping.

    Computes `t * dot(t, u) / t.z - u` with `t = base + (0, 0, 1)` and `u = detail * (-1, -1, 1)`.
    """
    t = graph.vector("ADD", base, (0, 0, 1))
    u = graph.vector("MULTIPLY", detail, (-1, -1, 1))
    scale = graph.math("DIVIDE", graph.vector("DOT_PRODUCT", t, u), graph.separate(t)[2])
    return graph.vector("NORMALIZE", graph.vector("SUBTRACT", graph.vector("SCALE", t, scale), u))


def _mixed_color(graph, wrinkles, influences, inputs):
    pairs = list(zip(wrinkles.layers, influences, strict=True))
    colors = [
        (graph.texture(layer.base_color, inputs["UV"], layer.name)[0], influence)
        for layer, influence in pairs
        if layer.base_color
    ]
    mixed = inputs["Base Color"]
    for (color, _), share in zip(colors, _shares(graph, [influence for _, influence in colors]), strict=True):
        difference = graph.vector("SUBTRACT", color, inputs["Base Color"])
        mixed = graph.vector("ADD", mixed, graph.vector("SCALE", difference, share))
    mixed = graph.vector("MULTIPLY", mixed, inputs["Base Color Factor"])
    bleeding = [(layer, influence) for layer, influence in pairs if layer.blood]
    if not bleeding:
        return mixed
    depths = []
    for (layer, _), share in zip(bleeding, _shares(graph, [influence for _, influence in bleeding]), strict=True):
        stored = graph.separate(graph.texture(layer.blood, inputs["UV"], layer.name)[0])[2]
        signed = graph.math("MULTIPLY_ADD", stored, 255 / 127, -128 / 127)
        amount = graph.math("MAXIMUM", signed, -1.0)
        depths.append(graph.math("MULTIPLY", graph.math("MULTIPLY", amount, layer.blood_amplitude), share))
    depth = graph.total(depths)
    transmitted = [graph.math("EXPONENT", graph.math("MULTIPLY", depth, -k)) for k in BLOOD_ABSORPTION]
    return graph.vector("MULTIPLY", mixed, graph.combine(*transmitted, label="blood"))


def _mixed_number(graph, base, values):
    mixed = base
    for (value, _), share in zip(values, _shares(graph, [own for _, own in values]), strict=True):
        difference = graph.math("SUBTRACT", value, base)
        mixed = graph.math("MULTIPLY_ADD", difference, share, mixed)
    return mixed
