"""How far pictures are from the integral along the rays (ray_integral.cpp), in decibels."""

import array
import hashlib
import math
import os
import subprocess

SIDE = 512
STRIDE = 2  # every second pixel of every second row


def reference(scene, program, volumes, folder):
    """The integral and the sum over slices of a scene: two arrays of four doubles a pixel. Kept in `folder`,
    by the program that made them."""
    with open(program, "rb") as file:
        digest = hashlib.sha256(file.read() + f"{scene} {STRIDE}".encode()).hexdigest()[:16]
    path = os.path.join(folder, f"integral-{scene.replace('/', '-')}-{digest}.f64")
    if not os.path.exists(path):
        part = path + ".part"
        subprocess.run([program, scene, volumes, str(STRIDE), part], check=True)
        os.replace(part, path)
    values = array.array("d")
    with open(path, "rb") as file:
        values.frombytes(file.read())
    half = len(values) // 2
    return values[:half], values[half:]


def picked_of(values):
    """Those pixels of a picture that the reference has, as (red, green, blue, alpha) after each other."""
    side = -(-SIDE // STRIDE)
    picked = array.array(values.typecode)
    for row in range(side):
        for column in range(side):
            start = 4 * (SIDE * STRIDE * row + STRIDE * column)
            picked.extend(values[start:start + 4])
    return picked


def read(path):
    values = array.array("f")
    with open(path, "rb") as file:
        values.frombytes(file.read())
    if len(values) != 4 * SIDE * SIDE:
        raise ValueError(f"{path}: {len(values)} numbers, expected {4 * SIDE * SIDE}")
    return picked_of(values)


def compare(picture, truth):
    """Peak signal-to-noise ratio of red, green and blue over the pixels whose true opacity is above 1/255, and
    the largest difference of any pixel."""
    total, count, largest = 0.0, 0, 0.0
    for i in range(0, len(truth), 4):
        differences = [picture[i + c] - truth[i + c] for c in range(3)]
        largest = max(largest, *(abs(d) for d in differences))
        if truth[i + 3] > 1 / 255:
            total += sum(d * d for d in differences)
            count += 3
    if count == 0:
        raise ValueError("the reference is empty")
    return (200.0 if total == 0 else min(200.0, -10 * math.log10(total / count))), largest
