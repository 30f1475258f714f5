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
	run "$1" scene.yaml
	of_file=$status
	cat "$scratch/out" "$scratch/err" >"$scratch/file"
	# shellcheck disable=SC2002 # a pipe is what is tested
	cat scene.yaml | "$HAWSER" "$1" - >"$scratch/piped" 2>"$scratch/said"
	of_pipe=$?
	cat "$scratch/said" >>"$scratch/piped"
	[ $of_file -eq $of_pipe ] || { echo "status $of_file of the file, $of_pipe of the pipe"; return 1; }
	for text in file piped; do
		sed 's/scene\.yaml/<stdin>/; s/^[0-9. ]*s of processor.*//' "$scratch/$text" >"$scratch/$text.plain"
	done
	diff "$scratch/file.plain" "$scratch/piped.plain"
}

# flow: a scene in blocks, as init writes it, on one line in flow style.
flow() {
	awk '
		{ sub(/ +#.*/, ""); sub(/^#.*/, ""); sub(/ +$/, "") }
		$0 == "" { next }
		{
			match($0, /^ */)
			indent = RLENGTH
			text = substr($0, indent + 1)
			if (goes_on) {
				printf " %s", text
				goes_on = text ~ /,$/
				next
			}
			goes_on = text ~ /,$/
			item = substr(text, 1, 2) == "- "
			if (item)
				text = substr(text, 3)
			while (depth && at[depth] > indent)
				printf "%s", shut[depth--]
			if (depth && at[depth] == indent)
				printf ", "
			else {
				at[++depth] = indent
				shut[depth] = item ? "]" : "}"
				printf "%s", item ? "[" : "{"
			}
			printf "%s%s", text, text ~ /:$/ ? " " : ""
		}
		END { while (depth) printf "%s", shut[depth--]; print "" }'
}

# told COMMAND: what it prints of scene.yaml, and its status
told() {
	run "$1" scene.yaml
	cat "$scratch/out"
	echo "$status"
}

for kind in $kinds; do
	run init "$kind"
	cp "$scratch/out" block.yaml
	cp block.yaml scene.yaml
	for command in check statics modes; do
		try "$kind: $command" piped "$command"
		told "$command" >"$scratch/block"
		# a file of JSON is in flow style
		[ "$kind" != model ] || continue
		for form in flow indented; do
			case $form in
				flow) flow <block.yaml >scene.yaml ;;
				*) sed 's/^/   /' block.yaml >scene.yaml ;;
			esac
			told "$command" >"$scratch/$form"
			try "$kind: $command, $form" diff "$scratch/block" "$scratch/$form"
		done
		cp block.yaml scene.yaml
	done
done

# Of any kind, the text is opened once.
if strace -V >/dev/null 2>&1 && strace -o "$scratch/trace" true 2>/dev/null; then
	for kind in $kinds; do
		run init "$kind"
		cp "$scratch/out" scene.yaml
		strace -f -e trace=openat -o "$scratch/trace" "$HAWSER" check scene.yaml >"$scratch/out" 2>&1
		try "$kind: opened once" test "$(grep -c 'scene\.yaml"' "$scratch/trace")" = 1
	done
else
	skip "opened once" "strace does not work here"
fi

# a span may name its own kind, and need not be in blocks
printf 'kind: span\ncable: {EA: 1e7, rho: 1}\nspan: {d: 100, h: 0}\ntension: {H: 1e4}\n' >scene.yaml
works "kind: span" statics scene.yaml
try "through a pipe" piped statics
printf '{cable: {EA: 1e7, rho: 1}, span: {d: 100, h: 0}, tension: {H: 1e4}}\n' >scene.yaml
try "in flow style" piped statics
refuses_like 1 "^hawser: --set kind=net: kind is a key of another kind of scenes" statics scene.yaml --set kind=net
done_testing
