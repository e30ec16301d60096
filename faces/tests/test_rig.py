import numpy as np
import pytest

from builder.rig import MAX_JOINTS, ONE, read_rig, strongest
from builder.source import Mesh


def test_weights_are_integers_with_an_exact_sum():
    weights = np.random.default_rng(0).dirichlet(np.ones(9), 500)
    joints, parts = strongest(weights)
    assert joints.shape == parts.shape == (500, MAX_JOINTS)
    assert (parts.sum(axis=1) == ONE).all()
    assert (parts >= 0).all()


def test_the_strongest_joints_come_first():
    joints, parts = strongest(np.array([[0.1, 0.5, 0.05, 0.05, 0.3, 0.0]]))
    assert joints.tolist() == [[1, 4, 0, 2]]
    assert parts[0] / ONE == pytest.approx(np.array([0.5, 0.3, 0.1, 0.05]) / 0.95, abs=1e-4)


def test_unused_slots_name_the_first_joint():
    joints, parts = strongest(np.array([[0.0, 0, 1, 0, 0, 0]]))
    assert joints.tolist() == [[2, 0, 0, 0]]
    assert parts.tolist() == [[ONE, 0, 0, 0]]


class Skeleton:
    """A fake wheel with a chain of three bones along x. The tests keep `a` and `b`, but not `c`."""

    def rig(self):
        def end(vertex):
            return {"strategy": "MEAN", "vertex_indices": [vertex]}

        return {
            "root": {"parent": None, "head": end(0), "tail": end(0)},
            "a": {"parent": "root", "head": end(0), "tail": end(1)},
            "b": {"parent": "a", "head": end(1), "tail": end(2)},
            "c": {"parent": "b", "head": end(2), "tail": end(3)},
        }

    def weights(self):
        return {"root": [[0, 0.5]], "a": [[0, 0.5], [1, 1.0]], "b": [[2, 2.0]], "c": [[2, 2.0], [3, 1.0]]}


@pytest.fixture
def rig():
    base = np.array([[0, 0, 0], [1, 0, 0], [1, 2, 0], [1, 3, 0]], float)
    mesh = Mesh(base, np.zeros((0, 2)), np.zeros((0, 4), int), np.zeros((0, 4), int), np.array([], str))
    return read_rig(Skeleton(), mesh, base, ["a", "b"], lambda name: np.array([0.0, 0.0, 1.0]))


def test_frames_run_along_bones_and_bend_inwards(rig):
    assert rig.parents == [-1, 0]
    assert rig.at("b").tolist() == [1, 0, 0]
    for frame, along in zip(rig.frames, ([1, 0, 0], [0, 1, 0]), strict=True):
        assert frame[:, 1] == pytest.approx(along)
        assert frame[:, 2] == pytest.approx([0, 0, 1])
        assert np.linalg.det(frame) == pytest.approx(1)


def test_weights_of_other_joints_go_to_their_ancestors(rig):
    assert rig.weights.tolist() == [[1, 0], [1, 0], [0, 1], [0, 1]]
