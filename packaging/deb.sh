#!/bin/sh
# deb.sh TARBALL FOLDER: the Debian packages of a tarball of `make dist`, in FOLDER, and what lintian says of
# them. DEB_BUILD_OPTIONS as dpkg-buildpackage has it, such as "nocheck parallel=2".
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
tarball=$1 folder=$2
for program in dpkg-buildpackage dh lintian; do
	command -v $program >/dev/null || {
		echo "deb: $program is not found: apt-get install dpkg-dev debhelper lintian" >&2
		exit 1
	}
done
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
