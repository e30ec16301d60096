extends Node
## Runs the commands of the tests in `test/godot`. The page calls `window.godotCommand(id, name, arguments, bytes)`, and gets
## the result by `window.godotResult(id, result)`. Arguments and results are JSON.

var _window := JavaScriptBridge.get_interface("window")
var _callback := JavaScriptBridge.create_callback(_receive)
var _scenes := {}


func _ready() -> void:
	FurrowGltfExtension.register()
	_window.godotCommand = _callback
	_window.godotReady()


func _receive(values: Array) -> void:
	var bytes := PackedByteArray()
	if values[3] != null:
		bytes = JavaScriptBridge.js_buffer_to_packed_byte_array(values[3])
	var result: Variant = await _run(values[1], JSON.parse_string(values[2]), bytes)
	_window.godotResult(values[0], JSON.stringify(result, "", false, true))


func _run(command: String, arguments: Dictionary, bytes: PackedByteArray) -> Variant:
	match command:
		"open":
			var scene: TestScene = FaceScene.new() if arguments.get("is_face", false) else TestScene.new()
			add_child(scene)
			var error := scene.add_file(bytes, int(arguments.copies))
			if error != OK:
				scene.free()
				return {"error": error_string(error)}
			_scenes[int(arguments.id)] = scene
			return {"faces": scene.faces.size()}
		"close":
			_scenes[int(arguments.id)].free()
			_scenes.erase(int(arguments.id))
			return null
		"count_resources":
			await RenderingServer.frame_post_draw
			return Performance.get_monitor(Performance.OBJECT_RESOURCE_COUNT)
		"demo":
			return await _show_demo(arguments)
	return await _scenes[int(arguments.id)].call(command, arguments)


## Moves a slider of the demo. Returns the names of all sliders, and the picture as a PNG file in base64.
func _show_demo(arguments: Dictionary) -> Dictionary:
	var viewport := SubViewport.new()
	viewport.size = Vector2i(480, 360)
	viewport.own_world_3d = true
	viewport.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	add_child(viewport)
	var demo: Node = load("res://demo/demo.tscn").instantiate()
	viewport.add_child(demo)
	var sliders := demo.find_children("*", "HSlider", true, false)
	for slider: HSlider in sliders:
		if slider.name == arguments.expression:
			slider.value = 1.0
	for i in 3:
		await RenderingServer.frame_post_draw
	var png := viewport.get_texture().get_image().save_png_to_buffer()
	viewport.queue_free()
	return {
		"sliders": sliders.map(func(slider: HSlider) -> String: return slider.name),
		"png": Marshalls.raw_to_base64(png),
	}
