"""The library and the program from Python: the same numbers by both routes, views, failures.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import gc
import os

import numpy as np
import pytest

import hawser
from hawser import results, scenes as forms

SPAN = {"cable": {"EA": "400 MN", "rho": 6.0}, "span": {"d": "250 m", "h": 10}, "tension": {"T0": "80 kN"},
        "damping": {"alpha": 0.08}, "load": {"frame": "local", "per_length": [0.8, 0.8, 0.8]},
        "model": {"modes": 3, "condense": "static", "energy": "quartic"}}


@pytest.fixture(scope="module")
def model():
    return hawser.Model(SPAN)


@pytest.fixture(scope="module")
def response(model):
    return model.respond("0.98w1", "1.02w1")


def test_response_equals_the_programs(model, response):
    result = hawser.run("frf", SPAN, from_="0.98w1", to="1.02w1")
    assert len(result.table) == len(response.point) == len(result.json["points"])
    assert np.allclose(result["Omega_rad_s"], response.omega_si, rtol=1e-13, atol=0)
    mid = response.probe[:, model.probes.index("mid"), 2] * model.length
    assert np.allclose(result["z_mid_m"], mid, rtol=1e-11, atol=0)
    assert np.allclose(result["T_max_N"], response.tension[:, 1], rtol=1e-12, atol=0)
    assert [e["kind"] for e in result.json["events"]] == response.event_names
    assert response.end.startswith("end of the range")
    assert (result["stable"] > 0).tolist() == response.stable.tolist()


def test_arrays_are_views_that_keep_their_memory(response, model):
    assert response.state.shape == (len(response.point), 2*model.n)
    assert np.shares_memory(response.state, response.state)
    with pytest.raises(ValueError):
        response.coordinate[0, 0] = 1.0
    other = hawser.Model(SPAN)
    K, expected = other.K, model.K.copy()
    del other
    gc.collect()
    filler = [np.full(K.shape, 7.0) for _ in range(1000)]  # would take memory that was released
    assert np.array_equal(K, expected) and len(filler) == 1000


def test_statics_and_modes():
    statics = hawser.Statics(SPAN)
    table = hawser.run("statics", SPAN, points=11)
    rows = statics.profile(11)
    assert statics.T0 == 80000.0 and abs(statics.sag - 5.76337268652) < 1e-10
    for name in ("S", "x", "y"):
        assert np.allclose(table[name + "_m"], rows[name], rtol=1e-14, atol=1e-12)
    modes = hawser.Modes(statics, n=4)
    listed = hawser.run("modes", SPAN, n=4)
    assert np.allclose(listed["omega_rad_s"], modes.omega_si, rtol=1e-13, atol=0)
    assert modes.shape.shape == (4, len(modes.s), 3) and np.all(np.diff(modes.s) > 0)


def test_motion_obeys_the_equations(model):
    motion = model.integrate("0.95w1", until=2.0, every=0.01)
    u, t = motion.state[:, :model.n], motion.time
    v = np.gradient(u, t, axis=0)[5:-5]
    assert np.abs(v - motion.state[5:-5, model.n:]).max() < 1e-4*np.abs(v).max()
    assert motion.time_si[-1] == pytest.approx(2.0, rel=1e-14)


def test_progress_stops_and_raises(model):
    seen = []
    part = model.respond("0.98w1", "1.02w1", progress=lambda fraction: seen.append(fraction) or len(seen) >= 3)
    assert len(part.point) == 3 and part.end == "interrupted"
    with pytest.raises(ZeroDivisionError):
        model.respond("0.98w1", "1.02w1", progress=lambda fraction: 1/0)


def test_failures_are_exceptions():
    with pytest.raises(hawser.NoSolutionError, match="below the least one") as caught:
        hawser.run("statics", SPAN, set={"tension.T0": "5 kN"})
    assert caught.value.exit == 2
    with pytest.raises(hawser.NoSolutionError, match="below the least one") as caught:
        hawser.Statics(hawser.Scene(SPAN, set={"tension.T0": "5 kN"}))
    assert caught.value.status is hawser.Status.NO_SOLUTION
    with pytest.raises(hawser.InputError, match="scene.yaml:2:3.*EB"):
        hawser.run("statics", {**SPAN, "cable": {"EB": 1.0}})
    with pytest.raises(ValueError, match="missing.yaml"):
        hawser.Scene("missing.yaml")
    with pytest.raises(hawser.InputError, match="unknown option|--fast"):
        hawser.run("statics", SPAN, fast=True)
    with pytest.raises(hawser.InputError, match="0.9w1"):
        hawser.Model(SPAN).respond("0.9 Hz", "1w1")
    with pytest.raises(TypeError, match="no value None"):
        hawser.run("statics", {**SPAN, "cable": {"EA": None}})


def test_scene_forms(scenes):
    scene = hawser.Scene(SPAN, set={"cable.rho": 7})
    assert scene["cable.rho"] == 7.0 and scene["load.frame"] == "local" and scene["cable.EA"] == 4e8
    assert forms.text({"cable": {"EA": float("inf"), "rho": 1e-3}, "attach": [{"at": 0.5, "mass": "2 kg"}]}) == (
        'cable:\n  EA: .inf\n  rho: 0.001\nattach:\n  - {at: 0.5, mass: "2 kg"}\n')
    assert len(hawser.run("tow steady", scenes / "tow-orbit.yaml").table) > 2


def test_names_are_no_numbers():
    _, table = results._table("node\tT_N\n1_2\t3.5\n1_3\t\n")
    assert list(table["node"]) == ["1_2", "1_3"] and table["T_N"][0] == 3.5 and np.isnan(table["T_N"][1])


@pytest.mark.skipif(not os.environ.get("HAWSER_LONG"), reason="their import takes seconds: HAWSER_LONG=1")
def test_pictures_and_frames(response):
    pandas = pytest.importorskip("pandas")
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from hawser import plots
    result = hawser.run("statics", SPAN, points=5)
    assert list(result.frame().columns) == list(result.table.dtype.names)
    assert isinstance(hawser.run("modes", SPAN, n=2).frame("modes"), pandas.DataFrame)
    assert "mid" in plots.response(response).get_ylabel()
