@tool
class_name FurrowMaterialConverter
extends RefCounted
## Converts a [StandardMaterial3D] or [ORMMaterial3D] to a [ShaderMaterial] that looks the same and mixes in wrinkles.

const WHO := "FurrowMaterialConverter"
const META := &"furrow_converted"

## Features that cannot be converted, by property. The value is that of a material without the feature.
const UNSUPPORTED := {
	"detail_enabled": false,
	"heightmap_enabled": false,
	"refraction_enabled": false,
	"anisotropy_enabled": false,
	"subsurf_scatter_enabled": false,
	"bent_normal_enabled": false,
	"uv1_triplanar": false,
	"uv2_triplanar": false,
	"billboard_mode": BaseMaterial3D.BILLBOARD_DISABLED,
	"grow": false,
	"proximity_fade_enabled": false,
	"distance_fade_mode": BaseMaterial3D.DISTANCE_FADE_DISABLED,
	"albedo_texture_msdf": false,
	"use_point_size": false,
	"fixed_size": false,
	"stencil_mode": BaseMaterial3D.STENCIL_MODE_DISABLED,
}

const FILTERS := [
	"filter_nearest", "filter_linear", "filter_nearest_mipmap", "filter_linear_mipmap",
	"filter_nearest_mipmap_anisotropic", "filter_linear_mipmap_anisotropic",
]
const BLEND_MODES := ["blend_mix", "blend_add", "blend_sub", "blend_mul", "blend_premul_alpha"]
const DEPTH_DRAW_MODES := ["depth_draw_opaque", "depth_draw_always", "depth_draw_never"]
const CULL_MODES := ["cull_back", "cull_front", "cull_disabled"]
const DIFFUSE_MODES := ["diffuse_burley", "diffuse_lambert", "diffuse_lambert_wrap", "diffuse_toon"]
const SPECULAR_MODES := ["specular_schlick_ggx", "specular_toon", "specular_disabled"]
## Render modes by property of the material.
const FLAGS := {
	"no_depth_test": "depth_test_disabled",
	"disable_receive_shadows": "shadows_disabled",
	"disable_ambient_light": "ambient_light_disabled",
	"disable_fog": "fog_disabled",
	"shadow_to_opacity": "shadow_to_opacity",
}
const CHANNEL_MASKS := [
	Vector4(1, 0, 0, 0), Vector4(0, 1, 0, 0), Vector4(0, 0, 1, 0), Vector4(0, 0, 0, 1),
	Vector4(0.333333, 0.333333, 0.333333, 0),
]

## Shaders by code, so that equal materials share a compiled shader.
static var _shaders: Dictionary[String, WeakRef] = {}

var _material: BaseMaterial3D
var _wrinkles: FurrowWrinkleShader
var _has_tangents: bool
var _repeats_normals: bool
var _parameters := {}


## Returns null if the material cannot be converted, after an error that names the reason.
static func convert(original: Material, face: FurrowWrinkles) -> ShaderMaterial:
	var material := original as BaseMaterial3D
	var problem := "" if material != null else "not a StandardMaterial3D"
	for property: String in UNSUPPORTED:
		if problem == "" and material.get(property) != null and material.get(property) != UNSUPPORTED[property]:
			problem = property
	if problem != "":
		push_error(FurrowJsonReader.describe(WHO, "material of %s cannot show wrinkles" % face.get_parent().name, problem,
				"a StandardMaterial3D without %s" % ", ".join(UNSUPPORTED.keys()), "the mesh is shown without wrinkles"))
		return null
	var converter := FurrowMaterialConverter.new()
	converter._material = material
	converter._wrinkles = FurrowWrinkleShader.new(face.wrinkle_set, face.is_tiled)
	converter._has_tangents = face.has_tangents
	converter._repeats_normals = face.wrinkle_set.repeats_normals
	return converter._convert(face.wrinkle_set)


## Whether [method convert] has made a material, or a material that it was duplicated from.
static func is_converted(material: Material) -> bool:
	return material != null and material.has_meta(META)


func _convert(wrinkle_set: FurrowWrinkleSet) -> ShaderMaterial:
	var code := _code(wrinkle_set.uses_uv2)
	var shader: Shader = _shaders[code].get_ref() if _shaders.has(code) else null
	if shader == null:
		shader = Shader.new()
		shader.code = code
		_shaders[code] = weakref(shader)
	var converted := ShaderMaterial.new()
	converted.set_meta(META, true)
	converted.shader = shader
	converted.render_priority = _material.render_priority
	converted.next_pass = _material.next_pass
	for name: String in _parameters:
		converted.set_shader_parameter(name, _parameters[name])
	for kind: String in wrinkle_set.maps:
		converted.set_shader_parameter(FurrowWrinkleShader.SAMPLERS[kind], wrinkle_set.maps[kind])
	var size := Vector2(wrinkle_set.weights.get_width(), wrinkle_set.weights.get_height())
	var last := (size - Vector2.ONE).max(Vector2.ONE)
	converted.set_shader_parameter("furrow_inside", Vector4(size.x / last.x, size.y / last.y, -0.5 / last.x, -0.5 / last.y))
	converted.set_shader_parameter("furrow_influence_map", wrinkle_set.atlas.texture)
	var t := wrinkle_set.uv_transform
	converted.set_shader_parameter("furrow_uv_transform", Basis(Vector3(t.x.x, t.x.y, 0), Vector3(t.y.x, t.y.y, 0),
			Vector3(t.origin.x, t.origin.y, 1)))
	return converted


func _code(uses_uv2: bool) -> String:
	var light := _light()
	var inputs := "" if light == "" else FurrowWrinkleShader.LIGHT_INPUTS
	var fragment := _fragment()
	return "shader_type spatial;\nrender_mode %s;\n%s%svoid vertex() {\n%s}\n\nvoid fragment() {\n%s}\n%s" % [
		", ".join(_render_modes()), _uniforms(), _wrinkles.declarations(FILTERS[_material.texture_filter]) + inputs, _vertex(uses_uv2), fragment, light,
	]


func _render_modes() -> PackedStringArray:
	var m := _material
	var modes := PackedStringArray([
		BLEND_MODES[m.blend_mode], DEPTH_DRAW_MODES[m.depth_draw_mode], CULL_MODES[m.cull_mode],
		DIFFUSE_MODES[m.diffuse_mode], SPECULAR_MODES[m.specular_mode],
	])
	if m.shading_mode == BaseMaterial3D.SHADING_MODE_UNSHADED:
		modes.append("unshaded")
	elif m.shading_mode == BaseMaterial3D.SHADING_MODE_PER_VERTEX:
		modes.append("vertex_lighting")
	if m.transparency == BaseMaterial3D.TRANSPARENCY_ALPHA_DEPTH_PRE_PASS:
		modes.append("depth_prepass_alpha")
	for property: String in FLAGS:
		if m.get(property):
			modes.append(FLAGS[property])
	return modes


func _uniforms() -> String:
	var m := _material
	var code := ""
	code += _texture("texture_albedo", m.albedo_texture, "source_color, ")
	code += _uniform("vec4 albedo : source_color", m.albedo_color)
	code += _uniform("vec3 uv1_scale", m.uv1_scale) + _uniform("vec3 uv1_offset", m.uv1_offset)
	if m is ORMMaterial3D:
		code += _texture("texture_orm", m.orm_texture, "hint_roughness_g, ")
	else:
		code += _texture("texture_metallic", m.metallic_texture, "hint_default_white, ")
		code += _texture("texture_roughness", m.roughness_texture, "hint_default_white, ")
		code += _uniform("float metallic", m.metallic) + _uniform("float roughness", m.roughness)
		code += _uniform("float specular", m.metallic_specular)
		code += _uniform("vec4 metallic_channel", CHANNEL_MASKS[m.metallic_texture_channel])
		code += _uniform("vec4 roughness_channel", CHANNEL_MASKS[m.roughness_texture_channel])
	if m.normal_enabled:
		code += _texture("texture_normal", m.normal_texture, "hint_default_white, ", _repeats_normals)
		code += _uniform("float normal_scale", m.normal_scale)
	if m.emission_enabled:
		code += _texture("texture_emission", m.emission_texture, "source_color, hint_default_black, ")
		code += _uniform("vec4 emission : source_color", m.emission)
		code += _uniform("float emission_energy", m.emission_energy_multiplier)
	if m.ao_enabled:
		code += _texture("texture_ao", m.ao_texture, "hint_default_white, ")
		code += _uniform("vec4 ao_channel", CHANNEL_MASKS[m.ao_texture_channel])
		code += _uniform("float ao_light_affect", m.ao_light_affect)
	if m.rim_enabled:
		code += _texture("texture_rim", m.rim_texture, "hint_default_white, ")
		code += _uniform("float rim", m.rim) + _uniform("float rim_tint", m.rim_tint)
	if m.clearcoat_enabled:
		code += _texture("texture_clearcoat", m.clearcoat_texture, "hint_default_white, ")
		code += _uniform("float clearcoat", m.clearcoat) + _uniform("float clearcoat_roughness", m.clearcoat_roughness)
	if m.backlight_enabled:
		code += _texture("texture_backlight", m.backlight_texture, "hint_default_black, ")
		code += _uniform("vec4 backlight : source_color", m.backlight)
	if m.transparency == BaseMaterial3D.TRANSPARENCY_ALPHA_SCISSOR:
		code += _uniform("float alpha_scissor_threshold", m.alpha_scissor_threshold)
	elif m.transparency == BaseMaterial3D.TRANSPARENCY_ALPHA_HASH:
		code += _uniform("float alpha_hash_scale", m.alpha_hash_scale)
	return code


func _texture(name: String, texture: Texture2D, hints: String, repeats := _material.texture_repeat) -> String:
	_parameters[name] = texture
	var repeat := "repeat_enable" if repeats else "repeat_disable"
	return "uniform sampler2D %s : %s%s, %s;\n" % [name, hints, FILTERS[_material.texture_filter], repeat]


func _uniform(declaration: String, value: Variant) -> String:
	_parameters[declaration.get_slice(" ", 1)] = value
	return "uniform %s;\n" % declaration


func _vertex(uses_uv2: bool) -> String:
	var code := ""
	if _material.vertex_color_is_srgb:
		code += "	if (!OUTPUT_IS_SRGB) {\n		COLOR.rgb = furrow_to_linear(COLOR.rgb);\n	}\n"
	if _material.shading_mode == BaseMaterial3D.SHADING_MODE_PER_VERTEX:
		code += "	ROUGHNESS = roughness;\n"
	code += "	furrow_coordinates = (furrow_uv_transform * vec3(%s, 1.0)).xy;\n" % ("UV2" if uses_uv2 else "UV")
	return code + "	UV = UV * uv1_scale.xy + uv1_offset.xy;\n"


func _fragment() -> String:
	var m := _material
	var code := _wrinkles.influence()
	code += "	vec4 albedo_tex = texture(texture_albedo, UV);\n"
	if m.albedo_texture_force_srgb:
		code += "	albedo_tex.rgb = furrow_to_linear(albedo_tex.rgb);\n"
	code += _wrinkles.base_color("albedo_tex.rgb")
	if m.vertex_color_use_as_albedo:
		code += "	albedo_tex *= COLOR;\n"
	code += "	ALBEDO = albedo.rgb * albedo_tex.rgb;\n" + _wrinkles.blood()
	if m is ORMMaterial3D:
		code += "	vec4 orm = texture(texture_orm, UV);\n	METALLIC = orm.b;\n	float rough = orm.g;\n"
		code += _wrinkles.roughness("rough") + "	ROUGHNESS = rough;\n"
	else:
		code += "	METALLIC = dot(texture(texture_metallic, UV), metallic_channel) * metallic;\n	SPECULAR = specular;\n"
		code += "	float rough = dot(texture(texture_roughness, UV), roughness_channel);\n"
		code += _wrinkles.roughness("rough") + "	ROUGHNESS = rough * roughness;\n"
	return code + _normals() + _other_maps() + _transparency()


func _normals() -> String:
	var code := "	vec3 furrow_normal = vec3(0.0, 0.0, 1.0);\n"
	if _material.normal_enabled:
		code += "	furrow_normal = texture(texture_normal, furrow_coordinates).xyz * 2.0 - 1.0;\n"
		if not _stores_z(_material.normal_texture):
			code += "	furrow_normal.z = sqrt(max(0.0, 1.0 - dot(furrow_normal.xy, furrow_normal.xy)));\n"
	code += _wrinkles.normals()
	if _material.normal_enabled:
		code += "	furrow_normal.xy *= normal_scale;\n"
	if not _has_tangents:
		code += "	furrow_frame(NORMAL, dFdx(VERTEX), dFdy(VERTEX), furrow_dx, furrow_dy, TANGENT, BINORMAL);\n"
	# Godot computes z from x and y.
	return code + "	NORMAL_MAP = normalize(furrow_normal) * 0.5 + 0.5;\n	NORMAL_MAP_DEPTH = 1.0;\n"


## Whether a normal map has three channels. Compressed normal maps have two.
static func _stores_z(texture: Texture2D) -> bool:
	var image_texture := texture as ImageTexture
	return image_texture != null and image_texture.get_format() in [Image.FORMAT_RGB8, Image.FORMAT_RGBA8]


func _other_maps() -> String:
	var m := _material
	var code := "	float occlusion = %s;\n" % ("orm.r" if m is ORMMaterial3D else "1.0")
	if m.ao_enabled:
		if m is not ORMMaterial3D:
			code += "	occlusion = dot(texture(texture_ao, %s), ao_channel);\n" % ("UV2" if m.ao_on_uv2 else "UV")
		code += "	AO_LIGHT_AFFECT = ao_light_affect;\n"
	elif m is ORMMaterial3D:
		code += "	occlusion = 1.0;\n"
	code += _wrinkles.occlusion("occlusion") + "	AO = occlusion;\n"
	if _light() != "":
		code += "	float visibility = 1.0;\n" + _wrinkles.occlusion("visibility")
		code += "	furrow_visibility = visibility;\n	furrow_specular = SPECULAR;\n"
	if m.emission_enabled:
		var operation := "+" if m.emission_operator == BaseMaterial3D.EMISSION_OP_ADD else "*"
		code += "	EMISSION = (emission.rgb %s texture(texture_emission, %s).rgb) * emission_energy;\n" % [
			operation, "UV2" if m.emission_on_uv2 else "UV",
		]
	if m.rim_enabled:
		code += "	vec2 rim_tex = texture(texture_rim, UV).xy;\n	RIM = rim * rim_tex.x;\n	RIM_TINT = rim_tint * rim_tex.y;\n"
	if m.clearcoat_enabled:
		code += "	vec2 coat = texture(texture_clearcoat, UV).xy;\n	CLEARCOAT = clearcoat * coat.x;\n"
		code += "	CLEARCOAT_ROUGHNESS = clearcoat_roughness * coat.y;\n"
	if m.backlight_enabled:
		code += "	BACKLIGHT = backlight.rgb + texture(texture_backlight, UV).rgb;\n"
	return code


func _transparency() -> String:
	var code := ""
	if _material.transparency != BaseMaterial3D.TRANSPARENCY_DISABLED or _material.shadow_to_opacity:
		code += "	ALPHA *= albedo.a * albedo_tex.a;\n"
	if _material.transparency == BaseMaterial3D.TRANSPARENCY_ALPHA_SCISSOR:
		code += "	ALPHA_SCISSOR_THRESHOLD = alpha_scissor_threshold;\n"
	elif _material.transparency == BaseMaterial3D.TRANSPARENCY_ALPHA_HASH:
		code += "	ALPHA_HASH_SCALE = alpha_hash_scale;\n"
	return code


## Returns the light function. It is needed only if wrinkles shadow highlights, and it has no toon shading, rim, clearcoat or
## backlight.
func _light() -> String:
	var m := _material
	var is_simple := m.diffuse_mode <= BaseMaterial3D.DIFFUSE_LAMBERT and \
			m.specular_mode == BaseMaterial3D.SPECULAR_SCHLICK_GGX and \
			m.shading_mode == BaseMaterial3D.SHADING_MODE_PER_PIXEL and \
			not (m.rim_enabled or m.clearcoat_enabled or m.backlight_enabled or m.shadow_to_opacity)
	if not is_simple or not _wrinkles.has_maps("occlusionTexture"):
		return ""
	var is_burley := m.diffuse_mode == BaseMaterial3D.DIFFUSE_BURLEY
	return FurrowWrinkleShader.LIGHT.replace("BURLEY", FurrowWrinkleShader.BURLEY if is_burley else "")
