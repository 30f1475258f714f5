"""serve.py: the checks in Python of a script of tests/cli, in processes forked from this one; starting Python for each takes
ten times as long. Standard input has two lines a check: the folder to run in, and the scratch folder, where check.py is and why
takes what it prints. The answer is a line with the status."""
# SPDX-License-Identifier: GPL-3.0-or-later
import csv  # these three are for the checks, which find them loaded
import json
import math
import os
import sys
import traceback


def check(folder, scratch):
    """Run check.py as the main program; returns its exit status."""
    path = os.path.join(scratch, "check.py")
    why = os.open(os.path.join(scratch, "why"), os.O_WRONLY | os.O_TRUNC)
    os.dup2(why, 1)
    os.dup2(why, 2)
    os.chdir(folder)
    sys.path.insert(0, scratch)
    sys.argv = [path]
    try:
        with open(path, encoding="utf-8") as text:
            exec(compile(text.read(), path, "exec"), {"__name__": "__main__"})
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else end.code is not None
    except BaseException:
        traceback.print_exc()
        return 1
    return 0


def main():
    """Answer until standard input ends."""
    requests = os.fdopen(os.dup(0), "rb", buffering=0)
    while True:
        words = [requests.readline().decode().rstrip("\n") for _ in range(2)]
        if not words[1]:
            return
        child = os.fork()
        if child == 0:
            status = 1
            try:
                status = int(check(*words))
                sys.stdout.flush()
            finally:
                os._exit(status)
        status = os.waitpid(child, 0)[1]
        os.write(1, b"%d\n" % (os.WEXITSTATUS(status) if os.WIFEXITED(status) else 128))


main()
