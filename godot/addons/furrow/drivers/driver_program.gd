@tool
class_name FurrowDriverProgram
extends RefCounted
## Computes the activations of one face from its inputs.
##
## A source of an input has a method `read` without parameters. A blendshape that the mesh lacks has no source and counts as
## 0. Drivers with another input that has no source are skipped.

## Names of the areas, in the order of [member activations].
var area_names: PackedStringArray
## Activations, 0..1, in the order of [member area_names].
var activations := PackedFloat64Array()
## Inputs, areas and drivers without effect, as text for a warning.
var missing := PackedStringArray()

var _plan: FurrowDriverPlan
var _sources: Array
var _drivers: Array[FurrowDriverPlan.Activation] = []
## For each driver, the index of its area.
var _areas := PackedInt32Array()
## For each driver, the indices of the areas that it reads.
var _read_areas: Array[PackedInt32Array] = []
var _delayed := PackedInt32Array()
var _last := PackedFloat64Array()
var _last_resting := PackedFloat64Array()
var _has_run := false
var _is_settled := false


## [param sources] has a source for each input of the plan, or null.
func _init(plan: FurrowDriverPlan, names: PackedStringArray, sources: Array) -> void:
	_plan = plan
	area_names = names
	_sources = sources
	activations.resize(names.size())
	for driver in plan.activations:
		var is_complete := true
		for input in driver.inputs:
			if sources[input] == null:
				missing.append("%s of a driver of area \"%s\"" % [_describe(plan.inputs[input]), driver.area])
				is_complete = is_complete and plan.inputs[input].kind == "target"
		if is_complete:
			_drivers.append(driver)
			_areas.append(names.find(driver.area))
			_read_areas.append(PackedInt32Array(Array(driver.areas).map(names.find)))
	for area in plan.delays:
		_delayed.append(names.find(area))
	for area in plan.cyclic_areas:
		missing.append("area \"%s\" (cyclic)" % area)


## Runs the drivers. Returns whether an activation has changed.
func run(resting: PackedFloat64Array, seconds: float) -> bool:
	var values := PackedFloat64Array()
	values.resize(_sources.size())
	for i in _sources.size():
		var value: float = _sources[i].read() if _sources[i] != null else 0.0
		values[i] = 0.0 if is_nan(value) else value
	var is_unchanged := _has_run and values == _last and resting == _last_resting
	if is_unchanged and (_delayed.is_empty() or _is_settled):
		return false
	_last = values.duplicate()
	_last_resting = resting.duplicate()
	_resolve_conflicts(values)
	var found := resting.duplicate()
	for i in _drivers.size():
		var area := _areas[i]
		found[area] = minf(1.0, found[area] + curve_at(_drivers[i].curve, _combine(i, values, found)))
	_delay(found, seconds)
	_has_run = true
	var has_changed := found != activations
	activations = found
	return has_changed


## Evaluates a piecewise-linear curve, which is a list of input, output, input, output and so on.
static func curve_at(points: PackedFloat64Array, input: float) -> float:
	var end := points.size()
	var next := 0
	while next < end and input > points[next]:
		next += 2
	if next == 0:
		return points[1]
	if next == end:
		return points[end - 1]
	var t := (input - points[next - 2]) / (points[next] - points[next - 2])
	return points[next - 1] * (1.0 - t) + points[next + 1] * t


func _resolve_conflicts(values: PackedFloat64Array) -> void:
	for pair in _plan.conflicts:
		if _sources[pair.x] == null or _sources[pair.y] == null:
			continue
		var common := minf(values[pair.x], values[pair.y])
		if common > 0.0:
			values[pair.x] -= common
			values[pair.y] -= common


## Combines the links of a driver by its rule.
func _combine(index: int, values: PackedFloat64Array, found: PackedFloat64Array) -> float:
	var driver := _drivers[index]
	var areas := _read_areas[index]
	var combined := 0.0
	for k in driver.weights.size():
		var value := values[driver.inputs[k]] if areas.is_empty() else found[areas[k]]
		if not driver.link_curves[k].is_empty():
			value = curve_at(driver.link_curves[k], value)
		value *= driver.weights[k]
		if k == 0:
			combined = value
		elif driver.rule == "sum":
			combined += value
		elif driver.rule == "product":
			combined *= value
		elif driver.rule == "max":
			combined = maxf(combined, value)
		else:
			combined = minf(combined, value)
	return combined


## Replaces activations of delayed areas by values that approach them.
func _delay(found: PackedFloat64Array, seconds: float) -> void:
	_is_settled = seconds > 0.0
	if not _has_run:
		return
	for area in _delayed:
		var delay := _plan.delays[area_names[area]]
		var shown := activations[area]
		var difference := found[area] - shown
		var constant: float = delay.attack if difference > 0.0 else delay.release
		if constant > 0.0:
			found[area] = shown + difference * (1.0 - exp(-seconds / constant))
		_is_settled = _is_settled and found[area] == shown


static func _describe(input: Dictionary) -> String:
	match input.kind:
		"target":
			return "target \"%s\"" % input.name
		"joint":
			return "joint \"%s\" or \"%s\"" % [input.joints[0], input.joints[1]]
		"tension":
			return "triangles of area \"%s\"" % input.area
	return "input \"%s\"" % input.name
