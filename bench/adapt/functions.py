# SPDX-License-Identifier: MIT
"""Functions on [-1,1]^2 that solvers' solutions look like, with their exact Hessians.

Values carry two derivatives along (a Taylor polynomial of degree two in x and y), so that a
function is written once, as itself."""
import numpy as np


class Jet:
    """A value, its gradient and its Hessian, of arrays."""

    def __init__(self, v, x, y, xx, xy, yy):
        self.v, self.x, self.y, self.xx, self.xy, self.yy = v, x, y, xx, xy, yy

    @staticmethod
    def of(value):
        return value if isinstance(value, Jet) else Jet(value, 0.0, 0.0, 0.0, 0.0, 0.0)

    def __add__(self, other):
        o = Jet.of(other)
        return Jet(self.v + o.v, self.x + o.x, self.y + o.y, self.xx + o.xx, self.xy + o.xy,
                   self.yy + o.yy)

    def __mul__(self, other):
        o = Jet.of(other)
        return Jet(self.v * o.v, self.x * o.v + self.v * o.x, self.y * o.v + self.v * o.y,
                   self.xx * o.v + 2 * self.x * o.x + self.v * o.xx,
                   self.xy * o.v + self.x * o.y + self.y * o.x + self.v * o.xy,
                   self.yy * o.v + 2 * self.y * o.y + self.v * o.yy)

    def __neg__(self):
        return self * -1.0

    def __sub__(self, other):
        return self + (-Jet.of(other))

    def __rsub__(self, other):
        return Jet.of(other) - self

    __radd__ = __add__
    __rmul__ = __mul__

    def chain(self, f, first, second):
        """Returns f of this value, from f's value and first two derivatives there."""
        return Jet(f, first * self.x, first * self.y,
                   first * self.xx + second * self.x * self.x,
                   first * self.xy + second * self.x * self.y,
                   first * self.yy + second * self.y * self.y)


def sin(u):
    return u.chain(np.sin(u.v), np.cos(u.v), -np.sin(u.v))


def cos(u):
    return u.chain(np.cos(u.v), -np.sin(u.v), -np.cos(u.v))


def exp(u):
    return u.chain(np.exp(u.v), np.exp(u.v), np.exp(u.v))


def tanh(u):
    t = np.tanh(u.v)
    return u.chain(t, 1 - t * t, -2 * t * (1 - t * t))


def power(u, p):
    return u.chain(u.v**p, p * u.v**(p - 1), p * (p - 1) * u.v**(p - 2))


def atan2(y, x):
    """Returns the angle of (x, y), by the derivatives of atan2."""
    r2 = x.v**2 + y.v**2
    a, b = -y.v / r2, x.v / r2
    aa, ab = 2 * x.v * y.v / r2**2, (y.v**2 - x.v**2) / r2**2

    def second(p, q, r, s):
        # the quadratic form of the outer Hessian (aa, ab; ab, -aa) on (p, q) and (r, s)
        return aa * p * r + ab * (p * s + q * r) - aa * q * s

    return Jet(np.arctan2(y.v, x.v), a * x.x + b * y.x, a * x.y + b * y.y,
               a * x.xx + b * y.xx + second(x.x, y.x, x.x, y.x),
               a * x.xy + b * y.xy + second(x.x, y.x, x.y, y.y),
               a * x.yy + b * y.yy + second(x.y, y.y, x.y, y.y))


def _radius(x, y, softened):
    return power(x * x + y * y + softened**2, 0.5)


def _spiral(x, y):
    x, y = x - 0.013, y - 0.017
    r = _radius(x, y, 0.02)
    return tanh(8.0 * sin(atan2(y, x) - 9.0 * r) * r)


def _bl(x, y):
    return (1.0 - exp((y + 1.0) * -100.0)) * (1.0 + 0.2 * x + 0.1 * x * x)


FUNCTIONS = {
    # convex, two layers that meet in a corner
    "blconv": lambda x, y: exp((x + 1.0) * (-1 / 0.03)) + exp((y + 1.0) * (-1 / 0.03))
    + 0.05 * (x * x + y * y),
    "circle": lambda x, y: tanh(20.0 * (x * x + y * y - 0.5)),
    "shock": lambda x, y: tanh(5.0 * (2.0 * x - sin(5.0 * y))),
    "tanhp": lambda x, y: tanh(50.0 * (x - y * y)),
    # a straight boundary layer, as refine's bl has it
    "bl": _bl,
    "crossing": lambda x, y: tanh(50.0 * (x - 0.3 * y + 0.05)) + tanh(50.0 * (y + 0.4 * x - 0.1)),
    "spiral": _spiral,
    # fine waves on coarse ones, and a curved front
    "waves": lambda x, y: 0.1 * sin(50.0 * x) * cos(3.0 * y) + tanh(20.0 * (sin(5.0 * y) - 2.0 * x)),
    # singular in a point: the gradient is not bounded there
    "corner": lambda x, y: power((x - 0.1) * (x - 0.1)
                                 + (y - 0.05) * (y - 0.05) + 1e-12, 1 / 3),
    # of aspect 400 beside a flat region
    "front": lambda x, y: tanh(60.0 * (y - 0.4 * sin(3.0 * x))) + 0.01 * x * x,
    # two rings that touch
    "rings": lambda x, y: tanh(30.0 * (_radius(x + 0.4, y, 1e-3) - 0.4))
    + tanh(30.0 * (_radius(x - 0.4, y, 1e-3) - 0.4)),
    # a saddle of waves with a fine, turning pulse
    "pulse": lambda x, y: sin(4.0 * x) * sin(4.0 * y)
    + exp((x - y * y * y + 0.2) * (x - y * y * y + 0.2) * -400.0),
}


def evaluate(name, points):
    """The jet at an n by 2 array of points."""
    one, zero = np.ones(len(points)), np.zeros(len(points))
    x = Jet(points[:, 0].copy(), one, zero, zero, zero, zero)
    y = Jet(points[:, 1].copy(), zero, one, zero, zero, zero)
    return FUNCTIONS[name](x, y)


def values(name, points):
    return evaluate(name, points).v


def hessians(name, points):
    """Returns the second derivatives at the points, as an array n by 2 by 2."""
    j = evaluate(name, points)
    return np.stack([np.stack([j.xx, j.xy], -1), np.stack([j.xy, j.yy], -1)], -2)
