#!/bin/sh
# bare-root.sh FOLDER [SUITE]: make a bare Debian by debootstrap and try the packages of FOLDER there (as root).
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
folder=$1 suite=${2-bookworm}
here=$(dirname "$0")
root=$(mktemp -d)
chmod 755 "$root"
trap 'rm -rf "$root"' EXIT
debootstrap --variant=minbase "$suite" "$root" >"$folder/debootstrap.log"
mkdir -p "$root/try/tests"
cp "$folder"/*.deb "$here/try-packages.sh" "$root/try"
cp "$here"/../debian/tests/main-job "$here"/../debian/tests/library "$here"/../debian/tests/python \
	"$root/try/tests"
chroot "$root" sh /try/try-packages.sh /try
