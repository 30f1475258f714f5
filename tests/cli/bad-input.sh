#!/bin/sh
# Scenes and model files that break their contract: status and message, no output, no file.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

# scene CABLE SPAN TENSION [MORE]: into ../scene.yaml
scene() {
	printf 'cable:   %s\nspan:    %s\ntension: %s\n%s\n' "$1" "$2" "$3" "${4-}" >../scene.yaml
}
cable='{EA: 400 MN, rho: 6 kg/m}'
span='{d: 250 m, h: 10 m}'
tension='{T0: 80 kN}'
bad() {
	refuses_like "$1" "$2" statics ../scene.yaml --json out.json --tsv out.tsv
	try "and no file" holds ""
}

scene "$cable" "$span" "$tension"
works "the scene itself is fine" statics ../scene.yaml
scene '{EA: 400 MN, rho: 6 kg/m, Rho: 3}' "$span" "$tension"
bad 1 'scene\.yaml:1:.*cable\.Rho: did you mean rho'
scene '{EA: 400 MN, rho: 6 kg/m, rho: 7}' "$span" "$tension"
bad 1 'scene\.yaml:1:.*rho.*(twice|again|duplicate|already)'
scene '{EA: 400 MN, mass: 6 kg/m}' "$span" "$tension"
bad 1 'scene\.yaml:1:.*cable\.mass: did you mean rho'
scene '{EA: 3,6 MN, rho: 6}' "$span" "$tension"
bad 1 'scene\.yaml:1:.*decimal comma'
scene "$cable" "$span" '{T0: "80,5 kN"}'
bad 1 'scene\.yaml:3:.*decimal point'
scene "$cable" "$span" '{T0: 80 kn}'
bad 1 'scene\.yaml:3:.*did you mean kN'
printf 'cable:\n\tEA: 4e8\n' >../scene.yaml
bad 1 'scene\.yaml:2:.*a tab'
refuses_like 1 'scene\.yaml is a file, and no command comes before it' ../scene.yaml
scene '{EA: 400 MN}' "$span" "$tension"
bad 1 'scene\.yaml.*cable\.rho'
scene "$cable" "$span" '{T0: 80 kN, H: 70 kN}'
bad 1 'scene\.yaml:3:.*tension'
scene "$cable" "$span" '{}'
bad 1 'scene\.yaml.*tension'
scene "$cable" "$span" "$tension" 'damping: {alpha: 0.1, ratio: 0.01}'
bad 1 'scene\.yaml:4:.*damping'
scene '{EA: 400 m, rho: 6 kg/m}' "$span" "$tension"
bad 1 'scene\.yaml:1:.*cable\.EA.*400 m'
for value in -1 0 .nan; do
	scene "{EA: $value, rho: 6 kg/m}" "$span" "$tension"
	bad 1 'scene\.yaml:1:.*cable\.EA'
	scene "{EA: 4e8, rho: $value}" "$span" "$tension"
	bad 1 'scene\.yaml:1:.*cable\.rho'
	scene "$cable" "{d: $value, h: 10}" "$tension"
	bad 1 'scene\.yaml:2:.*span\.d'
done
scene "$cable" "$span" '{T0: 5 kN}'
bad 2 'T0.*5000 N.*least.*10812\.6'
scene "$cable" "$span" '{length0: 200 m}'
printf 'cable: {EA: .inf, rho: 6}\nspan: {d: 250, h: 10}\ntension: {length0: 200 m}\n' >../scene.yaml
bad 2 'length'
printf 'cable: [\n' >../scene.yaml
bad 1 'scene\.yaml:'
: >../scene.yaml
bad 1 'scene\.yaml: a scene is a mapping of keys to values, .* needs at least cable'
refuses_like 1 'cannot read missing\.yaml: No such file or directory' statics missing.yaml
refuses_like 1 'cannot read missing\.yaml: No such file or directory' frf missing.yaml
refuses_like 1 'cannot read /: Is a directory' statics /

# modes
scene "$cable" "$span" "$tension" 'model: {modes: 0}'
refuses_like 1 'scene\.yaml:4:.*model\.modes' modes ../scene.yaml
scene "$cable" "$span" "$tension"
refuses 1 "--modes 0: must be at least 1" modes ../scene.yaml -n 0
refuses_like 1 '50 modes.*basis' modes ../scene.yaml -n 50 --basis 10
refuses_like 1 'foo.*spectral' modes ../scene.yaml --method foo
refuses_like 1 'fdm.*travelling.*spectral' modes ../scene.yaml --method fdm --set travel.hold=tension --set travel.speed="20 m/s"
refuses_like 1 'foo.*components, profile, waves' modes ../scene.yaml --view foo
refuses_like 1 'travel\.speed' modes ../scene.yaml --view waves --plot x.svg
refuses_like 2 'inextensible' modes ../scene.yaml --set cable.EA=.inf
refuses_like 1 'foo.*gauss' integrate ../scene.yaml --Omega 1 --method foo

# a scene without load has no forced response
refuses_like 1 '(forc|load)' frf ../scene.yaml

# model files
model() {
	printf '%s\n' "$1" >../model.json
	refuses_like 1 "$2" frf ../model.json --json out.json --from 0.5 --to 2
	try "and no file" holds ""
}
rest='"harmonics": [{"k": 1, "phase": "cos", "f": [1, 0]}]'
model '{"hawser_rom": 1, "n": 2, "K": [[1, 0]], '"$rest"'}' 'model\.json.*K'
model '{"hawser_rom": 1, "n": 2, "K": [[1, 0], [0, 1, 2]], '"$rest"'}' 'model\.json.*K'
model '{"hawser_rom": 1, "n": 0, "K": []}' 'model\.json.*n'
model '{"hawser_rom": 1, "n": 2, "K": [[1, 0], [0, 4]], "Q": [[0, 1, 2, 5]], '"$rest"'}' \
	'model\.json.*Q'
model '{"hawser_rom": 1, "n": 2, "K": [[1, 0], [0, 4]], "C": [[0, 1, 1, 5]], '"$rest"'}' \
	'model\.json.*C'
model '{"hawser_rom": 1, "n": 2, "K": [[1, 0], [0, "4"]], '"$rest"'}' 'model\.json.*K'
model '{"hawser_rom": 1, "n": 2, "K": [[1, 0], [0, 4]], "harmonics": [{"k": -1, "f": [1, 0]}]}' \
	'model\.json.*k'
model '{"hawser_rom": 7, "n": 2, "K": [[1, 0], [0, 4]], '"$rest"'}' 'model\.json.*hawser_rom'
model '{"hawser_rom": 1, "n": 2, ' 'model\.json:'

# no answer within reach: status 3, and the choice to keep what there is
cat >../soft.json <<'END'
{"hawser_rom": 1, "n": 1, "D": [[0.05]], "K": [[1]], "C": [[0, 0, 0, 0, -0.1]],
 "harmonics": [{"k": 1, "phase": "cos", "omega_power": 0, "f": [3]}]}
END
refuses_like 3 'Omega 0\.3' frf ../soft.json --from 0.3 --to 3 --tolerance 1e-5 --json out.json --tsv out.tsv
refuses_like 3 'escapes' integrate ../soft.json --Omega 0.9 --json out.json
try "and no file" holds ""
run integrate ../soft.json --Omega 0.9 --json out.json --partial -q
try "--partial keeps the status" like 3 'escapes'
try "and what was computed, marked" grep -q '"end": "failed"' out.json
if [ -w /dev/full ]; then
	refuses_like 3 'escapes.*; besides, cannot write /dev/full: No space left on device' \
		integrate ../soft.json --Omega 0.9 --json /dev/full --partial
	refuses_like 3 '; besides, cannot write /dev/full: No space left on device' \
		frf ../soft.json --from 4 --to 0.1 --tolerance 1e-5 --method auto --tsv /dev/full --partial
else
	skip "there is no /dev/full"
fi
rm -f out.json
printf '{"hawser_rom": 1, "n": 1, "K": [[-1]]}' >../unstable.json
refuses 1 "--Omega 2w1: the model has no natural frequency; write a number" \
	integrate ../unstable.json --Omega 2w1
refuses_like 1 'give --Omega' integrate ../unstable.json

# states
printf '1 2 3\n' >../state.txt
refuses 1 "../state.txt: does not hold a state; a state of this model is 2 numbers, u_1 to u_1 and \
then their velocities" integrate "$duffing" --Omega 1 --initial ../state.txt
printf '1 nan\n' >../state.txt
refuses_like 1 'does not hold a state' integrate "$duffing" --Omega 1 --initial ../state.txt
printf '[0.1,\n 0.2\n' >../state.txt
refuses_like 1 "^hawser: ../state.txt:3: .*']' expected" \
	integrate "$duffing" --Omega 1 --initial ../state.txt
printf '[0.1, \033[2J]\n' >../state.txt
refuses_like 1 "^hawser: ../state.txt:1: .*near '.?.'$" \
	integrate "$duffing" --Omega 1 --initial ../state.txt
try "without its control characters" test "$(tr -d '\033' <"$scratch/err" | wc -c)" -eq "$(wc -c <"$scratch/err")"
refuses 1 "--initial - and the input - are both standard input: give one of them as a file" \
	integrate - --Omega 1 --initial -
refuses 1 "--start - and the input - are both standard input: give one of them as a file" \
	frf - --start -
{ printf '{"state": [0.1, 0.2], "rest": "'; head -c 17000000 /dev/zero | tr '\0' x; echo '"}'; } \
	>../state.txt
works "a state out of a large file" \
	integrate "$duffing" --Omega 1 --initial ../state.txt --until 1 --every 0.5
printf '0.1 0.2\n' >"$scratch/in"
grep -v '^#' "$scratch/out" >../rows
works "a state on standard input" \
	integrate "$duffing" --Omega 1 --initial - --until 1 --every 0.5
grep -v '^#' "$scratch/out" | try "gives the same rows" diff ../rows -
refuses 1 "cannot read missing: No such file or directory" \
	integrate "$duffing" --Omega 1 --initial missing
done_testing
