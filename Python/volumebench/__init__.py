"""VolumeBench: studies that report the image error of volume rendering against its run time."""

__version__ = "0.1.0"
