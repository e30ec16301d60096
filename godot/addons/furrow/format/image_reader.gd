@tool
class_name FurrowImageReader
extends RefCounted
## Decodes the wrinkle maps of a glTF file to RGBA, 8 bits per channel. Each image is decoded once.

const MAX_SIDE := 8192
const MAX_BYTES := 512 << 20
const REMEDY := "check the file with `npx furrow validate`"

## Message of the first problem, or an empty string.
var error := ""

var _state: GLTFState
## JSON of the images in the file. See [method FurrowGltfExtension._import_preflight].
var _json: Array
var _known := {}
var _bytes := 0


func _init(state: GLTFState, images: Array) -> void:
	_state = state
	_json = images


## Returns the image of a texture info of the extension. Returns null after a problem.
func read(info: Dictionary) -> Image:
	var key := key_of(info)
	if not _known.has(key) and error == "":
		_known[key] = _decode(info.index, info.get("slice", -1))
	return _known.get(key)


## Returns a value that is equal for texture infos with the same image.
static func key_of(info: Dictionary) -> Vector2i:
	return Vector2i(info.index, info.get("slice", -1))


func _decode(texture: int, slice: int) -> Image:
	var who := "%s texture %d" % [FurrowMapsReader.EXTENSION, texture]
	var index := image_of(_state.json.textures[texture], slice >= 0)
	if slice >= 0 and index < 0:
		return _fail(who, "no such slice", null, "no slice, because the image is not KTX 2")
	if index < 0 or index >= _json.size() or _json[index] is not Dictionary:
		return _fail(who, "texture without an image", null, "")
	var bytes := _bytes_of(_json[index])
	var image := Image.new()
	var result := ERR_FILE_UNRECOGNIZED
	if bytes.size() < 24:
		return _fail(who, "not a readable image", "%d bytes" % bytes.size(), "an intact PNG, JPEG, WebP or KTX 2 file")
	var magic := bytes.decode_u32(0)
	match magic:
		0x474e5089:
			# The size is checked before decoding, because decoding a huge image may exhaust memory.
			var size := bytes.slice(16, 24)
			size.reverse()
			if not _count(who, size.decode_u32(4), size.decode_u32(0)):
				return null
			result = image.load_png_from_buffer(bytes)
		0x46464952:
			result = image.load_webp_from_buffer(bytes)
		0x58544bab:
			# Godot reads no arrays.
			result = image.load_ktx_from_buffer(FurrowKtx2Slice.extract(bytes, slice) if slice >= 0 else bytes)
			if result == OK and image.is_compressed():
				result = image.decompress()
		_ when magic & 0xffffff == 0xffd8ff:
			result = image.load_jpg_from_buffer(bytes)
	if result != OK or image.is_empty():
		return _fail(who, "Godot cannot read the image", error_string(result), "PNG, JPEG, WebP or KTX 2")
	if magic != 0x474e5089 and not _count(who, image.get_width(), image.get_height()):
		return null
	image.clear_mipmaps()
	image.convert(Image.FORMAT_RGBA8)
	return image


## Returns the index of a texture's image, or -1 if it has none. KTX 2 images are the last choice, unless a slice is needed.
static func image_of(texture: Variant, is_slice := false) -> int:
	if texture is not Dictionary:
		return -1
	var extensions: Variant = texture.get("extensions")
	var sources := [texture.get("source")]
	for name: String in ["EXT_texture_webp", "KHR_texture_basisu"]:
		var own: Variant = extensions.get(name) if extensions is Dictionary else null
		sources.append(own.get("source") if own is Dictionary else null)
	for source: Variant in [sources[2]] if is_slice else [sources[1], sources[0], sources[2]]:
		if source is float:
			return int(source)
	return -1


func _bytes_of(image: Dictionary) -> PackedByteArray:
	if image.has("bufferView"):
		var views := _state.buffer_views
		var view := int(image.bufferView)
		return views[view].load_buffer_view_data(_state) if view >= 0 and view < views.size() else PackedByteArray()
	var uri := str(image.get("uri", ""))
	if uri.begins_with("data:"):
		return Marshalls.base64_to_raw(uri.get_slice(",", 1))
	return FileAccess.get_file_as_bytes(_state.base_path.path_join(uri.uri_decode()))


## Adds the decoded size of an image, and checks the limits.
func _count(who: String, width: int, height: int) -> bool:
	_bytes += 4 * width * height
	if maxi(width, height) > MAX_SIDE:
		_fail(who, "image too large", "%d x %d" % [width, height], "at most %d texels per side" % MAX_SIDE)
	elif _bytes > MAX_BYTES:
		_fail(who, "total size of the wrinkle images too large", "%d MiB" % (_bytes >> 20), "512 MiB per file")
	return error == ""


func _fail(who: String, problem: String, value: Variant, limit: String) -> Image:
	error = FurrowJsonReader.describe(who, problem, value, limit, REMEDY)
	return null
