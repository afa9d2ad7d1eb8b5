"""A plant that grows under gravity and tropisms, live in a notebook.

>>> from bough_plant import Plant
>>> Plant(preset="figure-13c", fields=["loads.gravity"])  # doctest: +SKIP
"""

from pathlib import Path

import anywidget
import traitlets

__version__ = "0.1.0"
__all__ = ["Plant"]


class Plant(anywidget.AnyWidget):
    """A live plant. Everything that can be set has the name and the meaning that it has on ``<bough-plant>``."""

    _esm = Path(__file__).parent / "static" / "plant.js"

    preset = traitlets.Unicode(None, allow_none=True, help="Id of a preset, as 'figure-13c'.").tag(sync=True)
    params = traitlets.Dict(help="What differs from the preset, as {'loads': {'gravity': 3}}.").tag(sync=True)
    step = traitlets.Int(None, allow_none=True, min=1, help="The growth step; None is full grown.").tag(sync=True)
    view = traitlets.Enum(["plane", "space"], "plane").tag(sync=True)
    color = traitlets.Unicode("bark", help="'bark', or a quantity as 'moment'.").tag(sync=True)
    drawing = traitlets.Enum(["limb", "model"], "limb").tag(sync=True)
    controls = traitlets.Enum(["compact", "full", "none"], "compact").tag(sync=True)
    fields = traitlets.List(traitlets.Unicode(), help="Paths of the controls that come first.").tag(sync=True)
    theme = traitlets.Enum(["auto", "light", "dark"], "auto").tag(sync=True)
    alt = traitlets.Unicode(None, allow_none=True, help="What is seen, in words.").tag(sync=True)

    shown = traitlets.Dict(
        help="What is shown now: link, params (all of them), step, report, and the tip in metres. Empty before the first plant."
    ).tag(sync=True)
    problem = traitlets.Unicode(help="Why the last change could not be shown; empty when it could.").tag(sync=True)
