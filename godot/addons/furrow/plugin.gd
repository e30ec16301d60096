@tool
extends EditorPlugin
## Reads wrinkles when the editor imports files, and adds an autoload that does the same in the running project.

const AUTOLOAD := "FurrowWrinkleMaps"


func _enable_plugin() -> void:
	add_autoload_singleton(AUTOLOAD, "res://addons/furrow/autoload.gd")


func _disable_plugin() -> void:
	remove_autoload_singleton(AUTOLOAD)


func _enter_tree() -> void:
	FurrowGltfExtension.register()


func _exit_tree() -> void:
	FurrowGltfExtension.unregister()
