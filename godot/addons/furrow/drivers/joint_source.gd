@tool
class_name FurrowJointSource
extends RefCounted
## Rotation of a joint from its rest pose in radians, or distance between two joints in metres.

## Node of the reference and of the joint: a [Node3D], or a [Skeleton3D] with a bone.
var _nodes: Array[Node3D] = []
## Index of the bone, or -1 if the node itself is meant.
var _bones := PackedInt32Array()
## Rotation of the joint relative to the reference, in the rest pose.
var _rest: Basis
var _input: Dictionary


## Returns null if a joint does not exist.
static func create(face: FurrowWrinkles, input: Dictionary) -> FurrowJointSource:
	var source := FurrowJointSource.new()
	source._input = input
	var rests: Array[Transform3D] = []
	for name: String in input.joints:
		var joint: Dictionary = face.joints.get(name, {})
		var node := face.get_node_or_null(joint.get("path", NodePath())) as Node3D
		if node == null:
			return null
		source._nodes.append(node)
		source._bones.append(joint.bone)
		rests.append(joint.rest)
	if face.joints[input.joints[0]].has("bind") and face.joints[input.joints[1]].has("bind"):
		rests = [face.joints[input.joints[0]].bind, face.joints[input.joints[1]].bind]
	source._rest = _relative(rests[0].basis, rests[1].basis)
	return source


func read() -> float:
	if not is_instance_valid(_nodes[0]) or not is_instance_valid(_nodes[1]):
		return 0.0
	var from := _transform(0)
	var joint := _transform(1)
	if _input.measure == "distance":
		return from.origin.distance_to(joint.origin)
	# The antisymmetric part of the rotation has the vector axis * sin(angle). The trace is 1 + 2 * cos(angle).
	var turn := _rest.transposed() * _relative(from.basis, joint.basis)
	var vector := Vector3(turn.y.z - turn.z.y, turn.z.x - turn.x.z, turn.x.y - turn.y.x) / 2.0
	var cosine := (turn.x.x + turn.y.y + turn.z.z - 1.0) / 2.0
	if _input.has("axis"):
		# Twist about the axis (swing-twist decomposition), with both arguments multiplied by w of the quaternion.
		var along := vector.dot(_input.axis.normalized())
		return 2.0 * atan2(along / 2.0, maxf(0.0, (1.0 + cosine) / 2.0))
	return atan2(vector.length(), cosine)


func _transform(index: int) -> Transform3D:
	var node := _nodes[index]
	if _bones[index] < 0:
		return node.global_transform
	return node.global_transform * (node as Skeleton3D).get_bone_global_pose(_bones[index])


## Returns the rotation of a joint relative to a reference. Scales are ignored.
static func _relative(from: Basis, joint: Basis) -> Basis:
	return _unscaled(from).transposed() * _unscaled(joint)


static func _unscaled(basis: Basis) -> Basis:
	return Basis(basis.x.normalized(), basis.y.normalized(), basis.z.normalized())
