extends Node
## Reads wrinkles in all glTF files that the running project imports.


func _init() -> void:
	FurrowGltfExtension.register()
