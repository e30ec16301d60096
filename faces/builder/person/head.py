"""Builds the head and neck of a person.

They are cut out of MakeHuman's body and subdivided once, together with the ARKit targets. MakeHuman's mesh, its UV
layout and its targets are called the source.
"""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from ..layout import skin_layout
from ..part import Part, triangulate
from ..source import ARKIT, Mesh, Wheel
from ..subdivide import catmull_clark, vertex_normals

COLLAR = 0.61  # height in metres; UV islands that are entirely above it belong to the head
NECK_RINGS = 5  # number of rings of quads below the head's UV island that belong to the skin
SHIRT_RINGS = 9  # number of rings of quads below the head's UV island that belong to the skin or the shirt
SOCKET_RINGS = 6  # number of rings of subdivided quads to keep in each eye socket
NAPE = 0.02  # z in metres; neck vertices that are in the plane of symmetry and behind this z are on the UV seam


@dataclass
class Head:
    """The subdivided head. Vertices and quads after subdivision are called fine."""

    base: np.ndarray  # vertices of the person's full body, before subdivision
    units: dict[str, np.ndarray]  # displacements of the full body's vertices, by ARKit name
    used: np.ndarray  # for each vertex of the head, its index in `base`
    positions: np.ndarray  # fine vertices
    normals: np.ndarray  # normals of the fine vertices
    fine_quads: np.ndarray
    region: np.ndarray  # name for each fine quad: skin, mouth, socket-left or socket-right
    matrix: object  # sparse matrix of the subdivision, fine vertices x used vertices
    uv: np.ndarray  # texture coordinates of the fine skin
    uv_quads: np.ndarray  # fine quads of the skin, as indices into `uv`
    neck: np.ndarray  # for each quad of the skin before subdivision, whether it belongs to the neck
    # Displacements and changes of normals of fine vertices, by ARKit name.
    moves: dict[str, tuple[np.ndarray, np.ndarray]]


def islands(mesh: Mesh, faces: np.ndarray) -> np.ndarray:
    """Returns for each quad the index of its UV island in the source, (f,). `faces` (f,): indices of quads."""
    quads, count = mesh.uv_quads[faces], len(mesh.uv)
    a, b = quads.ravel(), np.roll(quads, -1, axis=1).ravel()
    return connected_components(coo_matrix((np.ones(len(a)), (a, b)), (count, count)), directed=False)[1][quads[:, 0]]


def regions(mesh: Mesh, neck_rings=NECK_RINGS) -> tuple[np.ndarray, np.ndarray]:
    """Assigns quads to parts of the head.

    Returns the name of each quad's part (skin, mouth, socket-left, socket-right, shirt, or "" outside the head), and a
    mask of the quads in the head's UV island.
    """
    body = np.flatnonzero(mesh.groups == "body")
    island = islands(mesh, body)
    name = np.full(len(mesh.quads), "", dtype="U16")
    above = []
    for i in np.unique(island):
        faces = body[island == i]
        points = mesh.positions[mesh.quads[faces]].reshape(-1, 3)
        if points[:, 1].min() < COLLAR:
            continue
        above.append(faces)
        if points[:, 0].min() > 0:
            name[faces] = "socket-left"
        elif points[:, 0].max() < 0:
            name[faces] = "socket-right"
        else:
            name[faces] = "mouth"
    name[max(above, key=len)] = "skin"
    head_island = name == "skin"
    # The head's UV island ends under the jaw. Each round adds a ring: the quads that touch the skin or the shirt.
    for ring in range(SHIRT_RINGS):
        reached = np.isin(mesh.quads[body], np.unique(mesh.quads[(name == "skin") | (name == "shirt")])).any(axis=1)
        name[body[reached & (name[body] == "")]] = "skin" if ring < neck_rings else "shirt"
    return name, head_island


def cut_at_the_back(
    mesh: Mesh, quads: np.ndarray, uv_quads: np.ndarray, island: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Splits the vertices along the UV seam, which runs down the back of the head and the nape.

    `island` (f,): mask of the quads in the head's UV island. Returns the quads as indices of the vertices after the
    split, and for each of these vertices the index of its original.
    """
    pairs = np.unique(np.stack([quads[island].ravel(), uv_quads[island].ravel()], 1), axis=0)
    vertex, copies = np.unique(pairs[:, 0], return_counts=True)
    neck = np.unique(quads[~island])
    x, z = mesh.positions[neck, 0], mesh.positions[neck, 2]
    seam = np.union1d(vertex[copies > 1], neck[(np.abs(x) < 1e-6) & (z < NAPE)])
    left = mesh.positions[quads].mean(axis=1)[:, 0] > 0
    side = np.where(np.isin(quads, seam), np.where(left, 1, -1)[:, None], 0)
    keys, index = np.unique(np.stack([quads.ravel(), side.ravel()], 1), axis=0, return_inverse=True)
    return index.reshape(-1, 4), keys[:, 0]


def build_head(wheel: Wheel, mesh: Mesh, shapes: dict[str, float], rest: dict[str, float]) -> Head:
    """Builds a head. `shapes`: weights of identity targets. `rest`: weights of expressions in the resting face."""
    base = mesh.positions.copy()
    for target, amount in shapes.items():
        base += amount * wheel.shape(target)
    units = {name: wheel.face_unit(name) for name in ARKIT}
    for name, amount in rest.items():
        base += amount * units[name]
    return subdivided(mesh, base, units)


def subdivided(mesh: Mesh, base: np.ndarray, units: dict[str, np.ndarray]) -> Head:
    """Cuts out and subdivides a head. `base`: vertices of the body. `units`: displacements (n, 3) by ARKit name."""
    region, island = regions(mesh)
    chosen = np.flatnonzero((region != "") & (region != "shirt"))
    used, quads = np.unique(mesh.quads[chosen], return_inverse=True)
    quads = quads.reshape(-1, 4)
    matrix, fine_quads = catmull_clark(quads, len(used))
    positions = _settled(matrix @ base[used])
    normals = vertex_normals(positions, fine_quads)

    moves = {}
    for name, unit in units.items():
        shift = _settled(matrix @ unit[used])
        if np.abs(shift).max() > 0:
            moves[name] = (shift, vertex_normals(positions + shift, fine_quads) - normals)

    on_skin = region == "skin"
    cut, vertex = cut_at_the_back(mesh, mesh.quads[on_skin], mesh.uv_quads[on_skin], island[on_skin])
    uv_matrix, uv_fine = catmull_clark(cut, len(vertex))
    source = np.full((len(vertex), 2), np.nan)
    source[cut[island[on_skin]]] = mesh.uv[mesh.uv_quads[on_skin & island]]
    uv = _settled(uv_matrix @ skin_layout(source, cut, mesh.positions[vertex]))

    fine_region = np.repeat(region[chosen], 4)
    return Head(
        base, units, used, positions, normals, fine_quads, fine_region, matrix, uv, uv_fine, ~island[on_skin], moves
    )


def _settled(values: np.ndarray) -> np.ndarray:
    """Rounds to a tenth of a micrometre, because the last bits differ between processors."""
    return np.round(values, 7)


def skin_part(head: Head, dense_neck=False) -> tuple[Part, np.ndarray]:
    """Returns the skin, split only at the UV seam, and for each vertex of the skin the index of its fine vertex.

    By default, the neck gets fewer vertices on the same surface, because targets hardly move it.
    """
    quads = head.fine_quads[head.region == "skin"]
    pairs, index = np.unique(np.stack([quads.ravel(), head.uv_quads.ravel()], 1), axis=0, return_inverse=True)
    index = index.reshape(-1, 4, 4)
    positions = head.positions[pairs[:, 0]]
    if dense_neck:
        triangles = triangulate(index.reshape(-1, 4), positions)
    else:
        fine = index[~head.neck].reshape(-1, 4)
        triangles = np.concatenate([triangulate(fine, positions), thin_out(index[head.neck], fine)])
    kept, triangles = np.unique(triangles, return_inverse=True)
    vertices = pairs[kept, 0]
    part = _part(head, "skin", "skin", vertices, head.uv[pairs[kept, 1]], triangles.reshape(-1, 3))
    part.complete = True
    return part, vertices


def coarse_skin(head: Head) -> Part:
    """Returns the skin with as many quads as before subdivision. Its vertices are on the subdivided surface."""
    quads = head.fine_quads[head.region == "skin"].reshape(-1, 4, 4)[:, :, 0]
    layout = head.uv_quads.reshape(-1, 4, 4)[:, :, 0]
    pairs, index = np.unique(np.stack([quads.ravel(), layout.ravel()], 1), axis=0, return_inverse=True)
    triangles = triangulate(index.reshape(-1, 4), head.positions[pairs[:, 0]])
    part = _part(head, "skin", "skin", pairs[:, 0], head.uv[pairs[:, 1]], triangles)
    part.complete = True
    return part


def thin_out(neck: np.ndarray, beside: np.ndarray) -> np.ndarray:
    """Replaces the fine quads of the neck by fewer triangles.

    `neck` (f, 4, 4): vertices of the four fine quads that replaced each original quad, in the order of `catmull_clark`:
    corner, edge point, face point, edge point. `beside`: quads of the fine skin that borders on the neck. The triangles
    use the corners of the original quads. Where an original quad borders on `beside`, its triangles also use the edge
    points on the border, so that no gap opens there.
    """
    meeting = np.isin(neck[:, :, 1], beside)
    triangles = []
    for corners, edges, meets in zip(neck[:, :, 0], neck[:, :, 1], meeting, strict=True):
        rim = [
            v
            for corner, edge, met in zip(corners, edges, meets, strict=True)
            for v in ((corner, edge) if met else (corner,))
        ]
        first = rim.index(edges[meets.argmax()]) if meets.any() else 0
        fan = rim[first:] + rim[:first]
        triangles += [(fan[0], fan[i], fan[i + 1]) for i in range(1, len(fan) - 1)]
    return np.array(triangles)


def mouth_lining(head: Head) -> Part:
    return _lining(head, np.flatnonzero(head.region == "mouth"), "mouth")


def socket_lining(head: Head) -> Part:
    """Returns the part of the eye sockets next to the lids. Eyeballs hide the rest."""
    skin = np.unique(head.fine_quads[head.region == "skin"])
    quads = np.flatnonzero(np.char.startswith(head.region, "socket"))
    near = skin
    for _ in range(SOCKET_RINGS):
        near = np.unique(head.fine_quads[quads[np.isin(head.fine_quads[quads], near).any(axis=1)]])
    return _lining(head, quads[np.isin(head.fine_quads[quads], near).all(axis=1)], "sockets")


def _lining(head: Head, chosen: np.ndarray, name: str) -> Part:
    """Returns the lining of the mouth or the sockets. It is dark, so it has no uv and its targets change no normals."""
    used, index = np.unique(head.fine_quads[chosen], return_inverse=True)
    triangles = triangulate(index.reshape(-1, 4), head.positions[used])
    part = _part(head, name, "mouth", used, None, triangles)
    part.targets = {name: (shift, None) for name, (shift, _) in part.targets.items()}
    return part


def _part(head, name, material, vertices, uv, triangles) -> Part:
    positions = head.positions[vertices]
    targets = {k: (shift[vertices], turn[vertices]) for k, (shift, turn) in head.moves.items()}
    return Part(name, material, positions, head.normals[vertices], uv, triangles, targets=targets)
