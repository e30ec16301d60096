@tool
class_name FurrowWrinkleShader
extends RefCounted
## Generates shader functions that mix the maps of a wrinkle set into the maps of a material. The formulas are those of
## FURROW_wrinkle_maps.md.

const CHANNELS := "xyzw"

## Samplers of the maps, by name in [member FurrowWrinkleSet.maps].
const SAMPLERS := {
	"normal": "furrow_normals",
	"base_color": "furrow_base_colors",
	"roughness": "furrow_roughnesses",
	"values": "furrow_values",
}

const COORDINATES := """
uniform sampler2D furrow_influence_map : filter_linear, repeat_disable;
uniform vec4 furrow_place;
uniform vec4 furrow_inside;
uniform mat3 furrow_uv_transform;
varying vec2 furrow_coordinates;

// Drops the integer part. Coordinates from 0 to 1 stay unchanged.
vec2 furrow_repeat(vec2 uv) {
	return uv - max(ceil(uv) - 1.0, min(floor(uv), vec2(0.0)));
}

vec4 furrow_sample_influence(vec2 uv) {
	vec2 inside = clamp(uv * furrow_inside.xy + furrow_inside.zw, vec2(0.0), vec2(1.0));
	return min(textureLod(furrow_influence_map, furrow_place.xy + inside * furrow_place.zw, 0.0), vec4(1.0));
}
"""

## Tangents from derivatives, for meshes without tangents (C. Schueler, "Normal Mapping Without Precomputed Tangents", 2013).
const FRAME := """
void furrow_frame(vec3 normal, vec3 dx, vec3 dy, vec2 uv_dx, vec2 uv_dy, out vec3 tangent, out vec3 binormal) {
	vec3 across = cross(dy, normal);
	vec3 along = cross(normal, dx);
	tangent = across * uv_dx.x + along * uv_dy.x;
	binormal = across * uv_dx.y + along * uv_dy.y;
	float size = max(dot(tangent, tangent), dot(binormal, binormal));
	// Renderers may draw upside down, which mirrors the derivatives.
	float scale = size > 0.0 ? inversesqrt(size) * sign(dot(cross(dx, dy), normal)) : 0.0;
	tangent *= scale;
	binormal *= -scale;
}
"""

const ONSET := """
float furrow_onset(float influence, float onset, float strength) {
	float t = clamp(1.0 - (1.0 - influence) / max(1.0 - onset, 1.0 / 255.0), 0.0, 1.0);
	return influence + (t * (2.0 - t) - influence) * strength;
}
"""

## Colour space conversions. The first is that of sRGB (IEC 61966-2-1). The others convert ALBEDO, which is in sRGB in the
## Compatibility renderer. This renderer decodes it by a cubic polynomial, which `furrow_to_albedo` inverts by Newton's method.
const COLOURS := """
vec3 furrow_to_linear(vec3 color) {
	return mix(color / 12.92, pow((color + 0.055) / 1.055, vec3(2.4)), step(vec3(0.04045), color));
}

vec3 furrow_decode(vec3 color) {
	return color * (color * (color * 0.305306011 + 0.682171111) + 0.012522878);
}

vec3 furrow_from_albedo(vec3 color, bool is_srgb) {
	return is_srgb ? furrow_decode(color) : color;
}

vec3 furrow_to_albedo(vec3 color, bool is_srgb) {
	if (!is_srgb) {
		return color;
	}
	vec3 root = sqrt(color);
	for (int i = 0; i < 3; i++) {
		root -= (furrow_decode(root) - color) / (root * (root * 0.915918033 + 1.364342222) + 0.012522878);
	}
	return root;
}
"""

## Samples a base colour map. Colours are converted before interpolation, which texture filters do not do here.
const SAMPLE_COLOR := """
vec3 furrow_sample_color(int slice, vec2 uv, vec2 dx, vec2 dy) {
	ivec2 size = textureSize(furrow_base_colors, 0).xy;
	vec2 texel = clamp(uv * vec2(size) - 0.5, vec2(0.0), vec2(size - 1));
	ivec2 first = ivec2(texel);
	ivec2 second = min(first + 1, size - 1);
	vec2 part = texel - vec2(first);
	vec3 top = mix(furrow_to_linear(texelFetch(furrow_base_colors, ivec3(first, slice), 0).rgb),
			furrow_to_linear(texelFetch(furrow_base_colors, ivec3(second.x, first.y, slice), 0).rgb), part.x);
	vec3 bottom = mix(furrow_to_linear(texelFetch(furrow_base_colors, ivec3(first.x, second.y, slice), 0).rgb),
			furrow_to_linear(texelFetch(furrow_base_colors, ivec3(second, slice), 0).rgb), part.x);
	vec3 filtered = textureGrad(furrow_base_colors, vec3(uv, float(slice)), dx, dy).rgb;
	float texels = max(length(dx * vec2(size)), length(dy * vec2(size)));
	return mix(mix(top, bottom, part.y), furrow_to_linear(filtered), clamp(log2(texels), 0.0, 1.0));
}
"""

const BLOOD := """
float furrow_blood(float stored) {
	float steps = stored * 255.0 - 128.0;
	return abs(steps) < 0.01 ? 0.0 : max(steps / 127.0, -1.0);
}
"""

## Values that fragment() passes to [constant LIGHT].
const LIGHT_INPUTS := "varying float furrow_visibility;\nvarying float furrow_specular;\n"

## Lighting with the formulas of Godot (Burley or Lambert, and GGX), with highlights that wrinkles shadow (D. Chan, "Material
## Advances in Call of Duty: WWII", 2018).
const LIGHT := """
float furrow_fresnel(float cosine) {
	return pow(1.0 - cosine, 5.0);
}

void light() {
	float n_dot_l = clamp(dot(NORMAL, LIGHT), 0.0, 1.0);
	float n_dot_v = max(dot(NORMAL, VIEW), 1e-4);
	vec3 middle = normalize(VIEW + LIGHT);
	float n_dot_h = clamp(dot(NORMAL, middle), 0.0, 1.0);
	float l_dot_h = clamp(dot(LIGHT, middle), 0.0, 1.0);
	float diffuse = n_dot_l / PI;
	BURLEY
	DIFFUSE_LIGHT += LIGHT_COLOR * diffuse * ATTENUATION;
	if (ROUGHNESS > 0.0) {
		float alpha = ROUGHNESS * ROUGHNESS;
		float a = n_dot_h * alpha;
		float k = alpha / (1.0 - n_dot_h * n_dot_h + a * a);
		float geometry = 0.5 / mix(2.0 * n_dot_l * n_dot_v, n_dot_l + n_dot_v, alpha);
		vec3 f0 = mix(vec3(0.16 * furrow_specular * furrow_specular), ALBEDO, METALLIC);
		vec3 reflected = f0 + (clamp(50.0 * f0.g, METALLIC, 1.0) - f0) * furrow_fresnel(l_dot_h);
		float cone = 1.0 - furrow_visibility;
		float visible = n_dot_l * n_dot_l < cone ? n_dot_l * n_dot_l / cone : 1.0;
		SPECULAR_LIGHT += n_dot_l * k * k / PI * geometry * reflected * LIGHT_COLOR * ATTENUATION * SPECULAR_AMOUNT * visible;
	}
}
"""

const BURLEY := """float grazing = 2.0 * l_dot_h * l_dot_h * ROUGHNESS - 0.5;
	diffuse *= (1.0 + grazing * furrow_fresnel(n_dot_v)) * (1.0 + grazing * furrow_fresnel(n_dot_l));"""

var _set: FurrowWrinkleSet
## Whether texture coordinates wrap around.
var _is_tiled: bool


func _init(wrinkle_set: FurrowWrinkleSet, is_tiled: bool) -> void:
	_set = wrinkle_set
	_is_tiled = is_tiled


func has_maps(slot: String) -> bool:
	return _set.layers.any(func(layer: Dictionary) -> bool: return layer.has(slot))


## Returns declarations for the start of the shader. [param filter] is the filter of the material's textures.
func declarations(filter: String) -> String:
	var code := COORDINATES + FRAME + COLOURS
	for kind: String in _set.maps:
		code += "uniform sampler2DArray %s : %s, repeat_disable;\n" % [SAMPLERS[kind], filter]
	if has_maps("onsetTexture"):
		code += ONSET
	if has_maps("baseColorTexture"):
		code += SAMPLE_COLOR
	if has_maps("bloodTexture"):
		code += BLOOD
	return code


## Returns statements for the start of fragment(). They compute `furrow_uv`, its derivatives `furrow_dx` and `furrow_dy`, the
## influence `i0`, `i1` and so on of each layer, and the texel `values0` and so on of each layer with occlusion, blood or onset.
func influence() -> String:
	var code := """	vec2 furrow_dx = dFdx(furrow_coordinates);
	vec2 furrow_dy = dFdy(furrow_coordinates);
	vec2 furrow_uv = %s;
	vec4 furrow_influence = furrow_sample_influence(furrow_uv);
""" % ("furrow_repeat(furrow_coordinates)" if _is_tiled else "furrow_coordinates")
	for i in _set.layers.size():
		if _slice("values", i) >= 0:
			code += "	vec4 values%d = %s;\n" % [i, _sample("values", i)]
		code += "	float i%d = furrow_influence.%s;\n" % [i, CHANNELS[i]]
		var onset: Dictionary = _set.layers[i].get("onsetTexture", {})
		if not onset.is_empty():
			code += "	i%d = furrow_onset(i%d, values%d.g, %s);\n" % [i, i, i, _float(onset.strength)]
	return code


## Returns statements that mix the normals of all layers into `furrow_normal`, which has the normal of the material.
func normals() -> String:
	var code := ""
	var replacing := PackedInt32Array()
	var slopes := PackedStringArray()
	for i in _set.layers.size():
		code += "	vec3 n%d = %s.xyz * 2.0 - 1.0;\n" % [i, _sample("normal", i)]
		code += "	n%d.xy *= %s;\n" % [i, _float(_set.layers[i].normalTexture.scale)]
		if _set.layers[i].kind == "replace":
			replacing.append(i)
		else:
			slopes.append("i%d * n%d.xy / max(n%d.z, 1e-4)" % [i, i, i])
	var mixed := replacing.duplicate()
	if not mixed.is_empty():
		code += "	furrow_normal += %s;\n" % _mixed(replacing, "(n%d - furrow_normal)")
	if not slopes.is_empty():
		code += """	vec2 slope = %s;
	if (slope != vec2(0.0)) {
		vec3 base = normalize(furrow_normal);
		vec3 detail = normalize(vec3(slope, 1.0)) * vec3(-1.0, -1.0, 1.0);
		vec3 between = base + vec3(0.0, 0.0, 1.0);
		furrow_normal = between * dot(between, detail) / between.z - detail;
	}
""" % " + ".join(slopes)
	return code


## Returns a statement that mixes the layers' base colours into a variable with an sRGB or linear colour.
func base_color(variable: String) -> String:
	var layers := _with("baseColorTexture")
	if layers.is_empty():
		return ""
	var code := "	if (%s > 0.0) {\n" % _total(layers)
	code += "		vec3 own = furrow_from_albedo(%s, OUTPUT_IS_SRGB);\n" % variable
	for i in layers:
		code += "		vec3 c%d = furrow_sample_color(%d, furrow_uv, furrow_dx, furrow_dy);\n" % [i, _slice("base_color", i)]
	code += "		own += %s;\n" % _mixed(layers, "(c%d - own)")
	return code + "		%s = furrow_to_albedo(own, OUTPUT_IS_SRGB);\n	}\n" % variable


## Returns a statement that mixes the layers' roughness into a variable.
func roughness(variable: String) -> String:
	var layers := _with("roughnessTexture")
	var code := ""
	for i in layers:
		code += "	float r%d = %s.g;\n" % [i, _sample("roughness", i)]
	return code + _added(variable, layers, "(r%%d - %s)" % variable)


## Returns a statement that mixes the layers' occlusion into a variable.
func occlusion(variable: String) -> String:
	var layers := _with("occlusionTexture")
	var code := ""
	for i in layers:
		var strength: float = _set.layers[i].occlusionTexture.strength
		code += "	float %s_o%d = 1.0 + %s * (values%d.r - 1.0);\n" % [variable.to_lower(), i, _float(strength), i]
	return code + _added(variable, layers, "(%s_o%%d - %s)" % [variable.to_lower(), variable])


## Returns statements that change ALBEDO by blood.
func blood() -> String:
	var layers := _with("bloodTexture")
	if layers.is_empty():
		return ""
	var code := ""
	for i in layers:
		var amplitude: float = _set.layers[i].bloodTexture.amplitude
		code += "	float b%d = furrow_blood(values%d.b) * %s;\n" % [i, i, _float(amplitude)]
	return code + """	float blood = %s;
	if (blood != 0.0) {
		vec3 skin = furrow_from_albedo(ALBEDO, OUTPUT_IS_SRGB) * exp(-blood * vec3(0.35, 1.0, 0.89));
		ALBEDO = furrow_to_albedo(skin, OUTPUT_IS_SRGB);
	}
""" % _mixed(layers, "b%d")


func _with(slot: String) -> PackedInt32Array:
	var found := PackedInt32Array()
	for i in _set.layers.size():
		if _set.layers[i].has(slot):
			found.append(i)
	return found


func _slice(kind: String, layer: int) -> int:
	return _set.slices[kind][layer] if _set.slices.has(kind) else -1


func _sample(kind: String, layer: int) -> String:
	var place := "vec3(furrow_uv, %s)" % _float(_slice(kind, layer))
	# Derivatives before wrapping, because wrapped coordinates jump. Without wrapping, `texture` is faster.
	return ("textureGrad(%s, %s, furrow_dx, furrow_dy)" if _is_tiled else "texture(%s, %s)") % [SAMPLERS[kind], place]


static func _total(layers: PackedInt32Array) -> String:
	return " + ".join(Array(layers).map(func(i: int) -> String: return "i%d" % i))


## Returns the sum of values times influences. Influences that sum to more than 1 are divided by their sum.
static func _mixed(layers: PackedInt32Array, value: String) -> String:
	var terms := Array(layers).map(func(i: int) -> String: return "%s * i%d" % [value % i, i])
	var sum := "(%s)" % " + ".join(terms)
	return sum if layers.size() == 1 else "%s / max(1.0, %s)" % [sum, _total(layers)]


static func _added(variable: String, layers: PackedInt32Array, value: String) -> String:
	return "" if layers.is_empty() else "	%s += %s;\n" % [variable, _mixed(layers, value)]


## Returns a number as a literal of the shading language.
static func _float(value: float) -> String:
	return "%.9f" % value
