#!/bin/sh
# What is refused, and in which words: messages of the program that no other test here provokes.
# `make check-provoked` tells which those are.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
scenes=$top/notebooks-data/scenes
beam=$scenes/d-figure-9.9.yaml
pair=$top/tests/reference/pair-2to1.json

# --- numbers and frequencies
refuses_like 1 'has natural frequencies w1 to w1' frf "$duffing" --from 0.6w2 --to 2
refuses_like 1 'no unit of time; write a plain number' frf "$duffing" --from '1 Hz' --to 2
refuses_like 1 'no unit of time; write a plain number' integrate "$duffing" --Omega 1 --until '1 s'
refuses_like 1 'or write a multiple of a natural frequency' frf "$chairlift" --from '1 kg' --to 3w1
refuses_like 1 'or write a number of periods' integrate "$chairlift" --Omega 1w1 --until '1 kg'
refuses_like 1 'must be greater than zero and finite' frf "$duffing" --from 0 --to 2
refuses_like 1 'must be greater than zero and finite' statics "$chairlift" --compatibility --from '-1 N'
refuses_like 1 'applies to scenes only' frf "$duffing" --from 1 --to 2 --set g=1
refuses_like 1 'more than .* times --set' frf "$duffing" $(i=0; while [ $i -lt 70 ]; do
	echo --set g=1; i=$((i + 1)); done)

# --- integrate
refuses_like 1 'makes .* rows: choose a longer interval' \
	integrate "$duffing" --Omega 1 --until 1e12T --every 0.001T
refuses_like 1 'too few rows for a picture' \
	integrate "$duffing" --Omega 1 --until 1T --every 1T --plot out.svg
refuses_like 1 'a spectrum needs .* rows or more' \
	integrate "$duffing" --Omega 1 --until 1T --every 0.5T --spectrum
refuses 4 "cannot read .: Is a directory" integrate "$duffing" --Omega 1 --initial .

# --- statics
printf 'cable: {EA: .inf, rho: 6}\nspan: {d: 250, h: 0}\ntension: {H: 8e4}\n' >stiff.yaml
refuses_like 2 'of an inextensible cable have epsilon = 0 everywhere' \
	statics stiff.yaml --compatibility --plot out.svg

# --- mms
refuses_like 1 'part of the range, at most 1' mms "$duffing" --step 2
refuses_like 1 'are the same frequency' mms "$duffing" --from 1 --to 1
refuses_like 1 'model.modes: auto chooses by the load' compare mms "$chairlift" --set model.modes=auto
sed 's/"f": \[[^]]*\]/"f": [0]/' "$duffing" >unloaded.json
refuses_like 1 'the load drives no mode at its own frequency: name one with --mode' mms unloaded.json
refuses_like 1 'the load does not meet mode 1' mms unloaded.json --mode 1
sed 's/"D": \[\[[^]]*\]\]/"D": [[0]]/' "$duffing" >undamped.json
refuses_like 1 'without damping its resonance has no peak' mms undamped.json --mode 1

# --- hill
refuses 1 '--mathieu, --forced and --orbit are different questions: choose one' \
	hill "$duffing" --forced --orbit
refuses_like 1 "is that of Mathieu's equation" hill "$duffing" --damping 0.1 --Omega 1
refuses_like 1 'boundaries are about rest' hill "$duffing" --orbit --x Omega=1:2 --y factor.load=0:1
refuses_like 1 'is a scene of a beam: hawser beam tells its stability' hill "$beam" \
	--x beam.v=0:1 --y beam.theta=1:2

# --- beam
refuses_like 1 'eigenvalues at one speed are no picture' beam "$beam" --plot out.svg
refuses_like 4 'cannot read missing: No such file' beam "$beam" --until 1 --initial missing
printf '0 0\n0.5 x\n1 0\n' >shape
refuses_like 1 'after 1 lines: a shape is 2 to' beam "$beam" --until 1 --initial shape
printf '0 0\n0.5 1e999\n1 0\n' >shape
refuses_like 1 'after 2 lines: a shape is 2 to' beam "$beam" --until 1 --initial shape
refuses_like 1 'is beyond double precision' beam "$beam" --to 1e999
refuses_like 1 'at most .* values' beam "$beam" --vary beam.rho=0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17
refuses_like 1 'at least 1' beam "$beam" --size -1
refuses_like 1 'both axes are' map "$beam" --x beam.v=0:1 --y beam.v=0:2 --points 3x3

# --- damping
refuses_like 4 'cannot be opened' damping missing
refuses_like 4 'cannot be read' damping .
printf '0 0\n1 1\n' >short
refuses_like 1 'is for scenes; damping reads a table' damping short --set g=1
refuses_like 1 'give at least' damping short
refuses_like 1 'a confidence between 0 and 1' damping short --confidence 2
refuses_like 1 'points: give at least 5' damping short --half-power
awk 'BEGIN { for (i = 0; i < 40; i++) print (i == 20 ? 1 : i)/10, cos(i) }' >times
refuses_like 1 'times must ascend' damping times
awk 'BEGIN { for (i = 0; i < 40; i++) print i, (i == 20 ? "1e999" : cos(i)) }' >times
refuses_like 3 'is not finite' damping times
awk 'BEGIN { for (i = 0; i < 40; i++) print i, exp(-i/10) }' >times
refuses_like 1 'half-cycles stand out: give at least two whole cycles' damping times
awk 'BEGIN { for (i = 0; i < 9; i++) print 9 - i, 1 }' >curve
refuses_like 1 'frequencies must ascend from above zero' damping curve --half-power
awk 'BEGIN { for (i = 1; i < 9; i++) print i, 1 }' >curve
refuses_like 2 'does not fall to 0.707' damping curve --half-power

# --- maps and their kin
refuses_like 1 'both axes are Omega' map "$duffing" --x Omega=1:2 --y Omega=1:2
refuses_like 1 'with an accuracy in percent' compare "$chairlift" --from 1w1 --to 2w1 --fidelities auto:99%
done_testing
