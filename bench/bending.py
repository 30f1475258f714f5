#!/usr/bin/env python3
# Errors of published formulas for a straight, clamped cable with bending stiffness, against the roots of
# the transcendental equation of the tensioned beam: the table of doc/theory-bending.md.
# SPDX-License-Identifier: GPL-3.0-or-later
from math import cos, cosh, pi, sin, sqrt, tanh


def exact(xi, n):
    """omega L sqrt(m/T): 2pq (1 - cos q cosh p) + (p^2 - q^2) sin q sinh p = 0 over cosh p."""
    def f(q):
        p = sqrt(q*q + xi*xi)
        return 2*p*q*(1/cosh(min(p, 700)) - cos(q)) + (p*p - q*q)*sin(q)*tanh(p)
    low, high = n*pi, (n + 0.5)*pi
    up = f(high) > 0
    for _ in range(100):
        middle = (low + high)/2
        low, high = (low, middle) if (f(middle) > 0) == up else (middle, high)
    return low*sqrt(low*low + xi*xi)/xi


def morse(xi, n):
    return n*pi*(1 + 2/xi + (4 + (n*pi)**2/2)/xi**2)


def pinned(xi, n):
    return n*pi*sqrt(1 + (n*pi/xi)**2)


def zui(xi):
    """Tension of the first mode over the true one."""
    f = exact(xi, 1)/(2*pi)
    c = 1/xi/f
    factor = (1 - 2.20*c - 0.550*c*c if xi >= 17 else 0.865 - 11.6*c*c if xi >= 6 else 0.828 - 10.5*c*c)
    return 4*f*f*factor


print("| ξ | ω₁ exact | string | pinned | Morse and Ingard | the same, n = 5 | T by Zui |")
print("| --- | --- | --- | --- | --- | --- | --- |")
for xi in (5, 10, 20, 50, 100, 200, 500, 1000):
    w = exact(xi, 1)
    print("| %d | %.9f | %+.1e | %+.1e | %+.1e | %+.1e | %+.1e |" % (
        xi, w/pi, pi/w - 1, pinned(xi, 1)/w - 1, morse(xi, 1)/w - 1,
        morse(xi, 5)/exact(xi, 5) - 1, zui(xi) - 1))
