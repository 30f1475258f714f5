"""Manual pages for the site: mandoc's HTML, divided into sections that Sphinx knows, with links between the pages.

Names of pages become links to them, "hawser-scene(5), NETS" to the section, and the names of scene keys to their entries.
mandoc gives each option and key an anchor. SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import html
import os
import re
import subprocess

PAGE = r"hawser(?:-[a-z]+)?"
REFERENCE = re.compile(r"(<b>)?(%s)(</b>)?\(([15])\)(, ([A-Z][A-Z]+(?:[ \n]+[A-Z]+)*)\b)?" % PAGE)
KEYED = re.compile(r"<b>([a-z][\w]*(?:\.[\w]+)+)</b>")


def anchor(title):
    """The anchor that Sphinx gives a heading."""
    return re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-")


def fragment(path):
    text = subprocess.run(["mandoc", "-T", "html", "-O", "fragment", path], check=True, capture_output=True,
                          encoding="utf-8").stdout
    text = text[text.index('<div class="manual-text">') + len('<div class="manual-text">'):]
    return text[:text.index("</div>\n<table class=\"foot\">")]


def sections(text):
    """(level, title, HTML) of each section."""
    text = re.sub(r"</?section[^>]*>\n?", "", text)
    parts = re.split(r'<h([12]) class="S[hs]"[^>]*>(.*?)</h\1>', text, flags=re.S)
    for i in range(1, len(parts), 3):
        title = re.sub(r"<[^>]*>", "", parts[i + 1])
        yield int(parts[i]), " ".join(html.unescape(title).split()), parts[i + 2].strip()


def renamed(text, taken):
    """Entries whose anchors are those of headings (--json and the section JSON) get others."""
    for name in sorted(taken):
        text = text.replace(' id="%s"' % name, ' id="entry-%s"' % name).replace(' href="#%s"' % name, ' href="#entry-%s"' % name)
    return text


def linked(text, own, known, keys):
    def page(hit):
        name = "%s.%s" % (hit[2], hit[4])
        if name not in known:
            return hit[0]
        section = anchor(hit[6]) if hit[6] else ""
        return '<a href="%s.html">%s(%s)</a>%s' % (name, hit[2], hit[4], "" if not section else ", " + (
            '<a href="%s.html#%s">%s</a>' % (name, section, hit[6]) if section in known[name] else hit[6]))

    def key(hit):
        return '<a href="hawser-scene.5.html#%s"><b>%s</b></a>' % (hit[1], hit[1]) if hit[1] in keys else hit[0]

    text = re.sub(r"<b>(--?[\w-]+)</b>", r'<b class="option">\1</b>', text)     # not broken at its hyphens
    parts = re.split(r"(<pre.*?</pre>|<a .*?</a>)", text, flags=re.S)
    for i in range(0, len(parts), 2):
        parts[i] = REFERENCE.sub(page, parts[i])
        if own != "hawser-scene.5":
            parts[i] = KEYED.sub(key, parts[i])
    return "".join(parts)


def pages(folder, tree, write):
    paths = {os.path.basename(path): path for path in glob.glob(os.path.join(folder, "hawser*.[15]"))
             + glob.glob(os.path.join(tree, "man/hawser*.[15]"))}
    texts = {name: list(sections(fragment(path))) for name, path in paths.items()}
    known = {name: {anchor(title) for _, title, _ in parts} for name, parts in texts.items()}
    keys = {key for _, _, body in texts["hawser-scene.5"] for key in re.findall(r'<dt id="([\w.]+)"', body)}
    names = sorted(texts, key=lambda name: (name != "hawser.1", name[-1], name))
    rows = []
    for name in names:
        title = "%s(%s)" % tuple(name.rsplit(".", 1))
        out = ["# " + title, ""]
        for level, heading, body in texts[name]:
            if heading == "NAME":
                summary = " ".join(html.unescape(re.sub(r"<[^>]*>", "", body)).split()).partition(" - ")[2]
            # a class of its own, so that mandoc's lists and texts have a style
            body = body.replace(' class="permalink"', ' class="self" aria-label="link to this entry"')
            out += ["#"*(level + 1) + " " + re.sub(r"([*_<\[])", r"\\\1", heading), ""]
            if body:
                out += ["```{raw} html", '<div class="man">' + linked(renamed(body, known[name]), name, known, keys) + "</div>", "```", ""]
        rows.append("| [%s](%s.md) | %s |" % (title, name, summary))
        write("man/" + name, "\n".join(out))
    write("man/index", "# Manual pages\n\nEvery option, every key of scenes, every column and key of results. "
          "`man hawser-frf` shows the same in a terminal.\n\n| page | about |\n| --- | --- |\n" + "\n".join(rows)
          + "\n\n```{toctree}\n:hidden:\n\n%s\n```\n" % "\n".join(names))
