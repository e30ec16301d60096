extends Node3D
## Shows a face with one slider per expression, and a slider for each input.

## Files to show. The first that exists is shown.
const FACES := ["res://demo/human.glb", "res://../faces/human.glb"]

var _player := FurrowExpressionPlayer.new()

@onready var _sliders: VBoxContainer = $Panel/Sliders
@onready var _camera: Camera3D = $Camera


func _ready() -> void:
	var face := _load_face()
	if face == null:
		return
	add_child(face)
	face.add_child(_player)
	_frame(face)
	for expression in _player.get_expression_names():
		if expression != "neutral":
			_add_slider(expression)


func _load_face() -> Node:
	var document := GLTFDocument.new()
	var state := GLTFState.new()
	for path: String in FACES:
		if FileAccess.file_exists(path) and document.append_from_file(path, state) == OK:
			return document.generate_scene(state)
	push_error("Demo: the face is missing; copy faces/human.glb to %s" % FACES[0])
	return null


## Turns the camera to the first mesh with wrinkles.
func _frame(face: Node) -> void:
	var found := face.find_children("*", "FurrowWrinkles", true, false)
	if found.is_empty():
		return
	var instance: MeshInstance3D = found[0].get_mesh_instance()
	var bounds := instance.global_transform * instance.get_aabb()
	_camera.position = bounds.get_center() + Vector3(0.2, 0.05, 1.0) * bounds.size.y * 3.2
	_camera.look_at(bounds.get_center())
	# Moves the face to the right of the sliders.
	_camera.h_offset = -0.7 * bounds.size.x


func _add_slider(expression: String) -> void:
	var label := Label.new()
	label.text = expression
	var slider := HSlider.new()
	slider.name = expression
	slider.max_value = 1.0
	slider.step = 0.01
	slider.value_changed.connect(func(value: float) -> void:
		var weights := _player.weights.duplicate()
		weights[expression] = value
		_player.weights = weights)
	_sliders.add_child(label)
	_sliders.add_child(slider)
