@tool
class_name FurrowJointFinder
extends RefCounted
## Finds the joints of drivers in an imported scene.

var _state: GLTFState
var _root: Node


func _init(state: GLTFState, root: Node) -> void:
	_state = state
	_root = root


## Returns the joints of a face's drivers by name. Each has the `path` from the face to a node, the index of its `bone` or
## -1, its `rest` transform in the file, and its `bind` transform if it is a joint of the face's skin.
func find(face: FurrowWrinkles) -> Dictionary[String, Dictionary]:
	var found: Dictionary[String, Dictionary] = {}
	for input in face.wrinkle_set.plan.inputs:
		for name: String in input.joints if input.kind == "joint" else PackedStringArray():
			var joint := {} if found.has(name) else _joint(face, name)
			if not joint.is_empty():
				found[name] = joint
	return found


func _joint(face: FurrowWrinkles, name: String) -> Dictionary:
	var nodes: Array = _state.json.get("nodes", [])
	var index := nodes.find_custom(func(node: Variant) -> bool: return node is Dictionary and node.get("name") == name)
	if index < 0:
		return {}
	var gltf_node := _state.nodes[index]
	var joint := {"bone": -1, "rest": _rest(index)}
	var node: Node = null
	if gltf_node.skeleton >= 0:
		var skeleton := _state.skeletons[gltf_node.skeleton].get_godot_skeleton()
		joint.bone = skeleton.find_bone(gltf_node.resource_name)
		node = skeleton if joint.bone >= 0 else null
		var bind: Variant = _bind(face, index)
		if bind != null:
			joint.bind = bind
	else:
		node = _state.get_scene_node(index)
		if not is_instance_valid(node) or not _root.is_ancestor_of(node) and node != _root:
			# Godot has replaced the nodes of meshes.
			node = _root.find_child(gltf_node.resource_name, true, false)
	if node == null:
		return {}
	joint.path = face.get_path_to(node)
	return joint


## Returns the transform of a node in the file, relative to the scene.
func _rest(index: int) -> Transform3D:
	var rest := _state.nodes[index].xform
	var parent := _state.nodes[index].parent
	while parent >= 0:
		rest = _state.nodes[parent].xform * rest
		parent = _state.nodes[parent].parent
	return rest


## Returns the rest pose that the face's skin defines for a joint, or null.
func _bind(face: FurrowWrinkles, index: int) -> Variant:
	var skin: Skin = face.get_parent().get("skin")
	for own in _state.skins:
		var joint := own.joints_original.find(index)
		if skin != null and own.godot_skin == skin and joint >= 0 and joint < own.inverse_binds.size():
			return (own.inverse_binds[joint] as Transform3D).affine_inverse()
	return null
