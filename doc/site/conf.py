"""Sphinx's settings for the documentation site; build.sh runs it on what assemble.py wrote.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import os
import re

from docutils import nodes
from sphinx import addnodes
from pygments.lexer import RegexLexer
from pygments.token import Generic, Text

project = "hawser"
author = "the authors of hawser"
release = version = os.environ["HAWSER_VERSION"]
extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
exclude_patterns = ["files"]
language = "en"
smartquotes = False             # "--plot" stays as it is
highlight_language = "none"     # most blocks are formulas and tables; commands and scenes are found below
myst_heading_anchors = 4
myst_html_meta = {"description": "hawser: statics and linear and nonlinear dynamics of cables, nets, ropeways and rods, from the shell, "
                                 "from Python and from C"}
html_theme = "furo"
html_title = "hawser " + version
HERE = os.path.dirname(os.path.abspath(__file__))
html_static_path = [os.path.join(HERE, "static")]
templates_path = [os.path.join(HERE, "templates")]
html_css_files = ["hawser.css"]
html_copy_source = False
html_show_copyright = False
html_use_index = False
html_domain_indices = False
html_theme_options = {"top_of_page_button": None}

MANUAL = re.compile(r"\b(hawser(?:-[a-z]+)?)\(([15])\)")
PAGES = {name[:-3] for name in os.listdir(os.path.join(os.environ["HAWSER_SITE"], "man"))}


class Shown(RegexLexer):
    """Commands behind "$ ", with their continued lines, and what they print."""
    tokens = {
        "root": [(r"^\$ ", Generic.Prompt, "command"), (r".*\n", Text)],
        "command": [(r"[^\\\n]+", Generic.Strong), (r"\\\n", Generic.Strong), (r"\\", Generic.Strong), (r"\n", Text, "#pop")],
    }


def language_of(text):
    """shown for commands, yaml for scenes, none for the rest."""
    if re.search(r"^\$ ", text, re.M):
        return "shown"
    if re.match(r"(#.*\n)*[a-z_]+:(\n| )", text) and "\n  " in text:
        return "yaml"
    return None


def manual_links(doctree, docname):
    """Names of manual pages in running text, and `man NAME`, lead to the pages."""
    up = "../"*docname.count("/")

    def reference(name, text):
        return nodes.reference("", text, refuri="%sman/%s.html" % (up, name), internal=True)

    for literal in list(doctree.findall(nodes.literal)):
        if re.fullmatch(r"--?[\w-]+", literal.astext()):
            literal["classes"].append("option")     # not broken at its hyphens
        hit = re.fullmatch(r"man (hawser(?:-[a-z]+)?)", literal.astext())
        page = hit and next((hit[1] + end for end in (".1", ".5") if hit[1] + end in PAGES), None)
        if page and not isinstance(literal.parent, nodes.reference):
            literal.replace_self(nodes.reference("", "", literal.deepcopy(), refuri="%sman/%s.html" % (up, page), internal=True))
    for text in list(doctree.findall(nodes.Text)):
        if isinstance(text.parent, (nodes.literal, nodes.literal_block, nodes.reference, nodes.title, nodes.raw)):
            continue
        parts = MANUAL.split(str(text))
        if len(parts) > 1:
            new = [nodes.Text(parts[0])]
            for name, section, rest in zip(parts[1::3], parts[2::3], parts[3::3]):
                page, shown = name + "." + section, "%s(%s)" % (name, section)
                new += [reference(page, shown) if page in PAGES else nodes.Text(shown), nodes.Text(rest)]
            text.parent.replace(text, new)


def adapt(app, doctree):
    for block in doctree.findall(nodes.literal_block):
        if block.get("language", "none") in ("none", "default"):
            block["language"] = language_of(block.astext()) or "none"
    manual_links(doctree, app.env.docname)


def titles_of(env):
    """The contents of all pages without their inner headings."""
    tocs = {}
    for page, toc in env.tocs.items():
        tocs[page] = toc.deepcopy()
        for entry in tocs[page].children:
            if len(entry) > 1:
                inner = list(entry.findall(addnodes.toctree))
                entry.pop(1)
                if inner:
                    entry.append(nodes.bullet_list("", *inner))
    return tocs


def navigation(app, pagename, templatename, context, doctree):
    """The navigation shows titles alone. Sphinx would copy the headings of all pages for each page, which took two thirds of the time."""
    complete = context.get("toctree")

    def titles(**options):
        if not hasattr(app, "hawser_titles"):
            app.hawser_titles = titles_of(app.env)
        tocs, app.env.tocs = app.env.tocs, app.hawser_titles
        try:
            return complete(**options)
        finally:
            app.env.tocs = tocs
    if complete:
        context["toctree"] = titles


def one_script(app, exception):
    """The theme's script may import another file, as in Debian 12; browsers refuse that for pages read from files."""
    path = os.path.join(app.outdir, "_static/scripts/furo.js")
    if exception or not os.path.isfile(path):
        return
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    imported = re.match(r'import Gumshoe from "\./([\w-]+\.js)";', text)
    if imported:
        with open(os.path.join(os.path.dirname(path), imported[1]), encoding="utf-8") as stream:
            text = stream.read() + text[imported.end():]
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)


def setup(app):
    app.add_lexer("shown", Shown)
    app.connect("doctree-read", adapt)
    app.connect("html-page-context", navigation, priority=400)   # before the theme's
    app.connect("build-finished", one_script)
    return {"parallel_read_safe": True}
