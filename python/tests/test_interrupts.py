"""Ctrl-C, by a timer: every long call ends within a second with KeyboardInterrupt and keeps what it has.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import signal
import threading
import time

import pytest
from test_hawser import SPAN

import hawser


@pytest.fixture(scope="module")
def model():
    return hawser.Model({**SPAN, "model": {**SPAN["model"], "modes": 6}})


def stopped(call, after=0.3, clock=time.process_time):
    """The exception of the call, which a signal interrupts; it ends within a second of that. The clock is that of the
    processor, since on a loaded machine a call may not have begun after this time."""
    before = signal.getsignal(signal.SIGINT)
    sent = []
    begin = clock()

    def interrupt():
        while clock() - begin < after:
            time.sleep(0.01)
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Thread(target=interrupt)
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt) as caught:
            call()
        assert time.monotonic() - sent[0] < 1.0 + float(os.environ.get("HAWSER_SLOW", "1"))  # other processes run too
    finally:
        timer.join()
    assert signal.getsignal(signal.SIGINT) is before
    return caught.value


def test_a_response_keeps_its_points(model):
    part = stopped(lambda: model.respond("0.5w1", "6w1", step=1e-4)).partial
    assert isinstance(part, hawser.Response) and len(part.point) > 3 and part.end == "interrupted"
    seen = []
    part = stopped(lambda: model.respond("0.5w1", "6w1", step=1e-4, progress=seen.append)).partial
    assert len(seen) > 3 and len(part.point) > 3


def test_a_motion_keeps_its_rows(model):
    part = stopped(lambda: model.integrate("0.95w1", until=1e5, every=0.1)).partial
    assert isinstance(part, hawser.Motion) and 3 < part.rows < 1e6 and part.interrupted


def test_a_model_is_left():
    big = hawser.Modes({**SPAN, "model": {**SPAN["model"], "modes": 60}})
    failure = stopped(lambda: [hawser.Model(big) for _ in range(1000)])
    assert not hasattr(failure, "partial")


def test_the_program_ends_with_what_it_has():
    part = stopped(lambda: hawser.run("frf", SPAN, from_="0.5w1", to="6w1", n=6, step=1e-4), after=1.0, clock=time.monotonic).partial
    assert isinstance(part, hawser.Result) and len(part.table) > 3 and part.json["end"].startswith("interrupted")
