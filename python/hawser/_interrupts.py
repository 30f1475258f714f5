"""Ctrl-C during calls of the library and of the program: KeyboardInterrupt within a second, and what was computed is kept.

Python runs its handlers of signals between its own instructions, so that during a call of C it would run none. Long
computations call `progress`, which asks; the others run in a thread, which goes on alone where Ctrl-C is pressed.

SPDX-License-Identifier: GPL-3.0-or-later
"""
from __future__ import annotations

import ctypes
import signal
import subprocess
import sys
import threading
from contextlib import contextmanager
from typing import Any, Callable, Iterator, List, Optional, Union

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


Progress = Union[bool, Callable[[str], Any], None]
_MARK = "\x1b[K"  # before a line of progress


class _Follower(threading.Thread):
    """Reads what the program writes to standard error: lines of progress are shown, others kept."""

    def __init__(self, stream: Any, progress: Progress) -> None:
        super().__init__(daemon=True)
        self.stream, self.progress, self.said, self.shown = stream, progress, "", 0

    def run(self) -> None:
        for line in self.stream:
            if not line.startswith(_MARK):
                self.said += line.lstrip("\n")
            elif callable(self.progress):
                self.progress(line[len(_MARK):].rstrip())
            else:
                self.show(line[len(_MARK):].rstrip())
        if self.shown:
            self.show("")
        self.stream.close()

    def show(self, text: str) -> None:
        """On the line of the last one: in a terminal, and below a cell of a notebook."""
        sys.stderr.write("\r" + text.ljust(self.shown) + ("" if text else "\r"))
        sys.stderr.flush()
        self.shown = len(text)


def communicate(process: "subprocess.Popen[str]", timeout: Optional[float],
                progress: Progress) -> "tuple[str, str, Optional[BaseException]]":
    """The output of the program, and KeyboardInterrupt if Ctrl-C was pressed."""
    if not progress:
        return _communicate(process, timeout)
    follower = _Follower(process.stderr, progress)
    process.stderr = None
    follower.start()
    out, _, stop = _communicate(process, timeout)
    follower.join()
    return out, follower.said, stop


def _communicate(process: "subprocess.Popen[str]", timeout: Optional[float]) -> "tuple[str, str, Optional[BaseException]]":
    """The program is asked to end with what it has if Ctrl-C is pressed, which takes it less than a second."""
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
