"""The library and the program from Python: the same numbers by both routes, views, failures.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import gc
import os
import re

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


def test_tables(tmp_path, monkeypatch):
    path = tmp_path / "table.tsv"
    path.write_text("# hawser\n# x: 1\nnode\tT_N\tempty\tk\n1_2\t3.5\t\t1\n1_3\t\t\t2\n")
    for large in (1 << 20, 0):  # by pandas, where it is installed
        monkeypatch.setattr(results, "_LARGE", large)
        comments, table = results._table(path)
        assert comments == ["hawser", "x: 1"] and list(table["node"]) == ["1_2", "1_3"] and table["k"].dtype == float
        assert table["T_N"][0] == 3.5 and np.isnan(table["T_N"][1]) and np.isnan(table["empty"]).all()
    path.write_text("# hawser\n")
    assert len(results._table(path)[1]) == 0


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


def test_commands_that_write_text(tmp_path, scenes):
    checked = hawser.run("check", scenes / "chairlift.yaml")
    assert "a span of cable, without errors" in checked.text and checked.json == {} and len(checked.table) == 0
    assert hawser.run("init", None, "net").text.startswith("# Cables between nodes")
    assert "definitions" in hawser.run("schema").json
    page = tmp_path / "page.html"
    hawser.run("report", scenes / "chairlift.yaml", parts="statics", o=page)
    assert page.read_text(encoding="utf-8").startswith("<!DOCTYPE html>")
    with pytest.raises(hawser.InputError, match="scene.yaml:2:3.*EB"):
        hawser.run("check", {**SPAN, "cable": {"EB": 1.0}})


def test_sweeps_are_frames_and_grids(scenes):
    pytest.importorskip("pandas")
    over = {"tension.T0": "60 kN:100 kN:3", "cable.rho": ["5 kg/m", "6 kg/m"]}
    lines = []
    frame = hawser.sweep(SPAN, over, "statics", keep=["sag", "H"], progress=lines.append)
    assert lines and re.fullmatch(r"sweep: \d+ %, \d+ of about 6 variations.*", lines[0])
    assert list(frame.columns) == ["tension.T0_kN", "cable.rho_kg_m", "status", "sag_m", "H_N"] and len(frame) == 6
    assert frame.attrs["units"]["sag_m"] == "m" and frame.attrs["failures"] == []
    alone = hawser.run("statics", SPAN, set={"tension.T0": "80 kN"}).json["sag"]
    assert frame[(frame["tension.T0_kN"] == 80) & (frame["cable.rho_kg_m"] == 6)]["sag_m"].item() == alone
    with pytest.raises(hawser.InputError, match="cable.rho"):
        hawser.sweep(SPAN, {"cable.rho": []})
    with pytest.warns(UserWarning, match="no result of 1 of 2 variations"):
        partly = hawser.sweep(SPAN, {"tension.T0": ["80 kN", "-1 N"]}, "statics", keep=["sag"])
    assert list(partly["status"]) == [0, 1] and partly.attrs["failures"][0]["variation"] == 1
    pytest.importorskip("xarray")
    grid = hawser.sweep(SPAN, over, keep=["sag"], grid=True)
    assert grid["sag_m"].shape == (3, 2) and grid["sag_m"].attrs["units"] == "m"
    assert grid["sag_m"].sel({"tension.T0_kN": 80, "cable.rho_kg_m": 6}).item() == alone


def test_labels_branches_and_events(scenes):
    stay = {"cable": {"EA": "150 MN", "rho": "12 kg/m"}, "span": {"d": "80 m", "h": "35 m"}, "tension": {"T0": "600 kN"},
            "damping": {"ratio": "0.2 %"}, "load": {"frame": "local", "per_length": [0, 0, "1.5 N/m"]}, "model": {"modes": 2}}
    response = hawser.run("frf", stay, from_="0.98w1", to="1.02w1", branches=1)
    event = next(e for e in response.json["events"] if e["kind"] == "branch-point")
    motion = response.orbit(event["label"])
    assert motion.command == "orbit" and abs(motion.json["Omega"]/event["Omega"] - 1) < 1e-9
    again = response.restart(1, to="1w1")
    assert again["Omega_rad_s"][0] == pytest.approx(response["Omega_rad_s"][0], rel=1e-12)
    with pytest.raises(hawser.InputError, match="labels are of a result"):
        hawser.run("statics", stay).orbit(1)
    pytest.importorskip("pandas")
    assert set(response.frame("events")["branch"]) == {1, 2} and set(response.branches()) == {1, 2}
    assert len(response.branches()[2]) == (response["branch"] == 2).sum()
