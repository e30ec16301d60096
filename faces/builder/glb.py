"""Writes parts, materials and images as binary glTF 2.0. The same input gives the same bytes."""

import json
import struct

import numpy as np
from scipy.spatial.transform import Rotation

from .part import Part
from .rig import Rig
from .source import ARKIT

# To make files smaller, invisible displacements are removed from targets. Each pair has a lower and an upper limit for
# the lengths of displacements (SHIFT, metres) or of changes of unit normals (TURN). Lengths below the lower limit
# become 0. Lengths between both limits are reduced, so that the border of the moved region is not visible. 0.34 mm is
# less than half a pixel on a full-screen face. `SHIFT_FADE_UNLIT` is for parts whose targets do not change normals. It
# is larger, because these parts are hidden or thin.
SHIFT_FADE = (3.4e-4, 8e-4)
SHIFT_FADE_UNLIT = (5e-4, 1.2e-3)
TURN_FADE = (0.068, 0.138)

# Values are rounded to multiples of these steps, because their last bits differ between processors. The steps are too
# small to be visible. Units: metres, uv, components of normals, components of changes of normals, and components of
# rotations.
MICRON, FINE_UV, FINE_NORMAL, FINE_TURN, FINE_TURNED = 1e-6, 1e-6, 1e-5, 1e-4, 1e-7

FLOAT, USHORT, UBYTE = 5126, 5123, 5121
ARRAY_BUFFER, ELEMENT_BUFFER = 34962, 34963


class Glb:
    """Collects the contents of a file. `finish` returns its bytes."""

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
            raise ValueError(f"glb: too many vertices in {part.name}, got {len(part.positions)}, allowed: 65535")
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
        if part.joints is not None:
            primitive["attributes"]["JOINTS_0"] = self._integers(part.joints, np.uint8)
            primitive["attributes"]["WEIGHTS_0"] = self._integers(part.weights, np.uint16, normalized=True)
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
        node = {"name": part.name, "mesh": len(self._json["meshes"]) - 1}
        siblings = self._json["scenes"][0]["nodes"]
        if part.joints is not None:
            node["skin"] = 0
        if part.parent is not None:
            joint = self._rig.names.index(part.parent)
            turn = self._rig.frames[joint].T
            node.update(_node(turn, -turn @ self._rig.positions[joint]))
            siblings = self._json["nodes"][joint].setdefault("children", [])
        siblings.append(len(self._json["nodes"]))
        self._json["nodes"].append(node)

    def skeleton(self, rig: Rig) -> None:
        """Adds the joints of a rig as the first nodes of the file. Must be called before `add`."""
        self._rig = rig
        inverse = np.zeros((len(rig.names), 4, 4))
        for j, (name, parent) in enumerate(zip(rig.names, rig.parents, strict=True)):
            turn, origin = rig.frames[j], rig.positions[j]
            inverse[j, :3, :3], inverse[j, :3, 3], inverse[j, 3, 3] = turn.T, -turn.T @ origin, 1
            above = rig.frames[parent].T if parent >= 0 else np.eye(3)
            start = rig.positions[parent] if parent >= 0 else np.zeros(3)
            self._json["nodes"].append({"name": name, **_node(above @ turn, above @ (origin - start))})
            siblings = (
                self._json["nodes"][parent].setdefault("children", [])
                if parent >= 0
                else self._json["scenes"][0]["nodes"]
            )
            siblings.append(j)
        columns = inverse.transpose(0, 2, 1).reshape(-1, 16)
        self._json["skins"] = [
            {
                "joints": list(range(len(rig.names))),
                "skeleton": 0,
                "inverseBindMatrices": self._accessor(columns, "MAT4", FINE_TURNED, target=None),
            }
        ]

    def animation(
        self, name: str, seconds: np.ndarray, turns: dict[str, np.ndarray], shifts: np.ndarray | None = None
    ) -> None:
        """Adds a clip. `turns`: rotation matrices (t, 3, 3) by joint name, in the joint's frame, at `seconds` (t,).

        `shifts` (t, 3): displacement of the root in metres.
        """
        rig = self._rig
        clip = {"name": name, "samplers": [], "channels": []}
        times = self._accessor(seconds[:, None], "SCALAR", MICRON, bounds=True, target=None)
        for joint, matrices in turns.items():
            node, parent = rig.names.index(joint), rig.parents[rig.names.index(joint)]
            rest = (rig.frames[parent].T if parent >= 0 else np.eye(3)) @ rig.frames[node]
            values = _continuous(np.array([_quaternion(rest @ matrix) for matrix in matrices]))
            clip["channels"].append({"sampler": len(clip["samplers"]), "target": {"node": node, "path": "rotation"}})
            clip["samplers"].append(
                {"input": times, "output": self._accessor(values, "VEC4", FINE_TURNED, target=None)}
            )
        if shifts is not None and shifts.any():
            clip["channels"].append({"sampler": len(clip["samplers"]), "target": {"node": 0, "path": "translation"}})
            output = self._accessor(rig.positions[0] + shifts, "VEC3", MICRON, target=None)
            clip["samplers"].append({"input": times, "output": output})
        self._json.setdefault("animations", []).append(clip)

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
        return b"".join(
            [
                struct.pack("<III", 0x46546C67, 2, total),
                struct.pack("<II", len(text), 0x4E4F534A),
                text,
                struct.pack("<II", len(self._bytes), 0x004E4942),
                bytes(self._bytes),
            ]
        )

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
        # A sparse accessor needs at least one entry. If no vertex changes, vertex 0 is stored with a change of 0.
        if not len(rows):
            rows = np.zeros(1, int)
        values = _settled(dense[rows], MICRON if bounds else FINE_TURN)
        accessor = {"componentType": FLOAT, "count": len(dense), "type": "VEC3"}
        # The vertices that are not listed in a sparse accessor have the displacement 0, which the bounds must include.
        if bounds:
            every = values if len(rows) == len(dense) else np.vstack([values, np.zeros((1, 3), "<f4")])
            accessor["min"], accessor["max"] = every.min(axis=0).tolist(), every.max(axis=0).tolist()
        # All sparse accessors share two buffer views, for indices and values. `finish` appends these views.
        accessor["sparse"] = {
            "count": len(rows),
            "indices": {"bufferView": -1, "byteOffset": len(self._rows), "componentType": USHORT},
            "values": {"bufferView": -1, "byteOffset": len(self._values)},
        }
        self._rows += rows.astype("<u2").tobytes()
        self._values += values.tobytes()
        return self._push(accessor)

    def _accessor(self, values: np.ndarray, kind: str, step: float, bounds=False, target=ARRAY_BUFFER) -> int:
        values = _settled(values, step)
        accessor = {
            "bufferView": self._view(values.tobytes(), target),
            "componentType": FLOAT,
            "count": len(values),
            "type": kind,
        }
        if bounds:
            accessor["min"], accessor["max"] = values.min(axis=0).tolist(), values.max(axis=0).tolist()
        return self._push(accessor)

    def _colours(self, colours: np.ndarray) -> int:
        return self._integers(np.round(np.clip(colours, 0, 1) * 255), np.uint8, normalized=True)

    def _integers(self, values: np.ndarray, kind: type, normalized=False) -> int:
        data = values.astype(kind)
        accessor = {
            "bufferView": self._view(data.tobytes(), ARRAY_BUFFER),
            "componentType": UBYTE if kind is np.uint8 else USHORT,
        }
        if normalized:
            accessor["normalized"] = True
        return self._push({**accessor, "count": len(data), "type": "VEC4"})

    def _indices(self, triangles: np.ndarray) -> int:
        data = triangles.astype("<u2").tobytes()
        return self._push(
            {
                "bufferView": self._view(data, ELEMENT_BUFFER),
                "componentType": USHORT,
                "count": triangles.size,
                "type": "SCALAR",
            }
        )

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
    t = np.clip((length - low) / (high - low), 0, 1)
    return change * t * t * (3 - 2 * t)


def _node(turn: np.ndarray, position: np.ndarray) -> dict:
    return {
        "rotation": _settled(_quaternion(turn), FINE_TURNED).tolist(),
        "translation": _settled(position, MICRON).tolist(),
    }


def _quaternion(turn: np.ndarray) -> np.ndarray:
    """Converts a rotation matrix to a quaternion (x, y, z, w) with w >= 0."""
    return Rotation.from_matrix(turn).as_quat(canonical=True)


def _continuous(values: np.ndarray) -> np.ndarray:
    """Makes a series of quaternions continuous: negates a quaternion if this brings it closer to the previous one."""
    for k in range(1, len(values)):
        values[k] *= 1 if values[k] @ values[k - 1] >= 0 else -1
    return values


def _settled(values: np.ndarray, step: float) -> np.ndarray:
    # Adding zero turns -0 into 0.
    return (np.round(values / step) * step + 0.0).astype("<f4")
