#!/bin/sh
# Statics of moorings from MoorDyn's files: W1 and W2 of the reference cases (an elastic catenary on a bed, a string in a current),
# each by two programs. Forces on supports within 2e-4 of the largest component; other elements, and the file's axes turned.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"

# file TYPE A B LINE DEPTH: a file of one line
file() {
	printf '%s\n' "--- LINE TYPES ---" names units "$1" "--- POINTS ---" names units "1 Anchor $2 0 0 0 0" "2 Coupled $3 0 0 0 0" \
		"--- LINES ---" names units "$4" "--- OPTIONS ---" "$5 WtrDpth" "1025 rhoW"
}
# forces X Y Z X Y Z: on both supports, those of the last run
forces() {
	sed -n 's/^# P[12] = .*support (\(.*\)) N/\1/p' "$scratch/out" | tr -d , | tr '\n' ' ' | awk -v want="$*" '{
		n = split(want, w, " ")
		for (i = 1; i <= n; i++) { most = w[i]*w[i] > most*most ? w[i] : most; d = $i - w[i]; worst = d*d > worst*worst ? d : worst }
		print "# difference", worst/most
		exit !(NF == n && worst*worst < 4e-8*most*most)
	}'
}

file "chain 0.0766 113.35 753.6e6 -1 0 2 1 0.4 0" "0 0 -200" "0 796.732 -14" "1 chain 1 2 835.5 200 p" 200 >w1.txt
"$HAWSER" init --from w1.txt >w1.yaml
works "W1" statics w1.yaml
try "  forces" forces 0 0 900903.8 0 629156.6 -900903.8
file "line 0.12 12 20e6 -1 0 1.2 1 0.02 0" "0 0 -200" "200 0 0" "1 line 1 2 300 60 p" 230 >w2.txt
"$HAWSER" init --from w2.txt >w2.yaml
works "W2" statics w2.yaml --set "water.current=[0.8 m/s, 0, 0.6 m/s]"
try "  forces" forces -10654.75 -5079.19 -3794.18 2652.88 11045.70 -5838.36
done_testing
