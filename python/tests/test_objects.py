"""Scenes as objects: the same results as their files, messages, pickles.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import pickle

import numpy as np
import pytest

import hawser


def span(**more):
    return hawser.Span(EA="400 MN", rho="6 kg/m", d="250 m", h="10 m", T0="80 kN", damping={"alpha": "0.08 kg/m/s"},
                       load={"frame": "local", "per_length": [0.8, 0.8, 0.8]}, **more)


def test_a_span_is_its_file(scenes):
    of_file = hawser.run("statics", scenes / "chairlift.yaml").json
    assert span().run("statics").json["sag"] == of_file["sag"] == hawser.Statics(span()).sag
    assert span().scene["cable"] == {"EA": "400 MN", "rho": "6 kg/m"} and "without errors" in span().check()
    page = span()._repr_html_()
    assert "<code>cable.EA</code></td><td>400 MN</td><td>axial stiffness" in page and page.count("<tr>") == 8
    assert repr(eval(repr(span()), {"Span": hawser.Span})) == repr(span())


def test_a_span_in_water_is_a_mesh():
    span = hawser.Span(EA="20 MN", rho="12 kg/m", d="200 m", h="10 m", length0="250 m", cable={"diameter": "0.1 m"},
                       water={"density": "1025 kg/m^3", "surface": "200 m"}, dynamics={"step": 0.1})
    assert "without errors" in span.check()
    assert hawser.Span(density="1.2 kg/m^3").scene == {"wind": {"density": "1.2 kg/m^3"}}


def test_a_net_is_its_file(scenes):
    net = (hawser.Net().node("A", 0, 0, 0).node("B", "300 m", 0, 0).node("J", mass="12 kg", load=["0 N", "-8 kN", "0 N"])
           .cable("A", "J", EA="60 MN", rho="5.56 kg/m", length0="150.9 m", name="left")
           .cable("J", "B", EA="60 MN", rho="5.56 kg/m", length0="150.9 m"))
    result = net.run("statics")
    assert [c["name"] for c in result.json["cables"]] == ["left", "c1"] and result.json["nodes"]["J"][0] == pytest.approx(150)
    with pytest.raises(hawser.InputError, match="no node C"):
        net.cable("A", "C")
    before = net.yaml
    with pytest.raises(hawser.InputError, match=r"unknown key cables\[2\].lenght0: did you mean length0"):
        net.cable("A", "B", EA=1.0, rho=1.0, lenght0=3)
    assert net.yaml == before


def test_a_ropeway_is_its_file(scenes):
    line = (hawser.Ropeway(rope={"EA": "40 MN", "rho": "4 kg/m"}, top={"at": [300, 58], "radius": 2.5, "drive": {"friction": 0.2}},
                           bottom={"at": [0, 0], "radius": "2.5 m", "tension": {"counterweight": "168 kN"}},
                           carriers={"spacing": "36.6 m", "mass": {"up": "400 kg", "down": "250 kg"}, "phase": "18.3 m"})
            .tower("80 m", "17 m", battery="support", radius="12 m").tower("190 m", "40 m", battery="support", radius="12 m"))
    of_file = hawser.run("statics", scenes / "ropeway-small.yaml")
    assert np.array_equal(line.run("statics")["T_in_N"], of_file["T_in_N"])


def test_mistakes_are_seen_before_a_run():
    for keys, message in (({"EB": 1}, "unknown key EB: did you mean"), ({"cable": {"EB": 1}}, "unknown key cable.EB: .* cable takes EA, rho, EI"),
                          ({"attach": [{"at": 0.5, "mas": 1}]}, r"unknown key attach\[0\].mas: did you mean mass"),
                          ({"mass": 3}, "mass is a key of|unknown key mass")):
        with pytest.raises(hawser.InputError, match=message):
            span(**keys)
    with pytest.raises(hawser.InputError, match='tension.T0: "80 kg"'):
        span(tension={"T0": "80 kg"}).check()


def test_quantities_of_pint_are_values():
    class Quantity:  # what hawser uses of one
        magnitude = 80.0

        class units:
            def __format__(self, form):
                return {"~C": "kN"}[form]
        units = units()

    assert span(tension={"T0": Quantity()}).yaml.count('T0: "80.0 kN"') == 1
    pint = pytest.importorskip("pint")
    registry = pint.UnitRegistry()
    assert hawser.Statics(span(tension={"T0": 80 * registry.kilonewton})).sag == hawser.Statics(span()).sag


def test_pickles_and_members():
    scene = span(model={"modes": 2, "condense": "static", "energy": "quartic"})
    model = hawser.Model(scene)
    response = model.respond("0.99w1", "1.01w1", step=0.05)
    for made in (scene, hawser.Scene(scene, set={"cable.rho": 7}), hawser.Statics(scene), model.modes, model, response,
                 model.integrate("1w1", until=1.0, every=0.5)):
        again = pickle.loads(pickle.dumps(made))
        assert type(again) is type(made)
    assert np.array_equal(pickle.loads(pickle.dumps(response)).state, response.state)
    assert pickle.loads(pickle.dumps(hawser.Scene(scene, set={"cable.rho": 7})))["cable.rho"] == 7.0
    assert {"sag", "H", "profile"} <= set(dir(hawser.Statics(scene)))


def test_shapes_of_modes_in_space():
    modes = hawser.Modes(span(), n=4)
    rest, moved = modes.displaced(2, 0.0), modes.displaced(2, 0.3)
    assert np.sqrt(((moved - rest)**2).sum(axis=1)).max() == pytest.approx(0.3, rel=1e-12)
    assert np.abs((moved - rest)[[0, -1]]).max() < 3e-3 and np.allclose(rest[[0, -1], :2], [[0, 0], [250, 10]], atol=0.5)
    assert 0 < modes.S_si[0] and modes.S_si[-1] < modes.statics.length0 < modes.S_si[0] + modes.S_si[-1] + 1e-9
    assert np.abs((modes.displaced(1, 1.0) - rest)[:, 2]).max() == pytest.approx(1.0)  # out of the plane
    with pytest.raises(hawser.InputError, match="mode 5: there are 1 to 4"):
        modes.displaced(5)
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    assert len(modes.plot().lines) == 4
    if os.environ.get("HAWSER_LONG"):
        assert "<img" in modes.animate(1, frames=3)._repr_html_()
    matplotlib.pyplot.close("all")
