class_name TestScene
extends SubViewport
## A glTF file in front of a camera, for tests.

var faces: Array[FurrowWrinkles] = []

var _camera := Camera3D.new()
var _light := DirectionalLight3D.new()
var _environment := Environment.new()
var _roots: Array[Node] = []
var _player: FurrowExpressionPlayer


func _init() -> void:
	size = Vector2i(32, 32)
	own_world_3d = true
	render_target_update_mode = SubViewport.UPDATE_ALWAYS
	_environment.background_mode = Environment.BG_COLOR
	_environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	var world_environment := WorldEnvironment.new()
	world_environment.environment = _environment
	_camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	_camera.size = 2.0
	_camera.position.z = 3.0
	for node: Node in [_camera, _light, world_environment]:
		add_child(node)


## Adds copies of a file.
func add_file(bytes: PackedByteArray, copies: int) -> Error:
	var document := GLTFDocument.new()
	var state := GLTFState.new()
	var error := document.append_from_buffer(bytes, "", state)
	if error != OK:
		return error
	var root := document.generate_scene(state)
	for face: FurrowWrinkles in root.find_children("*", "FurrowWrinkles", true, false):
		face.process_callback = FurrowWrinkles.ProcessCallback.MANUAL
	_roots.append(root)
	for i in copies - 1:
		_roots.append(root.duplicate())
	for own in _roots:
		add_child(own)
		for face: FurrowWrinkles in own.find_children("*", "FurrowWrinkles", true, false):
			faces.append(face)
	return OK


## Sets weights, inputs and joints, and runs the drivers once. Returns the activations of each face.
func pose(arguments: Dictionary) -> Array:
	var index := int(arguments.get("face", -1))
	for i in _roots.size():
		if index >= 0 and i != index:
			continue
		for instance: MeshInstance3D in _roots[i].find_children("*", "MeshInstance3D", true, false):
			for k in instance.mesh.get_blend_shape_count():
				var weights: Dictionary = arguments.get("weights", {})
				instance.set_blend_shape_value(k, weights.get(instance.mesh.get_blend_shape_name(k), 0.0))
		_pose_nodes(_roots[i], arguments)
	for i in faces.size():
		if index < 0 or i == index:
			faces[i].inputs.merge(arguments.get("inputs", {}), true)
			faces[i].activations.merge(arguments.get("activations", {}), true)
			faces[i].advance(arguments.get("seconds", 0.0))
	return faces.map(func(face: FurrowWrinkles) -> Dictionary:
		var found := {}
		for area in face.get_area_names():
			found[area] = face.get_activation(area)
		return found)


## Draws the square in diffuse light that shines from a direction, or in ambient light if there is none.
func draw(arguments: Dictionary) -> String:
	var light := {"from": arguments.get("from"), "diffuse_mode": BaseMaterial3D.DIFFUSE_LAMBERT, "specular": 0.0}
	_light.light_energy = arguments.get("energy", 1.0)
	_environment.ambient_light_energy = arguments.get("energy", 1.0)
	return await draw_lit({"light": light, "properties": {}})


## Draws the roughness.
func draw_roughness(_arguments: Dictionary) -> String:
	var shaders := {}
	for face in faces:
		var material: ShaderMaterial = face.get_mesh_instance().get_surface_override_material(0)
		var shader := Shader.new()
		var code := material.shader.code.replace("render_mode ", "render_mode unshaded, ")
		shader.code = code.replace("	ROUGHNESS =", "	ALBEDO = vec3(rough * roughness);\n	ROUGHNESS =")
		shaders[material] = material.shader
		material.shader = shader
	var drawn := await picture()
	for material: ShaderMaterial in shaders:
		material.shader = shaders[material]
	return drawn


func set_mode(arguments: Dictionary) -> void:
	for face in faces:
		face.mode = int(arguments.mode) as FurrowWrinkles.Mode


## Returns the pixels as RGBA, rows from the top, in base64.
func picture(_arguments := {}) -> String:
	await RenderingServer.frame_post_draw
	await RenderingServer.frame_post_draw
	var image := get_texture().get_image()
	image.convert(Image.FORMAT_RGBA8)
	return Marshalls.raw_to_base64(image.get_data())


func _each_material(change: Callable) -> void:
	for root in _roots:
		for instance: MeshInstance3D in root.find_children("*", "MeshInstance3D", true, false):
			for i in instance.mesh.get_surface_count():
				change.call(instance.mesh.surface_get_material(i))
	for face in faces:
		face.refresh_material()


func _pose_nodes(root: Node, arguments: Dictionary) -> void:
	for node: Node3D in root.find_children("*", "Node3D", true, false):
		if node is MeshInstance3D:
			continue
		var q: Array = arguments.get("rotations", {}).get(node.name, [0.0, 0.0, 0.0, 1.0])
		node.quaternion = Quaternion(q[0], q[1], q[2], q[3])
		var translation: Variant = arguments.get("translations", {}).get(node.name)
		if translation != null:
			node.position = Vector3(translation[0], translation[1], translation[2])


## Draws in Godot's own lighting, after a change of the materials.
func draw_lit(arguments: Dictionary) -> String:
	var from: Variant = arguments.light.get("from")
	_light.visible = from != null
	if from != null:
		_light.basis = Basis.looking_at(-Vector3(from[0], from[1], from[2]), Vector3(1, 2, 3))
	_environment.ambient_light_color = Color.BLACK if from != null else Color.WHITE
	_each_material(func(material: StandardMaterial3D) -> void:
		material.diffuse_mode = arguments.light.get("diffuse_mode", BaseMaterial3D.DIFFUSE_BURLEY)
		material.metallic_specular = arguments.light.get("specular", 0.5)
		for property: String in arguments.properties:
			var value: Variant = arguments.properties[property]
			if value is Array:
				value = Color(value[0], value[1], value[2], value[3])
			elif material.get(property) is Vector3:
				value = Vector3.ONE * value
			material.set(property, value))
	return await picture()


func show_only(arguments: Dictionary) -> void:
	for i in _roots.size():
		_roots[i].visible = i == int(arguments.face)


## Returns the number of different textures with weights of areas.
func count_textures(_arguments: Dictionary) -> int:
	var found := {}
	for face in faces:
		found[face.wrinkle_set.weights.get_rid()] = true
	return found.size()


func count_shader_materials(_arguments: Dictionary) -> int:
	return faces.filter(func(face: FurrowWrinkles) -> bool:
		return face.get_mesh_instance().get_active_material(0) is ShaderMaterial).size()


## Sets the blendshapes of all faces to one weight per frame. Returns the number of frames that draw influence maps.
func count_updates(arguments: Dictionary) -> int:
	var viewport: RID = faces[0].wrinkle_set.atlas._viewport
	var counts := [0]
	var count := func() -> void:
		if RenderingServer.viewport_get_update_mode(viewport) == RenderingServer.VIEWPORT_UPDATE_ONCE:
			counts[0] += 1
	# Connected after the add-on, so that it is called after the phases of the frame.
	RenderingServer.frame_pre_draw.connect(count)
	for weight: float in arguments.weights:
		pose({"weights": {"up": weight}})
		await RenderingServer.frame_post_draw
	RenderingServer.frame_pre_draw.disconnect(count)
	return counts[0]


## Sets a blendshape, and returns the picture of the next frame.
func draw_next_frame(arguments: Dictionary) -> String:
	for face in faces:
		face.process_callback = FurrowWrinkles.ProcessCallback.FRAME
		face.get_mesh_instance().set_blend_shape_value(0, arguments.up)
	await RenderingServer.frame_post_draw
	var image := get_texture().get_image()
	image.convert(Image.FORMAT_RGBA8)
	return Marshalls.raw_to_base64(image.get_data())


func count_signals(arguments: Dictionary) -> int:
	var counts := [0]
	faces[0].activations_changed.connect(func() -> void: counts[0] += 1)
	for weight: float in arguments.weights:
		pose({"weights": {"up": weight}})
	return counts[0]


func get_activation(arguments: Dictionary) -> float:
	return faces[0].get_activation(arguments.area)


func play(arguments: Dictionary) -> Dictionary:
	if _player == null:
		_player = FurrowExpressionPlayer.new()
		_roots[0].add_child(_player)
	_player.play(arguments.expression, arguments.seconds)
	faces[0].advance(0.0)
	return {"names": _player.get_expression_names(), "activations": [{"a": faces[0].get_activation("a")}]}


func pose_with_nan(arguments: Dictionary) -> float:
	faces[0].inputs[arguments.input] = NAN
	faces[0].advance(0.0)
	return faces[0].get_activation("a")


## Overrides the material before the face enters the tree. Returns the class and the colour of the material in the tree, and
## after the wrinkles are removed.
func override_material(arguments: Dictionary) -> Dictionary:
	var root := _roots[0]
	var instance := faces[0].get_mesh_instance()
	remove_child(root)
	var material: StandardMaterial3D = instance.mesh.surface_get_material(0).duplicate()
	material.albedo_color = Color.from_string(arguments.color, Color.BLACK)
	instance.set_surface_override_material(0, material)
	add_child(root)
	var shown: ShaderMaterial = instance.get_active_material(0)
	var found := {"shown": [shown.get_class(), shown.get_shader_parameter("albedo").to_html(false)]}
	faces[0].free()
	faces.clear()
	var removed: StandardMaterial3D = instance.get_active_material(0)
	found.removed = [removed.get_class(), removed.albedo_color.to_html(false)]
	return found


## Turns a bone from its rest pose, and returns the activation of an area.
func turn_bone(arguments: Dictionary) -> float:
	var skeleton: Skeleton3D = _roots[0].find_children("*", "Skeleton3D", true, false)[0]
	skeleton.reset_bone_poses()
	var bone := skeleton.find_bone(arguments.joint)
	var axis := Vector3(arguments.axis[0], arguments.axis[1], arguments.axis[2]).normalized()
	var rest := skeleton.get_bone_rest(bone).basis.get_rotation_quaternion()
	skeleton.set_bone_pose_rotation(bone, rest * Quaternion(axis, arguments.angle))
	# Long enough that delayed activations have arrived.
	for i in 10:
		faces[0].advance(100.0)
	return faces[0].get_activation(arguments.area)


## Draws the forehead of a face.
func draw_forehead(_arguments: Dictionary) -> String:
	var bounds := faces[0].get_mesh_instance().get_aabb()
	_camera.position = bounds.get_center() + Vector3(0.0, 0.28 * bounds.size.y, 2.0)
	_camera.size = 0.1
	_light.basis = Basis.looking_at(Vector3(1, -2, -1))
	_environment.ambient_light_color = Color.BLACK
	return await picture()
