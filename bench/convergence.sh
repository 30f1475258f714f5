#!/bin/sh
# What the number of modes buys: raw and condensed models of six scenes against the full-order model,
# around their first resonance. From a build folder:  ../bench/convergence.sh FOLDER [SCENE...]
# FOLDER receives a table and a picture for each scene; the command's own summary is printed.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
target=${1:?give a folder for tables and pictures}
shift
program=${HAWSER:-./hawser}
scenes=${SRCDIR:-$(dirname "$0")/..}/notebooks-data/scenes
export OPENBLAS_NUM_THREADS="${OPENBLAS_NUM_THREADS:-1}"
mkdir -p "$target"

# run NAME FROM TO FUNCTIONS FIDELITIES [SETTING...]
run() {
	name=$1 from=$2 to=$3 functions=$4 list=$5
	shift 5
	echo "== $name, $from to $to, against full order with $functions functions a component"
	"$program" compare "$scenes/$name.yaml" --from "$from" --to "$to" --step 0.02 --limit 300 \
		--fidelities "$list, full $functions" --reference "full $functions" --quiet \
		--tsv "$target/$name.tsv" --plot "$target/$name.svg" "$@"
	grep -v '^#' "$target/$name.tsv" | awk -F '\t' '
		NR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
		{ printf "%-15s folds %s of %s, Omega %9.1e; peaks: Omega %9.1e, size %9.1e; tension %9.1e; %8.2f s\n",
			$1, $column["folds_matched"], $column["folds_matched"] + $column["folds_missing"],
			$column["fold_Omega_error"], $column["largest_peak_Omega_error"],
			$column["largest_peak_amplitude_error"], $column["tension_error"],
			$column["processor_s"] }'
}

all="raw 5, raw 9, raw 16, condensed 5, condensed 7, condensed 9, condensed 12, condensed 16"
for scene in ${*:-b-table-4.4-line-2 b-table-4.2 b-table-4.5 b-table-5.4 deep-sag inclined}; do
	case $scene in
	b-table-4.4-line-2) run "$scene" 0.8w1 1.6w1 12 "multiple-scales 16, raw 5-12, $all" ;;
	b-table-4.2) run "$scene" 0.7w1 1.2w1 12 "$all" ;;
	*) run "$scene" 0.85w1 1.2w1 12 "$all" ;;
	esac
done
