"""Checks the JSON of FURROW_wrinkle_maps, called the document, by the rules of docs/FURROW_wrinkle_maps.md."""

from .driver_fields import read_driver
from .reader import MAX_NUMBER, FurrowError, Reader

EXTENSION = "FURROW_wrinkle_maps"
MAX_LAYERS = 4
MAX_AREAS = 256
MAX_DRIVERS = 4096

#: Texture fields of a layer. A texture with a number, such as a scale, has a tuple: the number's JSON field, minimum,
#: maximum, default. If the default is None, the number is required.
SLOTS = {
    "normalTexture": ("scale", -MAX_NUMBER, MAX_NUMBER, 1),
    "baseColorTexture": None,
    "roughnessTexture": None,
    "occlusionTexture": ("strength", 0, 1, 1),
    "heightTexture": ("amplitude", 0, MAX_NUMBER, None),
    "bloodTexture": ("amplitude", 0, 2, None),
    "onsetTexture": ("strength", 0, 1, 1),
}


def read_document(json, texture_count, who=EXTENSION, on_error=None):
    """
    Check the extension's JSON and fill in defaults. Keeps unknown fields and drivers of unknown types.

    `who`: beginning of error messages. `on_error`: function that is called with an error message for each malformed
    driver, which is then skipped. By default, malformed drivers raise FurrowError, as all other errors do. Returns a
    new dict with `layers`, `areas`, `drivers` and all other fields.
    """
    reader = Reader(who)
    root = dict(reader.object(json, "the extension"))
    layers = reader.array(root.get("layers"), "layers", 1, MAX_LAYERS)
    root["layers"] = [_layer(reader, item, f"layers[{i}]", texture_count) for i, item in enumerate(layers)]
    areas = reader.array(root.get("areas"), "areas", 1, MAX_AREAS)
    root["areas"] = [_area(reader, item, f"areas[{i}]", len(layers), texture_count) for i, item in enumerate(areas)]
    for kind in ("layers", "areas"):
        _check_names(reader, root[kind], kind)
    root["drivers"] = _drivers(reader, root.get("drivers", []), [area["name"] for area in root["areas"]], on_error)
    return root


def textures_of(document):
    """Iterate over all texture infos: first those of layers, then those of areas."""
    for layer in document["layers"]:
        yield from (layer[slot] for slot in SLOTS if slot in layer)
    for area in document["areas"]:
        yield area["texture"]


def without_defaults(document):
    layers = []
    for layer in document["layers"]:
        out = {key: value for key, value in layer.items() if (key, value) != ("kind", "replace")}
        for slot, number in SLOTS.items():
            if slot in out and number and out[slot].get(number[0]) == number[3]:
                out[slot] = {key: value for key, value in out[slot].items() if key != number[0]}
        layers.append(out)
    defaults = {"layer": 0, "channel": 0, "combine": "sum", "activation": 0}
    areas = [{k: v for k, v in area.items() if k not in defaults or v != defaults[k]} for area in document["areas"]]
    out = {**document, "layers": layers, "areas": areas}
    if not out["drivers"]:
        del out["drivers"]
    return out


def _texture(reader, value, path, count, number=None):
    info = dict(reader.object(value, path))
    info["index"] = reader.integer(info.get("index"), f"{path}.index", 0, count - 1)
    if "slice" in info:
        info["slice"] = reader.integer(info["slice"], f"{path}.slice", 0, 255)
    if number:
        field, low, high, default = number
        info[field] = reader.number(info.get(field, default), f"{path}.{field}", low, high)
    return info


def _texture_name(info):
    return f"{info['index']}, slice {info['slice']}" if "slice" in info else str(info["index"])


def _layer(reader, item, at, count):
    layer = dict(reader.object(item, at))
    reader.name(layer.get("name"), f"{at}.name")
    layer["kind"] = reader.choice(layer.get("kind", "replace"), f"{at}.kind", ("replace", "detail"))
    for slot, number in SLOTS.items():
        if slot in layer or slot == "normalTexture":
            layer[slot] = _texture(reader, layer.get(slot), f"{at}.{slot}", count, number)
    _check_shared_image(reader, layer, at)
    return layer


def _check_shared_image(reader, layer, at):
    """Check that occlusion, blood and onset share one image. Roughness and onset must not, because both use G."""
    blood, occlusion, onset = (layer.get(f"{name}Texture") for name in ("blood", "occlusion", "onset"))
    if blood and occlusion and not _is_same(blood, occlusion):
        problem = f"{at}.bloodTexture differs from occlusionTexture"
        remedy = "store blood in the B channel of the occlusion image"
        reader.fail(problem, _texture_name(blood), _texture_name(occlusion), remedy)
    shared, other = (occlusion, "occlusion") if occlusion else (blood, "blood")
    if onset and shared and not _is_same(onset, shared):
        problem = f"{at}.onsetTexture differs from {other}Texture"
        remedy = f"store onset in the G channel of the {other} image"
        reader.fail(problem, _texture_name(onset), _texture_name(shared), remedy)
    roughness = layer.get("roughnessTexture")
    if onset and roughness and _is_same(onset, roughness):
        problem = f"{at}.onsetTexture is the image of roughnessTexture"
        remedy = "store roughness in a separate image, because both use the G channel"
        reader.fail(problem, _texture_name(onset), "another image", remedy)


def _is_same(one, other):
    return (one["index"], one.get("slice")) == (other["index"], other.get("slice"))


def _area(reader, item, at, layer_count, count):
    area = dict(reader.object(item, at))
    reader.name(area.get("name"), f"{at}.name")
    area["layer"] = reader.integer(area.get("layer", 0), f"{at}.layer", 0, layer_count - 1)
    area["texture"] = _texture(reader, area.get("texture"), f"{at}.texture", count)
    area["channel"] = reader.integer(area.get("channel", 0), f"{at}.channel", 0, 3)
    area["combine"] = reader.choice(area.get("combine", "sum"), f"{at}.combine", ("sum", "max"))
    area["activation"] = reader.number(area.get("activation", 0), f"{at}.activation", 0, 1)
    return area


def _check_names(reader, named, kind):
    seen = set()
    for i, item in enumerate(named):
        if item["name"] in seen:
            reader.fail(f"{kind}[{i}].name is taken", item["name"], None, "give each a distinct name")
        seen.add(item["name"])


def _drivers(reader, value, areas, on_error):
    found = []
    for i, item in enumerate(reader.array(value, "drivers", 0, MAX_DRIVERS)):
        try:
            found.append(read_driver(reader, item, f"drivers[{i}]", areas))
        except FurrowError as error:
            if on_error is None:
                raise
            on_error(str(error))
    return found
