#!/bin/sh
# The documentation site: its links are checked (links.py), and the check finds what is broken. Where Sphinx, MyST, furo and mandoc
# are installed the site is built, without pictures unless HAWSER_LONG=1, warnings being errors.
# SPDX-License-Identifier: GPL-3.0-or-later
MANDIR=${MANDIR-$PWD/man} HAWSER=${HAWSER-$PWD/hawser}
export MANDIR HAWSER
. "$(dirname "$0")/lib.sh"

if ! command -v python3 >/dev/null; then
	skip "python3 is not installed"
	done_testing
	exit
fi
mkdir "$scratch/wrong"
cat >"$scratch/wrong/index.html" <<'END'
<html><head><title>a</title><link rel="stylesheet" href="https://example.org/a.css"></head><body id="top">
<a href="other.html#there">fine</a> <a href="https://example.org/">fine</a> <a href="#top">fine</a>
<a href="other.html#nowhere">1</a> <a href="missing.html">2</a> <img src="missing.png" alt=""> <img src="other.html">
<p id="top"></p></body></html>
END
echo '<html><head><title>b</title></head><body><p id="there"></p></body></html>' >"$scratch/wrong/other.html"
echo 'a { background: url(//example.org/a.png) }' >"$scratch/wrong/a.css"
echo 'import a from "./b.js";' >"$scratch/wrong/c.js"
python3 tests/checks/links.py "$scratch/wrong" | sort | sed 's|.*wrong/||' >"$scratch/found"
cat >"$scratch/expected" <<'END'
a.css: loads //example.org/a.png
c.js: a module, which browsers do not load from files
index.html: anchor #top stands twice
index.html: picture other.html has no alternative text
index.html:1: loads https://example.org/a.css
index.html:3: missing.html is not there
index.html:3: missing.png is not there
index.html:3: no anchor for other.html#nowhere
END
diff "$scratch/expected" "$scratch/found" | nothing "broken links, anchors and pictures, and what is loaded from elsewhere, are found"
rm "$scratch/wrong/a.css" "$scratch/wrong/c.js" "$scratch/wrong/index.html"
try "a folder without faults passes" python3 tests/checks/links.py "$scratch/wrong"

try "equations of the documents can be read" test -z "$(python3 doc/site/equations.py check doc/*.md)"
try "theory pages have equations" test "$(cat doc/theory-*.md | grep -c '^```eq')" -gt 100
python3 doc/site/equations.py show 'K_ij = a²/(2ε)' 'sinh a/a ≤ √(T/g)·∂²V' >"$scratch/shown"
for part in '<msub><mi>K</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub>' \
	'<mfrac><msup><mi>a</mi><mn>2</mn></msup><mrow><mn>2</mn><mi>ε</mi></mrow></mfrac>' \
	'<mfrac><mrow><mi>sinh</mi><mo>&#8289;</mo><mspace width="0.17em"></mspace><mi>a</mi></mrow><mi>a</mi></mfrac>' \
	'<msqrt><mfrac><mi>T</mi><mi>g</mi></mfrac></msqrt><mo>·</mo><msup><mi>∂</mi><mn>2</mn></msup><mi>V</mi>'; do
	grep -qF "$part" "$scratch/shown" || echo "not in the equation: $part"
done | nothing "indices, exponents, fractions, functions and roots are such in MathML"

version=$(sed -n 's/^AC_INIT(\[hawser\], \[\([^]]*\)\].*/\1/p' configure.ac)
pictures=no
[ -z "${HAWSER_LONG-}" ] || pictures=yes
SRCDIR=$PWD VERSION=$version PICTURES=$pictures sh doc/site/build.sh "$scratch/site" >"$scratch/why" 2>&1
status=$?
if [ "$status" -eq 77 ]; then
	skip "$(cat "$scratch/why")"
	done_testing
	exit
fi
verdict "$status" "the site is built without a warning"
python3 tests/checks/links.py "$scratch/site" | sed "s|$scratch/||" | nothing "its links hold, and it loads nothing from elsewhere"
for page in index tutorial gallery coming-from search man/hawser-frf.1 man/hawser-scene.5 api/modes.h theory errata scenes news; do
	[ -s "$scratch/site/$page.html" ] || echo "$page.html is not there"
done | nothing "it has the pages"
try "keys of scenes have anchors" grep -q 'id="cable.EA"' "$scratch/site/man/hawser-scene.5.html"
try "equations are MathML" grep -q '<math displaystyle="true"' "$scratch/site/theory-rom.html"
try "the search has functions of the headers" grep -q 'hawser_modes_solv' "$scratch/site/searchindex.js"
done_testing
