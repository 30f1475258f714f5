#!/usr/bin/env python3
"""rod-waves.py: a rigid rod that a hinge at its foot holds, in still water and in regular waves, as one ordinary differential
equation of its angle. Airy's waves and Morison's equation are written here anew: nothing of hawser is used. It prints the
numbers of tests/reference/test-rod-water.c. SPDX-License-Identifier: GPL-3.0-or-later"""
import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

G, WATER = 9.81, 1025.0
LENGTH, DIAMETER, MASS, CD, CA, FOOT = 20.0, 0.8, 200.0, 1.0, 1.0, -60.0
NODES, WEIGHTS = np.polynomial.legendre.leggauss(40)
S, W = 0.5*LENGTH*(NODES + 1.0), 0.5*LENGTH*WEIGHTS
AREA = 0.25*np.pi*DIAMETER**2


class Waves:
    def __init__(self, height, period, depth, ramp):
        self.a, self.w, self.h, self.ramp = 0.5*height, 2.0*np.pi/period, depth, ramp
        self.k = brentq(lambda k: G*k*np.tanh(k*depth) - self.w**2, 1e-6, 10.0, xtol=1e-15)

    def at(self, x, y, t):
        """Velocities and their local rates, [x, y] each."""
        q = self.k*x - self.w*t
        c, s = (f(self.k*(y + self.h))/np.sinh(self.k*self.h) for f in (np.cosh, np.sinh))
        p = min(t/self.ramp, 1.0)
        grown, rate = p**3*(10.0 - 15.0*p + 6.0*p*p), 30.0*p*p*(1.0 - p)**2/self.ramp
        aw = self.a*self.w
        u, v = aw*c*np.cos(q), aw*s*np.sin(q)
        return (grown*np.array([u, v]),
                grown*np.array([aw*self.w*c*np.sin(q), -aw*self.w*s*np.cos(q)]) + rate*np.array([u, v]))


def motion(start, times, waves):
    """Angles from the vertical, towards x, at these times, from rest."""
    inertia = (MASS + CA*WATER*AREA)*LENGTH**3/3.0 + MASS*DIAMETER**2/16.0*LENGTH

    def rates(t, state):
        angle, speed = state
        across = np.array([np.cos(angle), -np.sin(angle)])
        u, du = waves.at(S*np.sin(angle), FOOT + S*np.cos(angle), t) if waves else (np.zeros((2, 1)),)*2
        r = across@u - speed*S
        load = 0.5*WATER*DIAMETER*CD*np.abs(r)*r + WATER*AREA*(1.0 + CA)*(across@du)
        moment = W@(load*S) + 0.5*LENGTH**2*(WATER*AREA - MASS)*G*across[1]
        return [speed, moment/inertia]

    result = solve_ivp(rates, (0.0, times[-1]), [start, 0.0], "DOP853", times, rtol=1e-11, atol=1e-13, max_step=0.05)
    return result.y[0]


print("still water, from 0.3 rad:", motion(0.3, [3.0, 7.0939], None))
sea = Waves(4.0, 9.0, 60.0, 9.0)
print("waves of 4 m, 9 s, depth 60 m, ramp 9 s, from upright:", motion(0.0, [10.0, 14.0, 18.0, 22.0, 26.0], sea))
