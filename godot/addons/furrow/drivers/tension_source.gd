@tool
class_name FurrowTensionSource
extends RefCounted
## Mean compression or stretch of the skin of an area, measured on sampled triangles.

const SAMPLES := 16

var _surfaces: Array[FurrowDeformedSurface] = []
var _is_stretch: bool
## For each sampled triangle: surface, three vertices, and the three numbers of [method _rest_matrix].
var _triangles: Array[Array] = []


## Returns null if the area covers no triangles.
static func create(face: FurrowWrinkles, input: Dictionary) -> FurrowTensionSource:
	var source := FurrowTensionSource.new()
	source._is_stretch = input.measure == "stretch"
	source._sample(face, input)
	return null if source._triangles.is_empty() else source


func read() -> float:
	var sum := 0.0
	for triangle in _triangles:
		var surface: FurrowDeformedSurface = _surfaces[triangle[0]]
		var a := surface.position(triangle[1])
		var u := surface.position(triangle[2]) - a
		var v := surface.position(triangle[3]) - a
		sum += _stretch_of(triangle[4], u, v) - 1.0 if _is_stretch else 1.0 - _stretch_of(triangle[4], u, v)
	return sum / _triangles.size()


## Returns the larger or smaller principal stretch: the square root of an eigenvalue of the right Cauchy-Green tensor.
func _stretch_of(rest: Vector3, u: Vector3, v: Vector3) -> float:
	var first := u * rest.x
	var second := u * rest.y + v * rest.z
	var xx := first.length_squared()
	var yy := second.length_squared()
	var xy := first.dot(second)
	if rest.x == 0.0:
		return sqrt(yy)
	var mean := (xx + yy) / 2.0
	var radius := sqrt((xx - yy) * (xx - yy) / 4.0 + xy * xy)
	return sqrt(mean + radius) if _is_stretch else sqrt(maxf(0.0, mean - radius))


func _sample(face: FurrowWrinkles, input: Dictionary) -> void:
	var weights: Image = face.wrinkle_set.measured_weights.get(input.area)
	var instance := face.get_mesh_instance()
	if weights == null or instance.mesh is not ArrayMesh:
		return
	var covered := PackedFloat64Array()
	var corners: Array[Array] = []
	var total := 0.0
	for index in face.surfaces:
		var surface := FurrowDeformedSurface.new(instance, index, face.wrinkle_set.uses_uv2)
		_surfaces.append(surface)
		for k in surface.triangle_count():
			var triangle := surface.triangle(k)
			total += _coverage(surface, triangle, weights, face.wrinkle_set.uv_transform)
			covered.append(total)
			corners.append([_surfaces.size() - 1, triangle.x, triangle.y, triangle.z])
	if not total > 0.0:
		return
	var k := 0
	for i in SAMPLES:
		while covered[k] < (i + 0.5) / SAMPLES * total:
			k += 1
		var corner := corners[k]
		var rest: Variant = _rest_matrix(_surfaces[corner[0]], Vector3i(corner[1], corner[2], corner[3]), input,
				face.wrinkle_set.uv_transform)
		if rest != null:
			_triangles.append(corner + [rest])


## Returns the weight at the centroid of a triangle times its area at rest.
static func _coverage(surface: FurrowDeformedSurface, triangle: Vector3i, weights: Image, transform: Transform2D) -> float:
	var uv := transform * ((surface.uvs[triangle.x] + surface.uvs[triangle.y] + surface.uvs[triangle.z]) / 3.0)
	uv -= uv.floor()
	var texel := (Vector2i(uv * Vector2(weights.get_size()))).min(weights.get_size() - Vector2i.ONE)
	var a := surface.rest[triangle.x]
	var size := (surface.rest[triangle.y] - a).cross(surface.rest[triangle.z] - a).length() / 2.0
	return weights.get_pixelv(texel).r * size if is_finite(size) else 0.0


## Returns the elements xx, xy and yy of the inverse of the matrix of two edges, in coordinates of the triangle's plane. With
## a direction, returns 0 and the factors of the edges whose sum is a unit vector in this direction. Returns null for
## degenerate triangles.
static func _rest_matrix(surface: FurrowDeformedSurface, triangle: Vector3i, input: Dictionary,
		transform: Transform2D) -> Variant:
	var a := surface.rest[triangle.x]
	var u := surface.rest[triangle.y] - a
	var v := surface.rest[triangle.z] - a
	var along := u.length()
	var across := u.dot(v) / along
	var height := sqrt(maxf(0.0, v.length_squared() - across * across))
	var matrix := Vector3(1.0 / along, -across / (along * height), 1.0 / height)
	if input.has("direction") and matrix.is_finite():
		var first := transform.basis_xform(surface.uvs[triangle.y] - surface.uvs[triangle.x])
		var second := transform.basis_xform(surface.uvs[triangle.z] - surface.uvs[triangle.x])
		var factors := Vector2(input.direction.cross(second), first.cross(input.direction))
		if first.cross(second) == 0.0:
			return null
		var length := (u * factors.x + v * factors.y).length()
		matrix = Vector3(0.0, factors.x / length, factors.y / length)
	return matrix if matrix.is_finite() else null
