# A mesh from a field on a grid: surface nets. A cell whose corners lie on both sides of the surface gets a vertex, and
# an edge of the grid that goes through the surface a face between the four cells round it.

import itertools

import numpy as np

CORNERS = list(itertools.product((0, 1), repeat=3))


def crossings(field, inside, cells):
    """For each of the cells the mean of where its edges go through the surface, in cells."""
    total, count = np.zeros((len(cells), 3)), np.zeros(len(cells))
    for a, b in itertools.combinations(CORNERS, 2):
        if np.abs(np.subtract(a, b)).sum() != 1:
            continue
        ia, ib = tuple((cells + a).T), tuple((cells + b).T)
        through = inside[ia] != inside[ib]
        da, db = field[ia][through], field[ib][through]
        total[through] += cells[through] + a + (da / (da - db))[:, None] * np.subtract(b, a)
        count[through] += 1
    return total / count[:, None]


def surface(field):
    """The cells, their vertices, and faces of four vertices, counter-clockwise seen from outside."""
    inside = field < 0
    stacked = [inside[tuple(slice(c, n - 1 + c) for c, n in zip(corner, field.shape))] for corner in CORNERS]
    mixed = np.any(stacked, 0) & ~np.all(stacked, 0)
    cells = np.argwhere(mixed)
    number = np.full(mixed.shape, -1)
    number[mixed] = np.arange(len(cells))
    faces = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        ahead = np.roll(inside, -1, axis)
        edges = np.argwhere(inside != ahead)
        edges = edges[(edges[:, axis] < field.shape[axis] - 1)]
        step = np.eye(3, dtype=int)
        ring = [edges - step[u] - step[v], edges - step[v], edges, edges - step[u]]
        quads = np.stack([number[tuple(r.T)] for r in ring], 1)
        out = inside[tuple(edges.T)]
        faces += [quads[out], quads[~out][:, ::-1]]
    return cells, crossings(field, inside, cells), np.concatenate(faces)


def sample(field, p):
    """The field between its grid points, by trilinear interpolation; p in cells."""
    whole = np.floor(p).astype(int).clip(0, np.array(field.shape) - 2)
    part = p - whole
    value = 0
    for corner in CORNERS:
        weight = np.prod(np.where(corner, part, 1 - part), axis=1)
        value = value + weight * field[tuple((whole + corner).T)]
    return value


def slopes(field, p):
    return np.stack([sample(field, p + e) - sample(field, p - e) for e in np.eye(3) * 0.5], 1)


def normals(field, vertices):
    slope = slopes(field, vertices)
    return slope / np.linalg.norm(slope, axis=1)[:, None]


def relax(field, vertices, faces):
    """Moves each vertex to the middle of its neighbours, and from there back to the surface."""
    total, count = np.zeros_like(vertices), np.zeros(len(vertices))
    for k in range(4):
        np.add.at(total, faces[:, k], vertices[faces[:, (k + 1) % 4]] + vertices[faces[:, (k + 3) % 4]])
        np.add.at(count, faces[:, k], 2)
    p = total / count[:, None]
    for _ in range(2):
        slope = slopes(field, p)
        p = p - (sample(field, p) / np.maximum((slope**2).sum(1), 1e-3))[:, None] * slope
    return p


def open_edges(faces):
    """The edges that are not walked just twice, once each way. A closed surface has none."""
    edges = np.stack([faces, np.roll(faces, -1, 1)], -1).reshape(-1, 2)
    size = faces.max() + 1
    walks, backs = edges @ (size, 1), edges @ (1, size)
    walked, times = np.unique(walks, return_counts=True)
    return edges[np.isin(walks, walked[times != 1]) | ~np.isin(walks, backs)]


def closed(field):
    """The surface of a field in which gaps and walls as thin as a cell, where it would touch itself, are filled."""
    while True:
        cells, vertices, faces = surface(field)
        bad = open_edges(faces)
        if len(bad) == 0:
            return vertices, faces
        for corner in CORNERS:
            at = tuple((cells[np.unique(bad)] + corner).T)
            field[at] = np.minimum(field[at], -0.1 * np.abs(field[at]))
