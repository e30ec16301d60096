@tool
class_name FurrowInputSources
extends RefCounted
## Sources of the inputs of drivers: weights of blendshapes, joints, and numbers that the application sets.


## Returns the sources of all inputs of a face, with null for inputs that the face lacks.
static func create(face: FurrowWrinkles) -> Array:
	var instance := face.get_mesh_instance()
	var names := PackedStringArray()
	if instance.mesh is ArrayMesh:
		for i in instance.mesh.get_blend_shape_count():
			names.append(instance.mesh.get_blend_shape_name(i))
	return face.wrinkle_set.plan.inputs.map(func(input: Dictionary) -> RefCounted:
		match input.kind:
			"target":
				var indices := FurrowTargetNames.find(input.name, names)
				return null if indices.is_empty() else Target.new(instance, indices)
			"value":
				return Value.new(face, input.name, input.initial)
			"joint":
				return FurrowJointSource.create(face, input)
		return FurrowTensionSource.create(face, input))


## Mean weight of one or two blendshapes.
class Target:
	var _instance: MeshInstance3D
	var _indices: PackedInt32Array

	func _init(instance: MeshInstance3D, indices: PackedInt32Array) -> void:
		_instance = instance
		_indices = indices

	func read() -> float:
		var sum := 0.0
		for index in _indices:
			sum += _instance.get_blend_shape_value(index)
		return sum / _indices.size()


## Number that the application sets in [member FurrowWrinkles.inputs].
class Value:
	var _face: WeakRef
	var _name: String
	var _initial: float

	func _init(face: FurrowWrinkles, name: String, initial: float) -> void:
		_face = weakref(face)
		_name = name
		_initial = initial

	func read() -> float:
		return _face.get_ref().inputs.get(_name, _initial)
