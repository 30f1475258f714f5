"""Ctrl-C during calls of the library and of the program: KeyboardInterrupt within a second, and what was computed is kept.

Python runs its handlers of signals between its own instructions, so that during a call of C it would run none. Long
computations call `progress`, which asks; the others run in a thread, which goes on alone where Ctrl-C is pressed.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import signal
import subprocess
import threading
from contextlib import contextmanager
from typing import Any, Callable, Iterator, List, Optional

from ._library import call, struct


@contextmanager
def noticed() -> Iterator[List[BaseException]]:
    """The exceptions to raise: Ctrl-C adds one, instead of raising it anywhere, in the thread that Python gives it to."""
    raised: List[BaseException] = []
    ours = (threading.current_thread() is threading.main_thread()
            and signal.getsignal(signal.SIGINT) is signal.default_int_handler)
    if ours:
        signal.signal(signal.SIGINT, lambda number, frame: raised.append(KeyboardInterrupt()))
    try:
        yield raised
    finally:
        if ours:
            signal.signal(signal.SIGINT, signal.default_int_handler)


@contextmanager
def ended(options: ctypes.Structure, result: Any, progress: Optional[Callable[[float], bool]] = None) -> Iterator[None]:
    """A computation with these options ends early where `progress` returns True or raises an exception, or on Ctrl-C. The
    exception has what was computed as its attribute `partial`: the result."""
    state = struct("hawser_progress_state")
    with noticed() as raised:
        def watch(_: Any, address: int) -> int:
            try:
                return int(bool(raised) or bool(progress and progress(state.from_address(address).fraction)))
            except BaseException as failure:  # an exception cannot pass through C
                raised.append(failure)
                return 1

        callback = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(watch)
        options.progress.function = ctypes.cast(callback, ctypes.c_void_p).value
        try:
            yield
        finally:
            if raised:
                raised[0].partial = result  # type: ignore[attr-defined]
                raise raised[0]  # and not the failure to which the end may have led


def call_apart(name: str, *arguments: Any) -> None:
    """The same as `call`, for functions without progress. On Ctrl-C the computation goes on by itself, with its arguments,
    until it is done; nobody sees its result."""
    failures: List[BaseException] = []

    def work() -> None:
        try:
            call(name, *arguments)
        except BaseException as failure:
            failures.append(failure)

    if threading.current_thread() is not threading.main_thread():
        call(name, *arguments)
        return
    thread = threading.Thread(target=work, daemon=True)
    thread.start()
    thread.join()
    if failures:
        raise failures[0]


def communicate(process: "subprocess.Popen[str]", timeout: Optional[float]) -> "tuple[str, str, Optional[BaseException]]":
    """The output of the program, and KeyboardInterrupt if Ctrl-C was pressed. The program is then asked to end with what it
    has, which takes it less than a second."""
    try:
        return (*process.communicate(timeout=timeout), None)
    except KeyboardInterrupt as stop:
        process.send_signal(signal.SIGINT)
        try:
            return (*process.communicate(timeout=1.0), stop)
        except subprocess.TimeoutExpired:
            process.kill()
            return (*process.communicate(), stop)
    except BaseException:
        process.kill()
        process.communicate()
        raise
