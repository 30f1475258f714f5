#!/bin/sh
# check-roots.sh FOLDER SUITE...: both commands of README.md, `./quickstart` and `./quickstart check`, in bare Debians made by
# debootstrap, with the awk of the release and with gawk installed (as root). The mirror is debootstrap's default, or MIRROR.
# Logs stay in FOLDER; the status is 1 where a command failed.
# SPDX-License-Identifier: GPL-3.0-or-later
set -u
folder=$1
shift
[ "$(id -u)" -eq 0 ] || { echo "check-roots: only root can make a bare Debian" >&2; exit 1; }
command -v debootstrap >/dev/null || { echo "check-roots: apt-get install debootstrap" >&2; exit 1; }
mkdir -p "$folder" || exit 1
top=$(cd "$(dirname "$0")/.." && pwd)
root=
trap 'clean' EXIT
trap 'exit 130' INT TERM

clean() {
	[ -n "$root" ] || return
	# What a process of the root still has open keeps a mount busy: it is then detached, and is gone with that process.
	for at in proc dev sys; do
		umount "$root/$at" 2>/dev/null || umount --lazy "$root/$at" 2>/dev/null
	done
	rm -rf --one-file-system "$root"
	root=
}

# bare SUITE: a root with the sources of packages of this machine, where it has any, in a form for this suite.
bare() {
	root=$(mktemp -d)
	chmod 755 "$root"
	# shellcheck disable=SC2086 # an address, or none
	debootstrap --variant=minbase "$1" "$root" ${MIRROR-} >"$folder/$1-debootstrap.log" 2>&1 || return 1
	# how this machine reaches its sources
	grep -l '^ *Acquire::' /etc/apt/apt.conf.d/* 2>/dev/null | xargs -r cp -t "$root/etc/apt/apt.conf.d/"
	cp /etc/resolv.conf "$root/etc/" 2>/dev/null
	mount --bind /dev "$root/dev" && mount -t proc proc "$root/proc" &&
		mount -t sysfs -o ro sysfs "$root/sys" || return 1
	mkdir "$root/clone"
	(cd "$top" && git ls-files -z | tar --null -cf - -T -) | tar -xf - -C "$root/clone"
}

# inside NAME COMMAND...: in the clone; one line with the verdict.
failed=0
inside() {
	name=$1
	shift
	if chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
		sh -c "cd /clone && $*" >"$folder/$name.log" 2>&1 </dev/null; then
		echo "check-roots: $name: passed"
	else
		echo "check-roots: $name: FAILED ($folder/$name.log)"
		tail -n 15 "$folder/$name.log"
		failed=1
	fi
}

for suite; do
	if ! bare "$suite"; then
		echo "check-roots: $suite: no root could be made ($folder/$suite-debootstrap.log)"
		failed=1
		clean
		continue
	fi
	inside "$suite-run" ./quickstart
	inside "$suite-check" ./quickstart check
	inside "$suite-gawk" 'apt-get -q -y install gawk && rm -rf build configure && ./quickstart'
	clean
done
exit $failed
