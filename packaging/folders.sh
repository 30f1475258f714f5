#!/bin/sh
# folders.sh - which folders `make install` makes, so that `make uninstall` can remove these and no
# others. From Makefile.am; DESTDIR comes from the environment.
#
#   folders.sh note RECORD FOLDER...     before an install: add to RECORD what does not exist yet
#   folders.sh remove RECORD FOLDER...   after an uninstall: remove the empty ones that RECORD names
#
# FOLDER is a folder that files are installed to; the folders above it count too. A folder named after
# the package belongs to it, recorded or not: another build folder may have installed it.
# SPDX-License-Identifier: GPL-3.0-or-later
set -u
LC_ALL=C
export LC_ALL
verb=$1 record=$2
shift 2

# Every folder with those above it, the deepest first, each once.
for folder; do
	while [ "$folder" != / ] && [ "$folder" != . ]; do
		echo "${DESTDIR-}$folder"
		folder=$(dirname "$folder")
	done
done | sort -ru |
if [ "$verb" = note ]; then
	while read -r folder; do
		[ -d "$folder" ] || echo "$folder"
	done >"$record.new"
else
	while read -r folder; do
		if [ "${folder##*/}" = hawser ] || grep -qxF -- "$folder" "$record" 2>/dev/null; then
			rmdir "$folder" 2>/dev/null
		fi
	done
fi

# What earlier installs made counts as long as it is there.
if [ "$verb" = note ]; then
	[ ! -f "$record" ] || cat "$record" >>"$record.new"
	mv -f "$record.new" "$record"
elif [ -f "$record" ]; then
	while read -r folder; do
		[ ! -d "$folder" ] || echo "$folder"
	done <"$record" >"$record.new"
	if [ -s "$record.new" ]; then
		mv -f "$record.new" "$record"
	else
		rm -f "$record.new" "$record"
	fi
fi
exit 0
