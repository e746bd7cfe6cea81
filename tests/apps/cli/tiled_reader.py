# SPDX-License-Identifier: MIT
"""An independent reader of Tiled's XML maps, for comparison: which points the objects and the tiles of each layer
cover.

It maps a point of the screen back into the pixels in which each shape was drawn, as Tiled's documentation and
renderers place them, and tests it there. It does not use graze, creates no shapes and merges nothing."""

import base64
import gzip
import math
import pathlib
import xml.etree.ElementTree as ElementTree
import zlib


class Affine:
    """(x, y) -> (a x + c y + e, b x + d y + f)."""

    def __init__(self, a=1.0, b=0.0, c=0.0, d=1.0, e=0.0, f=0.0):
        self.a, self.b, self.c, self.d, self.e, self.f = a, b, c, d, e, f

    def __call__(self, point):
        x, y = point
        return self.a * x + self.c * y + self.e, self.b * x + self.d * y + self.f

    def __matmul__(self, inner):
        e, f = self((inner.e, inner.f))
        return Affine(self.a * inner.a + self.c * inner.b, self.b * inner.a + self.d * inner.b,
                      self.a * inner.c + self.c * inner.d, self.b * inner.c + self.d * inner.d, e, f)

    def inverse(self):
        det = self.a * self.d - self.b * self.c
        a, b, c, d = self.d / det, -self.b / det, -self.c / det, self.a / det
        return Affine(a, b, c, d, -(a * self.e + c * self.f), -(b * self.e + d * self.f))


def moved(x, y):
    return Affine(e=x, f=y)


def scaled(x, y):
    return Affine(a=x, d=y)


def turned(degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return Affine(c, s, -s, c)


def number(element, name, default=0.0):
    return default if element is None else float(element.get(name, default))


def winding(points, x, y):
    count = 0
    for (ax, ay), (bx, by) in zip(points, points[1:] + points[:1]):
        side = (bx - ax) * (y - ay) - (by - ay) * (x - ax)
        count += (ay <= y < by and side > 0) - (by <= y < ay and side < 0)
    return count


def covers_outline(element, width, height, x, y):
    """Whether an object without a tile covers a point, both in its own pixels."""
    polygon = element.find("polygon")
    if polygon is not None:
        points = [tuple(map(float, point.split(","))) for point in polygon.get("points").split()]
        return winding(points, x, y) != 0
    if element.find("ellipse") is not None:
        return width > 0 and height > 0 and ((2 * x / width - 1) ** 2 + (2 * y / height - 1) ** 2) <= 1
    if any(element.find(kind) is not None for kind in ("point", "polyline", "text")):
        return False  # no area
    return 0 <= x <= width and 0 <= y <= height


def grid_matrix(orientation, rows, width, height, skew=(0.0, 0.0)):
    """Maps the pixels of objects to the screen."""
    if orientation == "isometric":
        return moved(rows * width // 2, 0) @ Affine(width / 2 / height, 0.5, -width / 2 / height, 0.5)
    if orientation == "oblique":
        return Affine(b=skew[1] / width, c=skew[0] / height)
    return Affine()


def linear_part(matrix):
    return Affine(matrix.a, matrix.b, matrix.c, matrix.d)


class Tileset:
    def __init__(self, element, folder):
        self.first = int(element.get("firstgid", 1))
        if element.get("source"):
            path = folder / element.get("source")
            element = ElementTree.parse(path).getroot()
        self.size = number(element, "tilewidth"), number(element, "tileheight")
        offset = element.find("tileoffset")
        self.offset = number(offset, "x"), number(offset, "y")
        self.fills_grid = element.get("tilerendersize") == "grid"
        self.keeps_aspect = element.get("fillmode") == "preserve-aspect-fit"
        self.alignment = element.get("objectalignment", "unspecified")
        grid = element.find("grid")
        self.grid = None
        if grid is not None and grid.get("orientation") == "isometric":
            self.grid = number(grid, "width"), number(grid, "height")
        self.tiles = {int(tile.get("id")): tile for tile in element.findall("tile")}

    def size_of(self, tile):
        image = None if tile is None else tile.find("image")
        return self.size if image is None else (number(image, "width"), number(image, "height"))


def tile_of(gid, tilesets):
    tileset = [one for one in tilesets if one.first <= gid][-1]
    return tileset, tileset.tiles.get(gid - tileset.first)


class Map:
    def __init__(self, path):
        path = pathlib.Path(path)
        root = ElementTree.parse(path).getroot()
        self.orientation = root.get("orientation", "orthogonal")
        self.rows = int(root.get("height", 0))
        self.tile = int(root.get("tilewidth")), int(root.get("tileheight"))
        self.hex_side = int(root.get("hexsidelength", 0)) if self.orientation == "hexagonal" else 0
        self.staggers_x = root.get("staggeraxis") == "x"
        self.shifts_even = root.get("staggerindex") == "even"
        self.matrix = grid_matrix(self.orientation, self.rows, *self.tile, (number(root, "skewx"), number(root, "skewy")))
        self.tilesets = sorted((Tileset(one, path.parent) for one in root.findall("tileset")), key=lambda one: one.first)
        self.folder = path.parent
        self.covers = {}  # by layer: functions that say whether a point is covered
        self.read_layers(root, "", 0.0, 0.0)

    def read_layers(self, parent, path, x, y):
        for child in parent:
            name = path + child.get("name", "unnamed")
            shift = x + number(child, "offsetx"), y + number(child, "offsety")
            if child.tag == "group":
                self.read_layers(child, name + "/", *shift)
            elif child.tag == "objectgroup":
                for element in child.findall("object"):
                    self.covers.setdefault(name, []).append(self.object_cover(element, shift))
            elif child.tag == "layer":
                for column, row, gid in cells_of(child):
                    self.covers.setdefault(name, []).extend(self.cell_covers(column, row, gid, shift))

    def object_cover(self, element, shift):
        tilesets = self.tilesets
        if element.get("template"):
            path = self.folder / element.get("template")
            base = ElementTree.parse(path).getroot()
            if not element.get("gid") and base.find("tileset") is not None:
                tilesets = [Tileset(base.find("tileset"), path.parent)]
            merged = ElementTree.Element("object", {**base.find("object").attrib, **element.attrib})
            merged.extend([*element, *base.find("object")])
            element = merged
        width, height = number(element, "width"), number(element, "height")
        place = self.matrix((number(element, "x"), number(element, "y")))
        frame = moved(*shift) @ moved(*place) @ turned(number(element, "rotation"))
        gid = int(element.get("gid", 0)) & 0x0FFFFFFF
        if not gid:
            back = (frame @ linear_part(self.matrix)).inverse()
            return lambda point: covers_outline(element, width, height, *back(point))
        tileset, tile = tile_of(gid, tilesets)
        picture = tileset.size_of(tile)
        width, height = width or picture[0], height or picture[1]
        alignment = tileset.alignment
        if alignment == "unspecified":
            alignment = "bottom" if self.orientation == "isometric" else "bottomleft"
        left = -width * (0 if "left" in alignment else 1 if "right" in alignment else 0.5)
        top = -height * (0 if "top" in alignment else 1 if "bottom" in alignment else 0.5)
        left += tileset.offset[0] * width / picture[0]
        top += tileset.offset[1] * height / picture[1]
        back = frame.inverse()

        def covers(point):
            x, y = back(point)
            return left <= x <= left + width and top <= y <= top + height
        return covers

    def cell_place(self, column, row):
        """The bottom left corner of a cell on the screen."""
        width, height = self.tile
        if self.orientation == "isometric":
            return (column - row) * width / 2 + self.rows * width // 2 - width / 2, (column + row) * height / 2 + height
        if self.orientation in ("staggered", "hexagonal"):
            along_x, along_y = (self.hex_side, 0) if self.staggers_x else (0, self.hex_side)
            width, height = width & ~1, height & ~1
            slant_x, slant_y = (width - along_x) // 2, (height - along_y) // 2
            step_x, step_y = slant_x + along_x, slant_y + along_y
            odd = (column if self.staggers_x else row) % 2
            shifted = odd != self.shifts_even
            if self.staggers_x:
                x, y = column * step_x, row * height + (step_y if shifted else 0)
            else:
                x, y = column * width + (step_x if shifted else 0), row * step_y
            return x, y + height
        return self.matrix((column * width, (row + 1) * height))

    def cell_covers(self, column, row, gid, shift):
        tileset, tile = tile_of(gid & 0x0FFFFFFF, self.tilesets)
        if tile is None or tile.find("objectgroup") is None:
            return
        picture = tileset.size_of(tile)
        size = self.tile if tileset.fills_grid else picture
        grow = size[0] / picture[0], size[1] / picture[1]
        if tileset.keeps_aspect:
            grow = (min(grow),) * 2
        flip_x, flip_y, diagonal = gid >> 31 & 1, gid >> 30 & 1, gid >> 29 & 1
        # Relative to the center of the picture: scales and mirrors, then swaps the axes or rotates, then translates to
        # the cell.
        middle = scaled(*grow)
        width, height = size
        if self.orientation == "hexagonal":
            middle = turned(60 * diagonal + 120 * (gid >> 28 & 1)) @ scaled(-1 if flip_x else 1, -1 if flip_y else 1) @ middle
        else:
            if diagonal:
                middle = Affine(0, 1, 1, 0) @ middle
                width, height = height, width
            middle = scaled(-1 if flip_x else 1, -1 if flip_y else 1) @ middle
        x, y = self.cell_place(column, row)
        center = x + shift[0] + width / 2 + tileset.offset[0] * grow[0], y + shift[1] - height / 2 + tileset.offset[1] * grow[1]
        frame = moved(*center) @ middle @ moved(-picture[0] / 2, -picture[1] / 2)
        own = Affine()
        if tileset.grid:
            frame = frame @ moved(0, picture[1] - tileset.grid[1])
            own = grid_matrix("isometric", 1, *tileset.grid)
        for element in tile.find("objectgroup").findall("object"):
            place = own((number(element, "x"), number(element, "y")))
            back = (frame @ moved(*place) @ turned(number(element, "rotation")) @ linear_part(own)).inverse()
            wide, high = number(element, "width"), number(element, "height")
            yield lambda point, element=element, back=back, wide=wide, high=high: covers_outline(
                element, wide, high, *back(point))


def cells_of(layer):
    """Column, row and gid of each cell that is not empty."""
    data = layer.find("data")
    for part in data.findall("chunk") or [data]:
        sized = part if part.tag == "chunk" else layer
        width = int(sized.get("width"))
        for i, gid in enumerate(gids_of(part, data.get("encoding"), data.get("compression"))):
            if gid:
                yield int(sized.get("x", 0)) + i % width, int(sized.get("y", 0)) + i // width, gid


def gids_of(part, encoding, compression):
    if encoding is None:
        return [int(tile.get("gid", 0)) for tile in part.findall("tile")]
    if encoding == "csv":
        return [int(gid) for gid in part.text.split(",")]
    packed = base64.b64decode(part.text)
    plain = {None: bytes, "zlib": zlib.decompress, "gzip": gzip.decompress}[compression](packed)
    return [int.from_bytes(plain[i:i + 4], "little") for i in range(0, len(plain), 4)]
