#!/bin/sh
# tests/cli/standard-input.sh - a scene of every kind through a pipe: the same result as from a file, and the same refusals.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

kinds=$("$HAWSER" init --help | sed -n '1s/^[^[]*\[\([a-z|]*\)\].*/\1/p' | tr '|' ' ')
# shellcheck disable=SC2086 # words
set -- $kinds
try "kinds" test $# -ge 8

# piped COMMAND: of scene.yaml, status and all text but for the name of the scene, and for measured times.
piped() {
	"$HAWSER" "$1" scene.yaml >"$scratch/file" 2>&1
	of_file=$?
	# shellcheck disable=SC2002 # a pipe is what is tested
	cat scene.yaml | "$HAWSER" "$1" - >"$scratch/piped" 2>&1
	of_pipe=$?
	[ $of_file -eq $of_pipe ] || { echo "status $of_file of the file, $of_pipe of the pipe"; return 1; }
	for text in file piped; do
		sed 's/scene\.yaml/<stdin>/; s/^[0-9. ]*s of processor.*//' "$scratch/$text" >"$scratch/$text.plain"
	done
	diff "$scratch/file.plain" "$scratch/piped.plain"
}

for kind in $kinds; do
	"$HAWSER" init "$kind" >scene.yaml
	for command in check statics modes; do
		try "$kind: $command" piped "$command"
	done
done

# a span may name its own kind, and need not be in blocks
printf 'kind: span\ncable: {EA: 1e7, rho: 1}\nspan: {d: 100, h: 0}\ntension: {H: 1e4}\n' >scene.yaml
works "kind: span" statics scene.yaml
try "through a pipe" piped statics
printf '{cable: {EA: 1e7, rho: 1}, span: {d: 100, h: 0}, tension: {H: 1e4}}\n' >scene.yaml
try "in flow style" piped statics
refuses_like 1 "^hawser: --set kind=net: this is the scene of a net" statics scene.yaml --set kind=net
done_testing
