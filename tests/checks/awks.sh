#!/bin/sh
# The scripts of the build write the same with every awk: a clone must build with whichever one configure finds. The awks that are
# not installed are skipped; packages.txt names them.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/lib.sh"

# A program that prints the lists of the manual pages without being built.
cat >"$scratch/hawser" <<'END'
#!/bin/sh
case $1 in
	--help) printf 'Commands:\n  frf              frequency response\n  compare modes    methods beside each other\nOptions:\n  -h  help\n' ;;
	frf) printf 'Usage: hawser frf\n\nOptions:\n      --to B      end\n      --json F   file\n\nFurther:\n      --from A   start\n  -h, --help   help\n\nMore: man\n' ;;
	*) printf 'The table:\n  Omega_rad_s  frequency - of the load\n  a\\b  "quoted"\n    inner  deeper\n\nThe JSON:\n  points  [{...}]\n' ;;
esac
END
chmod +x "$scratch/hawser"
printf '.\\" @commands\n.\\" @columns frf\n.\\" @columns frf: The JSON\n' >"$scratch/lists.in"
printf '.TH HAWSER\\-FRF 1\n.SH OPTIONS\n.TP\n.B \\-\\-from \\fIA\nStart.\n.TP\n.B \\-\\-to \\fIB\nEnd.\n.RS\n.TP\n.B x\n.RE\n.TP\n.B \\-h\\fR, \\fB\\-\\-help\nHelp.\n.SH FILES\n' >"$scratch/options.in"

# What each awk makes of the scripts: C, manual pages, findings in headers.
writes() {
	for text in report.css report.js; do
		"$@" -v name=page -f src/lines.awk "src/output/$text"
	done
	"$@" -f src/lines.awk src/rom/file/texts/export.m src/rom/file/texts/export.jl
	for page in "$scratch/lists.in" "$scratch/options.in"; do
		"$@" -v hawser="$scratch/hawser" -v shared=man/shared -f man/page.awk "$page"
	done
	"$@" -v file=src/cli/beam/cmd_beam.c -v only=0 -f tests/faults/seed.awk tests/faults/faults.tsv src/cli/beam/cmd_beam.c
	"$@" -v file=src/core/ranks.c -v only=17 -f tests/faults/seed.awk tests/faults/faults.tsv src/core/ranks.c
	printf '9\tquick\tunit/x\n17\twarnings\t-\n' | "$@" -f tests/faults/sums.awk tests/faults/faults.tsv -
	"$@" -f src/batches.awk src/rom/*/*.c tests/unit/*.c
	printf '/* A comment. */\nint hawser_x(double *value);\nstruct s {\n\tdouble *y;\n};\n' >"$scratch/wrong.h"
	"$@" -f tests/checks/shapes.awk "$scratch/wrong.h" include/hawser/*.h
}

# same NAME COMMAND...: the same bytes as the first awk that was there.
same() {
	name=$1
	shift
	if ! "$@" 'BEGIN { exit 0 }' </dev/null >/dev/null 2>&1; then
		skip "$name is not installed"
		return
	fi
	writes "$@" >"$scratch/$name" 2>"$scratch/why"
	verdict $? "$name runs the scripts"
	[ -f "$scratch/want" ] || cp "$scratch/$name" "$scratch/want"
	try "$name: the same bytes" cmp "$scratch/want" "$scratch/$name"
}

same mawk mawk
same gawk gawk
same posix gawk --posix
same busybox busybox awk
same original original-awk
try "something was written" test "$(wc -l <"$scratch/want")" -gt 500
done_testing
