#!/bin/sh
# Responses by both methods, folds and motions of every scene that is shipped and that these commands take, mostly a few points of few
# modes each, for the sanitizers, which see what a result does not show. A scene that the table lacks fails.
# SPDX-License-Identifier: GPL-3.0-or-later
# A report of a sanitizer has an exit status of its own; without these it has that of a refusal.
ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}exitcode=99
UBSAN_OPTIONS=${UBSAN_OPTIONS:+$UBSAN_OPTIONS:}exitcode=99
export ASAN_OPTIONS UBSAN_OPTIONS
. "$SRCDIR/tests/cli/lib.sh"

scenes=$top/notebooks-data/scenes

# ends STATUS: so, without a report of a sanitizer.
ends() {
	! grep -E 'Sanitizer|runtime error' "$scratch/err" || return 1
	[ "$status" -eq "$1" ] || { echo "exit status $status, not $1"; cat "$scratch/err"; return 1; }
}

# takes STATUS ARGUMENTS
takes() {
	want=$1
	shift
	run "$@" -q
	called "$want" "$@"
	try "$words" ends "$want"
}

at_once() {
	by=$1
	shift
	takes 0 frf "$@" --method "$by" --from 0.9w1 --to 1.1w1 --step 1e-4 --max-points 2
}
# A search for folds ends at three points, before it is done: status 3.
search() {
	takes "${folds:-3}" folds "$@" --from 0.97w1 --to 0.98w1 --max-points 3
}
response() {
	for method in shooting balance; do
		at_once $method "$@"
	done
	search "$@"
}
motion() {
	takes 0 integrate "$@" --until 1T --every 0.5T
}

# Forced spans, by few modes: the exact energy, which sagging ones take by default, has cli/exact.
few="-n 2 --set model.energy=quartic"
for name in b-table-4.2 b-table-4.3-line-1 b-table-4.3-line-2 b-table-4.4-line-1 b-table-4.4-line-2 b-table-4.5 b-table-4.6-in-plane \
	b-table-4.6-out-of-plane b-table-5.4 b-table-5.4-at-rest b-table-5.6 bridge-stay chairlift conductor conductor-spacers \
	conductor-towers deep-sag deep-sag-light guide-rope inclined level-two-to-one rope ropeway-carriers stay-anchorage stay-clamped \
	stay-mast stay-sink; do
	# shellcheck disable=SC2086 # words
	response "$scenes/$name.yaml" $few
	# shellcheck disable=SC2086 # words
	motion "$scenes/$name.yaml" $few --Omega 0.9w1
	echo "$name.yaml" >>seen
done
# Those that ask for an accuracy reach it.
for name in bridge-stay deep-sag-light guide-rope level-two-to-one; do
	takes 0 frf "$scenes/$name.yaml"
done
# Tight pairs of a fold and a torus point, where a curve that turned round would find events again and not the end.
run frf "$scenes/bridge-stay.yaml"
eight() {
	grep -q '^# end: end of the range' "$scratch/out" && [ "$(grep -c '^# event' "$scratch/out")" -eq 8 ]
}
try "bridge-stay: eight events to the end of the range" eight
# Spans on which nothing acts, or a speed that changes once.
for name in b-table-4.1-case-1 b-table-4.1-case-2 b-table-4.1-case-3 b-table-5.1-fictitious b-table-5.1-hauling-rope b-table-5.1-ropeway \
	b-table-5.2 b-table-5.3 b-table-5.5 conductor-iced rope-current stay-absorber stay-damper; do
	motion "$scenes/$name.yaml" -n 2
	echo "$name.yaml" >>seen
done
# Models; a search for folds does not take those with further terms.
for name in duffing parametric-amplifier parametric-duffing rayleigh; do
	folds=1
	[ $name != duffing ] || folds=3
	response "$scenes/$name.json"
	motion "$scenes/$name.json" --Omega 0.9w1
	echo "$name.json" >>seen
done
folds=3
motion "$scenes/two-masses.json"
echo two-masses.json >>seen
# Ropeways, under both loads but for the longest. A response states the error of its model by the largest model of the ropeway,
# which takes 3 to 18 s: that of the smallest, by either method.
for name in ropeway-bouquet ropeway-gondola ropeway-small ropeway-transient; do
	for load in "--load passing" "--load drive --ripple 0.01"; do
		[ $name != ropeway-gondola ] || [ "$load" = "--load passing" ] || continue
		method=balance
		[ "$load" = "--load passing" ] || method=shooting
		# shellcheck disable=SC2086 # words
		[ $name != ropeway-small ] || at_once $method "$scenes/$name.yaml" -n 2 --damping 0.02 $load
		# shellcheck disable=SC2086
		search "$scenes/$name.yaml" -n 2 --damping 0.02 $load
		# so does a motion at one frequency, but for a sweep
		sweeps=
		[ $name = ropeway-small ] || sweeps="--Omega-to 0.95w1"
		# shellcheck disable=SC2086
		motion "$scenes/$name.yaml" -n 2 --damping 0.02 $load --Omega 0.9w1 $sweeps
	done
	echo "$name.yaml" >>seen
done
# The model of a net.
response "$scenes/net-crosstie.yaml" -n 4
motion "$scenes/net-crosstie.yaml" -n 4 --Omega 0.9w1
echo net-crosstie.yaml >>seen
# Nets and rods.
cp "$scenes/net-dragged.txt" .
for name in net-belt net-belt-driven net-capstan net-current net-drag net-dragged net-impact net-mooring net-pendulum net-seabed net-table-3-1 net-table-3-6 \
	rod-hoist rod-tether rod-waves d-section-5.1.2 d-section-5.1.3 d-section-5.1.4; do
	takes 0 integrate "$scenes/$name.yaml" --until "20 ms" --every "10 ms"
	echo "$name.yaml" >>seen
done
# These commands do not take: a net without masses, rods without inertia, beams, towed bodies, spans over obstacles, a ropeway whose
# sheaves are points. tests/cli/refusals.sh and others have the reasons.
for name in net-bars rod-bend rod-pipe rod-roll b-table-2.1 b-table-3.5 b-table-6.3 d-section-5.2.2 d-section-5.2.3 d-section-5.2.4 \
	d-section-5.2.5 d-section-5.2.6 d-section-5.3 tow-orbit tow-u-turn tow-waves span-seabed second-stable-region hoist-rope d-figure-9.1 \
	d-figure-9.2 d-figure-9.3 d-figure-9.4 d-figure-9.5 d-figure-9.7 d-figure-9.8 d-figure-9.9 d-figure-9.10 d-figure-9.11; do
	echo "$name.yaml" >>seen
done
(cd "$scenes" && ls -- *.yaml *.json) | sort >shipped
try "every scene is in the table" sh -c 'sort seen | diff - shipped'
done_testing
