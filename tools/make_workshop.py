#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes data/workshop.json: a workshop of a few hundred shapes of every kind, in metres, z up.

The room spans x 0..16 and y 0..12, open towards +x and -y, the viewer's side in an isometric picture. Layers: stock does not
touch furniture or building, because resting on them is normal; tools touch everything; sensors touch everything that can be
carried. Run without arguments; the output is the same every time.
"""

import argparse
import json
import math
import random
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LAYERS = ["building", "furniture", "stock", "tools", "sensors"]
MASKS = {
    "building": ["tools"],
    "furniture": ["tools"],
    "stock": ["stock", "tools", "sensors"],
    "tools": None,
    "sensors": ["stock", "tools"],
}


def rounded(value):
    """Numbers rounded to a tenth of a millimetre, so that the file does not depend on the math library."""
    if isinstance(value, float):
        return round(value, 4) + 0.0
    if isinstance(value, (list, tuple)):
        return [rounded(item) for item in value]
    if isinstance(value, dict):
        return {key: rounded(item) for key, item in value.items()}
    return value


def box(low, high):
    return {"type": "aabb", "min": low, "max": high}


def obb(center, half_extents, axis=(0, 0, 1), angle=0.0):
    return {"type": "obb", "center": center, "half_extents": half_extents, "rotation": {"axis": axis, "angle": angle}}


def capsule(a, b, radius):
    return {"type": "capsule", "a": a, "b": b, "radius": radius}


def sphere(center, radius):
    return {"type": "sphere", "center": center, "radius": radius}


class Workshop:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.objects = []
        self.counts = {}
        self.taken = []  # (x, y, radius) of objects on the floor

    def add(self, layer, kind, shape):
        self.counts[kind] = self.counts.get(kind, 0) + 1
        entry = {"name": f"{kind} {self.counts[kind]}", **shape, "layer": layer}
        if MASKS[layer] is not None:
            entry["mask"] = MASKS[layer]
        self.objects.append(rounded(entry))

    def take(self, x, y, radius):
        self.taken.append((x, y, radius))

    def free_place(self, radius):
        """A free place on the floor."""
        while True:
            x, y = self.random.uniform(0.8, 15.2), self.random.uniform(0.8, 8.8)
            if all(math.hypot(x - a, y - b) > radius + r + 0.05 for a, b, r in self.taken):
                self.take(x, y, radius)
                return x, y

    def between(self, low, high):
        return self.random.uniform(low, high)


def add_building(shop):
    shop.add("building", "floor", {"type": "half_space", "normal": [0, 0, 1], "offset": 0})
    for low, high, bottom, top in [(0, 3, 0, 3.6), (3, 5, 0, 1.1), (3, 5, 2.6, 3.6), (5, 8, 0, 3.6), (8, 10, 0, 1.1),
                                   (8, 10, 2.6, 3.6), (10, 12, 0, 3.6)]:
        shop.add("building", "west wall", box([-0.25, low, bottom], [0, high, top]))
    for low, high, bottom, top in [(-0.25, 12, 0, 3.6), (12, 14, 2.4, 3.6), (14, 16, 0, 3.6)]:
        shop.add("building", "north wall", box([low, 12, bottom], [high, 12.25, top]))
    for x in range(0, 16, 2):  # a strip of roof over the north wall, in pairs of triangles
        near, far = [11.2, 3.6], [12.6, 4.3]
        corners = [[x, *near], [x + 2, *near], [x + 2, *far], [x, *far]]
        shop.add("building", "roof", {"type": "triangle", "a": corners[0], "b": corners[1], "c": corners[2]})
        shop.add("building", "roof", {"type": "triangle", "a": corners[0], "b": corners[2], "c": corners[3]})
    slope = math.degrees(math.atan2(0.7, 1.4))
    for x in range(1, 16, 2):
        shop.add("building", "rafter", obb([x, 11.9, 3.85], [0.06, 0.75, 0.05], (1, 0, 0), slope))
    for height in (3.0, 3.25):  # pipes along both walls, and down where they are used
        for start in range(0, 16, 4):
            shop.add("building", "pipe", capsule([start + 0.1, 11.85, height], [start + 3.9, 11.85, height], 0.07))
        for start in range(0, 12, 4):
            shop.add("building", "pipe", capsule([0.15, start + 0.1, height], [0.15, start + 3.7, height], 0.07))
    for y in (2.0, 6.5, 10.6):
        shop.add("building", "downpipe", capsule([0.15, y, 0.3], [0.15, y, 2.9], 0.05))


def add_shelves(shop):
    for left in (1.0, 4.2, 7.4):
        right, front, back = left + 2.6, 11.0, 11.7
        for x in (left, right - 0.06):
            for y in (front, back - 0.06):
                shop.add("furniture", "upright", box([x, y, 0], [x + 0.06, y + 0.06, 2.4]))
        for level in range(4):
            bottom = 0.2 + 0.6 * level
            shop.add("furniture", "shelf", box([left, front, bottom], [right, back, bottom + 0.04]))
            x = left + 0.12
            while True:
                width, depth, height = shop.between(0.2, 0.45), shop.between(0.3, 0.6), shop.between(0.15, 0.5)
                if x + width > right - 0.1:
                    break
                low = [x, front + 0.04, bottom + 0.04]
                shop.add("stock", "box", box(low, [x + width, low[1] + depth, low[2] + height]))
                gap = shop.random.random()
                x += width + (0.0 if gap < 0.12 else 0.05 + 0.2 * gap)  # one in eight touches its neighbour


def table(x, y, width, depth, height):
    legs = [box([px, py, 0], [px + 0.08, py + 0.08, height]) for px in (x, x + width - 0.08)
            for py in (y, y + depth - 0.08)]
    return {"type": "compound", "parts": [box([x, y, height], [x + width, y + depth, height + 0.06]), *legs]}


def chair(x, y, angle):
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    turned = lambda u, v, z: [x + c * u - s * v, y + s * u + c * v, z]
    legs = [capsule(turned(u, v, 0.03), turned(u, v, 0.43), 0.03) for u in (-0.19, 0.19) for v in (-0.19, 0.19)]
    seat = obb(turned(0, 0, 0.45), [0.23, 0.23, 0.03], angle=angle)
    back = obb(turned(-0.21, 0, 0.72), [0.025, 0.22, 0.24], angle=angle)
    return {"type": "compound", "parts": [seat, back, *legs]}


def hammer(x, y, z, angle):
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    handle = capsule([x, y, z + 0.03], [x + 0.3 * c, y + 0.3 * s, z + 0.03], 0.02)
    head = obb([x + 0.3 * c, y + 0.3 * s, z + 0.04], [0.035, 0.09, 0.035], angle=angle)
    return {"type": "compound", "parts": [handle, head]}


def add_furniture(shop):
    benches = [(3.0, 6.2), (6.6, 6.2), (10.2, 6.2), (3.0, 2.2), (6.6, 2.2), (10.2, 2.2)]
    for x, y in benches:
        shop.add("furniture", "bench", table(x, y, 2.2, 0.9, 0.85))
        for step in (0.3, 1.1, 1.9):
            shop.take(x + step, y + 0.45, 0.7)
        shop.add("furniture", "chair", chair(x + 0.6, y - 0.5, 90 + shop.between(-25, 25)))
        shop.take(x + 0.6, y - 0.5, 0.35)
        shop.add("tools", "hammer", hammer(x + 0.4, y + 0.3, 0.91 + shop.random.choice([0.0, 0.002]), shop.between(0, 90)))
        shop.add("tools", "ruler", obb([x + 1.4, y + 0.5, 0.925], [0.3, 0.02, 0.005], angle=shop.between(-40, 40)))
        shop.add("tools", "vice", box([x + 1.95, y + 0.1, 0.91], [x + 2.15, y + 0.35, 1.15]))
    for y in (0.6, 1.9, 7.4, 8.7):
        shop.add("furniture", "cabinet", box([0.05, y, 0], [0.6, y + 1.1, 1.1]))
        shop.take(0.3, y + 0.3, 0.5)
        shop.take(0.3, y + 0.8, 0.5)
    shop.add("furniture", "pallet", box([13.2, 9.4, 0], [15.4, 11.2, 0.14]))


def stone(shop, x, y, size):
    """Points on a flattened sphere, the lowest of them moved to the floor."""
    points = []
    for _ in range(14):
        height, turn = shop.between(-1, 1), shop.between(0, 2 * math.pi)
        ring = math.sqrt(1 - height * height)
        points.append([x + size * ring * math.cos(turn), y + size * ring * math.sin(turn), 0.7 * size * (1 + height)])
    lowest = min(point[2] for point in points)
    return {"type": "polytope", "points": [[px, py, pz - lowest] for px, py, pz in points]}


def add_stock(shop):
    for row in range(3):  # crates on the pallet, each layer turned a little against the one below, and one askew
        for column in range(4):
            x, y = 13.5 + 0.52 * column, 9.7 + 0.56 * row
            shop.add("stock", "crate", obb([x, y, 0.36], [0.22, 0.24, 0.22], angle=shop.between(-3, 3)))
            if (row + column) % 2 == 0:
                shop.add("stock", "crate", obb([x, y, 0.801], [0.22, 0.22, 0.22], angle=shop.between(-12, 12)))
    shop.add("stock", "crate", obb([13.6, 8.6, 0.34], [0.3, 0.3, 0.2], (1, 0.4, 0.2), 24))
    shop.take(13.6, 8.6, 0.6)
    for step in range(10):
        x, y = 11.0 + 0.62 * (step % 2) + 0.05 * step, 9.3 + 0.4 * (step // 2)
        shop.add("stock", "barrel", capsule([x, y, 0.2], [x, y, 0.75], 0.18))
    for step in range(26):
        turn, reach = 2.4 * step, 0.42 * math.sqrt(step)
        x, y = 14.0 + 0.62 * reach * math.cos(turn), 1.7 + 0.62 * reach * math.sin(turn)
        shop.add("stock", "stone", stone(shop, x, y, shop.between(0.12, 0.2)))
    shop.take(14.0, 1.7, 1.7)


def add_tools(shop):
    for step in range(9):  # planks against the west wall: base on the floor, upper edge on the wall
        y, lean = 3.15 + 0.2 * step, math.radians(shop.between(10, 18))
        length, thickness = shop.between(1.6, 2.2), 0.03
        c, s = math.cos(lean), math.sin(lean)
        center = [thickness * c + length / 2 * s, y, length / 2 * c + thickness * s]
        shop.add("tools", "plank", obb(center, [thickness, 0.07, length / 2], (0, 1, 0), -math.degrees(lean)))
    for step in range(34):
        radius = shop.between(0.08, 0.3)
        x, y = shop.free_place(radius)
        height = rounded(radius) + (0.0 if step % 3 == 0 else 0.004)  # a third of them touch the floor
        shop.add("tools", "ball", sphere([x, y, height], rounded(radius)))
    for _ in range(12):
        x, y = shop.free_place(0.5)
        turn = shop.between(0, math.pi)
        dx, dy = 0.4 * math.cos(turn), 0.4 * math.sin(turn)
        shop.add("tools", "rod", capsule([x - dx, y - dy, 0.05], [x + dx, y + dy, 0.05], 0.04))
    for _ in range(8):
        x, y = shop.free_place(0.35)
        base = [[x - 0.25, y - 0.15, 0.01], [x + 0.25, y - 0.15, 0.01], [x + 0.25, y + 0.15, 0.01],
                [x - 0.25, y + 0.15, 0.01]]
        shop.add("tools", "wedge", {"type": "polytope", "points": [*base, [x + 0.25, y, 0.3]]})
    for _ in range(6):
        x, y = shop.free_place(0.4)
        shop.add("tools", "set square", {"type": "triangle", "a": [x, y, 0.02], "b": [x + 0.35, y + 0.05, 0.02],
                                         "c": [x, y + 0.3, 0.02]})
    for x, y in ((2.2, 5.1), (9.4, 4.9), (12.6, 5.2)):  # three spheres that overlap another
        shop.add("tools", "spill", sphere([x, y, 0.15], 0.15))
        shop.add("tools", "spill", sphere([x + 0.2, y, 0.16], 0.12))


def add_sensors(shop):
    for step in range(8):
        y, height = 0.5 + 1.2 * step, 0.2 if step % 3 == 0 else 1.5
        shop.add("sensors", "beam", {"type": "ray", "origin": [0.02, y, height], "direction": [1, 0, 0]})
    for step in range(8):
        x = 1.4 + 1.9 * step
        shop.add("sensors", "barrier", {"type": "segment", "start": [x, 0.1, 0.35], "end": [x, 10.9, 0.35]})
    for step in range(20):
        x, y = shop.between(0.5, 15.5), shop.between(0.5, 10.5)
        shop.add("sensors", "probe", {"type": "point", "position": [x, y, shop.between(0.5, 3.0)]})
    for entry in [[15.6, 0, 1.2], [15.6, 12, 1.2]]:
        shop.add("sensors", "post", capsule([entry[0], entry[1], 0.06], entry, 0.06))
    shop.add("sensors", "gate", {"type": "plane", "normal": [1, 0, 0], "offset": 15.6})


def scene_text(objects):
    head = {"schema": "graze.scene/1", "dimension": 3, "layers": LAYERS}
    lines = ",\n".join(f"  {json.dumps(key)}: {json.dumps(value)}" for key, value in head.items())
    rows = ",\n".join("    " + json.dumps(entry) for entry in objects)
    return f"{{\n{lines},\n  \"objects\": [\n{rows}\n  ]\n}}\n"


def make_workshop():
    shop = Workshop(seed=20)
    for add in (add_building, add_shelves, add_furniture, add_stock, add_tools, add_sensors):
        add(shop)
    return scene_text(shop.objects)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=Path, default=ROOT / "data" / "workshop.json", help="the output file")
    options = parser.parse_args()
    options.output.write_text(make_workshop(), encoding="utf-8")


if __name__ == "__main__":
    main()
