@tool
class_name FurrowMuscles
extends RefCounted
## Virtual muscles as blendshapes, from the formulas in FURROW_wrinkle_maps.md (K. Waters, "A Muscle Model for Animating
## Three-Dimensional Facial Expression", SIGGRAPH 1987).


## Adds a blendshape for each muscle that the mesh has no blendshape for. Returns the number of added blendshapes.
static func add_to(mesh: ImporterMesh, muscles: Array[Dictionary]) -> int:
	var names := PackedStringArray()
	for i in mesh.get_blend_shape_count():
		names.append(mesh.get_blend_shape_name(i))
	var added := muscles.filter(func(muscle: Dictionary) -> bool:
		return FurrowTargetNames.find(muscle.name, names).is_empty())
	if added.is_empty():
		return 0
	var surfaces: Array[Dictionary] = []
	for i in mesh.get_surface_count():
		var shapes: Array[Array] = []
		for k in names.size():
			shapes.append(mesh.get_surface_blend_shape_arrays(i, k))
		surfaces.append({
			"primitive": mesh.get_surface_primitive_type(i),
			"arrays": mesh.get_surface_arrays(i),
			"shapes": shapes,
			"material": mesh.get_surface_material(i),
			"name": mesh.get_surface_name(i),
			"format": mesh.get_surface_format(i),
		})
	mesh.clear()
	for name in names:
		mesh.add_blend_shape(name)
	for muscle in added:
		mesh.add_blend_shape(muscle.name)
	for surface in surfaces:
		for muscle in added:
			surface.shapes.append(_shape(surface.arrays, muscle))
		mesh.add_surface(surface.primitive, surface.arrays, surface.shapes, {}, surface.material, surface.name,
				surface.format & ~Mesh.ARRAY_FLAG_COMPRESS_ATTRIBUTES)
	return added.size()


## Returns the arrays of a surface at full contraction.
static func _shape(arrays: Array, muscle: Dictionary) -> Array:
	var positions: PackedVector3Array = arrays[Mesh.ARRAY_VERTEX].duplicate()
	for i in positions.size():
		positions[i] += offset(muscle, positions[i])
	var shape := []
	shape.resize(Mesh.ARRAY_MAX)
	shape[Mesh.ARRAY_VERTEX] = positions
	shape[Mesh.ARRAY_NORMAL] = arrays[Mesh.ARRAY_NORMAL]
	shape[Mesh.ARRAY_TANGENT] = arrays[Mesh.ARRAY_TANGENT]
	return shape


## Returns the displacement of a vertex at full contraction.
static func offset(muscle: Dictionary, position: Vector3) -> Vector3:
	var from: Vector3 = position - muscle.origin
	var axis: Vector3 = muscle.insertion - muscle.origin
	var length := axis.length()
	var along := axis / length
	var height := from.dot(along)
	var radius := (from - along * height).length()
	match muscle.kind:
		"sheet":
			if height <= 0.0 or height >= muscle.outer * length or radius >= muscle.width:
				return Vector3.ZERO
			return -muscle.strength * axis * cos(PI / 2.0 * radius / muscle.width) * _pull(muscle, height / length)
		"sphincter":
			return -muscle.strength * from * _fall_off(muscle, Vector2(height / length, radius / muscle.width).length())
	var distance := from.length()
	if distance == 0.0:
		return Vector3.ZERO
	var edge := cos(muscle.angle)
	var inside := maxf(0.0, (height / distance - edge) / (1.0 - edge))
	return -muscle.strength * from * inside * _pull(muscle, distance / length)


static func _pull(muscle: Dictionary, distance: float) -> float:
	return _fall_off(muscle, distance) if distance > muscle.inner else sin(PI / 2.0 * distance / muscle.inner)


static func _fall_off(muscle: Dictionary, distance: float) -> float:
	if distance <= muscle.inner:
		return 1.0
	if distance >= muscle.outer:
		return 0.0
	return cos(PI / 2.0 * (distance - muscle.inner) / (muscle.outer - muscle.inner))
