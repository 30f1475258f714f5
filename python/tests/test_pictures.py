"""Every command's picture: which axes it has and how many lines. With HAWSER_LONG=1 all of them, otherwise a few.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re
import subprocess

import pytest

import hawser
from hawser import _library, interactive, pictures

LONG = bool(os.environ.get("HAWSER_LONG"))
# command | arguments | of each panel title of x, title of y: number of lines (panels in space are listed last)
TABLE = """
statics | chairlift.yaml | Distance x (m), Height y (m): 1; S (m), Tension T (N): 1
statics | b-table-3.5.yaml | x (m), y (m): 1; S (m), Tension (N): 1
statics | net-table-3-1.yaml | cable, Tension (N): 2
statics | ropeway-bouquet.yaml | tower, Tension (N): 4
statics | rod-pipe.yaml | s (m), Tension (N): 1; Place x (m), Place z (m): 1
modes | chairlift.yaml -n 4 | Mode, Frequency (Hz): 2
modes | net-table-3-1.yaml | Mode, Frequency (Hz): 1
modes | ropeway-small.yaml | Mode, Frequency (Hz): 2
modes | stay-damper.yaml --over attach.0.damper[2]=5e3:2e6:6 -n 4 | attach.0.damper[2] (N.s/m), Damping ratio ζ: 4
modes | stay-damper.yaml --damped -n 4 | Mode, Frequency (Hz): 2
modes | b-table-5.1-hauling-rope.yaml -n 4 | Mode, Frequency (Hz): 2
irvine | chairlift.yaml -n 6 | Irvine's parameter λ, Frequency: 9
campbell | b-table-5.1-hauling-rope.yaml | Speed (m/s), Imaginary part (rad/s): 10
beam | d-figure-9.4.yaml --to 10 | Travel speed, Imaginary part: 10; Travel speed, Real part: 16
beam | d-figure-9.1.yaml | Real part, Imaginary part: 6
integrate | duffing.json --Omega 0.9 --until 50 | Time t, Displacement: 1
integrate | chairlift.yaml --Omega 0.95w1 --until 10T | Time t (s), Displacement (m): 2
integrate | net-impact.yaml --until 0.1s | Time t (s), Place (m): 3
integrate | d-section-5.1.4.yaml --until 1s | Time t (s), Place (m): 3
transient | ropeway-transient.yaml | Time t (s), Speed (m/s): 2; Time t (s), Force (N): 2; Time t (s), Tension (N): 3; Time t (s), Travel of the carriage (m): 1; Time t (s), Least pressing force (N): 1
transient | ropeway-transient.yaml --pass p1 | t (s), Tension (N): 2; t (s), Pressing force (N): 1
trajectory | d-section-5.2.5.yaml | x (m), z (m): 1
tow | tow-u-turn.yaml | Time t (s), tilt (rad): 1; Time t (s), Tension (N): 2; X (m), Z (m): 2
tow steady | tow-orbit.yaml | s (m), Tension T (N): 1; x (m), z (m): 1
frf | duffing.json --from 0.8 --to 1.8 | Forcing frequency Ω, Amplitude: 3
frf | bridge-stay.yaml --from 0.98w1 --to 1.02w1 --branches 1 | Forcing frequency Ω (rad/s), Amplitude (m): 2
folds | duffing.json --from 0.8 --to 1.8 | Forcing frequency Ω, load factor: 3
locus | duffing.json --over factor.damping=0.5:2 --from 0.8 --to 1.8 | Forcing frequency Ω, factor.damping: 2
nnm | two-masses.json --energy-to 1e3 | Energy, Frequency Ω: 2
mms | b-table-4.5.yaml -n 12 --set model.condense=static | Forcing frequency Ω (rad/s), Amplitude (m): 2
hill | --mathieu | delta, epsilon: 7
map | duffing.json --x Omega=0.8:1.8 --y factor.damping=0.5:2 --points 8x8 | Ω, factor.damping: 0; multiplier: 0
integrate | duffing.json --Omega 0.9 --until 50 --spectrum | Frequency, Amplitude: 1
modes | chairlift.yaml --shapes --points 9 | Arclength S (m), shape: 5
compare | b-table-4.4-line-2.yaml --from 0.8w1 --to 1.6w1 | Processor time (s), Error of the response, relative: 6
compare modes | chairlift.yaml | Time (s), Error of the frequencies, relative: 4
compare mms | b-table-4.5.yaml -n 12 --set model.condense=static | e, Omega distance (rad/s): 2
identify | bridge-stay.yaml stay-frequencies.tsv --free tension.T0 | Measured frequency (Hz), Computed/measured − 1: 2
statics | net-table-3-1.yaml --profile | S (m), Tension (N): 26; Place x (m), Place z (m): 26
statics | ropeway-bouquet.yaml --profile --units kN | Horizontal position x (m), Height y (m): 2; S (m), Tension (kN): 2
statics | chairlift.yaml --models | model, Error, relative: 4
frf | duffing.json --from 0.8 --to 1.8 --sweep both | Forcing frequency Ω, Amplitude: 5
modes | ropeway-small.yaml --shapes | S (m), shape: 12
campbell | b-table-5.1-hauling-rope.yaml --unit Hz | Speed (m/s), Imaginary part (Hz): 10
"""
ROWS = [[part.strip() for part in line.split("|")] for line in TABLE.strip().split("\n")]
FEW = ("statics | chairlift.yaml |", "frf | duffing.json --from 0.8 --to 1.8 |", "statics | ropeway-bouquet.yaml --profile")
WITHOUT = {"init", "check", "plan", "schema", "rom", "merge", "damping", "report", "completion"}


def drawn(command, arguments):
    words = arguments.split()
    scene = None if words[0].startswith("-") else words.pop(0)
    result = hawser.run(command, scene, *words)
    return result, result.plot().figure


def test_every_command_has_a_picture_or_none():
    text = subprocess.run([_library.program(), "--help"], capture_output=True, text=True, check=True).stdout
    commands = set(re.findall(r"^  ([a-z]+(?: [a-z]+)?)   +[A-Z]", text, re.M))
    assert commands - WITHOUT == set(pictures.PICTURES)
    assert {row[0] for row in ROWS} >= set(pictures.PICTURES) - {"orbit", "sweep", "compare motion"}


@pytest.mark.parametrize("row", [row for row in ROWS if LONG or " | ".join(row).startswith(FEW)], ids=lambda row: " ".join(row[:2]))
def test_pictures(row, scenes, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    monkeypatch.chdir(scenes)
    _, figure = drawn(*row[:2])
    panels = [", ".join(filter(None, (a.get_xlabel(), a.get_ylabel()))) + f": {len(a.lines)}" for a in figure.axes]
    assert "; ".join(panels) == row[2]
    figure.canvas.draw()  # which fails where a size or a limit is no number
    matplotlib.pyplot.close(figure)


def test_columns_have_titles_and_units(scenes):
    result = hawser.run("frf", scenes / "bridge-stay.yaml", from_="0.98w1", to="0.99w1", n=2, max_points=3, units="Hz, mm")
    assert result.keys[0] == "Omega" and result.names[0] == "Omega_Hz" and result.unit("Omega_Hz") == "Hz"
    assert result.title("Omega_Hz") == "Forcing frequency Ω" and result.find("y_mid z_*") == ["y_mid_mm"] + result.find("z_*")
    assert result.find("stable+1") == ["unstable"] and result.unit("stable") == ""
    orders = hawser.run("hill", scenes / "duffing.json", Omega=1.1)
    assert [orders.unit(orders.find(key)[0]) for key in ("modulus", "argument")] == ["", "rad"]


def test_without_a_picture_it_is_an_error(scenes):
    result = hawser.run("rom", scenes / "duffing.json")
    with pytest.raises(hawser.InputError, match="has no picture: name the columns"):
        result.plot()
    with pytest.raises(hawser.InputError, match="no column w.*it has tensor"):
        result.plot("tensor", "w")


def test_interactive_pictures_have_the_same_curves(scenes, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    monkeypatch.chdir(scenes)
    result, figure = drawn("frf", "duffing.json --from 0.8 --to 1.8")
    spec = interactive.spec(figure)
    lines = [one for one in spec["data"] if one["mode"] == "lines"]
    assert [one["line"]["dash"] for one in lines] == ["solid", "dash"] and lines[0]["line"]["color"] == lines[1]["line"]["color"]
    assert max(y for one in lines for y in one["y"] if y) == pytest.approx(result["u_1"].max(), rel=1e-12)
    marks = [one for one in spec["data"] if one["mode"] == "markers"]
    assert sum(len(one["x"]) for one in marks) == len(result.json["events"]) and spec["layout"]["xaxis"]["title"]["text"].startswith("Forcing")
    matplotlib.pyplot.close(figure)
    try:
        import plotly
    except ImportError:
        with pytest.raises(hawser.Error, match="need plotly"):
            result.plotly()
    else:
        assert plotly and len(result.plotly().data) == len(spec["data"])
