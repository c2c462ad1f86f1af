"""Transfer functions in JSON files: opacity per unit distance and colour over scalar values.

`voreen_functions` and `paraview_presets` read and write other programs' files.
"""

import json
from dataclasses import dataclass, replace
from pathlib import Path

from .errors import StudyError
from .json_file import check_schema, read_json, write_atomically

TRANSFER_FUNCTION_FOLDER = (
    Path(__file__).resolve().parents[2] / "Data" / "TransferFunctions"
)
NORMALIZED = "normalized"


@dataclass(frozen=True)
class TransferFunction:
    """Control points over the normalised scalar range or over scalar values.

    The unit distance of the opacities is so many voxels or so many edges of the box; the other is
    None. In edges, the picture does not change with the resolution of the volume.
    """

    name: str
    description: str
    domain: str
    opacity: tuple[tuple[float, ...], ...]
    color: tuple[tuple[float, ...], ...]
    unit_distance_voxels: float | None
    unit_distance_edges: float | None = None

    def in_values(self, low: float, high: float) -> "TransferFunction":
        """Return the same function over scalar values, for data of this range."""
        if self.domain != NORMALIZED:
            return self
        width = high - low if high > low else 1.0

        def scaled(points: tuple[tuple[float, ...], ...]) -> tuple:
            return tuple((low + point[0] * width, *point[1:]) for point in points)

        return replace(
            self,
            domain="value",
            opacity=scaled(self.opacity),
            color=scaled(self.color),
        )

    def unit_distance(
        self, spacing: tuple[float, float, float], dims: tuple[int, int, int]
    ) -> float:
        """Return the unit distance in world units: voxels, or edges of the box, of mean length."""
        if self.unit_distance_voxels is not None:
            return self.unit_distance_voxels * sum(spacing) / 3
        edges = [(count - 1) * length for count, length in zip(dims, spacing)]
        return self.unit_distance_edges * sum(edges) / 3


def find_transfer_function(name: str, folders: list[Path]) -> Path:
    """Return the file NAME.json in the first folder that has it."""
    for folder in folders:
        candidate = folder / f"{name}.json"
        if candidate.is_file():
            return candidate
    looked = ", ".join(str(folder) for folder in folders)
    raise StudyError(
        f'transfer function "{name}": no file {name}.json; looked in {looked}'
    )


def load_transfer_function(path: Path) -> TransferFunction:
    """Read and validate one file."""
    document = read_json(path)
    check_schema(document, "transfer_function_schema.json", path)
    normalized = document["domain"] == NORMALIZED
    for key in ("opacity", "color"):
        _check_ascending(document[key], key, normalized, path)
    units = [document.get(f"unit_distance_{unit}") for unit in ("voxels", "edges")]
    if units.count(None) != 1:
        raise StudyError(
            f'{path}: needs one of "unit_distance_voxels" and "unit_distance_edges"'
        )
    return TransferFunction(
        document["name"],
        document.get("description", ""),
        document["domain"],
        tuple(tuple(float(value) for value in point) for point in document["opacity"]),
        tuple(tuple(float(value) for value in point) for point in document["color"]),
        *(None if value is None else float(value) for value in units),
    )


def save_transfer_function(function: TransferFunction, path: Path) -> None:
    """Write one file, which `load_transfer_function` reads as the same function."""
    document = {
        "schema": 1,
        "name": function.name,
        "description": function.description,
        "domain": function.domain,
        "opacity": function.opacity,
        "color": function.color,
        "unit_distance_voxels": function.unit_distance_voxels,
        "unit_distance_edges": function.unit_distance_edges,
    }
    lines = [
        f"  {json.dumps(key)}: {json.dumps(value)}"
        for key, value in document.items()
        if value is not None
    ]
    write_atomically(path, "{\n" + ",\n".join(lines) + "\n}\n")


def _check_ascending(
    points: list[list[float]], key: str, normalized: bool, path: Path
) -> None:
    for index, point in enumerate(points):
        x = point[0]
        if normalized and not 0 <= x <= 1:
            raise StudyError(
                f'{path}: "{key}[{index}]": x {x} is outside [0, 1], the normalized domain'
            )
        if index and x <= points[index - 1][0]:
            raise StudyError(
                f'{path}: "{key}[{index}]": x {x} is not above the one before it, '
                f"{points[index - 1][0]}"
            )
