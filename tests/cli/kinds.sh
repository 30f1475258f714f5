#!/bin/sh
# tests/cli/kinds.sh - each kind of scenes in each command: the command takes it, or refuses it in one sentence, as hawser check says.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

# Those that take a scene, blanks as underscores.
takers=
for command in $(commands | tr ' ' _); do
	# shellcheck disable=SC2086 # a name of two words
	case $command in check | report | sweep) continue ;; esac # of all kinds
	run help $(echo "$command" | tr _ ' ')
	read -r usage <"$scratch/out"
	case $usage in *' SCENE'*) takers="$takers $command" ;; esac
done
# shellcheck disable=SC2086 # words
set -- $takers
try "commands" test $# -ge 24

# answered COMMAND: what it says of scene.yaml; a key that no scene has ends what it would compute.
answered() {
	case $1 in
		identify) run identify scene.yaml nowhere.tsv ;;
		hill) run hill scene.yaml --set no.such.key=1 --Omega 1 ;;
		map) run map scene.yaml --set no.such.key=1 --x Omega=1:2 --y factor.load=1:2 ;;
		*) run "$@" scene.yaml --set no.such.key=1 ;;
	esac
}

kinds=$("$HAWSER" init --help | sed -n '1s/^[^[]*\[\([a-z|]*\)\].*/\1/p' | tr '|' ' ')
kinds=${kinds%% stay*} # structures are of these kinds
for kind in $kinds model; do
	case $kind in
		model) cp "$duffing" scene.yaml ;;
		*) run init "$kind" && cp "$scratch/out" scene.yaml ;;
	esac
	run check scene.yaml
	listed=", $(sed -n 's/^commands that take it: //p; s/^those for which it lacks [^:]*: //p' "$scratch/out" | tr '\n' ',' |
		sed 's/,\([^ ]\)/, \1/g') "
	for command in $takers; do
		case $command in *_*) words="${command%%_*} ${command#*_}" ;; *) words=$command ;; esac
		# shellcheck disable=SC2086 # a name of two words
		answered $words
		refused=0
		while IFS= read -r line; do
			case $line in
				"hawser: scene.yaml is "*", which hawser $words does not take; these commands do: "*) refused=$((refused + 1)) ;;
			esac
		done <"$scratch/err"
		case $listed in
			*", $words,"*)
				try "$kind: $words" test "$refused" = 0
				case $command in identify | orbit) continue ;; esac # which need another file first
				try "  names a key that is not there" grep -q 'no\.such' "$scratch/err"
				;;
			*) case $kind in
				cable | travelling | beam) continue ;; # other kinds' readers say what is missing
				*) try "$kind: not $words" test "$status-$refused" = 1-1 ;;
			esac ;;
		esac
	done
done
done_testing
