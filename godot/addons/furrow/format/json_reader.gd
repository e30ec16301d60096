@tool
class_name FurrowJsonReader
extends RefCounted
## Reads and checks fields of FURROW_wrinkle_maps.
##
## The first problem is kept in [member error]. After a problem, methods return a valid default, so that callers need to
## check [member error] only once.

const MAX_NAME_LENGTH := 256
const MAX_NUMBER := 1000.0
const NAME_RULE := "1 to 256 characters, none of them a control character or a line break"

## Message of the first problem, or an empty string.
var error := ""

var _who: String


func _init(who: String) -> void:
	_who = who


## Returns a message of the form `Module: problem, got VALUE, allowed: LIMIT; remedy`.
static func describe(who: String, problem: String, value: Variant, limit: String, remedy: String) -> String:
	var got := "" if value == null else ", got %s" % JSON.stringify(value).left(120)
	return "%s: %s%s%s; %s" % [who, problem, got, "" if limit == "" else ", allowed: %s" % limit, remedy]


func fail(problem: String, value: Variant, limit: String, remedy: String) -> void:
	if error == "":
		error = describe(_who, problem, value, limit, remedy)


func object(value: Variant, path: String) -> Dictionary:
	if value is Dictionary:
		return value
	fail("%s must be an object" % path, value, "", "write { ... }")
	return {}


func array(value: Variant, path: String, low: int, high: int) -> Array:
	var limit := "%d to %d items" % [low, high]
	if value is not Array:
		fail("%s must be an array" % path, value, limit, "write [ ... ]")
	elif value.size() < low or value.size() > high:
		fail("%s has the wrong number of items" % path, value.size(), limit, "add or remove items")
	else:
		return value
	return []


func number(value: Variant, path: String, low: float, high: float) -> float:
	if (value is float or value is int) and is_finite(value):
		if value >= low and value <= high:
			return value
		fail("%s is out of range" % path, value, "%s..%s" % [low, high], "choose a value inside the range")
	else:
		fail("%s must be a number" % path, value, "%s..%s" % [low, high], "write a plain number")
	return low


func integer(value: Variant, path: String, low: int, high: int) -> int:
	var found := number(value, path, low, high)
	if found != floorf(found):
		fail("%s must be a whole number" % path, value, "%d..%d" % [low, high], "write it without a fraction")
	return int(found)


## Reads text of 1 to 256 characters.
func text(value: Variant, path: String) -> String:
	if value is String and value != "" and value.length() <= MAX_NAME_LENGTH:
		return value
	fail("%s must be text" % path, value, "1 to %d characters" % MAX_NAME_LENGTH, "write it in quotes")
	return ""


## Reads the name of a layer or area.
func name(value: Variant, path: String) -> String:
	if value is String and _is_name(value):
		return value
	fail("%s must be text" % path, value, NAME_RULE, "choose another name")
	return ""


func choice(value: Variant, path: String, allowed: Array) -> String:
	if value is String and allowed.has(value):
		return value
	fail("%s is unknown" % path, value, " or ".join(allowed), "use one of them")
	return ""


static func _is_name(value: String) -> bool:
	if value == "" or value.length() > MAX_NAME_LENGTH:
		return false
	for i in value.length():
		var code := value.unicode_at(i)
		var is_control := code < 0x20 or (code >= 0x7f and code < 0xa0)
		if is_control or code == 0x2028 or code == 0x2029 or (code >= 0xd800 and code < 0xe000):
			return false
	return true
