#!/usr/bin/env python3
"""Writes statics-spans.tsv: equilibria of 200 spans computed with 60 digits from the plain formulas of
B (2.82)-(2.87) by nested bisection - no code, no formula and no method in common with src/statics.
Needs mpmath. SPDX-License-Identifier: GPL-3.0-or-later"""
import random
from mpmath import mp, mpf, asinh, sinh, sqrt, quad, inf

mp.dps = 60
g = mpf(9.81)


def zero(f, lo, hi):
    """Illinois' regula falsi with bisection wherever it is slow."""
    flo, fhi, side = f(lo), f(hi), 0
    for n in range(600):
        x = (lo*fhi - hi*flo)/(fhi - flo) if n % 4 else (lo + hi)/2
        fx = f(x)
        if fx == 0 or abs(hi - lo) < mpf(10)**-52*max(abs(lo), abs(hi)):
            return x
        if fx*fhi > 0:
            hi, fhi, flo, side = x, fx, flo/2 if side == 1 else flo, 1
        else:
            lo, flo, fhi, side = x, fx, fhi/2 if side == -1 else fhi, -1
    raise ArithmeticError('no zero')


def solve(EA, rho, d, h, H):
    EA, rho, d, h, H = map(mpf, (EA, rho, d, h, H))
    w = rho*g
    eps, delta, hs = (mpf(0) if EA == inf else H/EA), w*d/H, h/d
    root = lambda u: sqrt(1 + u*u)

    def end(eta):  # slope at B of the cable that leaves A with the slope eta and spans d
        f = lambda q: (q - asinh(eta)) + eps*(sinh(q) - eta) - delta
        p = asinh(eta)
        return sinh(zero(f, p, min(p + delta, asinh(eta + delta/eps)) if eps else p + delta))

    def miss(eta):
        u1 = end(eta)
        return (root(u1) - root(eta) + eps*(u1*u1 - eta*eta)/2)/delta - hs

    lo, hi = hs - 1, hs
    while miss(lo) > 0:
        lo = hs - 2*(hs - lo)
    eta = zero(miss, lo, hi)
    u1 = end(eta)
    assert abs(miss(eta)) < mpf(10)**-40*(1 + abs(hs)), miss(eta)
    l = (u1 - eta)/delta
    x = ((asinh(hs) - asinh(eta)) + eps*(hs - eta))/delta
    y = (root(hs) - root(eta) + eps*(hs*hs - eta*eta)/2)/delta
    stretched = l + eps*quad(lambda t: mp.cosh(t)**2/delta, [asinh(eta), asinh(u1)])
    k = 1 + hs*hs
    touches = min(1 + hs*eta, 1 + hs*u1) <= 0  # perpendicular to the chord
    mp.dps = 30
    Le = inf if touches else quad(lambda t: mp.cosh(t)/delta*k*mp.cosh(t)**2/(1 + hs*sinh(t))**2,
                                  mp.linspace(asinh(eta), asinh(u1), 9))
    mp.dps = 60
    irvine = 0 if touches else inf if eps == 0 else sqrt(delta**2/(k*eps*Le))
    source = inf if eps == 0 else sqrt(delta/eps*(u1/root(u1) - eta/root(eta)))
    return [H*root(eta), H*root(u1), H*eta, d*l, d*stretched, d*(hs*x - y), irvine, source]


def spans():
    random.seed(20260)
    log = lambda a, b: a*(b/a)**random.random()
    corners = [(EA, s, delta) for EA in (1e4, 1e14) for s in (-20.0, 0.0, 20.0)
               for delta in (1e-7, 20.0)]
    corners += [(float('inf'), s, delta) for s in (-20.0, 0.3, 0.0) for delta in (1e-7, 0.1, 20.0)]
    for n in range(200):
        if n < len(corners):
            EA, slope, delta = corners[n]
        else:
            EA = log(1e4, 1e14)
            slope = random.uniform(-20, 20) if n % 2 else random.choice((-1, 1))*log(1e-6, 2)
            delta = random.uniform(0.1, 20) if n % 3 == 0 else log(1e-7, 20)
        rho, d = log(0.01, 100), log(1, 3000)
        yield EA, rho, d, slope*d, rho*9.81*d/delta


print('# 60-digit equilibria, made by make-statics-spans.py; g = 9.81 m/s^2, SI units')
print('EA\trho\td\th\tH\tT0\tT1\tV0\tlength0\tlength\tsag\tirvine\tirvine_source')
for span in spans():
    print('\t'.join([repr(v) for v in span] + [mp.nstr(v, 20) for v in solve(*span)]), flush=True)
