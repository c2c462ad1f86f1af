"""Lists of control points [x, value, ...]: values in between, and jumps as close pairs of points."""

from collections.abc import Sequence

Point = tuple[float, ...]

# Of the width of the domain; two points that lie closer stand for a jump.
JUMP_WIDTH = 2.0**-20


def value_at(points: Sequence[Point], x: float) -> tuple[float, ...]:
    """Return the values at x, straight between the points and constant beyond them."""
    if x <= points[0][0]:
        return tuple(points[0][1:])
    for before, after in zip(points, points[1:]):
        if x <= after[0]:
            share = (x - before[0]) / (after[0] - before[0])
            return tuple(
                a + share * (b - a) for a, b in zip(before[1:], after[1:], strict=True)
            )
    return tuple(points[-1][1:])


def ascending(steps: Sequence[tuple[float, Point, Point]]) -> tuple[Point, ...]:
    """Return points of (x, values below it, values from it on), x from 0 to 1, in order.

    Steps of one x are joined. A jump becomes two points, one a jump's width below x or, where the
    point before is as close, half way to it.
    """
    joined: list[list] = []
    for x, below, above in steps:
        if joined and joined[-1][0] == x:
            joined[-1][2] = above
        else:
            joined.append([x, below, above])
    points: list[Point] = []
    for x, below, above in joined:
        if below != above and x > 0:
            near = x - JUMP_WIDTH
            if points and near <= points[-1][0]:
                near = (points[-1][0] + x) / 2
            if not points or points[-1][0] < near < x:
                points.append((near, *below))
        points.append((x, *above))
    if len(points) == 1:
        return ((0.0, *points[0][1:]), (1.0, *points[0][1:]))
    return tuple(points)


def rescaled(points: Sequence[Point], low: float, high: float) -> tuple[Point, ...]:
    """Return points from low to high with x from 0 to 1 in its place."""
    return tuple(((point[0] - low) / (high - low), *point[1:]) for point in points)
