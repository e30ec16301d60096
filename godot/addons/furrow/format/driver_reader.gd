@tool
class_name FurrowDriverReader
extends RefCounted
## Checks drivers of FURROW_wrinkle_maps, and fills in defaults.

const MAX_DRIVERS := 4096
const MAX_LINKS := 1024
const MAX_CURVE_POINTS := 64
const MAX_SECONDS := 60.0
const RULES := ["sum", "max", "min", "product"]
const IDENTITY := [[0.0, 0.0], [1.0, 1.0]]
const TYPES := [
	"age", "area", "bone", "conflict", "expression", "input", "morph", "muscle", "tension", "time",
]

var _reader: FurrowJsonReader
var _areas: PackedStringArray


## Reads the drivers of a material. Malformed drivers are skipped, and their messages are appended to [param errors].
## Drivers of unknown types are skipped too, and their types appended to [param unknown_types].
static func read(json: Variant, areas: PackedStringArray, errors: PackedStringArray,
		unknown_types: PackedStringArray) -> Array[Dictionary]:
	var drivers: Array[Dictionary] = []
	var list := FurrowJsonReader.new(FurrowMapsReader.EXTENSION)
	var items := list.array(json, "drivers", 0, MAX_DRIVERS)
	if list.error != "":
		errors.append(list.error)
	for i in items.size():
		var reading := FurrowDriverReader.new()
		reading._reader = FurrowJsonReader.new(FurrowMapsReader.EXTENSION)
		reading._areas = areas
		var driver := reading._driver(items[i], "drivers[%d]" % i)
		if reading._reader.error != "":
			errors.append(reading._reader.error)
		elif TYPES.has(driver.type):
			drivers.append(driver)
		elif not unknown_types.has(driver.type):
			unknown_types.append(driver.type)
	return drivers


func _driver(item: Variant, at: String) -> Dictionary:
	var json := _reader.object(item, at)
	var type := _reader.text(json.get("type"), "%s.type" % at)
	var driver := {"type": type}
	match type:
		"morph":
			driver.merge({"area": _area(json, at), "targets": _links(json, "targets", at), "rule": _rule(json, at),
					"curve": _curve(json.get("curve", IDENTITY), "%s.curve" % at, 0.0, 1.0)})
		"area":
			driver.merge({"area": _area(json, at), "areas": _links(json, "areas", at, _areas), "rule": _rule(json, at),
					"curve": _curve(json.get("curve", IDENTITY), "%s.curve" % at, 0.0, 1.0)})
		"conflict":
			driver.targets = _names(json, "targets", at)
		"bone":
			driver.merge({"area": _area(json, at), "joints": _names(json, "joints", at),
					"measure": _reader.choice(json.get("measure"), "%s.measure" % at, ["angle", "distance"]),
					"curve": _curve(json.get("curve"), "%s.curve" % at, 0.0, 1.0)})
			if json.has("axis"):
				var axis := _vector(json, "axis", at, 3)
				driver.axis = Vector3(axis[0], axis[1], axis[2])
		"tension":
			driver.merge({"area": _area(json, at),
					"measure": _reader.choice(json.get("measure", "compression"), "%s.measure" % at,
							["compression", "stretch"]),
					"curve": _curve(json.get("curve"), "%s.curve" % at, 0.0, 1.0)})
			if json.has("direction"):
				var direction := _vector(json, "direction", at, 2)
				driver.direction = Vector2(direction[0], direction[1])
		"muscle":
			driver.merge(_muscle(json, at))
		"age":
			driver.merge({"area": _area(json, at), "curve": _curve(json.get("curve"), "%s.curve" % at, 0.0, 1.0),
					"initial": _number(json, "initial", at, -1000.0, 1000.0, 20.0)})
		"input":
			driver.merge({"name": _reader.text(json.get("name"), "%s.name" % at), "area": _area(json, at),
					"curve": _curve(json.get("curve"), "%s.curve" % at, 0.0, 1.0)})
		"time":
			driver.merge({"area": _area(json, at), "attack": _number(json, "attack", at, 0.0, MAX_SECONDS, 0.0),
					"release": _number(json, "release", at, 0.0, MAX_SECONDS, 0.0)})
		"expression":
			driver.merge(_expression(json, at))
	return driver


func _area(json: Dictionary, at: String) -> String:
	return _reader.choice(json.get("area"), "%s.area" % at, _areas)


func _rule(json: Dictionary, at: String) -> String:
	return _reader.choice(json.get("rule", "sum"), "%s.rule" % at, RULES)


func _number(json: Dictionary, field: String, at: String, low: float, high: float, default: float) -> float:
	return _reader.number(json.get(field, default), "%s.%s" % [at, field], low, high)


func _names(json: Dictionary, field: String, at: String) -> PackedStringArray:
	var names := PackedStringArray()
	for item: Variant in _reader.array(json.get(field), "%s.%s" % [at, field], 2, 2):
		names.append(_reader.text(item, "%s.%s[%d]" % [at, field, names.size()]))
	return names


## Reads links. With [param known], only these names are allowed.
func _links(json: Dictionary, field: String, at: String, known: Array = []) -> Array[Dictionary]:
	var links: Array[Dictionary] = []
	for item: Variant in _reader.array(json.get(field), "%s.%s" % [at, field], 1, MAX_LINKS):
		var path := "%s.%s[%d]" % [at, field, links.size()]
		var link := _reader.object(item, path)
		var name: Variant = link.get("name")
		links.append({
			"name": _reader.text(name, path + ".name") if known.is_empty() else _reader.choice(name, path + ".name", known),
			"weight": _number(link, "weight", path, -1000.0, 1000.0, 1.0),
			"curve": _curve(link.curve, path + ".curve", -1000.0, 1000.0) if link.has("curve") else PackedFloat64Array(),
		})
	return links


## Reads a curve as a flat list: input, output, input, output and so on.
func _curve(json: Variant, at: String, low: float, high: float) -> PackedFloat64Array:
	var points := PackedFloat64Array()
	for item: Variant in _reader.array(json, at, 2, MAX_CURVE_POINTS):
		var path := "%s[%d]" % [at, points.size() / 2]
		var point := _reader.array(item, path, 2, 2)
		if point.is_empty():
			return points
		var input := _reader.number(point[0], path + "[0]", -1000.0, 1000.0)
		if points.size() > 0 and input <= points[points.size() - 2]:
			_reader.fail("%s[0] does not increase" % path, input, "more than %s" % points[points.size() - 2],
					"sort the points by their input")
		points.append_array([input, _reader.number(point[1], path + "[1]", low, high)])
	return points


## Reads a vector whose length is not 0.
func _vector(json: Dictionary, field: String, at: String, size: int) -> PackedFloat64Array:
	var path := "%s.%s" % [at, field]
	var vector := PackedFloat64Array()
	for item: Variant in _reader.array(json.get(field), path, size, size):
		vector.append(_reader.number(item, "%s[%d]" % [path, vector.size()], -1000.0, 1000.0))
	vector.resize(size)
	if vector.count(0.0) == size:
		_reader.fail("%s has length zero" % path, json.get(field), "", "write e.g. [1, 0, 0]")
	return vector


func _point(json: Dictionary, field: String, at: String) -> Vector3:
	var path := "%s.%s" % [at, field]
	var items := _reader.array(json.get(field), path, 3, 3)
	var point := Vector3.ZERO
	for i in items.size():
		point[i] = _reader.number(items[i], "%s[%d]" % [path, i], -1000.0, 1000.0)
	return point


func _muscle(json: Dictionary, at: String) -> Dictionary:
	var muscle := {
		"name": _reader.text(json.get("name"), "%s.name" % at),
		"kind": _reader.choice(json.get("kind", "linear"), "%s.kind" % at, ["linear", "sheet", "sphincter"]),
		"origin": _point(json, "origin", at),
		"insertion": _point(json, "insertion", at),
		"angle": _number(json, "angle", at, 0.001, 1.57, 0.5),
		"width": _number(json, "width", at, 0.0001, 1000.0, 0.01),
		"inner": _number(json, "inner", at, 0.0, 10.0, 0.8),
		"outer": _number(json, "outer", at, 0.001, 10.0, 1.2),
		"strength": _number(json, "strength", at, -1.0, 1.0, 0.3),
	}
	if json.has("area"):
		muscle.area = _area(json, at)
	if muscle.origin == muscle.insertion:
		_reader.fail("%s.insertion equals the origin" % at, str(muscle.insertion), "", "move one of the two points")
	if muscle.outer <= muscle.inner:
		_reader.fail("%s.outer is too small" % at, muscle.outer, "more than %s" % muscle.inner,
				"make outer larger than inner")
	return muscle


func _expression(json: Dictionary, at: String) -> Dictionary:
	var expression := {"name": _reader.text(json.get("name"), "%s.name" % at), "targets": {}, "activations": {}}
	for item: Variant in _reader.array(json.get("targets", []), "%s.targets" % at, 0, MAX_LINKS):
		var target := _reader.object(item, "%s.targets" % at)
		expression.targets[_reader.text(target.get("name"), "%s.targets.name" % at)] = \
				_number(target, "weight", "%s.targets" % at, -1000.0, 1000.0, 1.0)
	for item: Variant in _reader.array(json.get("activations", []), "%s.activations" % at, 0, MAX_LINKS):
		var activation := _reader.object(item, "%s.activations" % at)
		expression.activations[_area(activation, "%s.activations" % at)] = \
				_number(activation, "activation", "%s.activations" % at, 0.0, 1.0, 1.0)
	return expression
