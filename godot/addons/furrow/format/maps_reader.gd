@tool
class_name FurrowMapsReader
extends RefCounted
## Checks the JSON of FURROW_wrinkle_maps, and fills in defaults.

const EXTENSION := "FURROW_wrinkle_maps"
const MAX_LAYERS := 4
const MAX_AREAS := 256
const MAX_SLICES := 256

## Texture fields of a layer. A texture with a number, such as a scale, has the number's field, minimum, maximum and
## default. Without a default, the number is required.
const SLOTS := {
	"normalTexture": ["scale", -1000.0, 1000.0, 1.0],
	"baseColorTexture": [],
	"roughnessTexture": [],
	"occlusionTexture": ["strength", 0.0, 1.0, 1.0],
	"heightTexture": ["amplitude", 0.0, 1000.0],
	"bloodTexture": ["amplitude", 0.0, 2.0],
	"onsetTexture": ["strength", 0.0, 1.0, 1.0],
}

## Groups of texture fields. All slices in one group must be in the same texture array.
const ARRAYS := [
	["normalTexture"],
	["baseColorTexture"],
	["roughnessTexture"],
	["occlusionTexture", "bloodTexture", "onsetTexture"],
	["heightTexture"],
]

var _reader: FurrowJsonReader
var _texture_count: int


## Reads the extension of a material. Returns a dictionary with `layers`, `areas` and unchecked `drivers`. If it breaks a
## rule, [param reader] has an error.
static func read(reader: FurrowJsonReader, json: Variant, texture_count: int) -> Dictionary:
	var maps := FurrowMapsReader.new()
	maps._reader = reader
	maps._texture_count = texture_count
	var root := reader.object(json, "the extension")
	var layers: Array[Dictionary] = []
	for item: Variant in reader.array(root.get("layers"), "layers", 1, MAX_LAYERS):
		layers.append(maps._layer(item, "layers[%d]" % layers.size()))
	var areas: Array[Dictionary] = []
	for item: Variant in reader.array(root.get("areas"), "areas", 1, MAX_AREAS):
		areas.append(maps._area(item, "areas[%d]" % areas.size(), layers.size()))
	maps._check_names(layers, "layers")
	maps._check_names(areas, "areas")
	maps._check_slices(layers, areas)
	return {"layers": layers, "areas": areas, "drivers": root.get("drivers", [])}


## Lists the texture infos of layers, and then those of areas, each with its field and the index of its owner.
static func textures_of(layers: Array, areas: Array) -> Array[Dictionary]:
	var found: Array[Dictionary] = []
	for i in layers.size():
		for slot: String in SLOTS:
			if layers[i].has(slot):
				found.append({"info": layers[i][slot], "slot": slot, "at": "layers[%d].%s" % [i, slot]})
	for i in areas.size():
		found.append({"info": areas[i].texture, "slot": "texture", "at": "areas[%d].texture" % i})
	return found


func _texture(value: Variant, path: String, limits: Array) -> Dictionary:
	var json := _reader.object(value, path)
	var info := {"index": _reader.integer(json.get("index"), "%s.index" % path, 0, _texture_count - 1)}
	if json.has("slice"):
		info.slice = _reader.integer(json.slice, "%s.slice" % path, 0, MAX_SLICES - 1)
	if limits.size() > 0:
		var field: String = limits[0]
		var value_of_field: Variant = json.get(field, limits[3] if limits.size() > 3 else null)
		info[field] = _reader.number(value_of_field, "%s.%s" % [path, field], limits[1], limits[2])
	return info


func _layer(item: Variant, at: String) -> Dictionary:
	var json := _reader.object(item, at)
	var layer := {
		"name": _reader.name(json.get("name"), "%s.name" % at),
		"kind": _reader.choice(json.get("kind", "replace"), "%s.kind" % at, ["replace", "detail"]),
	}
	for slot: String in SLOTS:
		if json.has(slot) or slot == "normalTexture":
			layer[slot] = _texture(json.get(slot), "%s.%s" % [at, slot], SLOTS[slot])
	_check_shared_image(layer, at)
	return layer


func _area(item: Variant, at: String, layer_count: int) -> Dictionary:
	var json := _reader.object(item, at)
	return {
		"name": _reader.name(json.get("name"), "%s.name" % at),
		"layer": _reader.integer(json.get("layer", 0), "%s.layer" % at, 0, layer_count - 1),
		"texture": _texture(json.get("texture"), "%s.texture" % at, []),
		"channel": _reader.integer(json.get("channel", 0), "%s.channel" % at, 0, 3),
		"combine": _reader.choice(json.get("combine", "sum"), "%s.combine" % at, ["sum", "max"]),
		"activation": _reader.number(json.get("activation", 0.0), "%s.activation" % at, 0.0, 1.0),
	}


## Checks that occlusion, blood and onset are in one image, and that roughness is in another image than onset.
func _check_shared_image(layer: Dictionary, at: String) -> void:
	var first: Variant = null
	for slot: String in ["occlusionTexture", "bloodTexture", "onsetTexture"]:
		if not layer.has(slot):
			continue
		if first == null:
			first = slot
		elif not _is_same(layer[first], layer[slot]):
			_reader.fail("%s.%s differs from %s" % [at, slot, first], _name_of(layer[slot]), _name_of(layer[first]),
					"store both in one image")
	if layer.has("onsetTexture") and layer.has("roughnessTexture"):
		if _is_same(layer.onsetTexture, layer.roughnessTexture):
			_reader.fail("%s.onsetTexture is the image of roughnessTexture" % at, _name_of(layer.onsetTexture),
					"another image", "store roughness in a separate image, because both use the G channel")


static func _is_same(a: Dictionary, b: Dictionary) -> bool:
	return a.index == b.index and a.get("slice", -1) == b.get("slice", -1)


static func _name_of(info: Dictionary) -> String:
	return "%d, slice %d" % [info.index, info.slice] if info.has("slice") else str(info.index)


func _check_names(named: Array[Dictionary], list: String) -> void:
	var seen := {}
	for i in named.size():
		if seen.has(named[i].name):
			_reader.fail("%s[%d].name is taken" % [list, i], named[i].name, "", "give each a distinct name")
		seen[named[i].name] = true


## Checks that maps of one kind are either all images or all slices of one texture array, and that arrays are used with a
## slice only.
func _check_slices(layers: Array[Dictionary], areas: Array[Dictionary]) -> void:
	var arrays := {}
	var images := {}
	var all := textures_of(layers, areas)
	for slots: Array in ARRAYS + [["texture"]]:
		var found := all.filter(func(item: Dictionary) -> bool: return slots.has(item.slot))
		var sliced := found.filter(func(item: Dictionary) -> bool: return item.info.has("slice"))
		for item: Dictionary in found:
			var is_in_array: bool = item.info.has("slice") and item.info.index == sliced[0].info.index
			if sliced.size() > 0 and not is_in_array:
				_reader.fail("%s is not in the texture array of %s" % [item.at, sliced[0].at], item.info.index,
						"a slice of texture %d" % sliced[0].info.index, "pack maps of one kind into one array")
			(arrays if item.info.has("slice") else images)[item.info.index] = item.at
	for index: int in arrays:
		if images.has(index):
			_reader.fail("%s has no slice" % images[index], index, "a slice index, because %s has one" % arrays[index],
					"add `slice`")
