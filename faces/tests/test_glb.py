import json
import struct

import numpy as np
import pytest

from builder.glb import SHIFT_FADE, Glb
from builder.rig import Rig
from builder.source import ARKIT
from tests.shapes import sheet_part


def parts_of(data: bytes) -> tuple[dict, bytes]:
    magic, version, length, size, kind = struct.unpack("<4sIII4s", data[:20])
    assert (magic, version, length, kind) == (b"glTF", 2, len(data), b"JSON")
    return json.loads(data[20 : 20 + size]), data[28 + size :]


def numbers(gltf: dict, binary: bytes, index: int) -> np.ndarray:
    accessor = gltf["accessors"][index]
    width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}[accessor["type"]]
    kind = {5121: "u1", 5123: "<u2", 5126: "<f4"}[accessor["componentType"]]
    start = gltf["bufferViews"][accessor["bufferView"]]["byteOffset"]
    return np.frombuffer(binary, kind, accessor["count"] * width, start).reshape(-1, width)


def written(part, **images):
    glb = Glb([{"name": "skin"}], images)
    glb.add(part)
    return glb.finish()


def test_a_part_can_be_read_back():
    part = sheet_part()
    gltf, binary = parts_of(written(part))
    (primitive,) = gltf["meshes"][0]["primitives"]
    attributes = primitive["attributes"]
    assert numbers(gltf, binary, attributes["POSITION"]) == pytest.approx(part.positions)
    assert numbers(gltf, binary, attributes["NORMAL"]) == pytest.approx(part.normals)
    assert numbers(gltf, binary, attributes["TEXCOORD_0"]) == pytest.approx(part.uv)
    assert (numbers(gltf, binary, primitive["indices"]).ravel() == part.triangles.ravel()).all()
    bounds = gltf["accessors"][attributes["POSITION"]]
    assert [bounds["min"], bounds["max"]] == [[0, 0, 0], [1, 1, 0]]


def test_the_same_input_gives_the_same_bytes():
    assert written(sheet_part()) == written(sheet_part())


def test_views_are_aligned():
    gltf, binary = parts_of(written(sheet_part(), odd=("image/png", b"12345")))
    assert all(view["byteOffset"] % 4 == 0 for view in gltf["bufferViews"])
    assert gltf["buffers"][0]["byteLength"] == len(binary)
    assert binary.startswith(b"12345")


def test_small_displacements_are_dropped_and_large_ones_kept():
    part = sheet_part()
    shift = np.zeros((9, 3))
    shift[3, 2], shift[4, 2] = SHIFT_FADE[0] * 0.9, SHIFT_FADE[1] * 2
    part.targets = {"jawOpen": (shift, np.zeros((9, 3)))}
    gltf, binary = parts_of(written(part))
    assert gltf["meshes"][0]["extras"]["targetNames"] == ["jawOpen"]
    (target,) = gltf["meshes"][0]["primitives"][0]["targets"]
    sparse = gltf["accessors"][target["POSITION"]]["sparse"]
    rows, values = (
        gltf["bufferViews"][sparse[key]["bufferView"]]["byteOffset"] + sparse[key]["byteOffset"]
        for key in ("indices", "values")
    )
    assert sparse["count"] == 1
    assert np.frombuffer(binary, "<u2", 1, rows).tolist() == [4]
    assert np.frombuffer(binary, "<f4", 3, values) == pytest.approx(shift[4])


def test_a_complete_part_lists_every_target():
    part = sheet_part()
    part.complete = True
    assert parts_of(written(part))[0]["meshes"][0]["extras"]["targetNames"] == ARKIT


def test_indices_must_fit_16_bits():
    part = sheet_part(256)
    with pytest.raises(ValueError, match="got 66049, allowed: 65535"):
        written(part)


def test_joints_and_clips():
    rig = Rig(["a", "b"], [-1, 0], np.array([[0.0, 0, 0], [0, 1, 0]]), np.array([np.eye(3)] * 2), np.zeros((9, 2)))
    part = sheet_part()
    part.joints, part.weights = np.zeros((9, 4), int), np.tile([65535, 0, 0, 0], (9, 1))
    glb = Glb([{"name": "skin"}], {})
    glb.skeleton(rig)
    glb.add(part)
    # The rotation goes past 180 degrees. Consecutive quaternions must not change sign.
    angles = np.radians([0, 100, 200, 300])
    turns = np.array([[[1, 0, 0], [0, np.cos(a), -np.sin(a)], [0, np.sin(a), np.cos(a)]] for a in angles])
    glb.animation("roll", np.arange(4.0), {"b": turns})
    gltf, binary = parts_of(glb.finish())
    assert [node["name"] for node in gltf["nodes"]] == ["a", "b", "sheet"]
    assert gltf["nodes"][1]["translation"] == [0, 1, 0]
    inverse = numbers(gltf, binary, gltf["skins"][0]["inverseBindMatrices"]).reshape(-1, 4, 4)
    moved = inverse[1].T @ [0, 1, 0, 1]
    assert moved == pytest.approx([0, 0, 0, 1])
    (sampler,) = gltf["animations"][0]["samplers"]
    quaternions = numbers(gltf, binary, sampler["output"])
    assert ((quaternions[1:] * quaternions[:-1]).sum(axis=1) > 0).all()
