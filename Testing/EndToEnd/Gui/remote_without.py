"""ParaView's window without the plugin, as the client of a server that has it: told what to do."""

import os
from pathlib import Path

from paraview import simple
from parallel import server
from remote import connect, leave, take_messages
from window import apply, trigger, wait_until


def check_the_missing_plugin_is_named() -> None:
    assert not hasattr(simple, "VolumeBenchmark"), "the client has the plugin"
    folder = Path(os.environ["VOLUMEBENCH_PLUGIN"]).parent
    said: list[str] = []
    with server(["env", f"PV_PLUGIN_PATH={folder}"], complains=True) as port:
        connect(port, with_plugin=False)
        trigger("Sources", "Alphabetical", "Wavelet")
        apply()
        wait_until(lambda: said.extend(take_messages()) or said, "what ParaView says")
        leave()
        said += take_messages()
    ours = [one for one in said if "the client has not" in one]
    assert ours, said
    for part in ("The server has the plugin VolumeBench", "Local Plugins > Load New"):
        assert part in ours[0], ours
