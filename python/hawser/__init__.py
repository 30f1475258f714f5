"""hawser: linear and nonlinear dynamics of cables.

`run` starts the program's commands and returns their results. Scene, Statics, Modes and Model call the shared library,
whose arrays numpy then sees without a copy. Failures are exceptions, all of the class Error.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from ._library import function as _function
from .errors import ConvergenceError, Error, InputError, Interrupted, NoSolutionError, Status, SystemFailure
from .models import Model, Modes, Motion, Response, Scene, Statics
from .objects import Net, Ropeway, Span
from .results import Result, run
from .sweeps import sweep


def library_version() -> str:
    """The version of the shared library in use."""
    return str(_function("hawser_version")().decode())


__all__ = ["ConvergenceError", "Error", "InputError", "Interrupted", "Model", "Modes", "Motion", "Net", "NoSolutionError",
           "Response", "Result", "Ropeway", "Scene", "Span", "Statics", "Status", "SystemFailure", "library_version", "run", "sweep"]
