"""Scenes that test how data spread over ranks are drawn; a script of pvbatch that saves them all."""

import os
import sys
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import Any

from paraview import simple
from rank_blocks import blocks_held
from support import (
    SIZE,
    color_by,
    load_plugin,
    look,
    new_view,
    set_functions,
    show,
    technique_labels,
)

COLORS = [37.0, 0.1, 0.2, 0.9, 150.0, 0.9, 0.8, 0.2, 277.0, 1.0, 0.3, 0.1]
HAZE = [(37, 0.0), (130, 0.2), (160, 0.02), (277, 0.5)]
WALL = [(37, 0.0), (150, 0.0), (152, 1.0), (277, 1.0)]


def wavelet(half: int = 10, **settings: Any) -> Any:
    source = simple.Wavelet(WholeExtent=[-half, half] * 3, **settings)
    source.UpdatePipeline()
    return source


def show_volume(view: Any, source: Any, label: str = "", opacity: Any = HAZE) -> Any:
    """Show a source as a volume through the test's functions."""
    display = show(source, view, *([label] if label else []))
    color_by(display, view, "RTData")
    set_functions("RTData", COLORS, opacity)
    display.ScalarOpacityUnitDistance = 1.0
    return display


def haze(view: Any) -> None:
    show_volume(view, wavelet())
    look(view)


def wall(view: Any) -> None:
    show_volume(view, wavelet(), opacity=WALL).Integrator = "Segment"
    look(view)


def lit(view: Any) -> None:
    show_volume(view, wavelet(), opacity=WALL).Shade = 1
    look(view, 50, -30)


def gradient_opacity(view: Any) -> None:
    show_volume(view, wavelet()).GradientOpacity = 1
    look(view)


def inside(view: Any) -> None:
    show_volume(view, wavelet())
    camera = view.GetActiveCamera()
    camera.SetPosition(1.3, -0.7, -2.2)
    camera.SetFocalPoint(8, 3, 4)
    camera.SetViewAngle(70)


def parallel_projection(view: Any) -> None:
    show_volume(view, wavelet())
    view.CameraParallelProjection = 1
    look(view, 0, 0)


def along_a_face(view: Any) -> None:
    """The eye lies in the plane in which ranks meet."""
    show_volume(view, wavelet())
    camera = view.GetActiveCamera()
    camera.SetPosition(0.01, 40, 0.01)
    camera.SetFocalPoint(0, 0, 0)
    camera.SetViewUp(0, 0, 1)


def long_steps(view: Any) -> None:
    """Steps whose ends lie far in what other ranks draw."""
    display = show_volume(view, wavelet(), opacity=WALL)
    display.Integrator = "Segment"
    display.StepVoxels = 6.0
    look(view, 65, 10)


def cropped(view: Any) -> None:
    display = show_volume(view, wavelet())
    display.UseCropping = 1
    display.CroppingOrigin = [2.0, -3.0, 1.0]
    display.CroppingScale = [0.4, 0.5, 0.6]
    look(view)


def moved(view: Any) -> None:
    """The prop's own transform turns and stretches the data, and what ranks hold with it."""
    display = show_volume(view, wavelet())
    display.Orientation = [20.0, 130.0, 40.0]
    display.Position = [5.0, -3.0, 30.0]
    display.Scale = [1.0, 1.5, 0.7]
    look(view)
    camera = view.GetActiveCamera()
    camera.Azimuth(70)
    simple.ResetCamera(view)


def cells(view: Any) -> None:
    source = simple.PointDatatoCellData(Input=wavelet())
    display = show(source, view)
    color_by(display, view, "RTData", "CELLS")
    set_functions("RTData", COLORS, HAZE)
    display.ScalarOpacityUnitDistance = 1.0
    look(view)


def geometry(view: Any) -> None:
    """Opaque things in, in front of and behind the volume."""
    show_volume(view, wavelet())
    for center, radius in (((0, 0, 0), 6.0), ((12, 6, 14), 3.0), ((-14, -4, -15), 4.0)):
        ball = simple.Sphere(
            Center=center, Radius=radius, ThetaResolution=48, PhiResolution=48
        )
        display = simple.Show(ball, view, "GeometryRepresentation")
        display.DiffuseColor = [0.2, 0.8, 0.3]
        display.SetRepresentationType("Surface")
    look(view, 40, 25)


def out_of_sight(view: Any) -> None:
    """Only a ball is in the picture, which one rank draws."""
    show_volume(view, wavelet())
    ball = simple.Sphere(Center=(90, 10, 0), Radius=6.0)
    simple.Show(ball, view, "GeometryRepresentation").SetRepresentationType("Surface")
    camera = view.GetActiveCamera()
    camera.SetPosition(90, 10, 60)
    camera.SetFocalPoint(90, 10, 0)


def two_volumes(view: Any) -> None:
    """Two volumes apart, the cuts of which between ranks do not meet."""
    show_volume(view, wavelet())
    show_volume(view, wavelet(6, Center=[3.0, 2.0, 1.0])).Position = [4.0, 6.0, 20.0]
    look(view, 25, 15)


def two_volumes_behind(view: Any) -> None:
    """The same from the other side."""
    two_volumes(view)
    look(view, 200, 15)


def default_functions(view: Any) -> None:
    """Nothing is chosen to colour by: a ramp over the values of all ranks."""
    simple.ColorBy(show(wavelet(), view), None)
    look(view)


def maximum(view: Any) -> None:
    """No rank's picture goes over another's: one rank draws all."""
    show_volume(view, wavelet()).TechniqueBlendMode = "Maximum"
    look(view)


def samples(view: Any) -> None:
    show_volume(view, wavelet()).Show = "Samples per Pixel"
    look(view)


def row_of_blocks(view: Any) -> None:
    show_volume(view, blocks_held())
    look(view, 60, 20)


def blocks_apart(view: Any) -> None:
    """Ranks whose boxes do not touch, seen so that the last one is in front."""
    show_volume(
        view, blocks_held("[p for p in (0, 2) if rank == (p > 0) * (ranks - 1)]")
    )
    look(view, -70, 10)


def interleaved_blocks(view: Any) -> None:
    show_volume(view, blocks_held("range(rank, 4, ranks)"))
    look(view, 60, 20)


def overlapping_blocks(view: Any) -> None:
    """Refused: what both ranks hold would be drawn twice."""
    show_volume(
        view, blocks_held("[p for p in (0, 0.5) if rank == (p > 0) * (ranks - 1)]")
    )
    look(view)


def one_rank_has_all(view: Any) -> None:
    show_volume(view, blocks_held("range(4) if rank == ranks - 1 else []"))
    look(view, 60, 20)


def lit_blocks(view: Any) -> None:
    show_volume(view, blocks_held(), opacity=WALL).Shade = 1
    look(view, 20, 20)


def multi_block(view: Any) -> None:
    show_volume(view, blocks_held(kind="vtkMultiBlockDataSet"))
    look(view, 60, 20)


def non_overlapping_levels(view: Any) -> None:
    """Blocks of two resolutions side by side, which ranks cannot join."""
    show_volume(view, blocks_held(kind="vtkNonOverlappingAMR", fine=(1, 3)))
    look(view, 60, 20)


def levels_apart(view: Any) -> None:
    """Both of one rank's levels lie between those of the other."""
    held = "range(rank, 4, ranks)"
    show_volume(view, blocks_held(held, kind="vtkNonOverlappingAMR", fine=(2, 3)))
    look(view, -50, 20)


def overlapping_levels(view: Any) -> None:
    """Refused: the fine block lies in what the coarse ones hold."""
    held = "[p for p in (0, 1, 0.5) if rank == (p != 0) * (ranks - 1)]"
    places = (0, 1, 0.5)
    show_volume(
        view, blocks_held(held, kind="vtkOverlappingAMR", fine=(0.5,), places=places)
    )
    look(view)


def other_arrays(view: Any) -> None:
    """Ranks whose blocks have arrays that others do not have, and values of their own."""
    source = blocks_held(
        other="['only here'] if rank == 0 else []", change="* (place + 1) / 4"
    )
    show_volume(view, source).TechniqueBlendMode = "Gradient"
    look(view, 60, 20)


def error_target(view: Any) -> None:
    """Ranks with more to draw and less, which would take steps of other lengths."""
    exact(view)
    display = simple.GetDisplayProperties(view=view)
    display.SetRepresentationType("Volume Single Pass")
    display.ErrorTarget = 1e-2


def exact(view: Any) -> None:
    source = blocks_held(change="* (place + 1) / 4")
    show_volume(view, source, "Volume Reference")
    look(view, 60, 20)


def bright(view: Any) -> None:
    show_volume(view, wavelet())
    view.Background = [1.0, 0.9, 0.7]
    look(view)


def translucent_behind(view: Any) -> None:
    """What is seen through lies behind the volume, whose parts all come over it."""
    show_volume(view, wavelet())
    plane = simple.Plane(
        Origin=[-14, -14, -14], Point1=[14, -14, -14], Point2=[-14, 14, -14]
    )
    simple.Show(plane, view, "GeometryRepresentation").Opacity = 0.5
    look(view, 20, 10)


def of_technique(label: str) -> Callable[[Any], None]:
    def draw(view: Any) -> None:
        show_volume(view, wavelet(), label)
        look(view)

    return draw


def moved_later(view: Any) -> None:
    """A prop that moves between two pictures, and so changes the order of the ranks."""
    two_volumes(view)
    simple.Render(view)
    simple.GetDisplayProperties(view=view).Position = [30.0, 0.0, -12.0]
    simple.Render(view)
    look(view, 110, 15)


def scenes() -> dict[str, Callable[[Any], None]]:
    """Return what sets up each scene, by its name."""
    named = [
        haze,
        wall,
        lit,
        gradient_opacity,
        inside,
        parallel_projection,
        along_a_face,
        long_steps,
        cropped,
        moved,
        cells,
        geometry,
        out_of_sight,
        default_functions,
        maximum,
        samples,
        two_volumes,
        two_volumes_behind,
        moved_later,
        row_of_blocks,
        blocks_apart,
        interleaved_blocks,
        one_rank_has_all,
        lit_blocks,
        multi_block,
        non_overlapping_levels,
        levels_apart,
        other_arrays,
        error_target,
        exact,
        bright,
        translucent_behind,
    ]
    table = {function.__name__: function for function in named}
    for label in technique_labels():
        table[label.lower().replace(" ", "_")] = of_technique(label)
    return table


def refused() -> dict[str, Callable[[Any], None]]:
    """Return what sets up each scene that is not drawn, by its name."""
    return {f.__name__: f for f in (overlapping_blocks, overlapping_levels)}


def save_all(folder: Path, names: list[str]) -> None:
    for name in names:
        draw = (scenes() | refused())[name]
        view = new_view()
        draw(view)
        path = str(folder / f"{name}.png")
        simple.SaveScreenshot(path, view, ImageResolution=list(SIZE))
        write_what_ranks_took(folder / f"{name}.txt", view)
        simple.ResetSession()


def write_what_ranks_took(path: Path, view: Any) -> None:
    """Write the row of the panel that tells of every rank."""
    simple.Render(view)
    display = view.Representations[0]
    display.SMProxy.InvokeCommand("AskRanks")
    display.UpdatePropertyInformation()
    path.write_text(display.GetProperty("RanksText").GetData() or "", encoding="utf-8")


if __name__ == "__main__":
    load_plugin()
    try:
        save_all(Path(sys.argv[1]), sys.argv[2:])
    except Exception:  # the other ranks would wait for this one until they are killed
        traceback.print_exc()
        sys.stderr.flush()
        os._exit(1)
