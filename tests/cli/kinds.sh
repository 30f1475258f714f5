#!/bin/sh
# tests/cli/kinds.sh - each kind of scenes in each command: the command takes it, or refuses it in one sentence, as hawser check says.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

# Those that take a scene, blanks as underscores.
takers=
for command in $(commands | tr ' ' _); do
	# shellcheck disable=SC2086 # a name of two words
	case $command in check | report | sweep) continue ;; esac # of all kinds
	"$HAWSER" help $(echo "$command" | tr _ ' ') | sed -n 1p | grep -q ' SCENE' && takers="$takers $command"
done
# shellcheck disable=SC2086 # words
set -- $takers
try "commands" test $# -ge 24

# answered COMMAND: what it says of scene.yaml; a key that no scene has ends what it would compute.
answered() {
	case $1 in
		identify) run identify scene.yaml nowhere.tsv ;;
		*) run "$@" scene.yaml --set no.such.key=1 ;;
	esac
}

kinds=$("$HAWSER" init --help | sed -n '1s/^[^[]*\[\([a-z|]*\)\].*/\1/p' | tr '|' ' ')
for kind in $kinds model; do
	case $kind in
		model) cp "$duffing" scene.yaml ;;
		*) "$HAWSER" init "$kind" >scene.yaml ;;
	esac
	listed=", $("$HAWSER" check scene.yaml 2>/dev/null | sed -n 's/^commands that take it: //p'),"
	for command in $takers; do
		words=$(echo "$command" | tr _ ' ')
		# shellcheck disable=SC2086 # a name of two words
		answered $words
		refused=$(grep -c "^hawser: scene.yaml is .*, which hawser $words does not take; these commands do: " "$scratch/err")
		case $listed in
			*", $words,"*) try "$kind: $words" test "$refused" = 0 ;;
			*) case $kind in
				cable | travelling | beam) continue ;; # other kinds' readers say what is missing
				*) try "$kind: not $words" test "$status-$refused" = 1-1 ;;
			esac ;;
		esac
	done
done
done_testing
