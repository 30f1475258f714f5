"""The sources of the documentation site, from the documents, the manual pages and the headers as they are.

    python3 assemble.py --source TREE --made FOLDER --man FOLDER --out FOLDER [--pictures FOLDER]

Writes a folder of Markdown that Sphinx (conf.py beside this file) makes HTML of. Nothing is written twice: links between
the documents of the tree become links of the site, links to other files of the tree become downloads, and below a command
that a page shows with `--plot NAME.svg` stands the picture it drew, where --pictures has it (tests/checks/shown.py draws).
Files that the build makes, such as doc/messages.md, are in the folder --made, below their names in the tree.
A document that PAGES does not name stands at the end of the navigation.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import glob
import os
import re
import shutil
import sys

import equations
import headers
import manual

# Where a file of the tree is in the site, and the group of the navigation that has it.
PAGES = (
    ("Begin", (("doc/tutorial.md", "tutorial"), ("doc/tutorial-nets.md", "tutorial-nets"),
               ("doc/tutorial-mooring.md", "tutorial-mooring"), ("doc/tutorial-galloping.md", "tutorial-galloping"),
               ("doc/tutorial-stay.md", "tutorial-stay"), ("doc/tutorial-chairlift.md", "tutorial-chairlift"),
               ("doc/tutorial-models.md", "tutorial-models"), ("doc/gallery.md", "gallery"), ("doc/coming-from.md", "coming-from"),
               ("doc/commands.md", "commands"), ("doc/spans.md", "spans"), ("doc/moorings.md", "moorings"), ("doc/install.md", "install"))),
    ("Reference", (("doc/water.md", "water"), ("doc/waves.md", "waves"), ("man", "man/index"), ("notebooks-data/scenes", "scenes"), ("doc/python.md", "python"), ("doc/library.md", "library"),
                   ("doc/cluster.md", "cluster"), ("include/hawser", "api/index"), ("doc/messages.md", "messages"),
                   ("doc/glossary.md", "glossary"))),
    ("Theory", (("doc/theory.md", "theory"), ("doc/errata.md", "errata"), ("doc/robustness.md", "robustness"),
                ("bench/README.md", "benches"))),
    ("Project", (("NEWS", "news"), ("HACKING.md", "hacking"), ("src/README.md", "sources"), ("tests/README.md", "checks"),
                 ("doc/site/README.md", "site"), ("packaging/README.md", "packaging"))),
)
# Titles in the navigation, where that of the page is not one.
TITLES = {"tutorial": "Ten minutes", "tutorial-nets": "Nets in ten minutes", "tutorial-galloping": "Galloping in ten minutes",
          "tutorial-stay": "A stay with a damper in ten minutes", "tutorial-chairlift": "A chairlift in ten minutes",
          "tutorial-models": "Equations in ten minutes", "tutorial-mooring": "Moorings in ten minutes",
          "install": "Installation", "coming-from": "Coming from other programs",
          "library": "The library", "api/index": "Headers", "python": "Python", "cluster": "Large maps", "messages": "Messages", "robustness": "Robustness"}
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s#]*)(#[^)\s]*)?\)")


class Site:
    def __init__(self, options):
        self.tree, self.out, self.pictures = options.source, options.out, options.pictures
        self.options = options
        self.where = {"README.md": "index"}
        self.where.update(row for _, rows in PAGES for row in rows)
        # in the order of the index, then what it does not name
        named = re.findall(r"\]\((theory-[\w-]+\.md)\)", self.read("doc/theory.md"))
        there = sorted(os.path.basename(path) for path in glob.glob(os.path.join(self.tree, "doc/theory-*.md")))
        self.notes = ["doc/" + name for name in sorted(there, key=lambda name: named.index(name) if name in named else len(named))]
        self.where.update((path, os.path.basename(path)[:-3]) for path in self.notes)
        others = sorted({"doc/" + os.path.basename(path) for path in glob.glob(os.path.join(self.tree, "doc/*.md"))} - set(self.where))
        self.groups = PAGES + ((("Further", tuple((path, os.path.basename(path)[:-3]) for path in others)),) if others else ())
        self.where.update(row for _, rows in self.groups for row in rows)

    def read(self, path):
        made = os.path.join(self.options.made, path)
        with open(made if os.path.isfile(made) else os.path.join(self.tree, path), encoding="utf-8") as stream:
            return stream.read()

    def write(self, page, text, suffix=".md"):
        path = os.path.join(self.out, page + suffix)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)

    def target(self, document, page, path):
        """Where a link of a document leads in the site, relative to its page; other files of the tree are copied."""
        place = os.path.normpath(os.path.join(os.path.dirname(document), path))
        if place in self.where:
            there = self.where[place] + ".md"
        elif os.path.isfile(os.path.join(self.tree, place)):
            there = os.path.join("files", place)
            os.makedirs(os.path.dirname(os.path.join(self.out, there)), exist_ok=True)
            shutil.copyfile(os.path.join(self.tree, place), os.path.join(self.out, there))
        else:
            sys.exit("assemble.py: %s links to %s, which is no file" % (document, path))
        return os.path.relpath(there, os.path.dirname(page) or ".")

    def links(self, document, page, text):
        def replace(hit):
            mark, words, path, anchor = hit[1], hit[2], hit[3], hit[4] or ""
            if "://" in path or not path:
                return hit[0]
            return "%s[%s](%s%s)" % (mark, words, self.target(document, page, path), anchor)
        return LINK.sub(replace, text)

    def drawn(self, document, page, text):
        """The page with each picture below the block of the command that draws it."""
        folder = os.path.join(self.pictures or "", os.path.basename(document))
        out, block = [], []
        for line in text.split("\n") + ["end"]:
            if line.startswith("    ") or (block and not line.strip()):
                block.append(line)
                continue
            if block:
                while not block[-1].strip():
                    block.pop()
                out += block + [""]
                for command, name in self.plots(block):
                    if self.pictures and os.path.isfile(os.path.join(folder, name)):
                        copy = os.path.join(self.out, "pictures", os.path.basename(page) + "-" + name)
                        os.makedirs(os.path.dirname(copy), exist_ok=True)
                        shutil.copyfile(os.path.join(folder, name), copy)
                        words = re.sub(r"([\[\]*_`])", r"\\\1", command)
                        out += ["![Picture drawn by the command %s](%s)" % (words, os.path.relpath(copy, self.out)), ""]
                block = []
            out.append(line)
        return "\n".join(out[:-1])

    @staticmethod
    def plots(block):
        text = "\n".join(block).replace("\\\n", " ")
        for line in text.split("\n"):
            name = re.search(r"--plot ([\w.-]+\.svg)", line)
            if name and line.strip().startswith("$ "):
                yield " ".join(line.split())[2:], name[1]

    def markdown(self, document, page, extra=""):
        text = equations.replaced(self.links(document, page, self.read(document)))
        text = text if page == "index" else self.drawn(document, page, text)     # it begins with its picture
        if "<!-- pictures -->" in text:
            text = text.replace("<!-- pictures -->", self.grid(text))
        # a line that begins with % would be a comment
        self.write(page, re.sub(r"^%", r"\\%", text, flags=re.M) + extra)

    @staticmethod
    def grid(text):
        """Small pictures that lead to the sections of the page."""
        cells, heading = [], ""
        for line in text.split("\n"):
            if line.startswith("### "):
                heading = line[4:].strip()
            picture = re.match(r"!\[.*\]\(pictures/(\S+)\)$", line)
            if picture and heading:
                cells.append('<a href="#%s"><img src="_images/%s" alt=""><span>%s</span></a>' % (manual.anchor(heading), picture[1], heading))
                heading = ""
        return "```{raw} html\n<nav class=\"grid\" aria-label=\"Pictures\">%s</nav>\n```" % "\n".join(cells) if cells else ""

    def scenes(self):
        """One page of all scenes, with their comments and text."""
        names = sorted(os.listdir(os.path.join(self.tree, "notebooks-data/scenes")))
        parts = ["# Scenes\n\nThe scenes that come with hawser, as they are (`share/hawser/scenes` after installation). "
                 "hawser-scene(5) explains their keys. Names that begin with b or d are published cases: B is the thesis of "
                 "Charlélie Bertrand (2022), D that of Abhinav Ravindra Dehadrai (2018).\n"]
        for name in names:
            if name.endswith(".yaml"):
                parts.append("## %s\n\n```yaml\n%s\n```\n" % (name, self.read("notebooks-data/scenes/" + name).rstrip()))
        self.write("scenes", "\n".join(parts))

    def news(self):
        text = self.read("NEWS").replace("<", r"\<").replace("/*.h", r"/\*.h")
        text = re.sub(r"^  (?=\S|  )", "", text, flags=re.M)
        text = re.sub(r"^hawser (\d\S*)", r"## Version \1", text, flags=re.M)
        self.write("news", "# News\n\n" + text)

    def contents(self):
        """The hidden tables of contents of the front page, which the theme's navigation shows."""
        parts = []
        for group, rows in self.groups:
            pages = ["%s <%s>" % (TITLES[page], page) if page in TITLES else page for _, page in rows]
            parts.append("\n```{toctree}\n:hidden:\n:caption: %s\n\n%s\n```\n" % (group, "\n".join(pages)))
        return "\n".join(parts)

    def build(self):
        shutil.rmtree(self.out, ignore_errors=True)
        os.makedirs(self.out)
        notes = "\n```{toctree}\n:hidden:\n\n%s\n```\n" % "\n".join(self.where[path] for path in self.notes)
        for _, rows in self.groups:
            for document, page in rows:
                if document.endswith(".md"):
                    self.markdown(document, page, notes if document == "doc/theory.md" else "")
        for document in self.notes:
            self.markdown(document, self.where[document])
        self.markdown("README.md", "index", self.contents())
        self.scenes()
        self.news()
        manual.pages(self.options.man, self.tree, self.write)
        headers.pages(os.path.join(self.tree, "include/hawser"), self.write)


def main():
    parser = argparse.ArgumentParser()
    for name in ("source", "made", "man", "out"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--pictures")
    Site(parser.parse_args()).build()


if __name__ == "__main__":
    main()
