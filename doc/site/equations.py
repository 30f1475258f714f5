"""Equations of the documents as MathML.

    python3 equations.py check DOCUMENT...     what cannot be read
    python3 equations.py show 'a²/(2ε) = b_j'  the MathML of a line

An equation is a fenced block with the word eq. Its notation is what one would type: Unicode letters and signs, u_j and K_(m−l) for
indices, ², ᵀ, e^(−q) and primes for exponents, √(...) for roots. a/b without blanks is a fraction, whose numerator and denominator lose
the parentheses around them; with blanks it is one before a parenthesis. A letter with digits, V2, is an index; two blanks and more separate equations;
words of four letters and more are text. Browsers show MathML without a script.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import html
import re
import sys
import unicodedata

SUPER = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁽⁾ᵀˢⁿ", "0123456789+−()Tsn"))
SUB = dict(zip("₀₁₂₃₄₅₆₇₈₉₊₋", "0123456789+−"))
PRIMES = {"′": "′", "″": "″", "‴": "‴", "'": "′", "''": "″", "'''": "‴", "''''": "⁗"}
FUNCTIONS = set("sin cos tan sinh cosh tanh coth asinh exp log ln max min diag sqrt det Re Im sym conj".split())
GREEK = {"alpha": "α", "gamma": "γ", "mu": "μ", "rho": "ρ", "sigma": "σ", "tau": "τ", "theta": "θ", "Pi": "Π", "kappa": "κ"}
SIGNS = {"int": "∫"}
WORDS = set("a an or at of sum to and the for not is in on by out end next over both as it from".split()) - {"a"}
PAIRS = {"(": ")", "[": "]", "{": "}", "⟨": "⟩"}
OPERATORS = "=≠≤≥<>+−±∓·×/,;:.→←⊥∂∫Σ…|*?^_↔∞∈≈∝&\"%°~"
LETTER = r"[A-Za-zα-ωΑ-ΩϑℓħĀ-ſ\u00e0-\u00ff\u1e00-\u1eff][\u0300-\u036f]*"
TOKEN = re.compile("|".join((
    r"(?P<number>\d+(?:\.\d+)?(?:e[-−]?\d+)?|[½¼¾])", r"(?P<letters>(?:%s)+)" % LETTER, r"(?P<primes>[′″‴]+|'+)",
    r"(?P<sup>[%s]+)" % "".join(SUPER), r"(?P<sub>[%s]+)" % "".join(SUB), r"(?P<root>√)", r"(?P<blank> +)",
    r"(?P<relation><=|>=|\+=)", r"(?P<bracket>[()\[\]{}⟨⟩])", r"(?P<sign>[-%s])" % re.escape(OPERATORS))))
INDEX = re.compile(r"(?:%s|\d)+(?:[−+,-](?=[\w])(?:%s|\d)+)*" % (LETTER, LETTER))
POWER = re.compile(r"[−-]?(?:%s|[\d.]*\d|½)+" % LETTER)


class Node:
    """A piece of MathML; blank: after a blank; kind: atom, function, sign, text or group (inner: what its brackets enclose)."""

    def __init__(self, text, kind="atom", blank=False, inner=None):
        self.text, self.kind, self.blank, self.inner = text, kind, blank, inner


def element(name, text, **attributes):
    return "<%s%s>%s</%s>" % (name, "".join(' %s="%s"' % pair for pair in attributes.items()), text, name)


def row(nodes):
    parts = []
    for k, node in enumerate(nodes):
        if node.blank and k and nodes[k - 1].kind != "sign" and node.kind != "sign":
            parts.append('<mspace width="0.25em"></mspace>')
        parts.append(node.text)
    return parts[0] if len(parts) == 1 else element("mrow", "".join(parts))


def letters(run):
    """The nodes of a run of letters: a word, a name of several letters, or single letters."""
    if run in FUNCTIONS:
        return [Node(element("mi", run), "function")]
    if run in GREEK:
        return [Node(element("mi", GREEK[run]))]
    if run in SIGNS:
        return [Node(element("mo", SIGNS[run]), "sign")]
    plain = re.fullmatch("[A-Za-z]+", run)
    if run in WORDS or plain and len(run) > 3:
        return [Node(element("mtext", run), "text")]
    if plain and (len(run) == 3 or len(run) == 2 and run.isupper()):
        return [Node(element("mi", run))]
    return [Node(element("mi", letter)) for letter in re.findall(LETTER, run)]


def small(text):
    """An index or an exponent."""
    out = []
    for part in re.findall(r"%s|\d+(?:\.\d+)?|." % ("(?:%s)+" % LETTER), text):
        if re.match(LETTER, part):
            known = part in GREEK or not (len(part) > 2 and re.fullmatch("[a-z]+", part) and not re.fullmatch("[ijklmnh]+", part))
            out += [node.text for node in letters(part)] if known and len(part) < 3 or part in GREEK else \
                [element("mtext", part)] if not known else [element("mi", letter) for letter in re.findall(LETTER, part)]
        elif part[0].isdigit():
            out.append(element("mn", part))
        elif part != " ":
            out.append(element("mo", "−" if part == "-" else html.escape(part)))
    return out[0] if len(out) == 1 else element("mrow", "".join(out))


def closing(text, start):
    """Where the bracket at start closes, or None."""
    depth = 0
    for at in range(start, len(text)):
        depth += text[at] in PAIRS
        depth -= text[at] in ")]}⟩"
        if depth == 0:
            return at
    return None


class Reader:
    def __init__(self, text):
        self.text, self.at, self.nodes, self.blank = text, 0, [], False

    def add(self, node):
        node.blank, self.blank = self.blank, False
        self.nodes.append(node)

    def attach(self, name, what):
        """An index or exponent of the last node; of an index with an exponent both."""
        if not self.nodes or self.nodes[-1].kind == "sign" and "∫" not in self.nodes[-1].text and "Σ" not in self.nodes[-1].text:
            self.add(Node(what))
            return
        last = self.nodes[-1]
        before = re.fullmatch(r"<(msub|msup)>(.*)</\1>", last.text, re.S)
        parts = getattr(last, "parts", None)
        if before and parts and parts[0] != name:
            low, high = (parts[2], what) if name == "msup" else (what, parts[2])
            last.text = element("msubsup", parts[1] + low + high)
        elif parts and parts[0] == name:
            last.text = element(name, parts[1] + element("mrow", parts[2] + what))
        else:
            last.parts = (name, last.text, what)
            last.text = element(name, last.text + what)
        last.kind = last.kind if last.kind in ("function", "sign") else "atom"
        last.inner = None

    def group(self, start):
        """The nodes between the brackets at start, or None where they do not close on this line."""
        end = closing(self.text, start)
        if end is None:
            return None
        self.at = end + 1
        return read(self.text[start + 1:end])

    def script(self, name, pattern):
        """What follows _ or ^."""
        if self.at < len(self.text) and self.text[self.at] in "({":
            inner = self.group(self.at)
            if inner is not None:
                self.attach(name, row(inner) if inner else "<mrow></mrow>")
                return
        hit = pattern.match(self.text, self.at)
        if not hit:
            raise ValueError("nothing behind %s" % self.text[self.at - 1:self.at + 6])
        self.at = hit.end()
        self.attach(name, small(hit[0]))

    def bracket(self, sign):
        start = self.at - 1
        inner = self.group(start) if sign in PAIRS else None
        if inner is None:
            self.add(Node(element("mo", sign, stretchy="false"), "sign"))
            return
        inside = row(inner) if inner else ""
        self.add(Node(element("mrow", element("mo", sign) + inside + element("mo", PAIRS[sign])), "group", inner=inside))

    def root(self):
        if self.text[self.at:self.at + 1] == "(":
            self.add(Node(element("msqrt", row(self.group(self.at)))))
            return
        blank, self.blank, mark = self.blank, False, len(self.nodes)
        hit = re.compile(r"(?:%s|\d+)(?:_(?:%s|\d)+)?" % (LETTER, LETTER)).match(self.text, self.at)
        self.at = hit.end()
        self.nodes[mark:] = [Node(element("msqrt", row(read(hit[0]))), blank=blank)]

    def bars(self):
        """|...| as one group, where a second bar is on this level."""
        depth = 0
        for at in range(self.at, len(self.text)):
            depth += self.text[at] in PAIRS
            depth -= self.text[at] in ")]}⟩"
            if depth < 0:
                break
            if depth == 0 and self.text[at] == "|":
                inner = row(read(self.text[self.at:at]))
                self.at = at + 1
                bar = element("mo", "|", stretchy="true")
                self.add(Node(element("mrow", bar + inner + bar)))
                return
        self.add(Node(element("mo", "|"), "sign"))

    def sign(self, text):
        if text == "*" and self.nodes and not self.blank:
            self.attach("msup", element("mo", "*"))
        elif text == "_":
            self.script("msub", INDEX)
        elif text == "^":
            self.script("msup", POWER)
        elif text == "|":
            self.bars()
        elif text == "∂":
            self.add(Node(element("mi", "∂")))
        else:
            self.add(Node(element("mo", "−" if text == "-" else html.escape(text)), "sign"))

    def token(self, kind, text):
        if kind == "number":
            last = self.nodes[-1] if self.nodes else None
            if last and not self.blank and re.fullmatch("<mi>.*</mi>", last.text) and text.isdigit():
                self.attach("msub", element("mn", text))
            else:
                self.add(Node(element("mn", text)))
        elif kind == "letters":     # cosθ is cos and θ
            for part in re.findall("[A-Za-z]+(?![\u0300-\u036f])|%s" % LETTER, text):
                for node in letters(part):
                    self.add(node)
        elif kind == "primes":
            self.attach("msup", element("mo", PRIMES.get(text, text)))
        elif kind == "sup":
            self.attach("msup", small("".join(SUPER[sign] for sign in text)))
        elif kind == "sub":
            self.attach("msub", small("".join(SUB[sign] for sign in text)))
        elif kind == "blank":
            self.blank = True
            if len(text) > 1 and self.nodes:
                self.add(Node('<mspace width="%s"></mspace>' % ("2em" if len(text) > 2 else "1em"), "sign"))
                self.blank = False
        elif kind == "relation":
            self.add(Node(element("mo", {"<=": "≤", ">=": "≥", "+=": "+="}[text]), "sign"))
        elif kind == "bracket":
            self.bracket(text)
        elif kind == "root":
            self.root()
        else:
            self.sign(text)

    def run(self):
        while self.at < len(self.text):
            hit = TOKEN.match(self.text, self.at)
            if not hit:
                raise ValueError("the sign %s is not known" % self.text[self.at])
            self.at = hit.end()
            self.token(hit.lastgroup, hit[0])
        return fractions(applied(self.nodes))


def applied(nodes):
    """Functions with what they are of: sinh a, cos 2Ωt, log|ab|."""
    out, k = [], 0
    while k < len(nodes):
        node, k = nodes[k], k + 1
        if node.kind != "function":
            out.append(node)
            continue
        argument = []
        while k < len(nodes) and nodes[k].kind in ("atom", "group") and (not argument or not nodes[k].blank and
                                                                        argument[-1].kind != "group"):
            argument.append(nodes[k])
            k += 1
        if argument and "<mi>sqrt</mi>" == node.text and argument[0].inner is not None:
            out.append(Node(element("msqrt", argument[0].inner), "atom", node.blank))
            out += argument[1:]
            continue
        gap = '<mspace width="0.17em"></mspace>' if argument and argument[0].blank else ""
        out.append(Node(element("mrow", node.text + "<mo>&#8289;</mo>" + gap + "".join(each.text for each in argument)), "atom",
                        node.blank))
    return out


def bare(nodes):
    """The MathML of a numerator or denominator, without brackets around all of it."""
    return nodes[0].inner if len(nodes) == 1 and nodes[0].inner else row(nodes)


def fractions(nodes):
    out, k = [], 0
    while k < len(nodes):
        node, k = nodes[k], k + 1
        over = node.text == "<mo>/</mo>" and out and k < len(nodes) and node.blank == nodes[k].blank
        if not over or node.blank and nodes[k].kind != "group" or out[-1].kind not in ("atom", "group") or nodes[k].kind not in ("atom", "group"):
            out.append(node)
            continue
        above = [out.pop()]
        while out and out[-1].kind in ("atom", "group") and not above[0].blank:
            above.insert(0, out.pop())
        below = [nodes[k]]
        nodes[k].blank = False
        k += 1
        while k < len(nodes) and nodes[k].kind in ("atom", "group") and not nodes[k].blank and below[-1].kind != "group":
            below.append(nodes[k])
            k += 1
        blank, above[0].blank = above[0].blank, False
        out.append(Node(element("mfrac", bare(above) + bare(below)), "atom", blank))
    return out


def read(text):
    return Reader(text.strip()).run()


def columns(line):
    """The two sides of a line at its first relation outside brackets."""
    depth = 0
    for at, sign in enumerate(line):
        depth += sign in PAIRS
        depth -= sign in ")]}⟩"
        if depth == 0 and sign in "=≤" and line[at - 1:at] not in ("<", ">", "+", ""):
            return line[:at].strip(), line[at:]
    return "", line


def mathml(lines):
    """A block of equations, one a line; several are aligned at their relations."""
    alt = html.escape(" ; ".join(" ".join(line.split()) for line in lines), quote=True)
    if len(lines) == 1:
        inside = row(read(unicodedata.normalize("NFC", lines[0])))
    else:
        rows = []
        for line in lines:
            left, right = columns(unicodedata.normalize("NFC", line))
            cells = [row(read(part)) if part.strip() else "" for part in (left, right)]
            rows.append(element("mtr", element("mtd", cells[0], style="text-align: right") +
                                element("mtd", cells[1], style="text-align: left")))
        inside = element("mtable", "".join(rows))
    return '<div class="equation"><math displaystyle="true" alttext="%s">%s</math></div>' % (alt, inside)


BLOCK = re.compile(r"^```eq\n(.*?)\n```$", re.M | re.S)


def replaced(text):
    """A document with MathML in the places of its equations."""
    return BLOCK.sub(lambda hit: "```{raw} html\n%s\n```" % mathml(hit[1].split("\n")), text)


def main():
    if sys.argv[1:2] == ["show"]:
        print(mathml(sys.argv[2:]))
        return
    for path in sys.argv[2:]:
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        for hit in BLOCK.finditer(text):
            try:
                mathml(hit[1].split("\n"))
            except ValueError as why:
                print("%s:%d: %s" % (path, text.count("\n", 0, hit.start()) + 2, why))


if __name__ == "__main__":
    main()
