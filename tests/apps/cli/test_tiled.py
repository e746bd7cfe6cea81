# SPDX-License-Identifier: MIT
"""Tiled's maps: graze's shapes cover what an independent reader says, and omissions are reported."""

import array
import base64
import gzip
import json
import pathlib
import random
import struct
import unittest
import zlib

from graze_program import CommandLineTest, with_memory_of

import tiled_reader

TILE_SHAPES = {
    0: '<object x="0" y="0" width="{w}" height="{h}"/>',
    1: '<object x="0" y="{half}" width="{w}" height="{half}"/>',
    2: '<object x="0" y="{h}"><polygon points="0,0 {w},0 {w},-{h}"/></object>',
    3: '<object x="2" y="3" width="6" height="4" rotation="30"/><object x="9" y="1" width="5" height="9"><ellipse/></object>',
    4: '<object x="1" y="1"><polygon points="0,0 12,9 12,0 0,9"/></object>',
}


def covers_shape(shape, x, y):
    """Whether a shape of graze's JSON covers a point; shapes without area cover none."""
    kind = shape["type"]
    if kind == "aabb":
        return all(low <= value <= high for low, value, high in zip(shape["min"], (x, y), shape["max"]))
    if kind == "obb":
        dx, dy = x - shape["center"][0], y - shape["center"][1]
        return all(abs(dx * axis[0] + dy * axis[1]) <= half for axis, half in zip(shape["axes"], shape["half_extents"]))
    if kind == "sphere":
        return (x - shape["center"][0]) ** 2 + (y - shape["center"][1]) ** 2 <= shape["radius"] ** 2
    if kind == "polytope":
        return tiled_reader.winding([tuple(point) for point in shape["points"]], x, y) != 0
    if kind == "compound":
        return any(covers_shape(part, x, y) for part in shape["parts"])
    return False


def packed_gids(gids, encoding, compression):
    """The <data> of a layer."""
    if encoding is None:
        return "<data>" + "".join(f'<tile gid="{gid}"/>' if gid else "<tile/>" for gid in gids) + "</data>"
    if encoding == "csv":
        return '<data encoding="csv">\n' + ",\n".join(map(str, gids)) + "\n</data>"
    plain = struct.pack(f"<{len(gids)}I", *gids)
    packed = {None: bytes, "zlib": zlib.compress, "gzip": gzip.compress}[compression](plain)
    attribute = f' compression="{compression}"' if compression else ""
    return f'<data encoding="base64"{attribute}>\n  {base64.b64encode(packed).decode()}\n</data>'


FORMATS = ((None, None), ("csv", None), ("base64", None), ("base64", "zlib"), ("base64", "gzip"))


def random_tileset(draw, first, size):
    w, h = size
    attributes = f'firstgid="{first}" name="t" tilewidth="{w}" tileheight="{h}" tilecount="8" columns="8"'
    if draw.random() < 0.3:
        attributes += ' tilerendersize="grid"'
        attributes += draw.choice(("", ' fillmode="preserve-aspect-fit"'))
    inner = f'<tileoffset x="{draw.randint(-5, 5)}" y="{draw.randint(-5, 5)}"/>' if draw.random() < 0.5 else ""
    if draw.random() < 0.3:
        inner += f'<grid orientation="isometric" width="{w}" height="{w // 2}"/>'
    inner += f'<image source="t.png" width="{8 * w}" height="{h}"/>'
    for number, text in TILE_SHAPES.items():
        inner += f'<tile id="{number}"><objectgroup>{text.format(w=w, h=h, half=h / 2)}</objectgroup></tile>'
    return f"<tileset {attributes}>{inner}</tileset>"


def random_map(draw, orientation):
    tile = draw.choice(((16, 16), (32, 16), (20, 12), (15, 11)))
    columns, rows = 6, 5
    attributes = f'orientation="{orientation}" width="{columns}" height="{rows}" tilewidth="{tile[0]}" tileheight="{tile[1]}"'
    if orientation in ("staggered", "hexagonal"):
        attributes += f' staggeraxis="{draw.choice("xy")}" staggerindex="{draw.choice(("odd", "even"))}"'
        attributes += f' hexsidelength="{draw.choice((4, 6, 7))}"'
    if orientation == "oblique":
        attributes += f' skewx="{draw.randint(-8, 8)}" skewy="{draw.randint(-4, 4)}"'
    text = f'<map version="1.10" {attributes}>' + random_tileset(draw, 1, tile) + random_tileset(draw, 9, (24, 20))
    flips = [0, 1 << 31, 1 << 30, 1 << 29, 3 << 30, 5 << 29, 3 << 29, 7 << 29]
    if orientation == "hexagonal":
        flips += [1 << 28, 3 << 28]
    for i in range(2):
        gids = [draw.choice((0, 1, 1, draw.randint(1, 16))) for _ in range(columns * rows)]
        gids = [gid | draw.choice(flips) if gid else 0 for gid in gids]
        offset = f'offsetx="{draw.randint(-9, 9)}" offsety="{draw.randint(-9, 9)}"'
        size = f'width="{columns}" height="{rows}"'
        text += f'<group name="g" {offset}><layer name="tiles{i}" {size} {offset}>'
        text += packed_gids(gids, *draw.choice(FORMATS)) + "</layer></group>"
    text += '<objectgroup name="things" offsetx="3">'
    for i in range(6):
        place = f'id="{i + 1}" x="{draw.randint(0, 90)}" y="{draw.randint(0, 90)}" rotation="{draw.choice((0, 0, 90, 33.5))}"'
        size = f'width="{draw.randint(1, 40)}" height="{draw.randint(1, 40)}"'
        text += draw.choice((f"<object {place} {size}/>", f'<object {place} {size} gid="{draw.randint(1, 16)}"/>',
                             f'<object {place} gid="{draw.randint(1, 16)}"/>', f"<object {place} {size}><ellipse/></object>",
                             f'<object {place}><polygon points="0,0 30,5 10,20 25,-8 3,17"/></object>'))
    return text + "</objectgroup></map>"


class TiledMaps(CommandLineTest):
    def compare(self, path, draw, samples):
        """Compares all layers at random points, except those too close to a boundary, and returns how many were
        covered."""
        expected = tiled_reader.Map(path)
        scene = json.loads(self.succeed("convert", path, "-")[0])
        layers = scene.get("layers") or ["layer 0"]
        found = {}
        for one in scene["objects"]:
            found.setdefault(one["layer"], []).append(one)
        compared = covered = 0
        for name, covers in expected.covers.items():
            for _ in range(samples):
                x, y = draw.uniform(-20, 150), draw.uniform(-20, 110)
                ring = [(x + dx, y + dy) for dx in (-0.05, 0, 0.05) for dy in (-0.05, 0, 0.05)]
                answers = {any(cover(point) for cover in covers) for point in ring}
                if len(answers) == 2:
                    continue
                answer = answers.pop()
                compared += 1
                covered += answer
                if answer != any(covers_shape(shape, x, y) for shape in found.get(name, [])):
                    self.fail(f"{name} of {path} at {x}, {y}: {answer} in\n{pathlib.Path(path).read_text()[:4000]}\n{layers}")
        return compared, covered

    def test_random_maps_cover_what_an_independent_reader_says(self):
        draw = random.Random(20261128)
        for orientation in ("orthogonal", "isometric", "staggered", "hexagonal", "oblique"):
            compared = covered = 0
            for _ in range(12):
                path = self.write("map.tmx", random_map(draw, orientation))
                more, of_them = self.compare(path, draw, 100)
                compared, covered = compared + more, covered + of_them
            with self.subTest(orientation):
                self.assertGreater(covered, 0.05 * compared)
                self.assertLess(covered, 0.9 * compared)


    def test_a_map_of_tiles_without_shapes_says_so(self):
        text = '<map tilewidth="8" tileheight="8"><tileset firstgid="1" tilewidth="8" tileheight="8" tilecount="4"/>' \
               '<layer name="sky" width="3" height="1"><data encoding="csv">1,0,2</data></layer></map>'
        _, said = self.succeed("check", self.write("sky.tmx", text))
        self.assertIn("not read: 2 x tile without collision shape", said)

    def packed_map(self, side, data, compression):
        text = '<map tilewidth="8" tileheight="8"><tileset firstgid="1" tilewidth="8" tileheight="8" tilecount="4">' \
               '<tile id="0"><objectgroup><object width="8" height="8"/></objectgroup></tile></tileset>' \
               f'<layer name="walls" width="{side}" height="{side}"><data encoding="base64" compression="{compression}">' \
               f"{base64.b64encode(data).decode()}</data></layer></map>"
        return self.write("packed.tmx", text)

    def test_a_bomb_is_unpacked_no_further_than_its_cells_need(self):
        bomb = zlib.compress(bytes(1 << 26))
        says = "the data unpacks to more than the 16 bytes that its cells need"
        self.refused("check", self.packed_map(2, bomb, "zlib"), says=says)
        self.refused("check", self.packed_map(2, gzip.compress(bytes(1 << 20)), "gzip"), says=says)
        self.refused("check", self.packed_map(65536, bomb, "zlib"), says="the most is 67108864")
        self.refused("check", self.packed_map(4096, bomb[:-9], "zlib"), says="is the file cut off?")

    def test_a_large_map_takes_little_memory(self):
        row = array.array("I", ([1] * 60 + [0] * 4) * 64)
        gids = (row + array.array("I", [0] * 4096)) * 2048
        path = self.packed_map(4096, zlib.compress(gids.tobytes(), 1), "zlib")
        scene = json.loads(self.succeed("info", "--format", "json", path, **with_memory_of(mebibytes=1024))[0])
        self.assertEqual(scene["objects"], 64 * 2048)

    def test_noise_takes_little_memory(self):
        draw = random.Random(20261128)
        gids = array.array("I", (byte & 1 for byte in draw.randbytes(2048 * 2048)))
        path = self.packed_map(2048, zlib.compress(gids.tobytes(), 1), "zlib")
        scene = json.loads(self.succeed("info", "--format", "json", path, **with_memory_of(mebibytes=512))[0])
        self.assertGreaterEqual(scene["objects"], 128 * 128)
        self.assertLess(scene["objects"], 128 * 128 + 100)


if __name__ == "__main__":
    unittest.main()
