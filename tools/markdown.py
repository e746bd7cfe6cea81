# SPDX-License-Identifier: MIT
"""The parts of a Markdown page that are checked: code blocks, links and headings."""

import re
from dataclasses import dataclass

_FENCE = re.compile(r"^( *)(```+)(\S*)[^`]*$")
_SOURCE = re.compile(r"^\s*<!--\s*(file|from|output):\s*(\S+)\s*-->\s*$")
_LINK = re.compile(r"\]\(<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\)|<(?:img|a)\b[^>]*?\b(?:src|href)=\"([^\"]+)\"")
_HEADING = re.compile(r"^#{1,6}\s+(.*?)\s*#*$")


@dataclass
class Block:
    """A fenced code block. `line` is that of its first line of code; `source` is the content of a comment directly above,
    <!-- file: PATH -->, <!-- from: PATH --> or <!-- output: PATH -->."""

    line: int
    language: str
    code: str
    source: tuple[str, str] | None


@dataclass
class Page:
    blocks: list[Block]
    links: list[tuple[int, str]]
    anchors: set[str]


def anchor_of(heading):
    """The URL fragment of a heading on web pages made from Markdown."""
    plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "")
    return re.sub(r"[^\w\- ]", "", plain.lower()).replace(" ", "-")


def read_page(text):
    page = Page([], [], set())
    fence, block, source = None, [], None
    for number, line in enumerate(text.splitlines(), 1):
        if fence:
            if line.strip() == fence[2]:
                indent = len(fence[1])
                code = "".join(code_line[indent:] + "\n" for code_line in block)
                page.blocks.append(Block(number - len(block), fence[3], code, source))
                fence, source = None, None
            else:
                block.append(line)
        elif opened := _FENCE.match(line):
            fence, block = opened, []
        else:
            page.links += [(number, match[1] or match[2]) for match in _LINK.finditer(re.sub(r"`[^`]*`", "", line))]
            if heading := _HEADING.match(line):
                page.anchors.add(anchor_of(heading[1]))
            marker = _SOURCE.match(line)
            source = (marker[1], marker[2]) if marker else source if not line.strip() else None
    return page
