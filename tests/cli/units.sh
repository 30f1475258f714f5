#!/bin/sh
# --units: tables in other units than SI, JSON in SI, and what is refused. Pictures: units-plot.sh.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

scene=$top/notebooks-data/scenes/chairlift.yaml

# same COLUMN OTHER FACTOR SI-TABLE TABLE: the column times the factor is that of the SI table.
same() {
	awk -F '\t' -v a="$1" -v b="$2" -v factor="$3" '
		/^#/ { next }
		!(FILENAME in head) { head[FILENAME]; for (i = 1; i <= NF; i++) if ($i == (file ? b : a)) at[FILENAME] = i
			file++; row = 0; next }
		file == 1 { value[++row] = $at[FILENAME]; next }
		{ row++; d = $at[FILENAME]*factor - value[row]; if (d < 0) d = -d; size = value[row] < 0 ? -value[row] : value[row]
			if (d > 1e-14*size) { print row ": " $at[FILENAME]*factor " " value[row]; bad = 1 } rows++ }
		END { exit bad || rows == 0 }' "$4" "$5"
}

works "statics in SI" statics "$scene" --tsv si.tsv --json si.json --reproducible
works "statics in kN and ft" statics "$scene" --units "kN, ft" --tsv us.tsv --json us.json --reproducible
# but for what it says of the columns of the table
for f in si us; do sed '/"columns": \[/,/^ *\]/d' $f.json >$f-numbers.json; done
try "JSON stays SI" cmp si-numbers.json us-numbers.json
try "lengths" same x_m x_ft 0.3048 si.tsv us.tsv
try "tensions" same T_N T_kN 1000 si.tsv us.tsv
# compounds: a foot is 0.3048 m
"$HAWSER" init rod >rod.yaml
"$HAWSER" init tow >tow.yaml
works "a rod in SI" statics rod.yaml --tsv rod.tsv
works "in kN and ft" statics rod.yaml --units "kN, ft" --tsv rod-us.tsv
try "moments follow from both" same M2_Nm M2_kNft 304.8 rod.tsv rod-us.tsv
try "curvatures from one" same k2_1_m k2_1_ft 3.280839895013123 rod.tsv rod-us.tsv
try "a list of a comment" grep -q '^# support at the start: force (.*, 0.2162, -0.005) kN, moment (.*) kN.ft$' rod-us.tsv
try "an energy too" grep -q '^# energy = 0.2166[0-9]* kN.ft$' rod-us.tsv
works "in ft" statics rod.yaml --units ft --tsv rod-ft.tsv
try "not without a force" grep -q '^# energy = 66.02[0-9]* J$' rod-ft.tsv
try "but moments" same M2_Nm M2_Nft 0.3048 rod.tsv rod-ft.tsv
works "in kJ" statics rod.yaml --units "kN, ft, kJ" --tsv rod-kj.tsv
try "a compound of the user's comes first" same M2_Nm M2_kJ 1000 rod.tsv rod-kj.tsv
works "a trajectory in SI" trajectory tow.yaml --set tow.speed=9 --tsv path.tsv
works "in ft" trajectory tow.yaml --set tow.speed=9 --units ft --tsv path-us.tsv
try "jerks" same jerk_x_m_s3 jerk_x_ft_s3 0.3048 path.tsv path-us.tsv
works "modes in SI" modes "$scene" --tsv modes.tsv
works "modes in Hz" modes "$scene" --units Hz --tsv hz.tsv
try "frequencies" same omega_rad_s omega_Hz 6.283185307179586 modes.tsv hz.tsv
works "Irvine" irvine "$scene" --points 3 -n 2 --unit rad/s --tsv irvine.tsv
works "Irvine in lbf and Hz" irvine "$scene" --points 3 -n 2 --unit rad/s --units "lbf, Hz" --tsv irvine-us.tsv
try "the swept tension" same H_N H_lbf 4.4482216152605 irvine.tsv irvine-us.tsv
try "a branch" same in_1_rad_s in_1_Hz 6.283185307179586 irvine.tsv irvine-us.tsv
refuses 1 '--units: "kN" and "lbf" are both units of force; write one of them' \
	modes "$scene" --units "kN, lbf"
refuses_like 1 '"V" has the dimension of m2.kg.s-3.A-1, and no result has that' modes "$scene" --units V
refuses_like 1 '"foo" is no unit' modes "$scene" --units foo
refuses_like 1 'a unit is empty' modes "$scene" --units "kN,,"
refuses_like 1 'a unit is too long' modes "$scene" --units aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa
works "a plan in ft, kip and Hz" plan "$chairlift" --limit 0.01 --fidelities "raw 1" --units "ft, kip, Hz"
try "its range" grep -q '^response over Omega from 0.1383.* to 0.761.* Hz$' "$scratch/out"
try "a setting" grep -q 'tension.T0  *17.9847[0-9]* kip' "$scratch/out"
try "a list, of a compound" grep -q 'load.per_length  *\[5.48174[0-9]*e-05, .*\] kip/ft' "$scratch/out"
try "nothing is in SI that is not" sh -c "! grep -E '[0-9] (m|N|rad/s) ' '$scratch/out'"
done_testing
