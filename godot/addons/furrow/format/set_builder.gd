@tool
class_name FurrowSetBuilder
extends RefCounted
## Creates a [FurrowWrinkleSet] from the checked JSON of a material and its images.

## Largest width and height of an influence map in texels.
const MAX_AREA_SIZE := 128

## For each sampler, the texture fields of a layer that it serves.
const SAMPLERS := {
	"normal": ["normalTexture"],
	"base_color": ["baseColorTexture"],
	"roughness": ["roughnessTexture"],
	"values": ["occlusionTexture", "bloodTexture", "onsetTexture"],
}

## Value of `wrapS` in glTF.
const CLAMP_TO_EDGE := 33071

## Message of the first problem, or an empty string.
var error := ""

var _set := FurrowWrinkleSet.new()
var _images: FurrowImageReader


## Returns null if an image cannot be read or the images break a rule.
func build(maps: Dictionary, state: GLTFState, index: int, images: FurrowImageReader) -> FurrowWrinkleSet:
	var material: Dictionary = state.json.materials[index]
	_images = images
	_set.layers = maps.layers
	_set.areas = maps.areas
	_set.drivers = maps.drivers
	for sampler: String in SAMPLERS:
		_add_maps(sampler, SAMPLERS[sampler])
	_add_areas()
	_read_coordinates(material)
	_read_sampler(material, state)
	if images.error != "":
		error = images.error
	return _set if error == "" else null


func _add_maps(sampler: String, slots: Array) -> void:
	var indices := {}
	var slices := PackedInt32Array()
	var found: Array[Image] = []
	for layer in _set.layers:
		var slot := slots.find_custom(func(own: String) -> bool: return layer.has(own))
		if slot < 0:
			slices.append(-1)
			continue
		var info: Dictionary = layer[slots[slot]]
		var key := FurrowImageReader.key_of(info)
		if not indices.has(key):
			var image := _images.read(info)
			if image == null:
				return
			indices[key] = found.size()
			# A copy, because the image may also be a map of another kind.
			found.append(image.duplicate())
		slices.append(indices[key])
	if found.is_empty():
		return
	for image in found:
		if image.get_size() != found[0].get_size():
			error = FurrowJsonReader.describe(FurrowMapsReader.EXTENSION, "%s maps differ in size" % sampler,
					"%s, %s" % [found[0].get_size(), image.get_size()], "one size for all layers",
					"scale the images to one size")
			return
		image.generate_mipmaps()
	_set.maps[sampler] = _array_of(found)
	_set.slices[sampler] = slices


func _add_areas() -> void:
	var measured := _set.drivers.filter(func(driver: Dictionary) -> bool: return driver.type == "tension")
	var channels: Array[Image] = []
	var size := Vector2i.ONE
	for area in _set.areas:
		var image := _images.read(area.texture)
		if image == null:
			return
		channels.append(_channel_of(image, area.channel))
		size = size.max(image.get_size())
	size = size.min(Vector2i(MAX_AREA_SIZE, MAX_AREA_SIZE))
	for i in channels.size():
		var image := channels[i]
		if image.get_size() != size:
			image.resize(size.x, size.y, Image.INTERPOLATE_TRILINEAR)
			image.clear_mipmaps()
		_set.bounds.append(_bounds_of(image))
		var name: String = _set.areas[i].name
		if measured.any(func(driver: Dictionary) -> bool: return driver.area == name):
			_set.measured_weights[name] = image
	_set.weights = _array_of(channels)


## Copies one channel of an RGBA image. Shifting the bytes and reading red is much faster than a loop over all texels.
static func _channel_of(image: Image, channel: int) -> Image:
	var bytes := image.get_data()
	var length := bytes.size()
	bytes = bytes.slice(channel)
	bytes.resize(length)
	var copy := Image.create_from_data(image.get_width(), image.get_height(), false, Image.FORMAT_RGBA8, bytes)
	copy.convert(Image.FORMAT_R8)
	return copy


## Returns the smallest rectangle with all weights above 0.
static func _bounds_of(image: Image) -> Rect2i:
	var turned: Image = image.duplicate()
	# Turned clockwise, so that the columns of the image become rows in the same order.
	turned.rotate_90(CLOCKWISE)
	var rows := _used_rows(image)
	var columns := _used_rows(turned)
	return Rect2i(columns.x, rows.x, columns.y - columns.x, rows.y - rows.x)


## Returns the first row with a weight above 0, and the row after the last.
static func _used_rows(image: Image) -> Vector2i:
	var width := image.get_width()
	var data := image.get_data()
	var empty := PackedByteArray()
	empty.resize(width)
	var first := 0
	var end := image.get_height()
	while first < end and data.slice(first * width, (first + 1) * width) == empty:
		first += 1
	while end > first and data.slice((end - 1) * width, end * width) == empty:
		end -= 1
	return Vector2i(first, end)


static func _array_of(images: Array[Image]) -> Texture2DArray:
	var texture := Texture2DArray.new()
	texture.create_from_images(images)
	return texture


## Reads the texture coordinates of the material's normal map, which all maps use.
func _read_coordinates(material: Dictionary) -> void:
	var info: Variant = material.get("normalTexture")
	if info is not Dictionary:
		return
	var coordinates: Variant = info.get("texCoord", 0)
	var extensions: Variant = info.get("extensions")
	var transform: Variant = extensions.get("KHR_texture_transform") if extensions is Dictionary else null
	if transform is Dictionary:
		coordinates = transform.get("texCoord", coordinates)
		var rotation: Variant = transform.get("rotation", 0.0)
		# A positive rotation of KHR_texture_transform turns the image counter-clockwise.
		_set.uv_transform = Transform2D(-rotation if rotation is float else 0.0, _pair(transform.get("scale"), Vector2.ONE),
				0.0, _pair(transform.get("offset"), Vector2.ZERO))
	_set.uses_uv2 = coordinates is float and coordinates == 1.0


## Reads the sampler of the material's normal map. Godot uses the sampler of the base colour map for all maps.
func _read_sampler(material: Dictionary, state: GLTFState) -> void:
	var info: Variant = material.get("normalTexture")
	var texture := int(info.index) if info is Dictionary and info.get("index") is float else -1
	if texture < 0 or texture >= state.textures.size():
		return
	var sampler := state.textures[texture].sampler
	if sampler >= 0 and sampler < state.texture_samplers.size():
		_set.repeats_normals = state.texture_samplers[sampler].wrap_s != CLAMP_TO_EDGE


static func _pair(json: Variant, default: Vector2) -> Vector2:
	var is_pair: bool = json is Array and json.size() == 2 and json[0] is float and json[1] is float
	return Vector2(json[0], json[1]) if is_pair else default
