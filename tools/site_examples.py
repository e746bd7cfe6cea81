# SPDX-License-Identifier: MIT
"""The examples in the reference: a page for each program, and with each public function the programs that use it.

Doxygen itself finds what an example uses, but only where it can tell the type of every argument. Functions for which it finds
nothing list the examples that call a function of their name; for members, those that also name the class.
"""

import re
from pathlib import Path
from xml.etree import ElementTree

# Functions that no example needs to show, by name or by header: they are declared in headers that programs include, but only
# the library calls them.
WITHOUT_EXAMPLE = {
    "graze/io/log/logged_answer.hpp", "graze/io/log/logged_call.hpp", "graze/io/log/side_by_side.hpp",  # replay is made of them
    "graze::io::log_head",
    "graze::io::read_json_scene",  # takes a document that read_scene has parsed
    "graze::io::ShapeNumbers::of",  # behind with_numbers
    "graze::anchor", "graze::owner",  # what partition and exchange cut by
    "graze::Partition::ranks", "graze::Partition::cell", "graze::Partition::rank_at",  # for programs that draw the cells
    "graze::finite_magnitude",
    "graze::Parts::edit",  # the other members are those of std::vector
}

# Classes that have the calls of another one, whose examples show them.
TWINS = {"PlainScene": "Scene", "RecordedScene": "Scene"}

_COMMENT_OR_TEXT = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?:\\.|[^\"\\\n])*\"", re.DOTALL)
_ENTRY = re.compile(r'(?<=\n)(?=<a id="\w+" name="\w+"></a>\n<h2 class="memtitle">)')
_END_OF_ENTRY = re.compile(r"\n</div>\n</div>\n(?!.*\n</div>\n</div>\n)", re.DOTALL)


class Function:
    """A public function: its place in the reference, its name, and of a member the names by which examples know its class."""

    def __init__(self, member, owners):
        self.anchor = member.get("id").rpartition("_1")[2]
        self.name = member.findtext("name")
        self.full_name = member.findtext("qualifiedname") or self.name
        location = member.find("location")
        self.place = location.get("declfile") or location.get("file")
        self._call = re.compile(rf"{'(?<![.>])' if owners is None else '(?:[.]|->|::)'}\b{self.name}\s*[(<]")
        self._owner = re.compile(rf"\b(?:{'|'.join(owners or [])})\b")

    def is_used_in(self, code):
        return bool(self._call.search(code) and self._owner.search(code))


class Examples:
    def __init__(self, root, paths):
        self.paths = [path for path in paths if path.parts[0] == "examples"]
        self._code = {str(path.relative_to("examples")): _COMMENT_OR_TEXT.sub("", (root / path).read_text(encoding="utf-8"))
                      for path in self.paths}

    def pages(self, recipe_label):
        """For Doxygen: a page for each example; `recipe_label(path)` names the page of the cookbook that explains it, if any."""
        pages = []
        for path in self.paths:
            label = recipe_label(path)
            explained = f"@details The cookbook explains this program: @ref {label}.\n" if label else ""
            pages.append(f"/** @example {path.relative_to('examples')}\n{explained}*/\n")
        return "".join(pages)

    def link(self, html, xml):
        """Adds the examples to the entries of functions for which Doxygen has found none."""
        index = ElementTree.parse(xml / "index.xml").getroot()
        pages = {entry.findtext("name"): f"{entry.get('refid')}.html" for entry in index.iterfind("compound[@kind='example']")}
        functions = {function.anchor: function for function in functions_of(xml)}
        for path in html.glob("*.html"):
            entries = _ENTRY.split(path.read_text(encoding="utf-8"))
            for i, entry in enumerate(entries):
                function = functions.get(entry[len('<a id="'):].partition('"')[0])
                if i == 0 or function is None or 'class="section examples"' in entry:
                    continue
                links = [f'<a class="el" href="{pages[name]}">{name}</a>' for name, code in self._code.items()
                         if name in pages and function.is_used_in(code)]
                if links:
                    listed = f'\n<dl class="section examples"><dt>Examples</dt><dd>{", ".join(links)}.</dd>\n</dl>\n'
                    entries[i] = _END_OF_ENTRY.sub(lambda end, listed=listed: listed + end[0], entry, count=1)
            path.write_text("".join(entries), encoding="utf-8")

    def problems(self, xml):
        """Complaints about public functions that no example calls."""
        unused = {(function.place, function.full_name) for function in functions_of(xml)
                  if WITHOUT_EXAMPLE.isdisjoint({function.place, function.full_name})
                  and not any(map(function.is_used_in, self._code.values()))}
        return [f"{place}: no example uses {name}; show it in examples/, or name it with the reason in WITHOUT_EXAMPLE of "
                "tools/site_examples.py" for place, name in sorted(unused)]


def functions_of(xml):
    """The public functions in Doxygen's XML, without operators, constructors and destructors."""
    compounds = [ElementTree.parse(path).getroot().find("compounddef") for path in sorted(Path(xml).glob("*.xml"))]
    compounds = [compound for compound in compounds if compound is not None]
    classes = [compound for compound in compounds if compound.get("kind") in ("class", "struct")]
    short = {compound.get("id"): re.sub(r"<.*", "", compound.findtext("compoundname")).strip().rpartition("::")[2]
             for compound in classes}
    names = {compound: {name, TWINS.get(name, name)} for compound, name in short.items()}  # and those of aliases and of derived classes
    for derived in classes:
        for base in derived.iterfind("basecompoundref"):
            names.get(base.get("refid"), set()).add(short[derived.get("id")])
    namespaces = [compound for compound in compounds if compound.get("kind") == "namespace"]
    for alias in (member for space in namespaces for member in space.iterfind(".//memberdef[@kind='typedef']")):
        if (meant := alias.find("type/ref")) is not None and meant.get("refid") in names:
            names[meant.get("refid")].add(alias.findtext("name"))
    for compound in compounds:
        owners = names.get(compound.get("id"))
        for member in compound.iterfind(".//memberdef[@kind='function'][@prot='public']"):
            name = member.findtext("name")
            if not re.match(r"operator\W|~", name) and name != short.get(compound.get("id")):
                yield Function(member, owners)
