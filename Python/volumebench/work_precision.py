"""What a sweep tells: fronts of error against time, equal-error speed-ups, orders, sample ratios."""

import math
from dataclasses import dataclass

from .fits import power_law
from .results import OK, Record
from .study import Scene
from .summary import in_scene, is_peer, scenes_of
from .techniques import ENGINE, PARAVIEW, REFERENCE_TECHNIQUE, VIEW

VTK_GPU = "vtk-gpu"
PEER_PATHS = {PARAVIEW: VIEW, VTK_GPU: ENGINE}
LEVELS = (1e-2, 1e-3)
DOUBT_FACTOR = (
    10.0  # an error must exceed so many times the uncertainty of the reference
)
SAMPLE_INTEGRATORS = ("Midpoint", "Segment")
SAMPLE_BAR = 1 / 2  # in every scene
SAMPLE_MEAN_BAR = 1 / 3  # in the geometric mean
EXPECTED_ORDERS = {"Left": 1, "Midpoint": 2, "Segment": 2, "PreIntegrated": 2}
ORDER_TOLERANCE = 0.2
FLAT_ORDER = 0.5
NEVER_STOPPING = {"termination_threshold": 0}
LARGEST_ORDER_STEP = 1.0  # voxels: beyond it there is no trend yet


@dataclass(frozen=True)
class Point:
    """One measured run in the plane of time and error."""

    ms: float
    rmse: float
    record: Record


def points_of(records: list[Record]) -> list[Point]:
    """Return the runs that have a time and an error above 0."""
    return [
        Point(row.frame_ms.median, row.error.rmse, row)
        for row in records
        if row.status == OK and row.frame_ms.median and row.error.rmse
    ]


def is_doubtful(record: Record) -> bool:
    """Tell whether the reference is too uncertain for the error of a run."""
    doubt = record.error.reference_uncertainty
    return doubt is not None and (record.error.rmse or 0) < DOUBT_FACTOR * doubt


def front_of(points: list[Point]) -> list[Point]:
    """Return the points that none is both as fast and as accurate as, the fastest first."""
    front: list[Point] = []
    for point in sorted(points, key=lambda item: (item.ms, item.rmse)):
        if not front or point.rmse < front[-1].rmse:
            front.append(point)
    return front


@dataclass(frozen=True)
class Bracket:
    """Two neighbours on a front, and how far an error is from the coarse one in log-log."""

    coarse: Point
    fine: Point
    share: float

    def between(self, coarse: float, fine: float) -> float:
        """Return what lies at that share between two values, straight in log-log."""
        return coarse * (fine / coarse) ** self.share


def bracket_at(front: list[Point], rmse: float) -> Bracket | None:
    """Return the neighbours that an error lies between; None beyond the ends."""
    for coarse, fine in zip(front, front[1:]):
        if fine.rmse <= rmse <= coarse.rmse:
            share = math.log(coarse.rmse / rmse) / math.log(coarse.rmse / fine.rmse)
            return Bracket(coarse, fine, share)
    if len(front) == 1 and rmse == front[0].rmse:
        return Bracket(front[0], front[0], 0.0)
    return None


def time_at(front: list[Point], rmse: float) -> float | None:
    """Return the time at an error, on the front in log-log; None beyond its ends."""
    found = bracket_at(front, rmse)
    return found.between(found.coarse.ms, found.fine.ms) if found else None


@dataclass(frozen=True)
class EqualError:
    """A peer and the fastest of our runs at the same error; None where a front does not get there."""

    scene: Scene
    peer: str
    rmse: float
    at_peers_error: bool
    ours_ms: float | None
    peer_ms: float | None
    ours_is_bound: bool

    def speed_up(self) -> float | None:
        """Return how many times shorter our frame is; where ours is a bound, at least so many."""
        if self.ours_ms is None or self.peer_ms is None:
            return None
        return self.peer_ms / self.ours_ms


def equal_errors(records: list[Record], peer: str) -> list[EqualError]:
    """Return the comparisons with a peer, on the path that it is measured on."""
    rows = [row for row in records if row.path == PEER_PATHS[peer]]
    result = []
    for scene in scenes_of(rows):
        inside = points_of(in_scene(rows, scene))
        theirs = front_of([item for item in inside if item.record.technique == peer])
        ours = front_of([item for item in inside if not is_peer(item.record)])
        own = paraview_error(records, scene)
        wanted = [(level, False) for level in LEVELS] + [(own, True)] * bool(own)
        for rmse, is_own in wanted:
            result.append(_equal_error(scene, peer, rmse, is_own, ours, theirs))
    return result


def _equal_error(
    scene: Scene,
    peer: str,
    rmse: float,
    own: bool,
    ours: list[Point],
    theirs: list[Point],
) -> EqualError:
    """Compare two fronts; our fastest run stands for coarser errors, which can only cost less."""
    bound = bool(ours) and rmse > ours[0].rmse
    ours_ms = ours[0].ms if bound else time_at(ours, rmse)
    return EqualError(scene, peer, rmse, own, ours_ms, time_at(theirs, rmse), bound)


def paraview_error(records: list[Record], scene: Scene) -> float | None:
    """Return the error of ParaView's Volume in a still picture."""
    row = paraview_row(records, scene)
    return row.error.rmse if row else None


def paraview_row(records: list[Record], scene: Scene) -> Record | None:
    """Return the row of ParaView's Volume in a still picture, if it was measured."""
    for row in in_scene(records, scene):
        if row.technique == PARAVIEW and row.path == VIEW and row.status == OK:
            return row
    return None


def geometric_mean(factors: list[float]) -> float:
    """Return the geometric mean of positive numbers."""
    return math.exp(math.fsum(map(math.log, factors)) / len(factors))


def sentence(records: list[Record]) -> str:
    """Return the one sentence to quote: the speed-up over ParaView's Volume at its own error."""
    own = [item for item in equal_errors(records, PARAVIEW) if item.at_peers_error]
    factors = [item.speed_up() for item in own if item.speed_up()]
    if not factors:
        return "No technique was measured that is as accurate as ParaView's Volume."
    low, high = min(factors), max(factors)
    scenes = f"{len(factors)} scene" + ("s" if len(factors) > 1 else "")
    text = (
        f"At equal error, VolumeBench draws still pictures {geometric_mean(factors):.1f} times as "
        f"fast as ParaView's Volume (geometric mean over {scenes}; {low:.1f} to {high:.1f} times)"
    )
    lacking = len(own) - len(factors)
    if lacking:
        text += f"; in {lacking} more its error was not reached"
    return text + "."


@dataclass(frozen=True)
class Order:
    """How fast the error of an integrator falls with its step in a scene."""

    scene: Scene
    technique: str
    integrator: str
    order: float
    steps: tuple[float, ...]
    stopping: bool  # measured on rays that stop early

    def expected(self) -> int:
        """Return the order for smooth data and functions."""
        return EXPECTED_ORDERS[self.integrator]

    def is_low(self) -> bool:
        """Tell whether it is clearly below that."""
        return self.order < self.expected() - ORDER_TOLERANCE

    def is_flat(self) -> bool:
        """Tell whether the error hardly depends on the step."""
        return self.order < FLAT_ORDER


def orders(records: list[Record]) -> list[Order]:
    """Return the orders of each technique, from steps up to a voxel whose errors can be trusted.

    Each is the slope of a straight line through at least three points in log-log: of rays that
    never stop early, where these were measured, since what a ray leaves out has no order.
    """
    result = []
    for scene in scenes_of(records):
        rows = [
            point.record
            for point in points_of(in_scene(records, scene))
            if _has_order(point.record)
        ]
        for method in dict.fromkeys((row.technique, row.integrator) for row in rows):
            own = [row for row in rows if (row.technique, row.integrator) == method]
            stopping = not any(row.settings for row in own)
            curve = {
                row.step_voxels: row.error.rmse
                for row in own
                if stopping or row.settings
            }
            if len(curve) > 2:
                steps = tuple(sorted(curve))
                order = Order(
                    scene,
                    *method,
                    power_law(list(curve.items())).exponent,
                    steps,
                    stopping,
                )
                result.append(order)
    return result


def _has_order(row: Record) -> bool:
    return (
        row.integrator in EXPECTED_ORDERS
        and row.path == ENGINE
        and row.settings in ({}, NEVER_STOPPING)
        and row.step_voxels <= LARGEST_ORDER_STEP
        and not is_doubtful(row)
    )


@dataclass(frozen=True)
class SampleRatio:
    """The samples of the cheapest run of ours that is as accurate as ParaView's Volume."""

    scene: Scene
    paraview: Record
    ours: Record | None

    def ratio(self) -> float | None:
        """Return our samples over ParaView's."""
        if self.ours is None:
            return None
        return self.ours.samples_taken / self.paraview.samples_taken


def sample_ratios(records: list[Record]) -> list[SampleRatio]:
    """Return the ratio of each scene in which ParaView's samples were counted.

    Ours are measured points of single pass, whose error with its uncertainty does not exceed
    ParaView's: nothing is interpolated.
    """
    result = []
    for scene in scenes_of(records):
        theirs = paraview_row(records, scene)
        if theirs is None or not theirs.samples_taken or theirs.error.rmse is None:
            continue
        fair = [
            point.record
            for point in points_of(in_scene(records, scene))
            if _may_count(point.record)
            and point.rmse + (point.record.error.reference_uncertainty or 0)
            <= theirs.error.rmse
        ]
        cheapest = min(fair, key=lambda row: row.samples_taken, default=None)
        result.append(SampleRatio(scene, theirs, cheapest))
    return result


def _may_count(row: Record) -> bool:
    return (
        row.technique == REFERENCE_TECHNIQUE
        and row.integrator in SAMPLE_INTEGRATORS
        and bool(row.samples_taken)
    )


def samples_verdict(ratios: list[SampleRatio]) -> str | None:
    """Return one sentence that holds the ratios against the bar; None without any."""
    if not ratios:
        return None
    known = [item.ratio() for item in ratios if item.ratio() is not None]
    if not known:
        return "No run of ours was as accurate as ParaView's Volume: no samples to compare."
    mean, worst = geometric_mean(known), max(known)
    complete = len(known) == len(ratios)
    met = complete and worst <= SAMPLE_BAR and mean <= SAMPLE_MEAN_BAR
    text = (
        f"At ParaView's own error we take {mean:.2f} of its samples (geometric mean over "
        f"{len(known)} of {len(ratios)} scenes; at most {worst:.2f})"
    )
    return text + (
        ": the bar of 1/2 in every scene and 1/3 in the mean is "
        + ("met." if met else "not met.")
    )
