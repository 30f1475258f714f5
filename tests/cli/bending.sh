#!/bin/sh
# Bending stiffness and held ends: keys, modes, the reduced model, and what refuses them.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
scene=$top/notebooks-data/scenes/stay-clamped.yaml

works "modes" modes "$scene" --json m.json
try "xi and end moments in the result" grep -q '"moment_A": 33636' m.json
try "xi in the result" grep -q '"xi": 330.129' m.json
works "words" modes "$scene" --set ends.A=pinned --set ends.B=clamped
works "a stiffness per radian" rom "$scene" -n 2
refuses_like 1 'ends.A: "clampd" must be a number in N.m, or pinned or clamped' modes "$scene" --set ends.A=clampd
refuses_like 1 "ends contradicts cable.EI = 0" modes "$scene" --set cable.EI=0
refuses_like 1 "cable.EI contradicts travel" modes "$scene" --set 'travel={speed: 1, hold: length}'
refuses_like 1 "cable.EI contradicts support.A.stiffness" modes "$scene" \
	--set 'support={A: {stiffness: [1 MN/m, 1 MN/m, 1 MN/m]}}'
works "a moving end" rom "$scene" -n 2 --set 'support={A: {motion: [1 cm, 0, 0]}}'
works "the full-order model" rom "$scene" --set model.energy=exact --set model.basis=15
refuses_like 1 "the method fdm is for a cable without bending stiffness" modes "$scene" --method fdm
refuses_like 1 "model.basis = 30 with cable.EI" modes "$scene" --basis 30
works "a sweep of the tension" irvine "$scene" --points 2 -n 1 --from "2 MN" --to "2.5 MN" --json i.json
works "condensed modes" rom "$scene" -n 2 --set model.condense=static
refuses_like 1 "modes are not weighed with cable.EI" frf "$scene" --set model.modes=auto --set model.condense=static
refuses_like 1 "900 modes asked, which need" modes "$scene" -n 900
works "a damper beside a clamp" modes "$top/notebooks-data/scenes/stay-damper.yaml" --damped -n 2 \
	--set 'cable.EI=1.2 MN m2' --set ends.A=clamped
refuses_like 1 "with cable.EI: at most" modes "$scene" --damped -n 300
done_testing
