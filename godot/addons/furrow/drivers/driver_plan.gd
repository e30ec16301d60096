@tool
class_name FurrowDriverPlan
extends RefCounted
## The drivers of a wrinkle set, sorted for evaluation.

## Inputs that drivers read: dictionaries with `kind` (`target`, `joint`, `tension` or `value`) and fields that depend on
## the kind. Equal inputs are listed once.
var inputs: Array[Dictionary] = []
## For each conflict, the indices of its two inputs.
var conflicts: Array[Vector2i] = []
## Drivers that add to an area, in evaluation order. Drivers that read no area come first, in the order of the file.
var activations: Array[Activation] = []
## For each delayed area, its last driver of type `time`.
var delays: Dictionary[String, Dictionary] = {}
## Areas that blendshapes, joints, tension or other areas drive.
var moved_areas: Dictionary[String, bool] = {}
## Areas that depend on themselves. Their drivers of type `area` are skipped.
var cyclic_areas := PackedStringArray()


## A driver that adds to the activation of an area.
class Activation:
	var area: String
	## Indices of inputs. Drivers that read areas have [member areas] instead.
	var inputs := PackedInt32Array()
	var areas := PackedStringArray()
	var weights := PackedFloat64Array()
	## For each link, the points of its curve. Links without a curve have an empty array.
	var link_curves: Array[PackedFloat64Array] = []
	var rule := "sum"
	var curve: PackedFloat64Array


func _init(drivers: Array[Dictionary]) -> void:
	var readers: Array[Activation] = []
	for driver in drivers:
		match driver.type:
			"conflict":
				var pair: Array = Array(driver.targets).map(func(name: String) -> int:
					return _input({"kind": "target", "name": name}))
				conflicts.append(Vector2i(pair[0], pair[1]))
			"morph":
				var links: Array = driver.targets.map(func(link: Dictionary) -> Dictionary:
					return {"kind": "target", "name": link.name})
				activations.append(_linked(driver, links, driver.targets))
			"area":
				var activation := _linked(driver, [], driver.areas)
				for link: Dictionary in driver.areas:
					activation.areas.append(link.name)
				readers.append(activation)
			"bone":
				activations.append(_single(driver, driver.merged({"kind": "joint"})))
			"tension":
				activations.append(_single(driver, driver.merged({"kind": "tension"})))
			"muscle" when driver.has("area"):
				var muscle := driver.merged({"curve": PackedFloat64Array([0.0, 0.0, 1.0, 1.0])})
				activations.append(_single(muscle, {"kind": "target", "name": driver.name}))
			"age":
				activations.append(_single(driver, {"kind": "value", "name": "age", "initial": _initial_age(drivers)}))
			"input":
				activations.append(_single(driver, {"kind": "value", "name": driver.name, "initial": 0.0}))
			"time":
				delays[driver.area] = driver
	_add_sorted(readers)
	for activation in activations:
		if Array(activation.inputs).all(func(input: int) -> bool: return inputs[input].kind == "value"):
			if activation.areas.is_empty():
				continue
		moved_areas[activation.area] = true


func _single(driver: Dictionary, input: Dictionary) -> Activation:
	return _linked(driver, [input], [{"weight": 1.0, "curve": PackedFloat64Array()}])


func _linked(driver: Dictionary, read: Array, links: Array) -> Activation:
	var activation := Activation.new()
	activation.area = driver.area
	activation.rule = driver.get("rule", "sum")
	activation.curve = driver.curve
	for input: Dictionary in read:
		activation.inputs.append(_input(input))
	for link: Dictionary in links:
		activation.weights.append(link.weight)
		activation.link_curves.append(link.curve)
	return activation


func _input(input: Dictionary) -> int:
	var index := inputs.find(input)
	if index < 0:
		inputs.append(input)
		index = inputs.size() - 1
	return index


static func _initial_age(drivers: Array[Dictionary]) -> float:
	var first := drivers.find_custom(func(driver: Dictionary) -> bool: return driver.type == "age")
	return drivers[first].initial


## Appends drivers that read areas, such that the drivers of an area come before the drivers that read this area.
func _add_sorted(readers: Array[Activation]) -> void:
	for reader in readers:
		if not cyclic_areas.has(reader.area) and _reaches(reader.area, reader.area, readers, {}):
			cyclic_areas.append(reader.area)
	var rest := readers.filter(func(own: Activation) -> bool: return not cyclic_areas.has(own.area))
	while not rest.is_empty():
		var pending := rest.map(func(own: Activation) -> String: return own.area)
		var is_ready := func(own: Activation) -> bool:
			return Array(own.areas).all(func(name: String) -> bool: return not pending.has(name))
		activations.append_array(rest.filter(is_ready))
		rest = rest.filter(func(own: Activation) -> bool: return not is_ready.call(own))


static func _reaches(from: String, to: String, readers: Array[Activation], seen: Dictionary) -> bool:
	for reader in readers:
		if reader.area != from:
			continue
		for name in reader.areas:
			if name == to:
				return true
			if not seen.has(name):
				seen[name] = true
				if _reaches(name, to, readers, seen):
					return true
	return false
