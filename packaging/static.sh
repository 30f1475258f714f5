#!/bin/sh
# static.sh BUILD NAME: pack the program of the build folder BUILD, linked statically, with its manual pages, data,
# scenes and the notices of all that is linked in, as NAME.tar.gz. From Makefile.am (make static-tarball), which
# configures BUILD without what has no static library in Debian (MPI, HDF5, Siconos).
#
# Fully static, not a program with its shared libraries beside it: it runs on each Linux of the processor's kind
# (kernel 3.2 and later), whatever its C library is, and nothing has to be found at run time. The price: dlopen() and
# so --model-library take only libraries of the same C library. Of what hawser links, METIS alone has no static
# library in Debian. CHOLMOD names it, for orderings that hawser never asks for (src/net/statics/sparse.c: AMD or none);
# two functions that fail stand in its place.
# SPDX-License-Identifier: GPL-3.0-or-later
set -eu
build=$1 name=$2
here=$(cd "$(dirname "$0")" && pwd)
top=$(dirname "$here")
: "${CC:=cc}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=$work/$name
data=$root/share/doc/hawser
for program in dpkg dpkg-query strip; do
	command -v $program >/dev/null || {
		echo "static-tarball: $program is not found: the notices come from Debian's packages" >&2
		exit 1
	}
done

# --- the program
cat >"$work/metis.c" <<'END'
/* In place of METIS: the status METIS_ERROR. */
int METIS_NodeND(void);
int METIS_ComputeVertexSeparator(void);
int METIS_NodeND(void) { return -4; }
int METIS_ComputeVertexSeparator(void) { return -4; }
END
stages=$(find "$build/src" -name 'lib*.a' -not -name liboutput.a)
mkdir -p "$root/bin" "$data/licences"
# shellcheck disable=SC2086 # lists; dlopen is known (above), and its warning is left out
"$CC" -static -o "$root/bin/hawser" "$build"/src/cli/*/*.o "$(find "$build/src/output" -name liboutput.a)" \
	-Wl,--trace -Wl,--start-group $stages "$work/metis.c" -lslicot -llapacke -ltmglib -lklu -lbtf -lcholmod -lamd -lcamd \
	-lcolamd -lccolamd -lsuitesparseconfig -lgomp -lsundials_cvode -lsundials_nvecserial \
	-lsundials_sunlinsoldense -lsundials_sunmatrixdense -lfftw3 -lyaml -ljansson -ludunits2 -lexpat -lgsl -llapack \
	-lopenblas -lgfortran -lquadmath -lpthread -ldl -lm -Wl,--end-group >"$work/trace" 2>"$work/said" || {
	cat "$work/said" >&2
	exit 1
}
grep -v "in function\|Using 'dlopen'" "$work/said" >&2 || :
strip "$root/bin/hawser"

# --- its data
make -C "$build" install-data DESTDIR="$work/stage" >/dev/null
stage=$(dirname "$(find "$work/stage" -name share -type d | head -n 1)")
cp -r "$stage/share/man" "$root/share/"
mkdir -p "$root/share/hawser/udunits"
cp -r "$stage/share/hawser/scenes" "$root/share/hawser/"
cp "$stage"/share/doc/hawser/* "$data/"
cp /usr/share/xml/udunits/*.xml "$root/share/hawser/udunits/"
cp "$top/COPYING" "$root/"

# --- the notices: each archive that the linker opened belongs to a Debian package
sed -n 's/^(*\(\/[^()]*\.[ao]\).*/\1/p' "$work/trace" | sort -u | while read -r archive; do
	real=$(readlink -f "$archive")
	case $real in "$work"/*|"$(readlink -f "$build")"/*|/tmp/*) continue ;; esac
	# a name in /usr/lib may be known to dpkg by its name in /lib
	dpkg -S "$real" 2>/dev/null || dpkg -S "${real#/usr}" 2>/dev/null || echo "unknown: $real"
done | sed 's/: .*//; s/:.*//' | sort -u >"$work/packages"
echo libudunits2-data >>"$work/packages"
if grep -q '^unknown' "$work/packages"; then
	echo "static-tarball: a library of no Debian package is linked in" >&2
	exit 1
fi
while read -r package; do
	cp -L "/usr/share/doc/$package/copyright" "$data/licences/$package"
	# shellcheck disable=SC2016 # dpkg-query's own variables
	dpkg-query -W -f '${Package} ${Version}: source ${source:Package} ${source:Version}\n' "$package" | head -n 1
done <"$work/packages" >"$data/licences/SOURCES"

cat >"$root/README" <<END
$(echo "$name" | sed 's/-/ /; s/-/ for /') - linear and nonlinear dynamics of cables, for machines without its Debian packages

    bin/hawser --help          the program needs no other file to run; it may be moved
    share/hawser/udunits       units beyond the common ones, found from ../share of the program
    share/hawser/scenes        example scenes
    share/man                  manual pages: man -M share/man hawser
    share/doc/hawser           theory, glossary, messages

Pictures (--plot) are drawn by gnuplot, which is not included. --model-library needs the C library that this program was
linked with ($(dpkg-query -W -f '${source:Package} ${source:Version}' libc6-dev 2>/dev/null | head -n 1)); with another one use Debian's packages, or build hawser from its source.

LICENCE AND SOURCES. hawser is free software under the GNU General Public License, version 3 or later (COPYING), without
any warranty. The libraries linked into the program have their own licences, each in share/doc/hawser/licences; all of them
permit this. The source of hawser is the file hawser-VERSION.tar.gz, which is published beside this file; it builds this
file by "make static-tarball". The sources of the libraries are the Debian source packages of the versions in
share/doc/hawser/licences/SOURCES: "apt-get source PACKAGE=VERSION" on Debian. Who passes this file on has to pass the
sources on as well, or to say where they are.
END
tar -czf "$name.tar.gz" --owner=0 --group=0 --sort=name -C "$work" "$name"
ls -l "$name.tar.gz"
