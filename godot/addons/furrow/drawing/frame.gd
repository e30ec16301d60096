@tool
class_name FurrowFrame
extends RefCounted
## Runs the phases of all faces before each frame is drawn. Each phase finishes for all faces before the next begins.

static var _faces: Array[FurrowWrinkles] = []


static func add(face: FurrowWrinkles) -> void:
	if _faces.is_empty():
		RenderingServer.frame_pre_draw.connect(FurrowFrame._run)
	_faces.append(face)


static func remove(face: FurrowWrinkles) -> void:
	_faces.erase(face)
	if _faces.is_empty():
		RenderingServer.frame_pre_draw.disconnect(FurrowFrame._run)


static func _run() -> void:
	var changed: Array[FurrowWrinkles] = []
	for face in _faces:
		if face.process_callback == FurrowWrinkles.ProcessCallback.FRAME and face.is_drawn() and face.run_drivers():
			changed.append(face)
	var atlases := {}
	for face in _faces:
		atlases[face.wrinkle_set.atlas] = true
		face.update_influence()
	for atlas: FurrowInfluenceAtlas in atlases:
		atlas.draw()
	for face in changed:
		face.activations_changed.emit()
