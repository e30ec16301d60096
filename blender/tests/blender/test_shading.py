"""Renders the nodes in Cycles, and compares each texel with the formulas of the specification, in float64."""

import math
import random
import unittest

import bpy

from furrow.material import group_node
from support import BlenderTest, document, image

SIZE = 8


def noise(seed, low=0, high=255):
    rng = random.Random(seed)
    values = [[tuple(rng.randint(low, high) for _ in range(3)) for _ in range(SIZE)] for _ in range(SIZE)]
    return lambda x, y: values[y][x]


def normals(seed):
    """Create random unit normals that are tilted by less than 60 degrees."""
    rng = random.Random(seed)

    def pixel():
        x, y = rng.uniform(-0.6, 0.6), rng.uniform(-0.6, 0.6)
        return tuple(round(127.5 * (value + 1)) for value in (x, y, math.sqrt(1 - x * x - y * y)))

    values = [[pixel() for _ in range(SIZE)] for _ in range(SIZE)]
    return lambda x, y: values[y][x]


PIXELS = {
    "base": normals(1),
    "one": normals(2),
    "two": normals(3),
    "three": normals(4),
    "areas": noise(5),
    "color": noise(6),
}
PIXELS["blood"] = noise(7, 0, 160)
PIXELS["onset"] = noise(8, 0, 160)
FILES = [image(name, pixel, SIZE) for name, pixel in PIXELS.items()]
INDEX = {name: {"index": i} for i, name in enumerate(PIXELS)}
LAYERS = [
    {
        "name": "one",
        "kind": "replace",
        "normalTexture": {**INDEX["one"], "scale": 0.7},
        "baseColorTexture": INDEX["color"],
    },
    {
        "name": "two",
        "kind": "replace",
        "normalTexture": {**INDEX["two"], "scale": 1},
        "roughnessTexture": INDEX["color"],
    },
    {"name": "three", "kind": "detail", "normalTexture": {**INDEX["three"], "scale": 0.8}},
]
LAYERS[2]["bloodTexture"] = {**INDEX["blood"], "amplitude": 0.7}
LAYERS[0]["onsetTexture"] = {**INDEX["onset"], "strength": 0.8}
LAYERS[2]["onsetTexture"] = {**INDEX["blood"], "strength": 1}
#: Areas: name, layer, channel, combine and activation.
AREAS = [
    ("a", 0, 0, "sum", 0.9),
    ("b", 0, 1, "sum", 0.8),
    ("c", 1, 2, "max", 0.7),
    ("d", 1, 0, "max", 0.5),
    ("e", 2, 1, "sum", 0.6),
    ("f", 2, 1, "sum", 0.3),
]
AREA_ITEMS = [
    {"name": name, "layer": layer, "texture": INDEX["areas"], "channel": channel, "combine": combine, "activation": own}
    for name, layer, channel, combine, own in AREAS
]


def influences(x, y):
    weights = [value / 255 for value in PIXELS["areas"](x, y)]
    out = []
    for layer in range(3):
        own = [(weights[channel] * activation, kind) for _, at, channel, kind, activation in AREAS if at == layer]
        total = min(1, sum(value for value, kind in own if kind == "sum"))
        out.append(max([total, *(value for value, kind in own if kind == "max")]))
    out[0] = delay(out[0], PIXELS["onset"](x, y)[1] / 255, 0.8)
    out[2] = delay(out[2], PIXELS["blood"](x, y)[1] / 255, 1)
    return out


def delay(influence, onset, strength):
    t = min(1, max(0, 1 - (1 - influence) / max(1 - onset, 1 / 255)))
    return influence + strength * (t * (2 - t) - influence)


def unpack(pixel, scale=1):
    x, y, z = (value / 255 * 2 - 1 for value in pixel)
    return [x * scale, y * scale, z]


def normalize(vector):
    length = math.hypot(*vector)
    return [value / length for value in vector]


def mix(base, values, shares):
    total = max(1, sum(shares))
    return [b + sum((v[i] - b) * s / total for v, s in zip(values, shares, strict=True)) for i, b in enumerate(base)]


def expected_normal(x, y, base_scale):
    i, j, k = influences(x, y)
    base = unpack(PIXELS["base"](x, y))
    m = normalize(mix(base, [unpack(PIXELS["one"](x, y), 0.7), unpack(PIXELS["two"](x, y))], [i, j]))
    n = unpack(PIXELS["three"](x, y), 0.8)
    d = normalize([n[0] / n[2] * k, n[1] / n[2] * k, 1])
    t, u = [m[0], m[1], m[2] + 1], [-d[0], -d[1], d[2]]
    scale = sum(a * b for a, b in zip(t, u, strict=True)) / t[2]
    x, y, z = (a * scale - b for a, b in zip(t, u, strict=True))
    return normalize([x * base_scale, y * base_scale, z])


def linear(value):
    value /= 255
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


def expected_color(x, y, factor):
    i, _, k = influences(x, y)
    mixed = mix((1, 1, 1), [[linear(value) for value in PIXELS["color"](x, y)]], [i])
    depth = 0.7 * max(-1, (PIXELS["blood"](x, y)[2] - 128) / 127) * k
    return [m * f * math.exp(-a * depth) for m, f, a in zip(mixed, factor, (0.35, 1, 0.89), strict=True)]


class ShadingTest(BlenderTest):
    def setUp(self):
        super().setUp()
        material = {
            "normalTexture": {"scale": 0.9},
            "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.6, 0.5, 1], "roughnessFactor": 0.5},
        }
        path = self.write_face(document(AREA_ITEMS, LAYERS), FILES, normal=FILES[0], material=material)
        self.group = self.import_face(path)

    def check(self, output, expected, tolerance=2 / 255):
        found = self.render(output)
        worst = 0
        for y in range(SIZE):
            for x in range(SIZE):
                for a, b in zip(found(x, y), expected(x, y), strict=False):
                    worst = max(worst, abs(a - b))
        self.assertLess(worst, tolerance)

    def render(self, output):
        """Render an output of the group as emission, with one pixel per texel."""
        material = next(item for item in bpy.data.materials if group_node(item))
        tree = material.node_tree
        emission = tree.nodes.new("ShaderNodeEmission")
        tree.links.new(group_node(material).outputs[output], emission.inputs[0])
        target = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
        tree.links.new(emission.outputs[0], target.inputs["Surface"])
        scene = bpy.context.scene
        camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
        camera.data.type, camera.data.ortho_scale = "ORTHO", 1
        # The square faces +Z in glTF, which is -Y in Blender.
        camera.location, camera.rotation_euler = (0.5, -1, 0.5), (math.pi / 2, 0, 0)
        scene.collection.objects.link(camera)
        scene.camera = camera
        scene.render.engine = "CYCLES"
        scene.cycles.samples = 1
        scene.cycles.use_denoising = False
        scene.cycles.pixel_filter_type = "BOX"
        # With a narrow filter, rays hit the centres of texels.
        scene.cycles.filter_width = 0.01
        scene.render.resolution_x = scene.render.resolution_y = SIZE
        scene.view_settings.view_transform = "Raw"
        scene.render.image_settings.file_format = "OPEN_EXR"
        scene.render.image_settings.color_depth = "32"
        scene.render.filepath = str(self.folder / "render.exr")
        bpy.ops.render.render(write_still=True)
        result = bpy.data.images.load(scene.render.filepath)
        result.colorspace_settings.is_data = True
        pixels = list(result.pixels)
        return lambda x, y: pixels[4 * (x + (SIZE - 1 - y) * SIZE) :][:3]

    def test_normals(self):
        self.check("Normal", lambda x, y: [0.5 + 0.5 * value for value in expected_normal(x, y, 0.9)])

    def test_base_colour_and_blood(self):
        self.check("Base Color", lambda x, y: expected_color(x, y, (0.8, 0.6, 0.5)))

    def test_roughness(self):
        def expected(x, y):
            return [mix([1], [[PIXELS["color"](x, y)[1] / 255]], [influences(x, y)[1]])[0] * 0.5] * 3

        self.check("Roughness", expected)

    def test_at_rest_the_face_is_plain(self):
        for area in self.group.furrow.areas:
            area.activation = 0
        bpy.context.view_layer.update()
        base = [0.8, 0.6, 0.5]
        self.check("Base Color", lambda x, y: base, 1e-6)
        self.check("Normal", lambda x, y: [0.5 + 0.5 * v for v in normalize(unpack(PIXELS["base"](x, y), 0.9))], 1e-3)


if __name__ == "__main__":
    unittest.main()
