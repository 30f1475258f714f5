#!/bin/sh
# try-packages.sh FOLDER: as root on a bare Debian: install the packages of FOLDER, use them, remove them, and
# say which files are left. Not for a machine in use: it removes the packages.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
folder=$1
work=$(mktemp -d)
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 AUTOPKGTEST_TMP="$work"
# minimal images leave out manual pages and documents
rm -f /etc/dpkg/dpkg.cfg.d/docker /etc/dpkg/dpkg.cfg.d/excludes
found() {
	find / -xdev -name '*hawser*' -not -path "$folder*" -not -path "$work*" -not -path '/proc/*' | sort
}
found >"$work/before"
apt-get update -q >/dev/null
apt-get install -y -q --no-install-recommends gnuplot-nox man-db gcc libc6-dev pkg-config >/dev/null
apt-get install -y -q --no-install-recommends "$folder"/*.deb >/dev/null
echo "installed: $(hawser --version | head -n 1)"
man -w hawser-frf hawser-scene >/dev/null && man hawser-frf | grep -q frequency && echo "manual pages: good"
for test in main-job library python; do
	sh "$folder/tests/$test" # set -e: the first that fails ends all
	echo "$test: good"
done
[ ! -f /usr/share/bash-completion/completions/hawser ] || echo "completion for bash: installed"
cd /
apt-get purge -y -q python3-hawser hawser libhawser0 libhawser-dev hawser-doc >/dev/null
# man keeps pages that it has shown; they are no files of the packages
rm -f /var/cache/man/cat*/hawser* /var/cache/man/*/cat*/hawser*
found >"$work/after"
if ! cmp -s "$work/before" "$work/after"; then
	echo "left after the removal:" >&2
	diff "$work/before" "$work/after" >&2
	exit 1
fi
echo "removed: nothing is left"
rm -rf "$work"
