@tool
class_name FurrowWrinkles
extends Node
## Shows the wrinkles of a face. The import of a glTF file with FURROW_wrinkle_maps adds this node to each
## [MeshInstance3D] with wrinkles.
##
## Before each frame, drivers compute how visible the wrinkles of each area are, from blendshapes, joints, skin tension and
## [member inputs]. Faces of one file share their textures, and each has its own activations.

## Emitted when a driver or a change of [member activations] has changed the activation of an area.
signal activations_changed

enum Mode {
	## Mixes the wrinkles into the material before it is lit.
	DEFAULT,
	## Shows the mesh with its own material, without wrinkles.
	OFF,
}

enum ProcessCallback {
	## Drivers run before each frame is drawn.
	FRAME,
	## Drivers run only in [method advance].
	MANUAL,
}

const WHO := "FurrowWrinkles"

## Layers, areas and drivers. Faces with the same resource share their textures.
@export var wrinkle_set: FurrowWrinkleSet
## Whether the wrinkles are shown.
@export var mode := Mode.DEFAULT:
	set(value):
		mode = value
		_apply_material()
## When drivers run.
@export var process_callback := ProcessCallback.FRAME
## Resting activations, 0 (smooth) to 1 (fully wrinkled), by name of the area. They replace those in the file, and drivers
## add to them.
@export var activations: Dictionary[String, float] = {}
## Numbers that drivers of type `age` and `input` read, by name, for example `age` in years.
@export var inputs: Dictionary[String, float] = {}
## Surfaces of the mesh that have the wrinkled material.
@export var surfaces := PackedInt32Array([0])
## Whether the vertices have tangents in the file. Otherwise tangents follow from texture coordinates.
@export_storage var has_tangents := false
## Whether texture coordinates of the maps are outside 0..1.
@export_storage var is_tiled := true
## Joints that drivers of type `bone` read, by name in the glTF file. See [FurrowJointFinder].
@export_storage var joints: Dictionary[String, Dictionary] = {}

var _cell: FurrowInfluenceAtlas.Cell
var _program: FurrowDriverProgram
## Materials that override those of the mesh's surfaces while this node is not in the tree.
var _overridden: Array[Material] = []
var _materials: Array[ShaderMaterial] = []
var _resting := PackedFloat64Array()
var _warned := false


func _enter_tree() -> void:
	# In the editor, the scene would be saved with the converted material.
	if wrinkle_set == null or get_mesh_instance() == null or Engine.is_editor_hint():
		return
	_overridden.clear()
	for surface in surfaces:
		var material := get_mesh_instance().get_surface_override_material(surface)
		_overridden.append(null if FurrowMaterialConverter.is_converted(material) else material)
	_cell = wrinkle_set.atlas.add(get_viewport().get_viewport_rid())
	refresh_material()
	FurrowFrame.add(self)


func _exit_tree() -> void:
	if _cell == null:
		return
	FurrowFrame.remove(self)
	wrinkle_set.atlas.remove(_cell)
	_cell = null
	_program = null
	_apply_material()
	_materials.clear()


func _get_configuration_warnings() -> PackedStringArray:
	if get_mesh_instance() == null:
		return PackedStringArray(["This node must be a child of a MeshInstance3D."])
	return PackedStringArray()


## Returns the mesh with the wrinkles, which is the parent of this node.
func get_mesh_instance() -> MeshInstance3D:
	return get_parent() as MeshInstance3D


## Returns the names of all areas.
func get_area_names() -> PackedStringArray:
	return wrinkle_set.get_area_names()


## Returns the current activation of an area, including the contributions of drivers.
func get_activation(area: String) -> float:
	var index := get_area_names().find(area)
	if index < 0:
		push_error(FurrowJsonReader.describe(WHO, "unknown area", area, ", ".join(get_area_names()),
				"use the name of an area in this set"))
		return 0.0
	return _read_resting()[index] if _cell == null else _bound().activations[index]


## Runs the drivers now. [param seconds] is the time since the last call, for delays.
func advance(seconds: float) -> void:
	if _cell != null and _run(seconds):
		activations_changed.emit()


## Converts the material of the mesh again. Call this method after a change of the [StandardMaterial3D].
func refresh_material() -> void:
	if _cell == null:
		return
	_materials.clear()
	for i in surfaces.size():
		var own := _overridden[i]
		if own == null:
			own = get_mesh_instance().mesh.surface_get_material(surfaces[i])
		_materials.append(FurrowMaterialConverter.convert(own, self))
	_apply_material()


## Whether the face may be visible in the next frame.
func is_drawn() -> bool:
	return mode == Mode.DEFAULT and get_mesh_instance().is_visible_in_tree()


## Runs the drivers of a frame. Returns whether an activation has changed.
func run_drivers() -> bool:
	return _run(get_process_delta_time() if can_process() else 0.0)


## Tells the atlas the current activations.
func update_influence() -> void:
	if mode == Mode.OFF:
		return
	var atlas := wrinkle_set.atlas
	atlas.update(_cell, _bound().activations)
	var place := atlas.place_of(_cell)
	for material in _materials:
		if material != null and material.get_shader_parameter("furrow_place") != place:
			material.set_shader_parameter("furrow_place", place)


func _run(seconds: float) -> bool:
	return _bound().run(_read_resting(), seconds)


func _bound() -> FurrowDriverProgram:
	if _program == null:
		_program = FurrowDriverProgram.new(wrinkle_set.plan, get_area_names(), FurrowInputSources.create(self))
		_program.run(_read_resting(), 0.0)
		if not _program.missing.is_empty() and not _warned:
			_warned = true
			push_warning(FurrowJsonReader.describe(WHO, "drivers of %s reference missing inputs or areas" % get_parent().name,
					", ".join(_program.missing), "", "the other drivers work"))
	return _program


func _read_resting() -> PackedFloat64Array:
	_resting.resize(wrinkle_set.areas.size())
	for i in _resting.size():
		var area := wrinkle_set.areas[i]
		var value: float = activations.get(area.name, area.activation)
		_resting[i] = clampf(value, 0.0, 1.0) if is_finite(value) else 0.0
	return _resting


func _apply_material() -> void:
	for i in _materials.size():
		var is_shown := _cell != null and mode == Mode.DEFAULT and _materials[i] != null
		get_mesh_instance().set_surface_override_material(surfaces[i], _materials[i] if is_shown else _overridden[i])
