# SPDX-License-Identifier: GPL-3.0-or-later
"""Small meshes for the examples and tests, made by numpy alone."""

from __future__ import annotations

import numpy as np


def surface_of_cubes(solid):
    """Return the vertices and faces of the boundary of unit cubes, given as a Boolean array.

    Cubes that touch each other along an edge or at a corner only must not occur.
    """
    solid = np.pad(np.asarray(solid, bool), 1)
    corners, squares = {}, []
    for axis in range(3):
        across, up = (axis + 1) % 3, (axis + 2) % 3
        for cube in np.argwhere(solid):
            for is_upper in (0, 1):
                neighbor = cube.copy()
                neighbor[axis] += 2 * is_upper - 1
                if solid[tuple(neighbor)]:
                    continue
                square = []
                for i, j in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    corner = cube.copy()
                    corner[axis] += is_upper
                    corner[across] += i
                    corner[up] += j
                    square.append(corners.setdefault(tuple(corner), len(corners)))
                squares.append(square if is_upper else square[::-1])
    squares = np.array(squares)
    faces = np.concatenate([squares[:, [0, 1, 2]], squares[:, [0, 2, 3]]])
    return np.array(list(corners), float) - 1, faces


def plate(holes=2, size=3):
    """Return a plate with holes in a row: a surface whose genus is the number of holes."""
    solid = np.ones(((2 * holes + 1) * size, 3 * size, size), bool)
    for hole in range(holes):
        first = (2 * hole + 1) * size
        solid[first : first + size, size : 2 * size] = False
    return surface_of_cubes(solid)


def body(arm=7, leg=10, trunk=12):
    """Return a flat body of cubes with a head, two arms and two legs."""
    solid = np.zeros((2 * arm + 6, 2, leg + trunk + 5), bool)
    left, right, neck = arm, arm + 6, leg + trunk
    solid[left:right, :, leg:neck] = True
    solid[:, :, neck - 3 : neck - 1] = True  # arms
    solid[left : left + 2, :, :leg] = True  # legs
    solid[right - 2 : right, :, :leg] = True
    solid[left + 2 : right - 2, :, neck:] = True  # head
    return surface_of_cubes(solid)


def sphere(rounds=3):
    """Return an icosahedron, subdivided and blown up to a sphere."""
    golden = (1 + 5**0.5) / 2
    vertices = [(s, t * golden, 0.0) for s in (-1.0, 1.0) for t in (-1.0, 1.0)]
    vertices += [(0.0, s, t * golden) for s in (-1.0, 1.0) for t in (-1.0, 1.0)]
    vertices += [(t * golden, 0.0, s) for s in (-1.0, 1.0) for t in (-1.0, 1.0)]
    points = np.array(vertices)
    near = np.linalg.norm(points[:, None] - points[None], axis=2) < 2.1
    faces = [
        (i, j, k)
        for i in range(12)
        for j in range(12)
        for k in range(12)
        if i < j and i < k and near[i, j] and near[j, k] and near[k, i] and j != k
        if np.linalg.det(points[[i, j, k]]) > 0
    ]
    faces = np.array(faces)
    for _ in range(rounds):
        points, faces = subdivided(points, faces)
    return points / np.linalg.norm(points, axis=1, keepdims=True), faces


def subdivided(points, faces):
    """Cut each face into four."""
    sides = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]], axis=2).reshape(-1, 2)
    edges, middle = np.unique(sides, axis=0, return_inverse=True)
    middle = middle.reshape(-1, 3) + len(points)
    points = np.concatenate([points, points[edges].mean(axis=1)])
    corners = [
        np.stack([faces[:, i], middle[:, i], middle[:, (i + 2) % 3]], axis=1) for i in range(3)
    ]
    return points, np.concatenate(corners + [middle])


def torus(around=24, along=36, radius=0.4):
    """Return a torus of large radius 1."""
    u, v = np.meshgrid(
        np.arange(along) * 2 * np.pi / along, np.arange(around) * 2 * np.pi / around, indexing="ij"
    )
    distance = 1 + radius * np.cos(v)
    points = np.stack([distance * np.cos(u), distance * np.sin(u), radius * np.sin(v)], axis=2)
    return points.reshape(-1, 3), _grid(along, around, True)


def tube(around=24, along=30, length=3.0, radius=1.0):
    """Return a tube that is open at both ends."""
    z, v = np.meshgrid(
        np.linspace(0, length, along + 1), np.arange(around) * 2 * np.pi / around, indexing="ij"
    )
    points = np.stack([radius * np.cos(v), radius * np.sin(v), z], axis=2)
    return points.reshape(-1, 3), _grid(along + 1, around, False)


def _grid(rows, columns, is_closed):
    """Return the triangles of a grid whose columns are closed, and perhaps its rows, too."""
    i, j = np.meshgrid(
        np.arange(rows if is_closed else rows - 1), np.arange(columns), indexing="ij"
    )
    next_i, next_j = (i + 1) % rows, (j + 1) % columns
    a, b = i * columns + j, next_i * columns + j
    c, d = next_i * columns + next_j, i * columns + next_j
    faces = [np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)]
    result = np.concatenate([f.reshape(-1, 3) for f in faces])
    return result if is_closed else result[:, ::-1]
