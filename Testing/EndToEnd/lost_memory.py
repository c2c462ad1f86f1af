"""Tells the leak sanitizer when a test ends that leaves its program by os._exit, which passes it by."""

import ctypes


def report_lost_memory() -> None:
    """Have memory that nothing points to reported, where the sanitizer is loaded."""
    check = getattr(ctypes.CDLL(None), "__lsan_do_recoverable_leak_check", None)
    if check:
        check()
