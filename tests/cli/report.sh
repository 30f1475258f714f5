#!/bin/sh
# hawser report: one page that needs nothing else, its parts and provenance, refusals. HAWSER_LONG=1: every kind of scene, and the
# page in a browser without window: no message, readings off a curve, zoom, phone width.
# SPDX-License-Identifier: GPL-3.0-or-later
. "$SRCDIR/tests/cli/lib.sh"
scenes=$top/notebooks-data/scenes
cp "$scenes/chairlift.yaml" .

if ! command -v gnuplot >/dev/null; then
	skip "gnuplot is not installed"
	done_testing
	exit
fi
refuses 1 "a report is one file, --output: leave --tsv out (the commands it shows have it)" report chairlift.yaml --tsv a
refuses 1 "--output a.pdf: a report is HTML, which a browser prints as PDF: write a name that ends in .html, or - for standard output" report chairlift.yaml -o a.pdf
refuses 1 "--parts statics, mode: a report of this scene has no part mode; it has statics, modes, irvine, frf, plan" \
	report chairlift.yaml --parts "statics, mode"
refuses_like 2 "tension T0 at end A" report chairlift.yaml --set tension.T0=5kN
refuses_like 1 "from" report chairlift.yaml --parts frf --from 2kg
try "no refusal left a file" test "$(ls -A)" = chairlift.yaml
mkdir left
TMPDIR=$PWD/left
export TMPDIR
works "two parts" report chairlift.yaml --parts "statics, modes" -n 3 --reproducible --title 'A <span> & "more"'
mv report.html first.html
"$HAWSER" report - --parts statics -o piped.html -q <chairlift.yaml
try "from standard input" grep -q "tension" piped.html
works "to standard output" report chairlift.yaml --parts "statics, modes" -n 3 --reproducible --title 'A <span> & "more"' -o - -q
try "  the same bytes" cmp "$scratch/out" first.html
cat >"it's slack.yaml" <<'END2'
cable: {EA: .inf, rho: 6 kg/m}
span: {d: 250 m, h: 0}
tension: {T0: 80 kN}
damping: {alpha: 0.08}
load: {frame: local, per_length: [0, 0, 1 N/m]}
END2
run report "it's slack.yaml" --parts "statics, frf" -o slack.html
try "a part that fails is told" grep -q "^hawser: warning: the report has no frf: " "$scratch/err"
try "  and stands in the report" grep -q 'role="note">Not computed: ' slack.html
works "a travelling beam" report "$scenes/d-figure-9.10.yaml" -o beam.html -q
try "  with a picture of its eigenvalues over the speed" grep -q '<h2 id="speeds">' beam.html
try "  whose command draws it" grep -q 'd-figure-9.10.yaml --plot speeds.svg' beam.html
try "  and no other picture" test "$(grep -c '<svg' beam.html)" = 1
try "commands are quoted as a shell reads them" grep -qF "hawser statics 'it'\\''s slack.yaml'" slack.html
try "no temporary file is left" test -z "$(ls -A left)"
digest=$( (sha256sum chairlift.yaml 2>/dev/null || echo none) | cut -d ' ' -f 1)

cat >look.py <<'END2'
"""Elements of pages: look.py DIGEST PAGE..."""
import html.parser
import re
import sys

VOID = ("meta", "link", "br", "input", "img")


class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.open, self.ids, self.found, self.links = [], [], [], []

    def handle_starttag(self, tag, attributes):
        a = dict(attributes)
        self.found.append((tag, a))
        if tag not in VOID:
            self.open.append(tag)
        if "id" in a:
            self.ids.append(a["id"])
        self.links += [a[k] for k in ("href", "src", "xlink:href", "action") if k in a]

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        assert self.open and self.open[-1] == tag, (tag, self.open)
        self.open.pop()


for name in sys.argv[2:]:
    text = open(name, encoding="utf-8").read()
    page = Page()
    page.feed(text)
    tags = [tag for tag, _ in page.found]
    assert not page.open, page.open
    assert len(page.ids) == len(set(page.ids)), "an id stands twice"
    assert all(l.startswith("#") and l[1:] in page.ids or l.startswith("data:") for l in page.links), page.links
    assert not re.search(r"(https?:)?//(?!www\.w3\.org/)\w+\.", re.sub(r"\s//[^\n]*", "", text)), "an address"
    assert "url(http" not in text and "@import" not in text
    assert tags.count("h1") == 1 and tags.count("main") == 1 and "title" in tags
    assert all(a.get("scope") in ("row", "col") for t, a in page.found if t == "th")
    assert all(a.get("role") == "img" and all(i in page.ids for i in a["aria-labelledby"].split())
               for t, a in page.found if t == "svg")
    assert tags.count("figure") == tags.count("figcaption") == tags.count("svg")
    assert dict(page.found[0][1]).get("lang") == "en"
    if name == "first.html":
        assert "<title>A &lt;span&gt; &amp; &quot;more&quot;</title>" in text
        assert sys.argv[1] in ("none", "") or "<td>%s</td>" % sys.argv[1] in text
        assert "model.tolerance</th><td>1e-10 (default)" in text and "modes --tolerance" in text or "modes" in text
        assert tags.count("svg") == 2 and "5.76337268652 m" in text
        panels = [a["data-panels"] for t, a in page.found if t == "svg"]
        box = [float(v) for v in panels[0].split(";")[0].split()]
        assert len(panels[0].split(";")) == 2 and box[4:] == [0.0, 250.0, -2.0, 10.0, 0.0], box
        rows = re.search(r"<summary>Table: (\d+) of (\d+) rows", text)
        assert rows.groups() == ("40", "201"), rows.groups()
        body = re.search(r"<tbody>\n<tr><td class=\"n\">0<.*?</tbody>", text, re.S).group(0)
        assert body.count("<tr>") == 40 and "250.50289" in body.split("<tr>")[-1]
END2
if command -v python3 >/dev/null; then
	try "pages are well formed, complete and without addresses" python3 -S look.py "$digest" first.html slack.html
else
	skip "python3 is not installed"
fi

if [ -n "${HAWSER_LONG:-}" ]; then
	for scene in chairlift rope ropeway-small net-table-3-1 rod-pipe tow-orbit d-section-5.2.5 hoist-rope b-table-3.5 \
		stay-anchorage conductor-towers; do
		run report "$scenes/$scene.yaml" -o $scene.html -q
		try "report of $scene" test "$status" -eq 0
		try "  is well formed" python3 -S look.py "" $scene.html
		try "  has all its parts" sh -c '! grep -q "Not computed" "$1"' sh $scene.html
	done
fi
if [ -n "${HAWSER_LONG:-}" ] && command -v chromium >/dev/null; then
	sed '/<\/body>/d; /<\/html>/d' chairlift.html >probe.html
	cat >>probe.html <<'END2'
<script>
addEventListener("load", function () {
  const figure = document.querySelector("figure"), svg = figure.querySelector("svg"), out = figure.querySelector("output");
  const q = svg.dataset.panels.split(";")[0].split(" ").map(Number), p = svg.createSVGPoint(), said = [];
  p.x = (q[0] + q[1])/2;
  p.y = q[3] - 8;
  const at = p.matrixTransform(svg.getScreenCTM());
  svg.dispatchEvent(new PointerEvent("pointermove", {clientX: at.x, clientY: at.y}));
  said.push(out.textContent);
  figure.querySelector("button").click();
  said.push(out.textContent);
  figure.querySelector(".plot").dispatchEvent(new KeyboardEvent("keydown", {key: "0"}));
  said.push(out.textContent, document.documentElement.scrollWidth - document.documentElement.clientWidth);
  document.title = said.join("|");
});
</script></body></html>
END2
	# a browser has no sandbox when root runs it
	for width in 1280 500; do
		chromium --headless --no-sandbox --disable-gpu --enable-logging=stderr --user-data-dir="$scratch/browser" \
			--window-size=$width,900 --virtual-time-budget=3000 --dump-dom "file://$PWD/probe.html" >dom 2>log
		try "$width px: readings, zoom, no overflow" grep -q '<title>curve: x = 12[0-9], y = -0.[78].*|enlarged 1.6 times|whole picture|0</title>' dom
		grep CONSOLE log | nothing "  no message"
	done
fi
done_testing
