@tool
class_name FurrowGltfExtension
extends GLTFDocumentExtension
## Reads FURROW_wrinkle_maps when Godot imports a glTF file, and adds a [FurrowWrinkles] node to each mesh with wrinkles.
##
## The object has no state: everything that belongs to a file is in the [GLTFState]. If the wrinkles of a material break a
## rule, its meshes are imported without wrinkles, after one error.

const KEY := &"furrow"
## Classes of nodes with meshes: at run time, and during import in the editor.
const INSTANCES := ["MeshInstance3D", "ImporterMeshInstance3D"]
const PLAIN := "the face has no wrinkles"

## A white image of one texel. It replaces the images that only wrinkles use, so that Godot does not decode them too.
const PLACEHOLDER := "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR42mP4DwABAQEAHLCMmQAAAABJRU5ErkJggg=="

static var _registered: FurrowGltfExtension


## Makes Godot read wrinkles in all files that are imported afterwards. The plugin calls this method.
static func register() -> void:
	if _registered == null:
		_registered = FurrowGltfExtension.new()
		GLTFDocument.register_gltf_document_extension(_registered)


static func unregister() -> void:
	if _registered != null:
		GLTFDocument.unregister_gltf_document_extension(_registered)
		_registered = null


func _get_supported_extensions() -> PackedStringArray:
	return PackedStringArray([FurrowMapsReader.EXTENSION])


func _import_preflight(state: GLTFState, extensions: PackedStringArray) -> Error:
	var found := {}
	var materials: Variant = state.json.get("materials")
	for i in materials.size() if materials is Array else 0:
		var own: Variant = materials[i].get("extensions") if materials[i] is Dictionary else null
		if own is Dictionary and own.has(FurrowMapsReader.EXTENSION):
			found[i] = _read(own[FurrowMapsReader.EXTENSION], state.json, extensions)
	if found.is_empty():
		return ERR_SKIP
	var images: Variant = state.json.get("images", [])
	state.set_additional_data(KEY, {"maps": found, "images": images.duplicate() if images is Array else [], "sets": {}})
	if images is Array:
		_hide_images(found, state.json)
	return OK


func _import_post_parse(state: GLTFState) -> Error:
	var data: Dictionary = state.get_additional_data(KEY)
	var images := FurrowImageReader.new(state, data.images)
	for index: int in data.maps:
		var maps: Dictionary = data.maps[index]
		var builder := FurrowSetBuilder.new()
		var error: String = maps.get("error", "")
		if error == "":
			data.sets[index] = builder.build(maps, state, index, images)
			error = builder.error
		if error != "":
			data.sets.erase(index)
			push_error("%s (%s)" % [error, PLAIN])
			continue
		for problem: String in maps.driver_errors.slice(0, 1):
			push_warning("%s (%d drivers are malformed; the other drivers work)" % [problem, maps.driver_errors.size()])
		if not maps.unknown_types.is_empty():
			push_warning(FurrowJsonReader.describe(FurrowMapsReader.EXTENSION, "drivers of unknown types",
					", ".join(maps.unknown_types), "", "the other drivers work"))
		_add_muscles(state, index, data.sets[index])
	return OK


func _import_post(state: GLTFState, root: Node) -> Error:
	var data: Dictionary = state.get_additional_data(KEY)
	var finder := FurrowJointFinder.new(state, root)
	for index: int in data.sets:
		var found := {}
		for type: String in INSTANCES:
			for instance in root.find_children("*", type, true, false):
				var surfaces := _surfaces_of(instance.mesh, state.materials[index])
				if not surfaces.is_empty():
					found[instance] = surfaces
		for instance: Node in _driven_faces(found.keys(), data.sets[index]):
			var face := FurrowWrinkles.new()
			face.name = "FurrowWrinkles"
			face.wrinkle_set = data.sets[index]
			face.surfaces = found[instance]
			face.has_tangents = _has_tangents(state, instance.mesh)
			face.is_tiled = _is_tiled(instance.mesh, found[instance], data.sets[index])
			instance.add_child(face)
			face.owner = root
			face.joints = finder.find(face)
	return OK


## Reads the JSON of a material. Returns a dictionary with `error` if the maps break a rule.
static func _read(json: Variant, file: Dictionary, extensions: PackedStringArray) -> Dictionary:
	var reader := FurrowJsonReader.new(FurrowMapsReader.EXTENSION)
	var textures: Variant = file.get("textures")
	var maps := FurrowMapsReader.read(reader, json, textures.size() if textures is Array else 0)
	if not extensions.has(FurrowMapsReader.EXTENSION):
		reader.fail("extensionsUsed lacks %s" % FurrowMapsReader.EXTENSION, null, "",
				"add the name, because tools drop undeclared extensions")
	if reader.error != "":
		return {"error": reader.error}
	var names := PackedStringArray(maps.areas.map(func(area: Dictionary) -> String: return area.name))
	maps.driver_errors = PackedStringArray()
	maps.unknown_types = PackedStringArray()
	maps.drivers = FurrowDriverReader.read(maps.drivers, names, maps.driver_errors, maps.unknown_types)
	return maps


## Replaces images that only wrinkles use.
static func _hide_images(found: Dictionary, file: Dictionary) -> void:
	var wrinkle_textures := {}
	for maps: Dictionary in found.values():
		for texture in FurrowMapsReader.textures_of(maps.get("layers", []), maps.get("areas", [])):
			wrinkle_textures[texture.info.index] = true
	var face_textures := {}
	_collect_textures([file.get("materials"), file.get("extensions")], "", face_textures)
	var hidden := {}
	var textures: Variant = file.get("textures")
	for index: int in textures.size() if textures is Array else 0:
		var image := FurrowImageReader.image_of(file.textures[index])
		var is_hidden: bool = wrinkle_textures.has(index) and not face_textures.has(index)
		hidden[image] = is_hidden and hidden.get(image, true)
	for image: int in hidden:
		if hidden[image] and image >= 0 and image < file.images.size() and file.images[image] is Dictionary:
			file.images[image] = {"uri": PLACEHOLDER, "name": file.images[image].get("name", "wrinkles%d" % image)}


## Collects the indices of textures that the file uses outside the extension.
static func _collect_textures(json: Variant, key: String, found: Dictionary) -> void:
	if json is Dictionary and key != FurrowMapsReader.EXTENSION:
		if key.to_lower().ends_with("texture") and json.get("index") is float:
			found[int(json.index)] = true
		for name: String in json:
			_collect_textures(json[name], name, found)
	elif json is Array:
		for item: Variant in json:
			_collect_textures(item, key, found)


static func _add_muscles(state: GLTFState, material: int, wrinkle_set: FurrowWrinkleSet) -> void:
	var muscles := wrinkle_set.drivers.filter(func(driver: Dictionary) -> bool: return driver.type == "muscle")
	if muscles.is_empty():
		return
	for mesh in state.meshes:
		for i in mesh.mesh.get_surface_count():
			if mesh.mesh.get_surface_material(i) == state.materials[material]:
				FurrowMuscles.add_to(mesh.mesh, muscles)
				break


## Returns the surfaces of a [Mesh] or [ImporterMesh] that have a material.
static func _surfaces_of(mesh: Resource, material: Material) -> PackedInt32Array:
	var found := PackedInt32Array()
	for i in mesh.get_surface_count() if mesh != null else 0:
		var own: Material = mesh.get_surface_material(i) if mesh is ImporterMesh else mesh.surface_get_material(i)
		if own == material:
			found.append(i)
	return found


## Whether all primitives of a mesh have tangents in the file. The format of the mesh does not tell, because Godot adds
## tangents without meaning to compressed meshes.
static func _has_tangents(state: GLTFState, mesh: Resource) -> bool:
	var index := state.meshes.find_custom(func(own: GLTFMesh) -> bool:
		return own.mesh == mesh or own.mesh.get_mesh() == mesh)
	return index >= 0 and state.json.meshes[index].primitives.all(func(primitive: Dictionary) -> bool:
		return primitive.attributes.has("TANGENT"))


static func _is_tiled(mesh: Resource, surfaces: PackedInt32Array, wrinkle_set: FurrowWrinkleSet) -> bool:
	for surface in surfaces:
		var arrays: Array = mesh.get_surface_arrays(surface) if mesh is ImporterMesh else mesh.surface_get_arrays(surface)
		var coordinates: Variant = arrays[Mesh.ARRAY_TEX_UV2 if wrinkle_set.uses_uv2 else Mesh.ARRAY_TEX_UV]
		for uv: Vector2 in wrinkle_set.uv_transform * coordinates if coordinates is PackedVector2Array else []:
			if uv.x < 0.0 or uv.y < 0.0 or uv.x > 1.0 or uv.y > 1.0:
				return true
	return false


## Finds the faces among meshes that share a material: those with at least half of the largest number of blendshapes that
## drivers read. Eyes and teeth often have the material too.
static func _driven_faces(instances: Array, wrinkle_set: FurrowWrinkleSet) -> Array:
	var counts := {}
	for instance: Node in instances:
		var names := PackedStringArray()
		for i in instance.mesh.get_blend_shape_count():
			names.append(instance.mesh.get_blend_shape_name(i))
		counts[instance] = wrinkle_set.plan.inputs.filter(func(input: Dictionary) -> bool:
			return input.kind == "target" and not FurrowTargetNames.find(input.name, names).is_empty()).size()
	var most: int = counts.values().max() if not counts.is_empty() else 0
	return instances.filter(func(instance: Node) -> bool: return 2 * counts[instance] >= most)
