#!/bin/sh
# quickstart refuses where it may not install, tells the administrator what to do, and leaves the folder
# as it was. It runs in a folder of its own, on a system that has no package and no sudo.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$(dirname "$0")/lib.sh"
clone=$scratch/clone
bin=$scratch/bin
mkdir "$clone" "$bin"
cp quickstart packages.txt "$clone"
stub() {
	printf '#!/bin/sh\n%s\n' "$2" >"$bin/$1"
	chmod +x "$bin/$1"
}
stub id 'echo 1000'
stub sudo 'exit 1'
stub dpkg-query 'exit 1'
stub apt-get 'echo apt-get was called; exit 1'

for job in run check; do
	PATH=$bin:$PATH "$clone/quickstart" $job >"$scratch/out" 2>"$scratch/err" </dev/null
	try "$job without rights: exit status 1" test $? -eq 1
	try "$job: the command for root is printed" \
		grep -q 'apt-get update && apt-get install .* autoconf automake' "$scratch/err"
	try "$job: and it is not run" sh -c "! grep -q 'was called' '$scratch/out' '$scratch/err'"
	find "$clone" -mindepth 1 ! -name quickstart ! -name packages.txt |
		nothing "$job: nothing is left in the folder"
done
awk '$1 == "check:" || $1 == "optional:" { for (i = 2; i <= NF; i++) print $i }' packages.txt |
	while read -r package; do
		grep -qw -- "$package" "$scratch/err" || echo "$package: not asked for"
	done | nothing "check asks for the tests' packages"

# A folder that can't be written to: not for root, whom permissions don't stop.
chmod a-w "$clone"
if [ -w "$clone" ]; then
	skip "root may write everywhere"
else
	PATH=$bin:$PATH "$clone/quickstart" >"$scratch/out" 2>"$scratch/err" </dev/null
	try "a folder without the right to write is named" grep -q "can't write here: $clone" "$scratch/err"
fi
chmod u+w "$clone"
done_testing
