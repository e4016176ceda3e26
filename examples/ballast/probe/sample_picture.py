"""A picture of spheres that belong to grains, whole and cut open, by a depth buffer: one pixel shows the nearest sphere."""

import numpy as np


def draw_sample(pebbles, plt):
    figure, both = plt.subplots(1, 2, figsize=(8.2, 6.0))
    for axes, cut, title in zip(both, (None, 0.0), ("From outside", "Cut open along the axis")):
        image, extent = render(pebbles, cut)
        axes.imshow(image, extent=extent, origin="lower", interpolation="lanczos")
        axes.set(title=title, xlabel="[mm]")
        axes.grid(False)
    return figure


def render(pebbles, cut, width=700):
    """Seen along y; what lies nearer than y = cut [m] is taken away."""
    x, y, z, radius = (pebbles[name] for name in ("x_m", "y_m", "z_m", "radius_m"))
    low = np.array((np.min(x - radius), np.min(z - radius))) - 2e-3
    high = np.array((np.max(x + radius), np.max(z + radius))) + 2e-3
    pixel = (high[0] - low[0]) / width
    height = int(np.ceil((high[1] - low[1]) / pixel))
    across = low[0] + (np.arange(width) + 0.5) * pixel
    up = low[1] + (np.arange(height) + 0.5) * pixel
    depth = np.full((height, width), np.inf)
    image = np.ones((height, width, 3))
    colours = colours_of(pebbles["grain"].astype(int))
    for i in range(len(x)):
        columns = slice(*np.searchsorted(across, (x[i] - radius[i], x[i] + radius[i])))
        lines = slice(*np.searchsorted(up, (z[i] - radius[i], z[i] + radius[i])))
        dx, dz = np.meshgrid((across[columns] - x[i]) / radius[i], (up[lines] - z[i]) / radius[i])
        inside = 1 - dx**2 - dz**2
        bulge = np.sqrt(np.maximum(inside, 0))
        front, back = y[i] - radius[i] * bulge, y[i] + radius[i] * bulge
        is_face = np.zeros_like(inside, dtype=bool)
        if cut is not None:
            is_face = (inside > 0) & (front < cut) & (back > cut)
            front = np.where(is_face, cut, front)
        visible = (inside > 0) & (front < depth[lines, columns]) & (cut is None or front >= cut)
        light = np.where(is_face, 0.55, 0.35 + 0.65 * np.maximum(0, -0.35 * dx + 0.75 * bulge + 0.55 * dz) / 1.0)
        depth[lines, columns] = np.where(visible, front, depth[lines, columns])
        image[lines, columns] = np.where(visible[..., None], np.clip(light, 0, 1)[..., None] * colours[i], image[lines, columns])
    extent = 1e3 * np.array((low[0], low[0] + width * pixel, low[1], low[1] + height * pixel))
    return image, extent


def colours_of(grain):
    """One muted colour per grain, the same in each run."""
    random = np.random.default_rng(7)
    palette = random.uniform(0.45, 1.0, (grain.max() + 1, 3))
    return palette[grain]
