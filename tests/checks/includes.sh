#!/bin/sh
# Data flows one way: a stage includes its own headers and those of the stages before it. No public
# header shows another library's types.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/lib.sh"

# rank of a stage, and the stage of a public header; a new stage or header is entered here.
table='
BEGIN {
	n = split("core continuation scene statics modes beam contact water net ropeway rod tow rom response study output cli", stage, " ")
	for (i = 1; i <= n; i++) rank[stage[i]] = i
	of["status"] = of["progress"] = "core"; of["document"] = of["scene"] = of["schema"] = of["plausible"] = "scene"; of["statics"] = "statics"; of["modes"] = of["gyroscopic"] = of["irvine"] = of["campbell"] = of["damped"] = "modes"
	of["beam"] = "beam"; of["friction"] = of["surface"] = "contact"; of["water"] = of["waves"] = of["drag"] = "water"; of["net"] = "net"
	of["net_motion"] = of["net_plan"] = of["net_span"] = of["net_modes"] = of["net_equilibria"] = of["net_waves"] = "net"
	of["line"] = of["ropeway"] = of["line_modes"] = of["ropeway_modes"] = of["transient"] = of["obstacles"] = "ropeway"
	of["rod"] = of["rod_motion"] = "rod"
	of["tow"] = of["trajectory"] = "tow"
	of["rom"] = of["rom_source"] = of["law"] = of["line_rom"] = of["net_rom"] = of["plugin"] = of["choose"] = "rom"; of["integrate"] = of["orbit"] = of["family"] = of["frf"] = of["cover"] = of["branches"] = of["backbone"] = of["nnm"] = of["normal_form"] = of["scales"] = of["folds"] = of["locus"] = of["linear"] = of["lyapunov"] = of["torus"] = of["beam_motion"] = "response"; of["hawser"] = "output"
	of["study"] = of["span_motion"] = of["scene_family"] = of["plan"] = of["accuracy"] = of["certificate"] = of["map"] = of["basin"] = of["primary"] = of["hill"] = of["decay"] = of["identify"] = of["sizes"] = "study"
}
function included(line) {
	if (match(line, /<hawser\/[a-z_]+\.h>/) || match(line, /"hawser\/[a-z_]+\.h"/)) {
		name = substr(line, RSTART + 8, RLENGTH - 11)
		return name in of ? of[name] : "?" name
	}
	if (match(line, /"[a-z]+\/[^"]*"/)) {
		name = substr(line, RSTART + 1); sub(/\/.*/, "", name)
		return name in rank ? name : "?" name
	}
	return ""
}
function look(stage_of) {
	to = included($0)
	if (to == "") return
	if (to ~ /^\?/) print FILENAME ":" FNR ": unknown stage or header " substr(to, 2) \
		" (tests/checks/includes.sh lists them)"
	else if (rank[to] > rank[stage_of]) print FILENAME ":" FNR ": " stage_of " includes " to ", which is downstream"
}
'
awk "$table"' /^[ \t]*#[ \t]*include/ { split(FILENAME, part, "/"); look(part[2]) }
	FNR == 1 { split(FILENAME, part, "/")
		if (!(part[2] in rank)) print FILENAME ":1: unknown stage " part[2] }
' $(find src -name '*.[ch]' | sort) | nothing "no stage includes a later one"
# Everything that follows a curve leaves the length of its steps to src/continuation, but for two: the boundaries of
# hill, plane curves without an orbit of their own, and the first orbit, for which the load is raised in steps.
find src/modes src/beam src/response src/study -name '*.[ch]' ! -path src/study/hill/hill.c ! -path src/response/orbit/start.c \
	! -path src/response/orbit/way.c \
	-exec grep -nE '\<(ds|step) [*/]=|\<(ds|step) = .*[0-9]\*([a-z]+->)?(ds|step)\>|GOAL_(ANGLE|CONTRACTION)' {} + |
	nothing "steps along curves are adapted in src/continuation only"
# The handler belongs to the process, so to the program that links the library.
find src -name '*.[ch]' -exec grep -n 'gsl_set_error_handler' {} + | nothing "GSL's error handler stays as it is"

awk "$table"' FNR == 1 { own = FILENAME; sub(/.*\//, "", own); sub(/\.h$/, "", own)
		if (!(own in of)) print FILENAME ":1: unknown header (tests/checks/includes.sh lists them)" }
	/^[ \t]*#[ \t]*include/ && own != "hawser" { look(of[own]) }
' include/hawser/*.h | nothing "no public header includes a later stage's"

# Comments may name a library; code may not.
for f in include/hawser/*.h; do
	awk -v f="$f" '{ line = $0
		gsub(/\/\*[^*]*(\*[^\/*][^*]*)*\*+\//, "", line)
		if (inside) { if (!sub(/^.*\*\//, "", line)) next; inside = 0 }
		if (sub(/\/\*.*/, "", line)) inside = 1
		if (line ~ /gsl_|N_Vector|SUNM|SUNL|sunrealtype|fftw_|json_t|yaml_|ut_unit|lapack|[^_]complex[^_]/)
			print f ":" FNR ": shows another library: " line }' "$f"
done | nothing "public headers show no other library's types"

for f in include/hawser/*.h; do
	[ "$f" = include/hawser/hawser.h ] || grep -q "<hawser/${f##*/}>" include/hawser/hawser.h ||
		echo "$f:1: not included by hawser.h"
done | nothing "hawser.h includes every public header"
done_testing
