# SPDX-License-Identifier: MIT
"""Builds the documentation as one static site: the reference of the public headers, the guide, the cookbook and the viewer.

usage: python3 tools/make_site.py [--output build/site] [--viewer build/web/viewer]

The reference comes from the headers directly in a layer's folder and from EXPORTED, the pages from README.md, docs/ and the
other Markdown files that they link to. Each example has a page, to which the functions that it uses are linked. Every warning
of Doxygen is an error, and so is a public function that no example uses. Without a built viewer its pages are omitted.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from urllib.parse import unquote

from markdown import anchor_of
from project_files import ROOT, project_files
from site_examples import Examples

LAYERS = ["math", "shape", "query", "broad", "scene", "io", "distributed"]
# Headers in sub-folders that declare, outside namespace detail, what public headers re-export.
EXPORTED = ["broad/grid/cells.hpp", "broad/index/key_table.hpp", "broad/index/region.hpp", "broad/orthtree/place.hpp",
            "io/log/logged_answer.hpp", "io/log/logged_call.hpp", "io/log/query_log.hpp", "io/log/side_by_side.hpp",
            "query/bounding/box.hpp", "query/bounding/obb.hpp", "query/bounding/sphere.hpp", "query/patch/clipped.hpp",
            "shape/fields/defect.hpp", "shape/fields/transformed.hpp"]
THEME = Path("/usr/share/doxygen-awesome-css")
VIEWER = Path("viewer/index.html")
# The order of the guide in the site's navigation.
GUIDE = ["docs/cookbook/README.md", "docs/cli.md", "docs/scene_format.md", "docs/tiled.md", "docs/mesh_formats.md",
         "docs/query_log.md", "docs/viewer.md", "docs/web.md", "docs/python.md", "docs/c.md", "docs/packages.md",
         "docs/platforms.md", "docs/distributed.md",
         "docs/accuracy.md", "docs/performance.md", "docs/benchmarks.md", "docs/benchmarks_engines.md",
         "docs/architecture.md"]

_FENCE = re.compile(r"^ *```")
_HEADING = re.compile(r"^(#{1,6})\s+(.*?)\s*#*$")
_LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(<?([^)\s>]+)>?\)")


def label_of(path, fragment=""):
    """The name that Doxygen uses for a page or one of its headings."""
    label = re.sub(r"\W+", "_", str(path.with_suffix(""))).lower()
    return f"{label}-{fragment}" if fragment else label


class Site:
    def __init__(self, root, output, viewer):
        self.root, self.output, self.viewer = root, output, viewer
        self.source = output.parent / "site-source"
        self.pages = {path for path in project_files(root, [".md"]) if path.parts[0] in ("docs", "bindings") or len(path.parts) == 1}
        self.headers = [Path("graze/graze.hpp"), *(path for path in project_files(root, [".hpp"]) if len(path.parts) == 3
                                                   and path.parts[0] == "graze" and path.parts[1] in LAYERS),
                        *(Path("graze", name) for name in EXPORTED)]
        self.examples = Examples(root, project_files(root, [".cpp"]))
        self.children = set()
        self.copies = set()  # linked files that are not pages: copied unchanged

    def link(self, page, is_picture, text, target):
        """A Markdown link of the page, converted for the site."""
        if re.match(r"[a-z][a-z+.-]*:", target):
            return f"{'!' if is_picture else ''}[{text}]({target})"
        name, _, fragment = target.partition("#")
        place = Path(os.path.normpath(page.parent / unquote(name))) if name else page
        if place == VIEWER:
            return f'<a href="viewer/#{fragment}">{text}</a>' if self.viewer else text
        if place in self.pages:
            if page.name == "README.md" and place.parent == page.parent != Path() and place not in self.children:
                self.children.add(place)  # the navigation shows it below this page
                return f'@subpage {label_of(place)} "{text}"'
            return f"[{text}](@ref {label_of(place, fragment)})"
        if (self.root / place).is_dir():
            return text
        self.copies.add(place)
        return f'<img src="files/{place}" alt="{text}"/>' if is_picture else f'<a href="files/{place}">{text}</a>'

    def page(self, path):
        """The text of a page for Doxygen: headings with labels, and links converted to targets within the site."""
        lines, in_code, is_first = [], False, True
        for line in (self.root / path).read_text(encoding="utf-8").splitlines():
            if _FENCE.match(line):
                in_code = not in_code
            elif not in_code and re.match(r"\s*<!--.*-->\s*$", line):
                continue
            elif not in_code and (heading := _HEADING.match(line)):
                anchor = "" if is_first else anchor_of(heading[2])
                line, is_first = f"{heading[1]} {heading[2]} {{#{label_of(path, anchor)}}}", False
            elif not in_code:
                line = _LINK.sub(lambda match: self.link(path, match[1] == "!", match[2], match[3]), line)
            lines.append(line)
        return "\n".join(lines) + "\n"

    def write_sources(self):
        shutil.rmtree(self.source, ignore_errors=True)
        for path in self.pages:
            target = self.source / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(self.page(path), encoding="utf-8")

    def recipe_label(self, example):
        """The page of the cookbook that explains an example, if there is one."""
        page = Path("docs/cookbook") / f"{example.stem}.md"
        return label_of(page) if example.parts[1] == "cookbook" and page in self.pages else None

    def configuration(self):
        first = [Path(name) for name in ["README.md", *GUIDE]]
        pages = [self.source / path for path in [*first, *sorted(self.pages - set(first))]]
        settings = {
            "INPUT": [*pages, self.root / "docs/site/namespaces.dox", self.source / "examples.dox",
                      *(self.root / header for header in self.headers)],
            "USE_MDFILE_AS_MAINPAGE": [self.source / "README.md"],
            "STRIP_FROM_PATH": [self.source, self.root],
            "STRIP_FROM_INC_PATH": [self.root],
            "EXAMPLE_PATH": [self.root / "examples"],
            "XML_OUTPUT": [self.source / "xml"],
            "OUTPUT_DIRECTORY": [self.output.parent],
            "HTML_OUTPUT": [self.output.name],
            "HTML_EXTRA_STYLESHEET": [THEME / "doxygen-awesome.css", THEME / "doxygen-awesome-sidebar-only.css",
                                      THEME / "doxygen-awesome-sidebar-only-darkmode-toggle.css", self.root / "docs/site/site.css"],
            "HTML_EXTRA_FILES": [THEME / "doxygen-awesome-darkmode-toggle.js"],
            "HTML_HEADER": [self.source / "header.html"],
        }
        text = (self.root / "docs/site/Doxyfile").read_text(encoding="utf-8")
        return text + "".join(f"{name} = {' '.join(map(str, values))}\n" for name, values in settings.items())

    def write_header(self):
        """Doxygen's page header with a button that switches between light and dark."""
        header = self.source / "header.html"
        scratch = [self.source / name for name in ("footer.html", "style.css")]
        subprocess.run(["doxygen", "-w", "html", header, *scratch], check=True, capture_output=True)
        text = header.read_text(encoding="utf-8")
        script = ('<script type="text/javascript" src="$relpath^doxygen-awesome-darkmode-toggle.js"></script>\n'
                  '<script type="text/javascript">DoxygenAwesomeDarkModeToggle.init()</script>\n')
        header.write_text(text.replace("</head>", f"{script}</head>"), encoding="utf-8")

    def build(self):
        """Returns the warnings of Doxygen."""
        shutil.rmtree(self.output, ignore_errors=True)
        self.output.mkdir(parents=True)
        self.write_sources()
        (self.source / "examples.dox").write_text(self.examples.pages(self.recipe_label), encoding="utf-8")
        self.write_header()
        done = subprocess.run(["doxygen", "-"], input=self.configuration(), text=True, capture_output=True, check=False, cwd=self.root)
        for path in self.copies:
            target = self.output / "files" / path
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(self.root / path, target)
        if self.viewer:
            shutil.copytree(self.viewer, self.output / "viewer")
        self.examples.link(self.output, self.source / "xml")
        problems = [line for line in done.stderr.splitlines() if line.strip()] + self.examples.problems(self.source / "xml")
        return [line.replace(f"{self.source}/", "").replace(f"{self.root}/", "").replace(": warning: ", ": ") for line in problems]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=Path, default=ROOT / "build/site", help="the site's folder (default: build/site)")
    parser.add_argument("--viewer", type=Path, default=ROOT / "build/web/viewer", help="the built viewer (default: build/web/viewer)")
    options = parser.parse_args()
    if not shutil.which("doxygen") or not THEME.is_dir():
        sys.exit("make_site: needs doxygen and doxygen-awesome-css, as packaged by Debian")
    site = Site(ROOT, options.output.resolve(), options.viewer.resolve() if options.viewer.is_dir() else None)
    problems = site.build()
    for problem in problems:
        print(problem, file=sys.stderr)
    print(f"site: {len(site.pages)} pages, {len(site.headers)} headers, {len(problems)} problems: {site.output / 'index.html'}")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
