"""The reference of the C library for the site: each public header, divided at its declarations.

The headers are the library's manual (their comments say shapes, units, ownership and statuses), so that what a page shows is
the header's text; a heading with the names of what is declared stands above each part, for links, contents and search.
SPDX-License-Identifier: GPL-3.0-or-later
"""
import glob
import os
import re

FRAME = re.compile(r'^#ifndef HAWSER_\w+_H\n#define HAWSER_\w+_H\n|^#ifdef __cplusplus\n(extern "C" \{|\})\n#endif\n?|'
                   r"^#endif\s*\Z", re.M)
NAMES = (r"^(?:struct|enum|union) (hawser\w+) \{", r"^[^\s#/*][^;{(]*?\b(hawser\w+)\(", r"^#define (HAWSER_\w+)",
         r"^typedef [^;]*\(\*(hawser\w+)\)", r"^enum \{ (HAWSER\w+)", r"^extern [^;]*?\b(hawser\w+)\b")


def parts(text):
    """The text, divided where a comment or a declaration begins after another has ended."""
    found, lines, depth, comment, ended = [], [], 0, False, False
    for line in text.split("\n"):
        begins = line.startswith("/*") or (not line.strip() and not comment and depth == 0)
        if lines and ended and begins:
            found.append("\n".join(lines))
            lines, ended = [], False
        if line.strip() or lines:
            lines.append(line)
        plain = re.sub(r"/\*.*?\*/", "", line)
        if comment and "*/" in plain:
            comment, plain = False, plain.partition("*/")[2]
        if not comment:
            if "/*" in plain:
                comment, plain = True, plain.partition("/*")[0]
            depth += plain.count("{") + plain.count("(") - plain.count("}") - plain.count(")")
            if depth == 0 and (plain.rstrip().endswith(";") or line.startswith("#") and not line.endswith("\\")):
                ended = True
    return [part for part in found + ["\n".join(lines)] if part.strip()]


def names(part):
    plain = re.sub(r"/\*.*?\*/", "", part, flags=re.S)
    hits = {}
    for pattern in NAMES:
        for hit in re.finditer(pattern, plain, re.M):
            if not hit[1].endswith("_H"):
                hits.setdefault(hit[1], hit.start())
    return sorted(hits, key=hits.get)


def prose(comment):
    """A comment's text as Markdown."""
    text = re.sub(r"^/\*+ ?|\s*\*/$", "", comment.strip())
    text = re.sub(r"^ \* ?", "", text, flags=re.M)
    text = re.sub(r"\s*SPDX-License-Identifier: \S+", "", text)
    return re.sub(r"([\\`*_<\[#|{])", r"\\\1", text).strip()


def page(name, text):
    head, text = re.match(r"(/\*.*?\*/)(.*)", text, re.S).groups()
    about = prose(head)
    first, _, rest = about.partition("\n\n")
    summary = re.sub(r"^hawser/\S+ - ", "", " ".join(first.split()).replace(r"\_", "_")).replace("_", r"\_")
    summary = summary[:1].upper() + summary[1:]
    out = ["# hawser/" + name, "", "    #include <hawser/%s>" % name, "", summary, "", rest, ""]
    for part in parts(FRAME.sub("", text)):
        found = names(part)
        if found:
            more = " …" if len(found) > 3 else ""
            out += ["## " + ", ".join(found[:3]).replace("_", r"\_") + more, ""]
            if found[1:]:
                out += ["```{raw} html", "".join('<span id="%s"></span>' % each for each in found[1:]), "```", ""]
        out += ["```c", part.strip("\n"), "```", ""]
    return summary, "\n".join(out)


def pages(folder, write):
    rows, files = [], []
    for path in sorted(glob.glob(os.path.join(folder, "*.h"))):
        name = os.path.basename(path)
        with open(path, encoding="utf-8") as stream:
            summary, text = page(name, stream.read())
        write("api/" + name, text)
        files.append(name)
        rows.append("| [hawser/%s](%s.md) | %s |" % (name, name, summary.partition(". ")[0].rstrip(".").replace("|", r"\|")))
    write("api/index", "# Library\n\n`libhawser` is for C and C++ programs. It prints nothing, never ends the program and has no "
          "global state. A call that can fail returns `enum hawser_status` and says where and why in the caller's report; structures "
          "are released with their `_clear`. Compile with `pkg-config --cflags --libs hawser`; [hawser/hawser.h](hawser.h.md) includes "
          "all headers. Each page is a header with its comments: shapes of arrays, units, ownership, statuses.\n\n"
          "| header | about |\n| --- | --- |\n" + "\n".join(rows)
          + "\n\n```{toctree}\n:hidden:\n\n%s\n```\n" % "\n".join(files))
