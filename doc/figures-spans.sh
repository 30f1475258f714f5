#!/bin/sh
# Pictures of spans with what people have on them; figures.sh calls it. The ones that spans.md shows are
# copies: stay-map.svg, carriers.svg, damper-size.svg, damper-place.svg, absorber.svg, spacers.svg; that of
# theory-response.md is over-tension.svg, that of theory-folds.md is loci.svg, that of theory-scales.md is
# nnm-tongue.svg.
# Needs gnuplot. Writes into the folder given as argument.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
target=${1:?give the folder for the figures}
hawser=${BUILD:-.}/hawser
scenes=${SRCDIR:?names the source directory}/notebooks-data/scenes
mkdir -p "$target"
export OPENBLAS_NUM_THREADS=1

# Parametric resonance of a stay whose upper anchorage moves along the chord.
"$hawser" map "$scenes/stay-anchorage.yaml" --x Omega=1.8w1:2.2w1 --y "support.B.motion[0]=0:60 mm" \
	--depth 7 --quantity multiplier -q --plot "$target/stay-map.svg"
# Mode shapes of a ropeway span with four carriers.
"$hawser" modes "$scenes/ropeway-carriers.yaml" -n 4 --plot "$target/carriers.svg" >"$target/carriers.txt"
# Damping of the first modes of a stay over the size and the place of its damper.
"$hawser" modes "$scenes/stay-damper.yaml" --over "attach.0.damper[2]=5 kN s/m:2000 kN s/m:60" --log -n 8 -q \
	--plot "$target/damper-size.svg" >"$target/damper-size.txt"
"$hawser" modes "$scenes/stay-damper.yaml" --over attach.0.at=0.005:0.1:40 -n 8 -q \
	--plot "$target/damper-place.svg" >"$target/damper-place.txt"
# Damping of a stay's first modes over the stiffness of an absorber.
"$hawser" modes "$scenes/stay-absorber.yaml" --over attach.0.absorber_stiffness=1e3:4e3:41 -n 4 -q \
	--plot "$target/absorber.svg" >"$target/absorber.txt"
# An iced conductor with two spacers in wind.
"$hawser" statics "$scenes/conductor-spacers.yaml" -q --plot "$target/spacers.svg"
# Tori of the chairlift span.
"$hawser" frf "$scenes/chairlift.yaml" --from "2.935 rad/s" --to "2.905 rad/s" --tori -q \
	--plot "$target/tori.svg" >"$target/tori.txt"
# The response of the chairlift span at one frequency over its tension.
"$hawser" frf "$scenes/b-table-4.2.yaml" -n 3 --set model.condense=static --over "tension.T0=100 kN:50 kN" \
	--Omega "1.42 rad/s" --tolerance 1e-7 -q --plot "$target/over-tension.svg" >"$target/over-tension.txt"
# The folds of the chairlift span over its load, with their cusps and resonances.
"$hawser" locus "$scenes/chairlift.yaml" --from 1.2 --to 3.6 --over factor.load=0.3:1.6 -q \
	--plot "$target/loci.svg" >"$target/loci.txt"
# A nonlinear normal mode with the tongue of a 3:1 resonance.
"$hawser" nnm "$scenes/two-masses.json" --energy-to 1e5 --branches 1 --from 0.9 --to 1.45 -q \
	--plot "$target/nnm-tongue.svg" >"$target/nnm-tongue.txt"
