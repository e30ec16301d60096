@tool
class_name FurrowInfluenceAtlas
extends RefCounted
## Texture with the influence maps of all faces that share a wrinkle set.
##
## Each face has one cell of a grid. A cell stores, for each layer, the sum of `weight * activation` over the areas of the
## layer. The half floats are not clamped, because the sum must be clamped after interpolation. Only cells with a changed
## activation are drawn, at most once per frame.

## Half a step of 8 bits. Smaller changes of an activation are not visible.
const SMALLEST_CHANGE := 1.0 / 510.0

## Combines the areas of one cell. Row `i` of `areas` has the bounds of an area. `drawn` lists areas with an activation.
const CODE := """shader_type canvas_item;
render_mode unshaded, blend_disabled;
uniform sampler2DArray weights : filter_nearest, repeat_disable;
uniform ivec4 bounds[AREAS];
uniform int layers[AREAS];
uniform vec2 drawn[AREAS];
uniform int count = 0;
uniform vec2 corner;
void fragment() {
	ivec2 texel = ivec2(FRAGCOORD.xy - corner);
	vec4 sum = vec4(0.0);
	vec4 largest = vec4(0.0);
	for (int i = 0; i < count; i++) {
		int area = int(drawn[i].x);
		ivec4 inside = bounds[area];
		if (texel.x < inside.x || texel.y < inside.y || texel.x >= inside.z || texel.y >= inside.w) {
			continue;
		}
		float influence = texelFetch(weights, ivec3(texel, area), 0).r * drawn[i].y;
		int layer = layers[area];
		vec4 added = vec4(0.0);
		added[layer % 4] = influence;
		if (layer < 4) {
			sum += added;
		} else {
			largest = max(largest, added);
		}
	}
	COLOR = max(sum, largest);
}
"""

## Texture with all cells.
var texture: RID
var columns := 1
var rows := 1

var _weights: Texture2DArray
## Four numbers per area: the bounds of its weights in texels.
var _bounds := PackedInt32Array()
## Layer of each area, plus 4 for areas that combine by `max`.
var _layers := PackedInt32Array()
var _size: Vector2i
var _viewport: RID
var _canvas: RID
var _shader := Shader.new()
var _cells: Array[Cell] = []
var _changed: Array[Cell] = []
var _visible: Array[Cell] = []


## Rectangle of the atlas with the influence map of one face.
class Cell:
	var index: int
	var item: RID
	var material := ShaderMaterial.new()
	## Activations at the last draw. Empty if the cell must be drawn.
	var drawn := PackedFloat64Array()


func _init(wrinkle_set: FurrowWrinkleSet) -> void:
	# The set is not kept, because it refers to this object.
	_weights = wrinkle_set.weights
	_size = Vector2i(_weights.get_width(), _weights.get_height())
	for rect in wrinkle_set.bounds:
		_bounds.append_array([rect.position.x, rect.position.y, rect.end.x, rect.end.y])
	for area in wrinkle_set.areas:
		_layers.append(area.layer + (4 if area.combine == "max" else 0))
	_shader.code = CODE.replace("AREAS", str(_layers.size()))
	_canvas = RenderingServer.canvas_create()
	_viewport = RenderingServer.viewport_create()
	RenderingServer.viewport_set_disable_3d(_viewport, true)
	RenderingServer.viewport_set_use_hdr_2d(_viewport, true)
	RenderingServer.viewport_set_transparent_background(_viewport, true)
	RenderingServer.viewport_set_clear_mode(_viewport, RenderingServer.VIEWPORT_CLEAR_NEVER)
	RenderingServer.viewport_set_update_mode(_viewport, RenderingServer.VIEWPORT_UPDATE_DISABLED)
	RenderingServer.viewport_attach_canvas(_viewport, _canvas)
	RenderingServer.viewport_set_size(_viewport, _size.x, _size.y)
	RenderingServer.viewport_set_active(_viewport, true)
	texture = RenderingServer.viewport_get_texture(_viewport)


func _notification(what: int) -> void:
	if what == NOTIFICATION_PREDELETE:
		for cell in _cells:
			if cell != null:
				RenderingServer.free_rid(cell.item)
		RenderingServer.free_rid(_viewport)
		RenderingServer.free_rid(_canvas)


## Allocates a cell. The grid may grow, so the places of all cells may change.
## [param viewport] is the viewport that shows the face. Influence maps are drawn before this viewport.
func add(viewport: RID) -> Cell:
	RenderingServer.viewport_set_parent_viewport(_viewport, viewport)
	var cell := Cell.new()
	cell.index = _cells.find(null)
	if cell.index < 0:
		cell.index = _cells.size()
		_cells.append(null)
	_cells[cell.index] = cell
	cell.material.shader = _shader
	cell.material.set_shader_parameter("weights", _weights)
	cell.material.set_shader_parameter("bounds", _bounds)
	cell.material.set_shader_parameter("layers", _layers)
	cell.item = RenderingServer.canvas_item_create()
	RenderingServer.canvas_item_set_parent(cell.item, _canvas)
	RenderingServer.canvas_item_set_material(cell.item, cell.material.get_rid())
	RenderingServer.canvas_item_set_visible(cell.item, false)
	if _grow():
		for other in _cells:
			if other != null:
				_place(other)
	else:
		_place(cell)
	return cell


func remove(cell: Cell) -> void:
	RenderingServer.free_rid(cell.item)
	_cells[cell.index] = null
	_changed.erase(cell)
	_visible.erase(cell)


## Sets the activations of a face. Draws its cell in the next call of [method draw] if the change is visible.
func update(cell: Cell, activations: PackedFloat64Array) -> void:
	if not _has_moved(activations, cell.drawn):
		return
	cell.drawn = activations.duplicate()
	var drawn := PackedVector2Array()
	for i in activations.size():
		if activations[i] > 0.0:
			drawn.append(Vector2(i, activations[i]))
	cell.material.set_shader_parameter("count", drawn.size())
	drawn.resize(activations.size())
	cell.material.set_shader_parameter("drawn", drawn)
	if not _changed.has(cell):
		_changed.append(cell)


## Draws all changed cells.
func draw() -> void:
	for cell in _visible:
		RenderingServer.canvas_item_set_visible(cell.item, false)
	for cell in _changed:
		RenderingServer.canvas_item_set_visible(cell.item, true)
	if not _changed.is_empty():
		RenderingServer.viewport_set_update_mode(_viewport, RenderingServer.VIEWPORT_UPDATE_ONCE)
	_visible = _changed
	_changed = []


## Returns the centre of a cell's first texel (x, y), and the offset from there to the centre of its last texel (z, w), in
## texture coordinates of the atlas.
func place_of(cell: Cell) -> Vector4:
	var grid := Vector2(columns, rows)
	var size := Vector2(_size)
	var first := (_corner(cell) + Vector2(0.5, 0.5)) / (size * grid)
	var inside := (size - Vector2.ONE) / (size * grid)
	return Vector4(first.x, first.y, inside.x, inside.y)


func _corner(cell: Cell) -> Vector2:
	return Vector2(cell.index % columns * _size.x, cell.index / columns * _size.y)


func _place(cell: Cell) -> void:
	cell.drawn = PackedFloat64Array()
	cell.material.set_shader_parameter("corner", _corner(cell))
	RenderingServer.canvas_item_clear(cell.item)
	RenderingServer.canvas_item_add_rect(cell.item, Rect2(_corner(cell), _size), Color.WHITE)


func _grow() -> bool:
	if columns * rows >= _cells.size():
		return false
	while columns * rows < _cells.size():
		if columns * _size.x <= rows * _size.y:
			columns *= 2
		else:
			rows *= 2
	RenderingServer.viewport_set_size(_viewport, columns * _size.x, rows * _size.y)
	return true


static func _has_moved(activations: PackedFloat64Array, drawn: PackedFloat64Array) -> bool:
	if drawn.size() != activations.size():
		return true
	for i in drawn.size():
		var change := absf(activations[i] - drawn[i])
		# Skin must be exactly smooth at 0.
		if change > SMALLEST_CHANGE or change > 0.0 and (activations[i] == 0.0 or drawn[i] == 0.0):
			return true
	return false
