"""Lists the glTF materials of the models. Colours are linear, as in glTF."""


def materials(look: dict) -> tuple[list[dict], list[str]]:
    """Returns the materials of a face, and the names of their images in the order of texture indices."""
    images = ["skin-colour", "skin-normal", "skin-surface", "skin-specular", "eye", "brow", "lash"]
    texture = {name: {"index": i} for i, name in enumerate(images)}

    hair = {"KHR_materials_specular": {"specularFactor": 0.3}}

    def textured(name, image, *rest, **more):
        return _textured(name, texture[image], *rest, **more)

    return [
        _skin(texture, look),
        textured(
            "eye",
            "eye",
            0.32,
            extensions={"KHR_materials_clearcoat": {"clearcoatFactor": 1.0, "clearcoatRoughnessFactor": 0.02}},
        ),
        _plain("lid-shade", 0.9, alphaMode="BLEND", extensions={"KHR_materials_specular": {"specularFactor": 0.0}}),
        textured("brow", "brow", 0.75, alphaMode="BLEND", extensions=hair),
        textured("lash", "lash", 0.75, alphaMode="BLEND", doubleSided=True, extensions=hair),
        _plain("teeth", 0.28),
        _plain("tongue", 0.45, extensions={"KHR_materials_specular": {"specularFactor": 0.25}}),
        _plain("mouth", 0.8, extensions={"KHR_materials_specular": {"specularFactor": 0.0}}),
        _plain("shirt", 0.92, (*look["shirt"], 1), doubleSided=True),
    ], images


def hand_materials(look: dict) -> tuple[list[dict], list[str]]:
    """Returns the materials of the hand and its cuff, and the names of their images in the order of texture indices."""
    images = ["skin-colour", "skin-normal", "skin-surface"]
    texture = {name: {"index": i} for i, name in enumerate(images)}
    return [_skin(texture, look), _plain("shirt", 0.92, (*look["shirt"], 1), doubleSided=True)], images


def figure_materials(look: dict, clothes: dict) -> tuple[list[dict], list[str]]:
    """Returns the materials of the clothed figure, and the names of their images in the order of texture indices."""
    listed, images = materials(look)
    names = ["hand-colour", "hand-normal", "hand-surface"]
    texture = {f"skin{name[4:]}": {"index": len(images) + i} for i, name in enumerate(names)}
    hands = {**_skin(texture, look), "name": "hand-skin"}
    cloth = [_plain(name, 0.9, (*colour, 1), doubleSided=True) for name, colour in clothes.items()]
    return [*[one for one in listed if one["name"] != "shirt"], hands, *cloth], images + names


def _plain(name, roughness, colour=(1, 1, 1, 1), **more):
    return {
        "name": name,
        "pbrMetallicRoughness": {"baseColorFactor": list(colour), "metallicFactor": 0, "roughnessFactor": roughness},
        **more,
    }


def _textured(name, texture, roughness, **more):
    return {
        "name": name,
        "pbrMetallicRoughness": {"baseColorTexture": texture, "metallicFactor": 0, "roughnessFactor": roughness},
        **more,
    }


def _skin(texture, look):
    extensions = {
        # With an index of refraction of 1.4, skin reflects 2.8 per cent at normal incidence. Sheen approximates fine
        # hair, and light that leaves the skin at grazing angles after scattering below it.
        "KHR_materials_ior": {"ior": 1.4},
        "KHR_materials_specular": {"specularTexture": texture["skin-specular"]} if "skin-specular" in texture else None,
        "KHR_materials_sheen": {"sheenColorFactor": look["fuzz"], "sheenRoughnessFactor": 0.45},
    }
    skin = _textured(
        "skin",
        texture["skin-colour"],
        1.0,
        normalTexture=texture["skin-normal"],
        occlusionTexture=texture["skin-surface"],
        extensions={name: value for name, value in extensions.items() if value},
    )
    skin["pbrMetallicRoughness"]["metallicRoughnessTexture"] = texture["skin-surface"]
    return skin
