"""Series of a scaling study: where each scene stands, which run counts there, and what is told."""

from dataclasses import replace

import pytest
from volumebench.error import ImageError
from volumebench.findings import findings_of
from volumebench.results import Record, SetUpTimes, record_of
from volumebench.scaling import growths, remarks, sentence
from volumebench.scaling_tables import scaling_tables
from volumebench.statistics import spread
from volumebench.study import SCALING, Dataset, Run, Scene, Series

EDGES = (8, 16, 32)


@pytest.fixture
def scaling(study):
    datasets = tuple(
        Dataset(f"cube-{edge}", (edge, edge, edge), "uint8", generator="shell", share=s)
        for edge, s in zip(EDGES, (0.01, 0.1, 1.0))
    )
    names = tuple(item.name for item in datasets)
    return replace(
        study,
        report=SCALING,
        datasets=datasets,
        transfer_functions={name: ("ramp",) for name in names},
        techniques=("single-pass", "vtk-gpu"),
        image_sizes=((40, 30),),
        paths=("engine",),
        series=(Series("By edge", "edge", names),),
    )


def row(
    edge: int,
    ms: float,
    technique: str = "single-pass",
    step: float | None = 1.0,
    rmse: float = 1e-2,
    size: tuple[int, int] = (40, 30),
    integrator: str | None = "Midpoint",
    settings: tuple = (),
    **more,
) -> Record:
    if technique == "vtk-gpu":
        step = integrator = None
    scene = Scene(f"cube-{edge}", "ramp", size)
    sampling = (technique, integrator, step)
    run = Run("small", scene, *sampling, "orbit-y", "engine", settings)
    facts = {"frame_ms": spread([ms]), "error": ImageError(rmse=rmse)} | more
    return record_of(run, (edge, edge, edge), "uint8", **facts)


def rows() -> list[Record]:
    """Time as the edge, set-up and bytes as its third power."""
    found = []
    for edge in EDGES:
        facts = {
            "setup_ms": SetUpTimes(edge**3 / 2, edge**3 / 4, edge**3 / 4, 1e6),
            "bytes_on_device": 2 * edge**3,
            "samples_taken": 100 * edge,
        }
        found.append(row(edge, 3.0 * edge, **facts))
        found.insert(0, row(edge, 1.0, settings=(("termination_threshold", 0),)))
        found.append(row(edge, 1.0, step=2.0))
        found.append(row(edge, 1.0, integrator="Segment"))
        found.append(row(edge, 5.0 * edge**2, "vtk-gpu"))
    return found


def by_quantity(study, records, technique="single-pass"):
    found = growths(study, records)
    return {item.quantity: item for item in found if item.technique == technique}


def test_exponents_of_one_sampling(scaling):
    """Compiling does not count as set-up; other steps, integrators and settings are no part of it."""
    found = by_quantity(scaling, rows())
    assert found["frame ms"].points == ((8, 24), (16, 48), (32, 96))
    exponents = {name: item.fit().exponent for name, item in found.items()}
    assert exponents == {
        "frame ms": pytest.approx(1),
        "set-up ms": pytest.approx(3),
        "bytes on the device": pytest.approx(3),
        "samples": pytest.approx(1),
    }
    theirs = by_quantity(scaling, rows(), "vtk-gpu")
    assert set(theirs) == {"frame ms"}, "what a peer does not tell is no quantity"
    assert theirs["frame ms"].fit().exponent == pytest.approx(2)


@pytest.mark.parametrize(
    "factor, places",
    [("edge", [8, 16, 32]), ("share", [0.01, 0.1, 1.0]), ("pixels", [1200] * 3)],
)
def test_places_along_a_factor(scaling, factor, places):
    names = tuple(f"cube-{edge}" for edge in EDGES)
    study = replace(scaling, series=(Series("S", factor, names),))
    found = by_quantity(study, rows())["frame ms"]
    assert [x for x, _ in found.points] == pytest.approx(places)


def test_pictures_of_several_sizes(scaling):
    sizes = ((10, 10), (20, 20))
    only = replace(scaling.datasets[0], image_sizes=sizes)
    names = (only.name,)
    study = replace(
        scaling,
        datasets=(only,),
        transfer_functions={only.name: ("ramp",)},
        series=(Series("P", "pixels", names),),
    )
    assert [scene.image_size for scene in study.scenes()] == list(sizes)
    records = [row(8, size[0] ** 2 / 10, size=size) for size in sizes]
    fit = by_quantity(study, records)["frame ms"].fit()
    assert fit.exponent == pytest.approx(1) and fit.half_width is None


def at_error(scaling):
    names = tuple(f"cube-{edge}" for edge in EDGES)
    return replace(scaling, series=(Series("E", "edge", names, rmse=1e-3),))


def test_equal_error_is_read_off_the_curve(scaling):
    """10 ms at 1e-2 to 1000 ms at 1e-4, times the edge: 100 ms at 1e-3, times the edge."""
    records = [
        row(edge, ms * edge, step=step, rmse=rmse)
        for edge in EDGES
        for ms, step, rmse in ((10, 2.0, 1e-2), (1000, 0.5, 1e-4))
    ]
    found = by_quantity(at_error(scaling), records)
    assert dict(found["frame ms"].points) == pytest.approx({8: 800, 16: 1600, 32: 3200})
    assert remarks(at_error(scaling), records) == []


def test_bounds_and_what_is_not_reached_are_left_out_and_told(scaling):
    records = [
        *(row(8, 10, rmse=1e-4), row(8, 20, step=0.5, rmse=1e-5)),
        *(row(16, 10, rmse=1e-2), row(16, 20, step=0.5, rmse=5e-3)),
        *(row(32, 10, rmse=1e-2), row(32, 20, step=0.5, rmse=1e-4)),
    ]
    study = at_error(scaling)
    assert [x for x, _ in by_quantity(study, records)["frame ms"].points] == [32]
    (text,) = remarks(study, records)
    assert "cube-8" in text and "cube-16" in text and "cube-32" not in text
    assert sentence(study, records).startswith("No series was measured")


def test_the_sentence_and_tables_tell_exponents(scaling):
    assert sentence(scaling, rows()) == (
        "The frame time of Single Pass grows as follows. By edge: edge^(1.00 \u00b1 0.00)."
    )
    exponents, numbers = scaling_tables(scaling, rows())
    assert exponents.rows[0][2:] == ("frame ms", "edge", "3", "1.00 \u00b1 0.00")
    assert numbers.header == ("technique", "quantity", "8", "16", "32")
    assert numbers.rows[0] == ("Single Pass", "frame ms", "24", "48", "96")


def test_a_volume_that_was_left_out_is_no_gap(scaling):
    smaller = scaling.without_datasets({"cube-32"}, "cube-32 is left out")
    found = by_quantity(smaller, rows())
    assert [x for x, _ in found["frame ms"].points] == [8, 16]
    assert smaller.notes == ("cube-32 is left out",)


def test_each_series_has_a_figure(scaling, tmp_path):
    empty = Series("Nothing", "edge", ("cube-8",), rmse=1e-9)
    study = replace(scaling, series=(*scaling.series, empty))
    found = findings_of(study, rows(), [], tmp_path)
    assert found.figures == (("scaling-1-edge.png", "By edge"),)
    picture = tmp_path / "plots" / "scaling-1-edge.png"
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert "Exponents of growth" in found.text()
