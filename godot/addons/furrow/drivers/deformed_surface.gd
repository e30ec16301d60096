@tool
class_name FurrowDeformedSurface
extends RefCounted
## Positions of the vertices of a surface after blendshapes and skinning.

## Positions in the rest pose.
var rest: PackedVector3Array
var uvs: PackedVector2Array

var _instance: MeshInstance3D
var _indices: PackedInt32Array
var _shapes: Array[PackedVector3Array] = []
var _bones: PackedInt32Array
var _weights: PackedFloat32Array
var _influences := 0


func _init(instance: MeshInstance3D, surface: int, uses_uv2: bool) -> void:
	_instance = instance
	var mesh := instance.mesh as ArrayMesh
	var arrays := mesh.surface_get_arrays(surface)
	rest = arrays[Mesh.ARRAY_VERTEX]
	var coordinates: Variant = arrays[Mesh.ARRAY_TEX_UV2 if uses_uv2 else Mesh.ARRAY_TEX_UV]
	uvs = coordinates if coordinates != null else PackedVector2Array()
	uvs.resize(rest.size())
	_indices = arrays[Mesh.ARRAY_INDEX] if arrays[Mesh.ARRAY_INDEX] != null else PackedInt32Array(range(rest.size()))
	var is_relative := mesh.blend_shape_mode == Mesh.BLEND_SHAPE_MODE_RELATIVE
	for shape: Array in mesh.surface_get_blend_shape_arrays(surface):
		var offsets: PackedVector3Array = shape[Mesh.ARRAY_VERTEX].duplicate()
		if not is_relative:
			for i in offsets.size():
				offsets[i] -= rest[i]
		_shapes.append(offsets)
	if arrays[Mesh.ARRAY_BONES] != null and instance.skin != null:
		_bones = arrays[Mesh.ARRAY_BONES]
		_weights = arrays[Mesh.ARRAY_WEIGHTS]
		_influences = _bones.size() / maxi(1, rest.size())


func triangle_count() -> int:
	return _indices.size() / 3


## Returns the indices of the vertices of a triangle.
func triangle(index: int) -> Vector3i:
	return Vector3i(_indices[3 * index], _indices[3 * index + 1], _indices[3 * index + 2])


## Returns the current position of a vertex.
func position(vertex: int) -> Vector3:
	var posed := rest[vertex]
	for i in _shapes.size():
		var weight := _instance.get_blend_shape_value(i)
		if weight != 0.0:
			posed += _shapes[i][vertex] * weight
	var skeleton := _instance.get_node_or_null(_instance.skeleton) as Skeleton3D
	if _influences == 0 or skeleton == null:
		return posed
	var skinned := Vector3.ZERO
	for i in range(vertex * _influences, (vertex + 1) * _influences):
		if _weights[i] > 0.0:
			skinned += _bind(skeleton, _bones[i]) * posed * _weights[i]
	return skinned


## Returns the transform of a joint of the skin from the rest pose to the current pose.
func _bind(skeleton: Skeleton3D, index: int) -> Transform3D:
	var skin := _instance.skin
	var name := skin.get_bind_name(index)
	var bone := skeleton.find_bone(name) if name != "" else skin.get_bind_bone(index)
	return skeleton.get_bone_global_pose(bone) * skin.get_bind_pose(index)
