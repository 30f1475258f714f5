"""The links of a folder of HTML: links.py FOLDER [--external].

Each internal link, anchor, picture, script and style of every page has to be there, and no page may load anything from elsewhere
(a link to follow is no load), nor scripts that are modules. Prints a line a fault, and ends with status 1 where there are any; --external lists the links that
lead elsewhere, which are not followed. SPDX-License-Identifier: GPL-3.0-or-later
"""
import html.parser
import os
import re
import sys
import urllib.parse

LOADS = {("img", "src"), ("script", "src"), ("source", "src"), ("iframe", "src"), ("video", "src"), ("embed", "src"), ("object", "data")}
LOADED_LINKS = {"stylesheet", "icon", "preload", "prefetch", "preconnect", "dns-prefetch", "search"}
DRAWN_BY_SCRIPT = {"search.html"}   # whose results appear when words are given


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.links, self.ids, self.twice, self.bare, self.title = [], set(), set(), [], False
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        for key in ("id", "name") if tag == "a" else ("id",):
            if values.get(key):
                if values[key] in self.ids and key == "id":
                    self.twice.add(values[key])
                self.ids.add(values[key])
        self.title = self.title or tag == "title"
        if tag == "img" and "alt" not in values:
            self.bare.append(values.get("src"))
        loaded = tag == "link" and LOADED_LINKS & set((values.get("rel") or "").split())
        for key in ("href", "src", "data"):
            if values.get(key) is not None and (key == "href" or (tag, key) in LOADS):
                self.links.append((values[key], (tag, key) in LOADS or bool(loaded), self.getpos()[0]))

    handle_startendtag = handle_starttag


def elsewhere(text):
    """What a style loads from elsewhere."""
    return re.findall(r"(?:url\(|@import)\s*[\"']?((?:https?:)?//[^\"')\s]+)", text)


def read(path):
    with open(path, encoding="utf-8") as stream:
        return stream.read()


def check(folder):
    """(faults, links that lead elsewhere)"""
    faults, external, pages = [], set(), {}
    for where, _, names in os.walk(folder):
        for name in names:
            path = os.path.join(where, name)
            if name.endswith(".html"):
                pages[os.path.normpath(path)] = Page(read(path))
            elif name.endswith(".js") and re.search(r"^(import|export) ", read(path), re.M):
                faults.append(path + ": a module, which browsers do not load from files")
            elif name.endswith(".css"):
                faults += ["%s: loads %s" % (path, link) for link in elsewhere(read(path))]
    for path, page in sorted(pages.items()):
        faults += ["%s: anchor #%s stands twice" % (path, each) for each in sorted(page.twice)]
        faults += ["%s: picture %s has no alternative text" % (path, each) for each in page.bare]
        if not page.title:
            faults.append(path + ": no title")
        for link, loaded, line in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme in ("data", "mailto", "javascript"):
                continue
            if parts.scheme or parts.netloc:
                external.add(link)
                if loaded:
                    faults.append("%s:%d: loads %s" % (path, line, link))
                continue
            target = path if not parts.path else os.path.normpath(
                os.path.join(os.path.dirname(path), urllib.parse.unquote(parts.path)))
            anchor = urllib.parse.unquote(parts.fragment)
            if parts.path.startswith("/") or not os.path.isfile(target):
                faults.append("%s:%d: %s is not there" % (path, line, link))
            elif anchor and target in pages and anchor not in pages[target].ids:
                faults.append("%s:%d: no anchor for %s" % (path, line, link))
    if not pages:
        faults.append(folder + ": no pages")
    return faults, sorted(external)


def main():
    faults, external = check(sys.argv[1])
    if "--external" in sys.argv:
        print("\n".join(external))
    print("\n".join(faults), end="\n" if faults else "")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
