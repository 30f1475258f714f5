#!/bin/sh
# try-static.sh TARBALL HAWSER: the program of `make static-tarball` in a folder that is the whole file system, and
# whether its results are those of the program HAWSER. Needs root, or user namespaces (unshare).
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
tarball=$1 hawser=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tar -xzf "$tarball" -C "$work"
name=$(cd "$work" && echo hawser-*)
PATH=$PATH:/usr/sbin:/sbin
chroot=$(command -v chroot)
scenes=$work/$name/share/hawser/scenes
# nothing but the tarball: no C library, no loader, no /proc, no environment
if [ "$(id -u)" -eq 0 ]; then
	inside() { env -i "$chroot" "$work" "/$name/bin/hawser" "$@"; }
else
	inside() { env -i "$(command -v unshare)" -r "$chroot" "$work" "/$name/bin/hawser" "$@"; }
fi
inside --version | head -n 1
# equal COMMAND SCENE OPTIONS: the same bytes, but for the place of the scene. No environment for both:
# OPENBLAS_CORETYPE would choose another kernel, with other round-off.
equal() {
	command=$1 scene=$2
	shift 2
	inside "$command" "/$name/share/hawser/scenes/$scene" "$@" --quiet --reproducible --json - | sed 's|"name": "[^"]*"||' >"$work/a"
	env -i PATH="$PATH" "$hawser" "$command" "$scenes/$scene" "$@" --quiet --reproducible --json - | sed 's|"name": "[^"]*"||' >"$work/b"
	cmp "$work/a" "$work/b" && echo "$command $scene: the same $(wc -c <"$work/a") bytes"
}
equal statics chairlift.yaml
equal modes chairlift.yaml -n 6
equal frf chairlift.yaml --from 0.95w1 --to 1.05w1
equal statics net-table-3-1.yaml
equal statics ropeway-small.yaml
# a unit that only udunits2's database has
inside statics "/$name/share/hawser/scenes/chairlift.yaml" --set 'span.d=820.2099737532808 international_foot' --quiet | grep -q '250' &&
	echo "units: found"
