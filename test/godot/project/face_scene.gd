class_name FaceScene
extends TestScene
## Copies of a face, for pictures and for benchmarks.

## Blendshapes that move in benchmarks.
const MOVING := [
	"browInnerUp", "browDownLeft", "browDownRight", "noseSneerLeft", "mouthSmileLeft", "jawOpen",
]
const WARM_UP := 4
## Distance between faces of a crowd in metres.
const DISTANCE := 0.3


## Draws a face in the pose, with the camera and with the lamps of `bench/cycles`. Returns a PNG file in base64, and the
## activations.
func draw_shot(arguments: Dictionary) -> Dictionary:
	var shot: Dictionary = arguments.shot
	size = Vector2i(arguments.size, arguments.size)
	msaa_3d = Viewport.MSAA_4X
	_environment.background_color = Color8(40, 40, 40)
	_environment.ambient_light_color = Color(Color.WHITE * arguments.ambient, 1.0).linear_to_srgb()
	_light.visible = false
	for lamp: Dictionary in arguments.lamps:
		var light := DirectionalLight3D.new()
		add_child(light)
		light.light_energy = lamp.strength / PI
		light.basis = Basis.looking_at(-_vector(lamp.from), Vector3(1, 2, 3))
	_camera.projection = Camera3D.PROJECTION_PERSPECTIVE
	_camera.fov = arguments.camera.fov
	_camera.near = 0.01
	_camera.position = _vector(arguments.camera.position)
	_camera.look_at(_vector(arguments.camera.target))
	# Like three.js and Babylon.js.
	_each_material(func(material: StandardMaterial3D) -> void:
		material.texture_filter = BaseMaterial3D.TEXTURE_FILTER_LINEAR_WITH_MIPMAPS_ANISOTROPIC)
	# Long enough that delayed activations have arrived.
	for i in 10:
		pose({"weights": shot.targets, "seconds": 10.0})
	await RenderingServer.frame_post_draw
	await RenderingServer.frame_post_draw
	var png := get_texture().get_image().save_png_to_buffer()
	return {"png": Marshalls.raw_to_base64(png), "activations": pose({"weights": shot.targets})[0]}


## Places all faces before the camera, and shows only meshes with wrinkles.
func prepare_timing(arguments: Dictionary) -> void:
	size = Vector2i(arguments.width, arguments.height)
	var columns := ceili(sqrt(faces.size()))
	var middle := faces[0].get_mesh_instance().get_aabb().get_center()
	for i in _roots.size():
		_roots[i].position = DISTANCE * Vector3(i % columns - (columns - 1) / 2.0, (columns - 1) / 2.0 - i / columns, 0)
		for instance: MeshInstance3D in _roots[i].find_children("*", "MeshInstance3D", true, false):
			instance.visible = faces.any(func(face: FurrowWrinkles) -> bool: return face.get_mesh_instance() == instance)
	for face in faces:
		face.process_callback = FurrowWrinkles.ProcessCallback.FRAME
	_environment.ambient_light_energy = 0.3
	_light.basis = Basis.looking_at(Vector3(1, -1, -2))
	_camera.size = DISTANCE * columns
	_camera.position = middle + Vector3(0, 0, 1)
	_camera.look_at(middle)


## Measures frames in milliseconds. With `moving`, six blendshapes of each face change in each frame.
func time_frames(arguments: Dictionary) -> float:
	for face in faces:
		face.mode = FurrowWrinkles.Mode.DEFAULT if arguments.wrinkled else FurrowWrinkles.Mode.OFF
	var count := int(arguments.frames)
	var start := 0
	for frame in WARM_UP + count:
		if frame == WARM_UP:
			# Reading the picture waits until the GPU has drawn it.
			get_texture().get_image()
			start = Time.get_ticks_usec()
		if arguments.moving or frame == 0:
			_move(frame)
		RenderingServer.force_draw(false)
	get_texture().get_image()
	return (Time.get_ticks_usec() - start) / 1000.0 / count


## Measures the time of the CPU for inputs, drivers and influence maps of all faces, in milliseconds. Returns the time of the
## fastest frame, because other processes only slow frames down.
func time_phases(arguments: Dictionary) -> float:
	for face in faces:
		face.mode = FurrowWrinkles.Mode.DEFAULT
	var fastest := INF
	for frame in int(arguments.frames):
		_move(frame)
		var start := Time.get_ticks_usec()
		FurrowFrame._run()
		fastest = minf(fastest, Time.get_ticks_usec() - start)
	return fastest / 1000.0


## Moves six blendshapes of each face.
func _move(frame: int) -> void:
	for i in faces.size():
		var instance := faces[i].get_mesh_instance()
		for k in MOVING.size():
			var index := instance.find_blend_shape_by_name(MOVING[k])
			instance.set_blend_shape_value(index, 0.5 + 0.5 * sin(frame * 0.37 + i + k * 2.4))


static func _vector(numbers: Array) -> Vector3:
	return Vector3(numbers[0], numbers[1], numbers[2])
