@tool
class_name FurrowTargetNames
extends RefCounted
## Finds blendshapes by name, in the spellings of different rigs.

static var _canonical := {}
static var _prefixes: Array[RegEx] = []
static var _side: RegEx


## Returns the indices of the blendshapes that a name refers to. A blendshape with exactly this name takes precedence over
## other spellings, and these over the left and right halves of a shape.
static func find(name: String, targets: PackedStringArray) -> PackedInt32Array:
	var own := targets.find(name)
	if own >= 0:
		return PackedInt32Array([own])
	var keys := PackedStringArray()
	for target in targets:
		keys.append(_key(canonical(target)))
	var wanted := _key(canonical(name))
	var same := keys.find(wanted)
	if same >= 0:
		return PackedInt32Array([same])
	var halves := PackedInt32Array()
	for side: String in ["left", "right"]:
		var half := keys.find(wanted + side)
		if half >= 0:
			halves.append(half)
	return halves


## Returns the canonical name of a blendshape, e.g. `browOuterUpLeft` for `blendShape1.browOuterUp_L`.
static func canonical(name: String) -> String:
	_prepare()
	var key := _key(name)
	if _canonical.has(key):
		return _canonical[key]
	var plain := name
	for prefix in _prefixes:
		plain = prefix.sub(plain, "")
	plain = _with_side(plain)
	return _canonical.get(_key(plain), plain)


static func _prepare() -> void:
	if _side != null:
		return
	_side = RegEx.create_from_string("[_. -]([LR])$")
	for pattern: String in ["^.*\\.(?=[^.]{2})", "(?i)^M_F\\d+(_\\d+)*_", "(?i)^BS_"]:
		_prefixes.append(RegEx.create_from_string(pattern))
	for names: Array in FurrowTargetAliases.ALIASES:
		for alias: String in names:
			_canonical[_key(alias)] = names[0]


static func _with_side(name: String) -> String:
	var found := _side.search(name)
	if found == null:
		return name
	return name.left(found.get_start()) + ("Left" if found.get_string(1) == "L" else "Right")


## Returns the letters and digits of a name in lower case. Names that differ only in capitals and separators have one key.
static func _key(name: String) -> String:
	var letters := ""
	for character in _with_side(name).to_lower():
		var is_ascii := character.unicode_at(0) < 128
		if is_ascii and not (character.is_valid_int() or character.is_valid_ascii_identifier() and character != "_"):
			continue
		letters += character
	return letters if letters != "" else name
