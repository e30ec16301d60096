import io

import numpy as np
import pytest
from PIL import Image

from builder.person.fields import Fields, occlusion
from builder.person.skin_maps import encode, encode_palette, lay, relief
from builder.raster import Atlas
from tests.shapes import grid, sheet_part


@pytest.fixture(scope="module")
def fields():
    part = sheet_part()
    return Fields(Atlas(part.uv, part.triangles, 64), part.positions, seed=3)


def test_noise_depends_on_its_channel(fields):
    assert (fields.noise(0.05, 1) == fields.noise(0.05, 1)).all()
    assert not np.allclose(fields.noise(0.05, 1), fields.noise(0.05, 2))


def test_noise_has_mean_0_and_deviation_about_1(fields):
    noise = fields.noise(0.02, 5)
    assert abs(noise.mean()) < 0.15
    assert 0.7 < noise.std() < 1.3


def test_a_spot_is_a_gaussian(fields):
    spot = fields.near_to(np.array([0.5, 0.5, 0.1]), 0.1)
    assert spot.max() == pytest.approx(np.exp(-1), abs=0.02)
    assert np.unravel_index(spot.argmax(), spot.shape) in [(31, 31), (31, 32), (32, 31), (32, 32)]


def test_a_plane_sees_the_full_sky():
    points = grid(100)[0] * 0.05
    normals = np.tile([0.0, 0.0, 1.0], (len(points), 1))
    assert occlusion(points, normals, points) == pytest.approx(1)


def test_a_floor_beside_a_wall_sees_half_of_it():
    floor = grid(200)[0] * 0.1
    wall = floor[:, [2, 1, 0]]  # the plane x = 0, as high as the floor is wide
    normals = np.tile([0.0, 0.0, 1.0], (len(floor), 1))
    seen = occlusion(floor, normals, np.concatenate([floor, wall]))
    middle = np.abs(floor[:, 1] - 0.05) < 0.01
    near = seen[middle & (floor[:, 0] > 0.001) & (floor[:, 0] < 0.003)]
    far = seen[middle & (floor[:, 0] > 0.09)]
    assert near.mean() == pytest.approx(0.5, abs=0.05)
    assert far.mean() > 0.85


def test_relief_is_flat_away_from_the_skin():
    height = np.tile(np.arange(8.0), (8, 1))
    near = np.ones((8, 8), bool)
    near[0] = False
    normals = np.round(relief(height, 0.5, near) * 255)
    assert (normals[0] == [128, 128, 255]).all()
    # Heights increase to the right, so normals lean to the left. Bytes are 128 plus a multiple of 3.
    assert (normals[1:, :, 0] < 128).all()
    assert ((normals[1:, :, 0] - 128) % 3 == 0).all()
    assert (normals[1:, :, 1] == 128).all()


def test_relief_is_green_up():
    height = np.tile(np.arange(8.0)[::-1, None], (1, 8))  # heights increase upwards, so normals lean downwards
    assert (relief(height, 0.5, np.ones((8, 8), bool))[..., 1] * 255 < 128).all()


def test_layers_cover_by_their_opacity():
    under = np.zeros((1, 3, 3))
    laid = lay(under, np.array([1.0, 0.5, 0.0]), np.array([[0.0, 0.5, 2.0]]))
    assert laid.tolist() == [[[0, 0, 0], [0.5, 0.25, 0], [1, 0.5, 0]]]


def test_images_are_encoded_the_same_every_time():
    image = np.random.default_rng(0).random((16, 16, 3))
    for kind, magic in (("png", b"\x89PNG"), ("jpeg", b"\xff\xd8")):
        mime, data = encode(image, kind)
        assert mime == f"image/{kind}"
        assert data.startswith(magic)
        assert encode(image, kind)[1] == data


def test_a_palette_keeps_the_most_frequent_colours():
    pixels = np.zeros((32, 32, 3), np.uint8)
    pixels[..., 0] = np.arange(32)[:, None] // 2 * 8
    pixels[..., 1] = np.arange(32)[None] // 2 * 8
    pixels[0, 0] = (0, 3, 0)  # the 257th colour, in one texel
    mime, data = encode_palette(pixels / 255)
    image = Image.open(io.BytesIO(data))
    assert (mime, image.mode) == ("image/png", "P")
    decoded = np.asarray(image.convert("RGB"))
    assert decoded[0, 0].tolist() == [0, 0, 0]
    assert (decoded[1:] == pixels[1:]).all()
    assert encode_palette(pixels / 255)[1] == data
