"""The one exception of the package: bad input, told in one line that names file, key and limit."""


class BenchError(Exception):
    """Bad input or an unusable folder; the message is the whole story and fits one line."""

    def __init__(self, message: str) -> None:
        super().__init__(" ".join(str(message).split()))


class StudyError(BenchError):
    """A study, a volume description or a transfer function that cannot be used."""


class OutputError(BenchError):
    """Results cannot be written: the disk is full, or the folder gone; the study ends."""
