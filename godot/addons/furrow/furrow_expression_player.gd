@tool
class_name FurrowExpressionPlayer
extends Node
## Plays expressions on all meshes below the parent of this node: those that a file stores as drivers of type `expression`,
## or presets such as `happy` if it has none.

const WHO := "FurrowExpressionPlayer"

## Weights of expressions, 0 to 1, by name. The sum of an expression's blendshapes times its weight is shown.
@export var weights: Dictionary[String, float] = {}:
	set(value):
		weights = value
		_apply()

var _expressions: Dictionary[String, Dictionary] = {}
## For each blendshape that expressions move: its mesh, its index, and its weight by expression.
var _targets: Array[Dictionary] = []
var _faces: Array[FurrowWrinkles] = []
var _tween: Tween


func _ready() -> void:
	for face: FurrowWrinkles in get_parent().find_children("*", "FurrowWrinkles", true, false):
		_faces.append(face)
		for driver in face.wrinkle_set.drivers:
			if driver.type == "expression" and not _expressions.has(driver.name):
				_expressions[driver.name] = driver
	if _expressions.is_empty():
		_expressions.assign(FurrowExpressionPresets.EXPRESSIONS)
	for instance: MeshInstance3D in get_parent().find_children("*", "MeshInstance3D", true, false):
		if instance.mesh is ArrayMesh:
			_bind(instance)
	_apply()


## Returns the names of the expressions.
func get_expression_names() -> PackedStringArray:
	return _expressions.keys()


## Changes from the current face to an expression in the given time in seconds.
func play(expression: String, seconds := 0.25) -> void:
	if not _expressions.has(expression):
		push_error(FurrowJsonReader.describe(WHO, "unknown expression", expression, ", ".join(get_expression_names()),
				"use one of these names"))
		return
	var from := weights.duplicate()
	var to: Dictionary[String, float] = {expression: 1.0}
	if _tween != null:
		_tween.kill()
	if seconds <= 0.0:
		weights = to
		return
	_tween = create_tween()
	_tween.tween_method(func(t: float) -> void: _mix(from, to, t), 0.0, 1.0, seconds)


func _mix(from: Dictionary[String, float], to: Dictionary[String, float], t: float) -> void:
	var mixed: Dictionary[String, float] = {}
	for expression in _expressions:
		mixed[expression] = lerpf(from.get(expression, 0.0), to.get(expression, 0.0), t)
	weights = mixed


func _bind(instance: MeshInstance3D) -> void:
	var names := PackedStringArray()
	for i in instance.mesh.get_blend_shape_count():
		names.append(instance.mesh.get_blend_shape_name(i))
	var found := {}
	for expression in _expressions:
		var targets: Dictionary = _expressions[expression].targets
		for name: String in targets:
			for index in FurrowTargetNames.find(name, names):
				found.get_or_add(index, {})[expression] = targets[name]
	for index: int in found:
		_targets.append({"instance": instance, "index": index, "weights": found[index]})


func _apply() -> void:
	for target in _targets:
		var sum := 0.0
		for expression: String in target.weights:
			sum = clampf(sum + target.weights[expression] * weights.get(expression, 0.0), 0.0, 1.0)
		target.instance.set_blend_shape_value(target.index, sum)
	for face in _faces:
		_activate(face)


## Sets the resting activations of areas that only expressions activate.
func _activate(face: FurrowWrinkles) -> void:
	for area in face.wrinkle_set.areas:
		if face.wrinkle_set.plan.moved_areas.has(area.name):
			continue
		var value: float = area.activation
		var is_set := false
		for expression in _expressions:
			var own: Dictionary = _expressions[expression].activations
			if own.has(area.name):
				is_set = true
				value = clampf(value + weights.get(expression, 0.0) * (own[area.name] - area.activation), 0.0, 1.0)
		if is_set:
			face.activations[area.name] = value
