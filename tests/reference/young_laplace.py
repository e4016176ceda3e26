"""The liquid bridge between two equal spheres, exactly: the Young-Laplace equation of an axisymmetric bridge of given volume
and contact angle, on its stable branch. Lengths in R, forces in 2 pi R gamma; arrays of bridges are solved at once.

Along the meridian, s from the neck, p the suction in gamma/R, t the slope against the axis (Orr, Scriven & Rivas 1975):

    r cos t + p r^2/2 = F          the force through every cross-section is the same: the first integral
    (r^2)'' = 2 + 2 p F - p^2 r^2  from it and r' = sin t, so with r(0) = r0, r'(0) = 0:
    r^2 = r0^2 + 2 (1 + p r0) (1 - cos p s)/p^2

This holds for nodoids (p > 0), catenoids (p = 0), unduloids and cylinders (1 + p r0 = 0) without a case distinction. Height and
volume are integrals over s, by Gauss-Legendre. A bridge has three unknowns, the neck r0, the suction p and the half length of
the meridian; Newton's method solves contact angle, volume and gap for them, with derivatives by complex steps.
At fixed volume the gap has a largest value, the rupture gap: there the Jacobian is singular.
"""

import numpy as np

NODES, WEIGHTS = np.polynomial.legendre.leggauss(48)
NODES, WEIGHTS = (NODES + 1) / 2, WEIGHTS / 2


def versine(x):
    """(1 - cos x)/x^2 and sin(x)/x."""
    half = x / 2
    small = np.abs(half) < 1e-4
    safe = np.where(small, 1.0, half)
    sinc = np.where(small, 1 - half**2 / 6 + half**4 / 120, np.sin(safe) / safe)
    return sinc**2 / 2, sinc * np.cos(half)


def residuals(unknowns, angle):
    """(error of the contact angle, volume, gap) of r0, p, length."""
    r0, p, length = unknowns
    force = r0 + p * r0**2 / 2
    s = length[..., None] * NODES
    square = (r0**2)[..., None] + 2 * (1 + p * r0)[..., None] * versine(p[..., None] * s)[0] * s**2
    radius = np.sqrt(square)
    slope = (force[..., None] - p[..., None] * square / 2) / radius  # cos t
    height = length * (slope * WEIGHTS).sum(-1)
    volume = np.pi * length * (square * slope * WEIGHTS).sum(-1)

    one_minus_cos, sinc = versine(p * length)
    square = r0**2 + 2 * (1 + p * r0) * one_minus_cos * length**2
    radius = np.sqrt(square)
    steepness = (1 + p * r0) * sinc * length / radius  # sin t
    centre = np.sqrt(1 - square)  # cos of the filling angle
    cap = square / (1 + centre)  # 1 - cos
    off = steepness - (centre * np.cos(angle) - radius * np.sin(angle))
    return np.array([off, 2 * (volume - np.pi * cap**2 * (3 - cap) / 3), 2 * (height - cap)])


def jacobian(unknowns, angle):
    """Values, and derivatives[i][j] of residual i by unknown j."""
    step = 1e-30
    columns = []
    for j in range(3):
        moved = unknowns.astype(complex)
        moved[j] += 1j * step * np.abs(unknowns[0])
        columns.append(residuals(moved, angle).imag / (step * np.abs(unknowns[0])))
    return residuals(unknowns, angle), np.array(columns).transpose(1, 0, 2)


def newton(unknowns, angle, volume, third, value, steps=60):
    """Solved for contact angle, volume, and the gap (third = 2) or the neck (third = 0)."""
    unknowns = unknowns.copy()
    for _ in range(steps):
        now, slopes = jacobian(unknowns, angle)
        error = np.array([now[0], (now[1] - volume) / volume, (now[2] if third == 2 else unknowns[0]) - value])
        rows = slopes.copy()
        rows[1] /= volume
        if third == 0:
            rows[2] = np.array([np.ones_like(volume), np.zeros_like(volume), np.zeros_like(volume)])
        change = np.linalg.solve(rows.transpose(2, 0, 1), error.T[..., None])[..., 0].T
        # A step may not leave the region where a bridge exists.
        limit = np.minimum(1.0, 0.3 / np.maximum(1e-300, np.max(np.abs(change[[0, 2]] / unknowns[[0, 2]]), axis=0)))
        unknowns -= change * limit
        if np.max(np.abs(change[[0, 2]] / unknowns[[0, 2]])) < 1e-12:  # quadratic: the next step would be rounding
            break
    return unknowns, np.abs(error).max(0)


def surface_energy(unknowns, angle):
    """Of the liquid's surface less cos(angle) times the wetted area, in 2 pi gamma R^2; its derivative by the gap is the force."""
    r0, p, length = unknowns
    s = length[..., None] * NODES
    square = (r0**2)[..., None] + 2 * (1 + p * r0)[..., None] * versine(p[..., None] * s)[0] * s**2
    rim = r0**2 + 2 * (1 + p * r0) * versine(p * length)[0] * length**2
    return 2 * length * (np.sqrt(square) * WEIGHTS).sum(-1) - 2 * np.cos(angle) * rim / (1 + np.sqrt(1 - rim))


def force(unknowns):
    return unknowns[0] + unknowns[1] * unknowns[0] ** 2 / 2


def fold(unknowns, angle):
    """d gap / d neck at fixed contact angle and volume: zero at rupture."""
    _, d = jacobian(unknowns, angle)
    determinant = d[0, 1] * d[1, 2] - d[0, 2] * d[1, 1]
    by_p = -(d[0, 0] * d[1, 2] - d[0, 2] * d[1, 0]) / determinant
    by_length = -(d[0, 1] * d[1, 0] - d[0, 0] * d[1, 1]) / determinant
    return d[2, 0] + d[2, 1] * by_p + d[2, 2] * by_length


class Bridges:
    """Bridges of given contact angles [rad] and volumes, from touch to rupture."""

    def __init__(self, angle, volume):
        self.angle, self.volume = (np.array(x, dtype=float).ravel() for x in np.broadcast_arrays(angle, volume))
        self.touch = self.at_touch()
        self.walk()

    def at_touch(self):
        """At gap 0, by continuation from a thin bridge: suction 2 cos(angle)/height, of height r^2."""
        start = np.minimum(self.volume, 1e-6)
        neck = (2 * start / np.pi) ** 0.25
        bend = neck**2 / (2 * np.cos(self.angle))
        x = np.array([neck * (1 - neck / 3), 1 / bend, bend * (np.pi / 2 - self.angle - neck)])
        ratio = (self.volume / start) ** (1 / 24)
        for i in range(25):
            x, error = newton(x, self.angle, start * ratio**i, 2, 0.0)
        assert error.max() < 1e-12, error.max()
        return x

    def walk(self, factor=0.97):
        """Along the stable branch, by the neck, past the rupture; then the rupture itself."""
        path = [self.touch]
        x = self.touch
        while True:
            guess = x.copy()
            if len(path) > 1:
                guess = path[-1] + (path[-1] - path[-2]) * factor
            neck = path[-1][0] * factor
            x, error = newton(guess, self.angle, self.volume, 0, neck)
            assert error.max() < 1e-11, error.max()
            path.append(x)
            if (fold(x, self.angle) > 0).all():
                break
        self.path = np.array(path)
        signs = np.array([fold(x, self.angle) for x in path]) > 0
        first = signs.argmax(0)

        def pick(i):
            return self.path[i, :, np.arange(self.volume.size)].T

        # d gap / d neck is zero at rupture: by the secant method inside the bracket.
        low, high = pick(first), pick(first - 1)
        at_low, at_high = fold(low, self.angle), fold(high, self.angle)
        for _ in range(60):
            neck = (low[0] * at_high - high[0] * at_low) / (at_high - at_low)
            x, error = newton((low + high) / 2, self.angle, self.volume, 0, neck)
            now = fold(x, self.angle)
            upper = now > 0
            low, high = np.where(upper, x, low), np.where(upper, high, x)
            at_high = np.where(upper, at_high / 2, now)
            at_low = np.where(upper, now, at_low / 2)
            if np.abs(now).max() < 1e-11:
                break
        self.rupture, self.first = x, first
        assert error.max() < 1e-11 and np.abs(now).max() < 1e-9, (error.max(), np.abs(now).max())
        self.rupture_gap = residuals(x, self.angle)[2]
        self.gaps = np.array([residuals(x, self.angle)[2] for x in self.path])
        self.rupture_force, self.touch_force = force(x), force(self.touch)

    def at(self, gap):
        """The bridges at these gaps, one for each; at the rupture gap and beyond, those that rupture."""
        gap = np.broadcast_to(gap, self.volume.shape)
        gaps = self.gaps
        x = self.touch.copy()
        for i in range(self.volume.size):
            n = self.first[i]  # beyond it the branch is unstable
            known = np.append(gaps[:n, i], self.rupture_gap[i])
            # In sqrt(rupture gap - gap) the branch is smooth.
            room = np.sqrt(np.maximum(self.rupture_gap[i] - known, 0.0))[::-1]
            states = np.vstack([self.path[:n, :, i], self.rupture[:, i]])[::-1]
            wanted = np.sqrt(max(self.rupture_gap[i] - gap[i], 0.0))
            for j in range(3):
                x[j, i] = np.interp(wanted, room, states[:, j])
        at_rupture = gap >= self.rupture_gap
        safe = np.where(at_rupture, 0.5 * self.rupture_gap, gap)
        x = np.where(at_rupture, self.path[np.maximum(self.first // 2, 1), :, np.arange(gap.size)].T, x)
        x, error = newton(x, self.angle, self.volume, 2, safe)
        assert np.where(at_rupture, 0.0, error).max() < 1e-11
        return np.where(at_rupture, self.rupture, x)
