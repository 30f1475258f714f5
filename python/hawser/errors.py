"""Failures as exceptions, with hawser's status and message.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import enum
from typing import Dict, Type


class Status(enum.IntEnum):
    """enum hawser_status of hawser/status.h (a test compares them)."""

    OK = 0
    ARGUMENT = 1
    SCENE = 2
    NO_SOLUTION = 3
    CONVERGENCE = 4
    NAN = 5
    MEMORY = 6
    IO = 7
    PROGRAM = 8


class Error(Exception):
    """hawser failed. `message` says what happened and what to do; `status` is the library's status, or None where
    only the program's exit status is known; `exit` is that exit status (1 usage or scene, 2 no solution, 3 not
    converged, 4 system)."""

    def __init__(self, message: str, status: "Status | None", exit: int) -> None:
        super().__init__(message)
        self.message, self.status, self.exit = message, status, exit


class InputError(Error, ValueError):
    """An invalid argument, option, scene or model file (exit 1)."""


class NoSolutionError(Error):
    """The problem has no solution (exit 2)."""


class ConvergenceError(Error, ArithmeticError):
    """An iteration did not reach its tolerance, or a value is not a number (exit 3)."""


class SystemFailure(Error):
    """Memory, a file, or another program (exit 4)."""


class Interrupted(Error):
    """A signal ended the run (exit 128 + its number)."""


_BY_EXIT: Dict[int, Type[Error]] = {1: InputError, 2: NoSolutionError, 3: ConvergenceError, 4: SystemFailure}
_EXIT = {Status.ARGUMENT: 1, Status.SCENE: 1, Status.NO_SOLUTION: 2, Status.CONVERGENCE: 3, Status.NAN: 3,
         Status.MEMORY: 4, Status.IO: 4, Status.PROGRAM: 4}


def error(status: Status, message: str) -> Error:
    """The exception of a status of the library."""
    code = _EXIT[status]
    return _BY_EXIT[code](message, status, code)


def exit_error(code: int, message: str) -> Error:
    """The exception of an exit status of the program."""
    return _BY_EXIT.get(code, Interrupted)(message, None, code)
