@tool
class_name FurrowWrinkleSet
extends Resource
## Layers, areas and drivers of a wrinkled material, as stored in the glTF extension FURROW_wrinkle_maps.
##
## All faces with the material share this resource, its textures and the texture with their influence maps.

## Maps of the fully wrinkled skin: for each layer, its checked JSON.
@export var layers: Array[Dictionary] = []
## Groups of wrinkles that are controlled together: for each area, its checked JSON.
@export var areas: Array[Dictionary] = []
## Rules that set the activations of areas: for each driver, its checked JSON.
@export var drivers: Array[Dictionary] = []

## Weights of the areas, one slice per area.
@export_storage var weights: Texture2DArray
## For each area, the rectangle outside of which its weights are 0, in texels.
@export_storage var bounds: Array[Rect2i] = []
## Weights of areas whose tension is measured, by name of the area.
@export_storage var measured_weights: Dictionary[String, Image] = {}
## Maps of the layers by sampler: `normal`, `base_color`, `roughness`, and `values` with occlusion, blood and onset.
@export_storage var maps: Dictionary[String, Texture2DArray] = {}
## For each sampler, the slice of each layer in the texture array, or -1.
@export_storage var slices: Dictionary[String, PackedInt32Array] = {}
## Whether the maps use TEXCOORD_1.
@export_storage var uses_uv2 := false
## Whether the material's normal map repeats outside 0..1.
@export_storage var repeats_normals := true
## `KHR_texture_transform` of the material's normal map.
@export_storage var uv_transform := Transform2D.IDENTITY

## Drivers in evaluation order.
var plan: FurrowDriverPlan:
	get:
		if plan == null:
			plan = FurrowDriverPlan.new(drivers)
		return plan

## Influence maps of all faces.
var atlas: FurrowInfluenceAtlas:
	get:
		if atlas == null:
			atlas = FurrowInfluenceAtlas.new(self)
		return atlas


func get_area_names() -> PackedStringArray:
	return areas.map(func(area: Dictionary) -> String: return area.name)
