"""Writes parts, materials and images as one binary glTF 2.0 file. Same input, same bytes."""

import json
import struct

import numpy as np

from .part import Part
from .source import ARKIT

# Displacements (metres) and changes of unit normals below the first number are left out, and up to the second they
# are faded in, so that no step shows where they end. A third of a millimetre is less than half a pixel on a face
# that fills the screen. Parts that carry no changes of normals are hidden or thin, and may be rougher.
SHIFT_FADE = (3.4e-4, 8e-4)
SHIFT_FADE_UNLIT = (5e-4, 1.2e-3)
TURN_FADE = (0.068, 0.138)

# Values are rounded to these steps, far below what can be seen, so that the last bits, in which processors differ, do
# not reach the file.
MICRON, FINE_UV, FINE_NORMAL, FINE_TURN = 1e-6, 1e-6, 1e-5, 1e-4

FLOAT, USHORT, UBYTE = 5126, 5123, 5121
ARRAY_BUFFER, ELEMENT_BUFFER = 34962, 34963


class Glb:
    """Collects parts in the order they are given, then gives the file's bytes."""

    def __init__(self, materials: list[dict], images: dict[str, tuple[str, bytes]]):
        self._bytes, self._rows, self._values = bytearray(), bytearray(), bytearray()
        self._json = {
            "asset": {"version": "2.0", "generator": "Furrow faces/build.py"},
            "scene": 0,
            "scenes": [{"nodes": []}],
            "nodes": [],
            "meshes": [],
            "materials": materials,
            "accessors": [],
            "bufferViews": [],
        }
        if images:
            self._json["samplers"] = [{"magFilter": 9729, "minFilter": 9987, "wrapS": 33071, "wrapT": 33071}]
            self._json["images"] = [
                {"name": name, "mimeType": mime, "bufferView": self._view(data, None)}
                for name, (mime, data) in images.items()
            ]
            self._json["textures"] = [{"name": name, "sampler": 0, "source": i} for i, name in enumerate(images)]
        used = sorted({name for material in materials for name in material.get("extensions", {})})
        if used:
            self._json["extensionsUsed"] = used

    def add(self, part: Part) -> None:
        if len(part.positions) > 65535:
            raise ValueError(f"glb: part {part.name} has {len(part.positions)} vertices, at most 65535 fit its indices")
        primitive = {
            "attributes": {
                "POSITION": self._accessor(part.positions, "VEC3", MICRON, bounds=True),
                "NORMAL": self._accessor(part.normals, "VEC3", FINE_NORMAL),
            },
            "indices": self._indices(part.triangles),
            "material": [m["name"] for m in self._json["materials"]].index(part.material),
        }
        if part.tangents is not None:
            primitive["attributes"]["TANGENT"] = self._accessor(part.tangents, "VEC4", FINE_NORMAL)
        if part.uv is not None:
            primitive["attributes"]["TEXCOORD_0"] = self._accessor(part.uv, "VEC2", FINE_UV)
        if part.colours is not None:
            primitive["attributes"]["COLOR_0"] = self._colours(part.colours)
        mesh = {"name": part.name, "primitives": [primitive]}
        names = []
        still = np.zeros_like(part.positions)
        for name in ARKIT:
            shift, turn = part.targets.get(name, (still, still))
            if part.complete or name in part.targets:
                target = self._target(shift, turn, part.complete)
                if target:
                    names.append(name)
                    primitive.setdefault("targets", []).append(target)
        if names:
            mesh["weights"] = [0.0] * len(names)
            mesh["extras"] = {"targetNames": names}
        self._json["meshes"].append(mesh)
        self._json["nodes"].append({"name": part.name, "mesh": len(self._json["meshes"]) - 1})
        self._json["scenes"][0]["nodes"].append(len(self._json["nodes"]) - 1)

    def finish(self) -> bytes:
        sparse = [a["sparse"] for a in self._json["accessors"] if "sparse" in a]
        if sparse:
            rows, values = self._view(bytes(self._rows), None), self._view(bytes(self._values), None)
            for entry in sparse:
                entry["indices"]["bufferView"], entry["values"]["bufferView"] = rows, values
        self._pad()
        document = dict(self._json, buffers=[{"byteLength": len(self._bytes)}])
        text = json.dumps(document, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        total = 12 + 8 + len(text) + 8 + len(self._bytes)
        return b"".join([
            struct.pack("<III", 0x46546C67, 2, total),
            struct.pack("<II", len(text), 0x4E4F534A), text,
            struct.pack("<II", len(self._bytes), 0x004E4942), bytes(self._bytes),
        ])

    def _target(self, shift: np.ndarray, turn: np.ndarray | None, keep: bool) -> dict | None:
        shift = _fade(shift, *(SHIFT_FADE_UNLIT if turn is None else SHIFT_FADE))
        if not shift.any() and not keep:
            return None
        target = {"POSITION": self._sparse(shift, bounds=True)}
        if turn is not None:
            target["NORMAL"] = self._sparse(_fade(turn, *TURN_FADE))
        return target

    def _sparse(self, dense: np.ndarray, bounds=False) -> int:
        rows = np.flatnonzero(dense.any(axis=1))
        if not len(rows):  # every target of a mesh must have the same attributes, and a sparse accessor one entry
            rows = np.zeros(1, int)
        values = _settled(dense[rows], MICRON if bounds else FINE_TURN)
        accessor = {"componentType": FLOAT, "count": len(dense), "type": "VEC3"}
        if bounds:  # zeros count too, unless every vertex moves
            every = values if len(rows) == len(dense) else np.vstack([values, np.zeros((1, 3), "<f4")])
            accessor["min"], accessor["max"] = every.min(axis=0).tolist(), every.max(axis=0).tolist()
        # All sparse data shares two buffer views, the indices' and the values'; finish() places them.
        accessor["sparse"] = {
            "count": len(rows),
            "indices": {"bufferView": -1, "byteOffset": len(self._rows), "componentType": USHORT},
            "values": {"bufferView": -1, "byteOffset": len(self._values)},
        }
        self._rows += rows.astype("<u2").tobytes()
        self._values += values.tobytes()
        return self._push(accessor)

    def _accessor(self, values: np.ndarray, kind: str, step: float, bounds=False) -> int:
        values = _settled(values, step)
        accessor = {
            "bufferView": self._view(values.tobytes(), ARRAY_BUFFER),
            "componentType": FLOAT, "count": len(values), "type": kind,
        }
        if bounds:
            accessor["min"], accessor["max"] = values.min(axis=0).tolist(), values.max(axis=0).tolist()
        return self._push(accessor)

    def _colours(self, colours: np.ndarray) -> int:
        data = np.round(np.clip(colours, 0, 1) * 255).astype(np.uint8)
        return self._push({
            "bufferView": self._view(data.tobytes(), ARRAY_BUFFER), "componentType": UBYTE, "normalized": True,
            "count": len(data), "type": "VEC4",
        })

    def _indices(self, triangles: np.ndarray) -> int:
        data = triangles.astype("<u2").tobytes()
        return self._push({
            "bufferView": self._view(data, ELEMENT_BUFFER), "componentType": USHORT,
            "count": triangles.size, "type": "SCALAR",
        })

    def _push(self, accessor: dict) -> int:
        self._json["accessors"].append(accessor)
        return len(self._json["accessors"]) - 1

    def _view(self, data: bytes, target: int | None) -> int:
        self._pad()
        view = {"buffer": 0, "byteOffset": len(self._bytes), "byteLength": len(data)}
        if target:
            view["target"] = target
        self._bytes += data
        self._json["bufferViews"].append(view)
        return len(self._json["bufferViews"]) - 1

    def _pad(self) -> None:
        self._bytes += b"\0" * (-len(self._bytes) % 4)


def _fade(change: np.ndarray, low: float, high: float) -> np.ndarray:
    length = np.linalg.norm(change, axis=1, keepdims=True)
    share = np.clip((length - low) / (high - low), 0, 1)
    return change * share * share * (3 - 2 * share)


def _settled(values: np.ndarray, step: float) -> np.ndarray:
    return (np.round(values / step) * step + 0.0).astype("<f4")  # adding zero turns -0 into 0
