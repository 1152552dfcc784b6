"""Photographs that others took (of Debian's packages), moved by known amounts or with a measured answer: the subset correlation
of fabric.lab.correlate beside OpenCV's.

    python3 photographs.py <source tree> [folder of photographs ...]

Needs python3-numpy, python3-scipy and python3-opencv, and photographs of python3-skimage and opencv-doc; what is not there is
named and skipped. FABRICSH names the program.

A photograph is moved by a spline of fifth order through its pixels, with four by four samples over each pixel of a picture of half
its size: no pixel of either picture is one of the original, and the correlation's own spline (of third order) makes neither.
"""
import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile

missing = [m for m in ("numpy", "scipy", "cv2") if importlib.util.find_spec(m) is None]
if missing:
    print("SKIPPED: Python has no", ", ".join(missing), "(python3-numpy, python3-scipy, python3-opencv): photographs of others were not tried")
    sys.exit(77)
import cv2
import numpy as np
from scipy import ndimage

tree = pathlib.Path(sys.argv[1]).resolve()
program = os.environ.get("FABRICSH", "fabricsh")
folders = [pathlib.Path(f) for f in sys.argv[2:]] + [
    pathlib.Path("/usr/lib/python3/dist-packages/skimage/data"), pathlib.Path("/usr/share/doc/opencv-doc/examples/data")]
work = pathlib.Path(tempfile.mkdtemp())
failed = []


def photograph(name):
    for folder in folders:
        if (folder / name).exists():
            return cv2.imread(str(folder / name), cv2.IMREAD_GRAYSCALE).astype(float)
    print("SKIPPED:", name, "of python3-skimage or opencv-doc is not in", ", ".join(map(str, folders)))
    return None


def seen(image, inverse, noise=0.0, seed=0):
    """The picture by a camera of half the pixels of a scene moved by a map; `inverse` leads from places of the picture to the scene's."""
    high, wide = image.shape[0] // 2, image.shape[1] // 2
    spline = ndimage.spline_filter(image, 5, mode="mirror")
    total = np.zeros((high, wide))
    row, column = np.mgrid[0:high, 0:wide].astype(float)
    for dy in (np.arange(4) - 1.5) / 4:
        for dx in (np.arange(4) - 1.5) / 4:
            x, y = inverse(column + dx, row + dy)
            total += ndimage.map_coordinates(spline, [2 * y + 0.5, 2 * x + 0.5], order=5, mode="mirror", prefilter=False)
    grey = total / 16 + noise * 255 * np.random.default_rng(seed).standard_normal(total.shape)
    return np.clip(np.rint(grey), 0, 255).astype(np.uint8)


def own(first, second, margin, search=20, subset=25):
    files = [work / "first.png", work / "second.png", work / "moved.csv"]
    cv2.imwrite(str(files[0]), first), cv2.imwrite(str(files[1]), second)
    high, wide = first.shape
    subprocess.run([program, "--quiet", str(tree / "tests/lab/others/displacements.lua"), *map(str, files), str(margin), str(wide - margin),
                    str(margin), str(high - margin), str(search), str(subset)], check=True)
    return np.genfromtxt(files[2], delimiter=",", names=True)


def lucas_kanade(first, second, x, y):
    points = np.stack([x, y], 1).astype(np.float32).reshape(-1, 1, 2)
    moved, status, _ = cv2.calcOpticalFlowPyrLK(first, second, points, None, winSize=(25, 25), maxLevel=4,
                                                criteria=(cv2.TERM_CRITERIA_EPS | cv2.TERM_CRITERIA_COUNT, 100, 1e-5))
    out = (moved - points).reshape(-1, 2).astype(float)
    out[status.ravel() == 0] = np.nan
    return out


def enhanced(first, second, x, y, start):
    """OpenCV's affine alignment by the correlation coefficient, of every seventh subset, from where Lucas and Kanade ended."""
    out = np.full((len(x), 2), np.nan)
    for i in range(0, len(x), 7):
        cx, cy = int(x[i]), int(y[i])
        if not np.isfinite(start[i]).all():
            continue
        pattern = first[cy - 12:cy + 13, cx - 12:cx + 13]
        left, top = (max(0, int(c + s) - 30) for c, s in ((cx, start[i, 0]), (cy, start[i, 1])))
        warp = np.array([[1, 0, cx - 12 - left + start[i, 0]], [0, 1, cy - 12 - top + start[i, 1]]], np.float32)
        try:
            _, warp = cv2.findTransformECC(pattern, second[top:top + 61, left:left + 61], warp, cv2.MOTION_AFFINE,
                                           (cv2.TERM_CRITERIA_EPS | cv2.TERM_CRITERIA_COUNT, 60, 1e-7), None, 1)
        except cv2.error:
            continue
        end = warp @ np.array([12, 12, 1])
        out[i] = end[0] + left - cx, end[1] + top - cy
    return out


def dense(first, second, x, y):
    flow = cv2.DISOpticalFlow_create(cv2.DISOPTICAL_FLOW_PRESET_MEDIUM)
    flow.setFinestScale(0)
    field = flow.calc(first, second, None)
    return field[y.astype(int), x.astype(int)].astype(float)


def rms(a):
    return float(np.sqrt(np.nanmean(np.square(a)))) if np.isfinite(a).any() else float("nan")


def expect(what, got, limit):
    if not got <= limit:
        failed.append(f"{what}: {got:.4g}, at most {limit:.4g} was expected")


def references(first, second, x, y):
    lk = lucas_kanade(first, second, x, y)
    return {"Lucas-Kanade": lk, "ECC": enhanced(first, second, x, y, lk), "DIS": dense(first, second, x, y)}


class Errors:
    """Of displacements, pixels, one axis, at the subsets that were found; beyond `far` a subset counts as lost."""

    def __init__(self, name, far=0.5):
        self.name, self.far, self.errors, self.told, self.found, self.of = name, far, {}, [], 0, 0

    def add(self, first, second, t, u, v):
        u, v = np.broadcast_to(u, t["x"].shape), np.broadcast_to(v, t["x"].shape)
        found = np.isfinite(t["u"])
        self.found, self.of = self.found + found.sum(), self.of + len(found)
        t, reference = t[found], np.stack([u, v], 1)[found]
        self.told.append(t["deviation"])
        for key, moved in {"own": np.stack([t["u"], t["v"]], 1), **references(first, second, t["x"], t["y"])}.items():
            e = moved - reference
            self.errors.setdefault(key, []).append(e[np.isfinite(e).all(1)])

    def rms(self, key):
        e = np.concatenate(self.errors[key])
        return rms(e[np.abs(e).max(1) < self.far])

    def lost(self, key="own"):
        e = np.concatenate(self.errors[key])
        return int((np.abs(e).max(1) >= self.far).sum())

    def tell(self):
        told = rms(np.concatenate(self.told))
        print(f"{self.name:32s} {self.found:4d} of {self.of:4d} |", ", ".join(
            f"{key} {self.rms(key):.4f}" + (f" ({self.lost(key)} lost)" if self.lost(key) else "") for key in self.errors),
            f"| own told {told:.4f}, largest {np.abs(np.concatenate(self.errors['own'])).max():.3f}", flush=True)
        return told


def still(x, y):
    return x, y


# Textures that fill the picture; a wall of bricks, smooth inside; a scene with a knit and a woven cloth.
TEXTURES, PHOTOGRAPHS = ("grass.png", "gravel.png"), ("grass.png", "gravel.png", "brick.png", "rubberwhale1.png")


def shifted(name, image):
    for noise in (0.0, 0.01):
        errors = Errors(f"{name}, shifts, noise {100 * noise:g} %")
        first = seen(image, still, noise, 1)
        for k in (1, 3, 5, 8):
            sx, sy = 0.1 * k, 3 - 0.07 * k
            second = seen(image, lambda x, y: (x - sx, y - sy), noise, 1 + k)
            t = own(first, second, 16)
            errors.add(first, second, t, sx, sy)
        told = errors.tell()
        # Where texture is poor a search for a shift alone, which this is, does better than one for an affine map: six numbers cost more
        # noise than two.
        expect(errors.name, errors.rms("own"), min(errors.rms("Lucas-Kanade"), errors.rms("ECC")) if name in TEXTURES else errors.rms("ECC"))
        expect(errors.name + ", over what is told", errors.rms("own") / told, 1.5)
        expect(errors.name + ", lost", errors.lost(), 0 if name in TEXTURES else 0.03 * errors.found)


def turned(name, image):
    first = seen(image, still)
    mx, my = (first.shape[1] - 1) / 2, (first.shape[0] - 1) / 2
    turn = np.deg2rad(5)
    F = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]) @ np.array([[1.05, 0.03], [0.0, 0.98]])
    B = np.linalg.inv(F)
    second = seen(image, lambda x, y: (mx + B[0, 0] * (x - mx) + B[0, 1] * (y - my), my + B[1, 0] * (x - mx) + B[1, 1] * (y - my)))
    t = own(first, second, 30)
    x, y = t["x"], t["y"]
    errors = Errors(name + ", turned and stretched")
    errors.add(first, second, t, mx + F[0, 0] * (x - mx) + F[0, 1] * (y - my) - x, my + F[1, 0] * (x - mx) + F[1, 1] * (y - my) - y)
    errors.tell()
    C = (F.T @ F - np.eye(2)) / 2
    strain = np.stack([t["E11"] - C[0, 0], t["E22"] - C[1, 1], t["E12"] + C[0, 1]], 1)
    print(f"{'':32s} strains: rms {rms(strain):.1e}, largest {np.nanmax(np.abs(strain)):.1e}", flush=True)
    expect(errors.name, errors.rms("own"), 1.1 * errors.rms("ECC"))
    expect(errors.name + ", strains", rms(strain), 1e-3)


def waved(name, image):
    """Parts that differ within a subset: an affine map cannot follow them, and the error is what it leaves out."""
    wave = 2 * np.pi / 80
    first, second = seen(image, still), seen(image, lambda x, y: (x - np.sin(wave * y), y - np.sin(wave * x)))
    t = own(first, second, 16)
    x, y = t["x"], t["y"]
    X, Y = x.copy(), y.copy()
    for _ in range(60):
        X, Y = x + np.sin(wave * Y), y + np.sin(wave * X)
    errors = Errors(name + ", waves of 80 pixels")
    errors.add(first, second, t, X - x, Y - y)
    errors.tell()
    # Along a wave of height 1 the straight line that fits best in a square of side 2 h leaves 1 - sin(a)/a at its crest, a = 2 pi h/80.
    for half in (12, 6) if name in TEXTURES else (12,):
        if half == 6:
            t = own(first, second, 16, subset=13)
            x, y = t["x"], t["y"]
            X, Y = x.copy(), y.copy()
            for _ in range(60):
                X, Y = x + np.sin(wave * Y), y + np.sin(wave * X)
            errors = Errors(name + ", subsets of 13 pixels")
            errors.add(first, second, t, X - x, Y - y)
            errors.tell()
        a = wave * (half + 0.5)
        expect(errors.name, errors.rms("own"), 1.5 * (1 - np.sin(a) / a) / np.sqrt(2) + 0.02)


def stereo():
    """Two photographs of a plant before a cloth, from places apart; how far each pixel moved was measured by structured light
    (D. Scharstein, C. Pal, CVPR 2007), in whole pixels of the full size. A quarter of that size is correlated."""
    left, right, reference = photograph("aloeL.jpg"), photograph("aloeR.jpg"), photograph("aloeGT.png")
    if left is None or right is None or reference is None:
        return
    small = [cv2.resize(p, None, fx=0.25, fy=0.25, interpolation=cv2.INTER_AREA) for p in (left, right)]
    first, second = (np.rint(p).astype(np.uint8) for p in small)
    t = own(first, second, 16, search=70)
    x, y = t["x"], t["y"]
    u, keep = np.full(len(x), np.nan), np.zeros(len(x), bool)
    for i in np.flatnonzero(np.isfinite(t["u"])):
        part = reference[int(4 * y[i]) - 48:int(4 * y[i]) + 52, int(4 * x[i]) - 48:int(4 * x[i]) + 52]
        keep[i] = part.min() > 0 and np.ptp(part) <= 12  # no edge of a leaf within the subset
        middle = reference[int(4 * y[i]) - 2:int(4 * y[i]) + 6, int(4 * x[i]) - 2:int(4 * x[i]) + 6]
        u[i] = -middle.mean() / 4
    errors = Errors("aloe, two cameras", far=1.0)
    errors.add(first, second, t[keep], u[keep], np.zeros(keep.sum()))
    errors.tell()
    expect(errors.name, errors.rms("own"), 0.2)
    expect(errors.name + ", lost", errors.lost(), 0.05 * keep.sum())


tried = 0
if "--stereo" in sys.argv:
    PHOTOGRAPHS = ()
for name in PHOTOGRAPHS:
    image = photograph(name)
    if image is None:
        continue
    tried += 1
    shifted(name, image), turned(name, image), waved(name, image)
stereo()
if not tried:
    sys.exit(77)
for line in failed:
    print("FAILED:", line)
sys.exit(1 if failed else 0)
