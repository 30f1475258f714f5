#!/bin/sh
# deb.sh TARBALL FOLDER: the Debian packages of a tarball of `make dist`, in FOLDER, and what lintian says of
# them. deb.sh --needs: only whether the packages that this takes are there. DEB_BUILD_OPTIONS as
# dpkg-buildpackage has it, such as "nocheck parallel=2".
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
if [ "$1" = --needs ]; then
	top=$(cd "$(dirname "$0")/.." && pwd)
	missing=$(sed -n 's/^\(build\|deb\): //p' "$top/packages.txt" | tr ' ' '\n' | while read -r package; do
		dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || echo "$package"
	done | tr '\n' ' ')
	[ -z "$missing" ] || {
		echo "deb: apt-get install --no-install-recommends $missing" >&2
		exit 1
	}
	exit 0
fi
tarball=$1 folder=$2
name=$(basename "$tarball" .tar.gz)
rm -rf "$folder"
mkdir -p "$folder"
cp "$tarball" "$folder/$(echo "$name" | tr - _).orig.tar.gz"
tar -xzf "$tarball" -C "$folder"
unset MAKEFLAGS MAKELEVEL MFLAGS
# Debian's own programs: another python3 in PATH would have none of the modules of the build dependencies.
PATH=/usr/sbin:/usr/bin:/sbin:/bin
export PATH
(cd "$folder/$name" && dpkg-buildpackage -us -uc)
# What upstream's own packages cannot know is the number of the bug that asks for them; and their folder debian is in the tarball, so
# that nothing is added to it.
lintian --fail-on error,warning --suppress-tags initial-upload-closes-no-bugs,no-debian-changes "$folder"/*.changes
ls -l "$folder"/*.deb
