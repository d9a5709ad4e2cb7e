"""The Mega in the browser: a folder of static files, in which the compiled examples run on an emulated Mega, beside the
simulated autopilot, with a map.

    from playing import make_folder
    made = make_folder(Path("build/playground/site"))

`page/` are the files as they are served, `inside/` the Python that runs in the browser, beside that of simulation/ and
of tools/demonstration and tools/planning; the other modules here put the folder together, serve it and look at it.
`tools/playground` is the command line of it.
"""

from .folder import Made, NotMade, make_folder

__all__ = ["Made", "NotMade", "make_folder"]
