"""Reads images from `.glb` and `.gltf` files, and adds wrinkles to such files."""

import base64
import json
import struct
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import quote, unquote

from .document import EXTENSION, textures_of, without_defaults
from .reader import FurrowError

_JSON, _BINARY = 0x4E4F534A, 0x004E4942
_EXTENSIONS = {"image/png": ".png", "image/jpeg": ".jpg", "image/webp": ".webp"}
_WEBP = "EXT_texture_webp"
_BASISU = "KHR_texture_basisu"


@dataclass(frozen=True)
class ImageFile:
    """An encoded image, as the bytes of its file."""

    name: str
    mime_type: str
    data: bytes


class GltfFile:
    """A glTF file that was read. `json` is its JSON, and `image_of` reads its images."""

    def __init__(self, path):
        self.path = Path(path)
        data = self.path.read_bytes()
        if data[:4] == b"glTF":
            text, self.binary = _read_glb(data, self.path.name)
        else:
            text, self.binary = data, b""
        try:
            self.json = json.loads(text)
        except ValueError as error:
            raise FurrowError(f"{self.path.name}: invalid JSON, {error}; export the file again") from error

    @property
    def texture_count(self):
        return len(self.json.get("textures", []))

    def image_of(self, texture):
        """Read the image of a texture. Raises FurrowError if it is missing, damaged or unsupported by Blender."""
        try:
            item = self.json["textures"][texture]
            extensions = item.get("extensions", {})
            if _BASISU in extensions and "source" not in item:
                raise FurrowError(
                    f"{self.path.name}: texture {texture} is KTX 2, which Blender cannot read; "
                    "pack the face without --ktx2"
                )
            index = extensions.get(_WEBP, {}).get("source", item.get("source"))
            image = self.json["images"][index]
            data = bytes(self._uri(image["uri"]) if "uri" in image else self.view(image["bufferView"]))
            return ImageFile(image.get("name") or f"wrinkles {index}", mime_type_of(data), data)
        except (LookupError, TypeError, AttributeError, ValueError, OSError) as error:
            raise FurrowError(
                f"{self.path.name}: the image of texture {texture} cannot be read; export the file again"
            ) from error

    def view(self, index):
        """Return the bytes of a buffer view. Raises ValueError if they are not in the buffer."""
        view = self.json["bufferViews"][index]
        start = view.get("byteOffset", 0)
        buffer = self.json["buffers"][view["buffer"]]
        data = self._uri(buffer["uri"]) if "uri" in buffer else self.binary
        if start + view["byteLength"] > len(data):
            raise ValueError("buffer view beyond its buffer")
        return data[start : start + view["byteLength"]]

    def _uri(self, uri):
        if uri.startswith("data:"):
            return base64.b64decode(uri.split(",", 1)[1])
        return (self.path.parent / unquote(uri)).read_bytes()


def mime_type_of(data):
    """Detect PNG, JPEG or WebP from the first bytes. Returns the MIME type. Raises ValueError for other formats."""
    if data[:8] == b"\x89PNG\r\n\x1a\n":
        return "image/png"
    if data[:3] == b"\xff\xd8\xff":
        return "image/jpeg"
    if data[:4] == b"RIFF" and data[8:12] == b"WEBP":
        return "image/webp"
    raise ValueError("neither PNG, JPEG nor WebP")


def add_wrinkles(path, wrinkles):
    """
    Add the extension to materials of a file and overwrite the file.

    `wrinkles`: dict from material names to pairs: the extension's JSON, and a list of ImageFile. Texture indices in
    the JSON are indices into this list. Materials that the file lacks are skipped. Returns the names of the changed
    materials.
    """
    file = GltfFile(path)
    is_glb = has_glb_header(path)
    json_, binary = file.json, bytearray(file.binary)
    found = []
    for name, (document, images) in wrinkles.items():
        materials = [item for item in json_.get("materials", []) if item.get("name") == name]
        if not materials:
            continue
        textures = [_add_image(json_, image, binary, file.path, is_glb) for image in images]
        for material in materials:
            coordinates = material.get("normalTexture", {}).get("texCoord", 0)
            extension = _with_textures(document, textures, coordinates)
            material.setdefault("extensions", {})[EXTENSION] = without_defaults(extension)
        found.append(name)
    if not found:
        return found
    _declare(json_, EXTENSION)
    if is_glb:
        if binary:
            buffers = json_.setdefault("buffers", [{}])
            buffers[0]["byteLength"] = len(binary)
        file.path.write_bytes(write_glb(json_, bytes(binary)))
    else:
        file.path.write_text(json.dumps(json_, indent="\t"), "utf-8")
    return found


def has_glb_header(path):
    with open(path, "rb") as file:
        return file.read(4) == b"glTF"


def _with_textures(document, textures, coordinates):
    """
    Copy the extension's JSON (`document`), and replace its texture indices by those of the file.

    `textures`: new texture index by old index. `coordinates`: number of the UV set (texCoord) that all textures use.
    """
    copy = json.loads(json.dumps(document))
    for info in textures_of(copy):
        info["index"] = textures[info["index"]]
        info.pop("texCoord", None)
        if coordinates:
            info["texCoord"] = coordinates
    return copy


def _add_image(json_, image, binary, path, is_glb):
    images = json_.setdefault("images", [])
    item = {"name": image.name, "mimeType": image.mime_type}
    if is_glb:
        views = json_.setdefault("bufferViews", [])
        binary.extend(b"\0" * (-len(binary) % 4))
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(image.data)})
        binary.extend(image.data)
        item["bufferView"] = len(views) - 1
    else:
        file = path.with_name(f"{path.stem}-wrinkles-{len(images)}{_EXTENSIONS[image.mime_type]}")
        file.write_bytes(image.data)
        item["uri"] = quote(file.name)
    images.append(item)
    textures = json_.setdefault("textures", [])
    if image.mime_type == "image/webp":
        textures.append({"extensions": {_WEBP: {"source": len(images) - 1}}})
        _declare(json_, _WEBP)
    else:
        textures.append({"source": len(images) - 1})
    return len(textures) - 1


def _declare(json_, name):
    used = json_.setdefault("extensionsUsed", [])
    if name not in used:
        used.append(name)


def _read_glb(data, who):
    try:
        version, length = struct.unpack_from("<II", data, 4)
        if version != 2 or length > len(data):
            raise ValueError("not version 2, or truncated")
        chunks, at = {}, 12
        while at < length:
            size, kind = struct.unpack_from("<II", data, at)
            if at + 8 + size > len(data):
                raise ValueError("a chunk is truncated")
            chunks.setdefault(kind, data[at + 8 : at + 8 + size])
            at += 8 + size
        return chunks[_JSON], chunks.get(_BINARY, b"")
    except (ValueError, KeyError, struct.error) as error:
        raise FurrowError(f"{who}: invalid .glb, {error}; export the file again") from error


def write_glb(json_, binary):
    text = json.dumps(json_, separators=(",", ":"), ensure_ascii=False).encode()
    text += b" " * (-len(text) % 4)
    out = struct.pack("<II", len(text), _JSON) + text
    if binary:
        binary += b"\0" * (-len(binary) % 4)
        out += struct.pack("<II", len(binary), _BINARY) + binary
    return b"glTF" + struct.pack("<II", 2, 12 + len(out)) + out
