# tests/checks/messages.py - the messages of all failures, out of the sources.
#   messages.py list [TREE]   each once, as the page doc/messages.md, which make writes into the build folder
#   messages.py wrong         those that break a rule of messages
#   messages.py unexplained   those of the program that have no row in doc/robustness.md
#   messages.py places        "file:line:last line:message" of each, for what looks whether it was provoked
# From the top of the source tree, or with its folder as the last argument.
# SPDX-License-Identifier: GPL-3.0-or-later
import glob
import os
import re
import sys

# Where the format stands among the arguments, and where the status, or which it is.
CALLS = {"hawser__fail": (3, 1), "hawser__fail_at": (5, 1), "hawser__reader_fail": (2, "HAWSER_ERR_SCENE"),
         "hawser__wrong": (1, "HAWSER_ERR_SCENE")}
HEAD = """# All messages

Every message of a failure, by status; … stands for what varies, and none is here twice. Each says what to do; those
that users meet are explained in [robustness.md](robustness.md). This page is made of the sources by `make`.
"""
LONGEST = 400
# What no message does. A message follows "hawser: ", or another text and a colon.
RULES = ((r"[.!]$", "ends without a full stop"), (r"  |^ | $", "has single blanks, and none at its ends"),
         (r"\w [,;:] ", "has no blank before a comma, semicolon or colon"),
         (r"^(?!Lyapunov|Omega)[A-Z][a-z]", "begins in lower case, unless with a name"),
         (r"(?i)\b(please|sorry|oops|illegal|fatal|bad|etc|e\.g|i\.e)\b", "says what happened in plain words"),
         (r"(?i)\b(we|our|my)\b", "is about the input, not about us"), (".{%d}" % (LONGEST + 1), "has at most %d characters" % LONGEST))


def without_comments(text):
    return re.sub(r'/\*.*?\*/', lambda hit: re.sub(r"[^\n]", " ", hit.group(0)), text, flags=re.S)


def arguments(text, start):
    """The arguments of a call whose parenthesis has just opened, and where it ends."""
    parts, depth, begin, at = [], 1, start, start
    while depth:
        if text[at] in "\"'":
            quote = text[at]
            at += 1
            while text[at] != quote:
                at += 2 if text[at] == "\\" else 1
        elif text[at] in "([{":
            depth += 1
        elif text[at] in ")]}":
            depth -= 1
        if not depth or (text[at] == "," and depth == 1):
            parts.append(text[begin:at])
            begin = at + 1
        at += 1
    return parts, at


def literals(text):
    """Literals of an expression, those joined that stand side by side."""
    found = []
    for group in re.findall(r'"(?:[^"\\]|\\.)*"(?:\s*(?:"(?:[^"\\]|\\.)*"|PRI\w+))*', text):
        joined = "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', group))
        found.append(joined.replace('\\"', '"').replace("\\n", " "))
    return found


def shown(text):
    text = re.sub(r"%[-+ #0]*[\d*]*(?:\.[\d*]+)?(?:hh|h|ll|l|z|j)?[diouxXeEfgGcsp]", "…", text)
    return re.sub(r"\s+", " ", text.replace("%%", "%")).strip()


def messages():
    """(file, line, last line, status, message) of each."""
    for name in sorted(glob.glob("src/**/*.[ch]", recursive=True)):
        text = without_comments(open(name, encoding="utf-8").read())
        for hit in re.finditer(r"\b(%s)\(" % "|".join(CALLS), text):
            parts, end = arguments(text, hit.end())
            where, status = CALLS[hit.group(1)]
            if len(parts) <= where or "..." in parts or parts[-1].strip() == "...":
                continue
            status = status if isinstance(status, str) else parts[status].strip()
            first, last = text.count("\n", 0, hit.start()) + 1, text.count("\n", 0, end) + 1
            for message in literals(parts[where]):
                if len(re.sub("[…:%s \\-]", "", shown(message))) > 3:
                    yield name, first, last, status, shown(message)


def listed():
    by_status = {}
    for _, _, _, status, message in messages():
        status = status if re.match(r"HAWSER_ERR_\w+$", status) else "Status of what failed"
        by_status.setdefault(status, set()).add(message)
    print(HEAD, end="")
    for status in sorted(by_status, key=lambda s: (not s.startswith("HAWSER"), s)):
        print("\n## %s\n" % status)
        for message in sorted(by_status[status]):
            print("- `%s`" % message.replace("`", "'"))


def wrong():
    seen = set()
    for name, line, _, _, message in messages():
        for pattern, rule in RULES:
            if re.search(pattern, message) and (message, rule) not in seen:
                seen.add((message, rule))
                print("%s:%d: a message %s: %s" % (name, line, rule, message))


def rows():
    table = open("doc/robustness.md", encoding="utf-8").read().partition("## Messages")[2]
    for row in re.findall(r"^\| `([^`]*)` \|", table, flags=re.M):
        yield [part.strip() for part in row.split("…") if len(part.strip()) > 4]


def unexplained():
    explained = [row for row in rows() if row]
    for name, line, _, _, message in messages():
        flat = message.replace("…", "")
        if name.startswith("src/cli/") and not any(
                all(part.replace("…", "") in flat or part in message for part in row)
                for row in explained):
            print("%s:%d: no row in doc/robustness.md: %s" % (name, line, message))


def places():
    for name, line, last, _, message in messages():
        print("%s:%d:%d:%s" % (name, line, last, message))


if len(sys.argv) > 2:
    os.chdir(sys.argv[2])
{"list": listed, "wrong": wrong, "unexplained": unexplained, "places": places}[sys.argv[1]]()
