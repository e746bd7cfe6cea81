# SPDX-License-Identifier: MIT
"""Creates tables from the data that ./dev exam writes.

Prints them or, with --write, inserts the tables of docs/accuracy.json between the marks <!-- exam: NAME --> and
<!-- exam: end --> in docs/accuracy.md and docs/accuracy_tables.md. check_docs.py fails if the pages differ."""

import argparse
import json
import re
import sys
import textwrap
from pathlib import Path

from project_files import ROOT

DATA = Path("docs/accuracy.json")
PAGES = (Path("docs/accuracy.md"), Path("docs/accuracy_tables.md"))
SPACES = {"2D f": "2D float", "2D d": "2D double", "3D f": "3D float", "3D d": "3D double"}
PROGRAMS = ("graze", "textbook", "qhull", "Bullet", "FCL", "FCL, libccd", "libccd", "ODE")

_MARKED = re.compile(r"(<!-- exam: (?!end)(.*?) -->\n)(.*?)(<!-- exam: end -->)", re.DOTALL)


def error(x):
    """An error with two digits; infinite ones are null in the data."""
    return "inf" if x is None else "0" if x == 0 else f"{x:.2g}"


def percent(share):
    return "0" if share == 0 else f"{round(100 * share, 6):.{2 if share < 0.01 else 0}f} %"


def in_space(space):
    return lambda errors: error(errors[space]) if space in errors else "-"


def by_scalar(errors):
    return " / ".join(in_space(scalar)(errors) for scalar in ("float", "double"))


def over_spaces(name):
    return [(head, name, in_space(space)) for head, space in SPACES.items()]


# graze's results: the columns after the subject, as heading, figure and format.
ANSWERS = {
    "point": [("cases", "cases", str), ("held", "held", percent), ("wrong", "wrong", str), ("forgiven", "forgiven", by_scalar),
              ("`signed_distance`", "signed_distance", by_scalar), ("`closest_point`", "closest_point", by_scalar),
              ("`closest_boundary_point`", "closest_boundary_point", by_scalar), ("needles", "needles", by_scalar)],
    "relation": [("cases", "cases", str), ("certified", "certified", percent), ("hits", "hits", percent), ("wrong", "wrong", str),
                 ("outside", "outside", str), ("in band", "in_band", percent), *over_spaces("gap")],
    "distance": [("cases", "cases", str), ("apart", "apart", percent), ("wrong", "wrong", str), ("outside", "outside", str),
                 *over_spaces("distance"), ("points", "points", error)],
    "contact": [("cases", "cases", str), ("meet", "meet", percent), ("wrong", "wrong", str), ("outside", "outside", str),
                *over_spaces("depth"), ("left", "left", error)],
    "manifold": [("cases", "cases", str), ("meet", "meet", percent), ("wrong", "wrong", str), ("outside", "outside", str),
                 *over_spaces("depth"), ("points", "points", error)],
    "ray_cast": [("cases", "cases", str), ("hits", "hits", percent), ("wrong", "wrong", str), ("outside", "outside", str),
                 *over_spaces("entry")],
    "shape_cast": [("cases", "cases", str), ("hits", "hits", percent), ("wrong", "wrong", str), ("outside", "outside", str),
                   *over_spaces("gap"), ("claimed", "claimed", error)],
    "time_of_impact": [("cases", "cases", str), ("hits", "hits", percent), ("wrong", "wrong", str),
                       ("unfinished", "unfinished", str), ("outside", "outside", str), *over_spaces("gap"),
                       ("claimed", "claimed", error)],
    "mass_properties": [("cases", "cases", str), ("with volume", "with_volume", str), ("wrong", "wrong", str),
                        ("volume", "volume", error), ("centroid", "centroid", error), ("inertia", "inertia", error)],
}

# The results of all programs: the common figures, and the content of a cell.
_OFF = "{false_yes} + {false_no}, {off}, {worst}"
_OFF_TWICE = "{false_yes} + {false_no}, {off} / {slightly_off}, {worst}"
SIDE_BY_SIDE = {
    "relation": (["touching"], "{false_yes} + {false_no}, {touching_missed}"),
    "distance": (["measured"], _OFF_TWICE + ", {points_off}"),
    "contact": (["measured"], _OFF),
    "manifold": (["measured"], _OFF + ", {points_off}, {points:.1f}"),
    "ray_cast": (["measured"], _OFF),
    "shape_cast": (["measured"], _OFF_TWICE),
    "time_of_impact": (["measured"], _OFF_TWICE),
    "convex_hull": (["points", "corners"], "{missing} + {extra}, {worst}, {given_up}"),
}


def table(head, rows):
    lines = [row(head), "|---" + "|--:" * (len(head) - 1) + "|\n", *map(row, rows)]
    return "".join(lines)


def row(cells):
    return f"| {' | '.join(cells)} |\n"


def of(rows, **wanted):
    return [one for one in rows if all(one[name] == value for name, value in wanted.items())]


def run_line(data):
    run = data["run"]
    cases = sum(one["cases"] for one in data["answers"])
    text = (f"{run['date']}, {run['compiler']}, seed {run['seed']}, {run['cases']} cases per pair of types and space, "
            f"{run['points']} per shape and space for point queries, {run['distances']} per pair and space for distances, "
            f"{run['contacts']} for contacts, {run['manifolds']} for manifolds, {run['casts']} for casts, {run['impacts']} for "
            f"times of impact, {run['rays']} per shape and space for rays, {run['masses']} for mass properties, {run['hulls']} "
            f"sets per kind and space for hulls")
    if run["seconds"]:
        text += f", but at most {run['seconds']:g} seconds for each"
    if run["pairs"]:
        text += f", only those named \"{run['pairs']}\""
    text += f"; {cases} cases in all."
    if of(data["answers"], question="relation"):
        text += (f" Of the verdicts on pairs {100 * run['certified']:.2f} % were judged by a certificate, the others by the "
                 "oracle.")
    return textwrap.fill(text, 118, break_on_hyphens=False) + "\n"


def answers_table(rows, question):
    columns = ANSWERS[question]
    head = ["pair" if "," in rows[0]["subject"] else "shape", *(heading for heading, _, _ in columns)]
    return table(head, [[one["subject"], *(tell(one[name]) for _, name, tell in columns)] for one in rows])


def programs_of(rows):
    return [name for name in PROGRAMS if any(name in one["programs"] for one in rows)]


def program_cell(figures, form):
    if figures is None:
        return ""
    return form.format(**{**figures, "worst": error(figures.get("worst"))})


def programs_table(rows, question):
    common, form = SIDE_BY_SIDE[question]
    names = programs_of(rows)
    lines = []
    for one in rows:
        subject = "**all**" if one["subject"] == "all" else one["subject"]
        lines.append([subject, str(one["cases"]), *(str(one[name]) for name in common),
                      *(program_cell(one["programs"].get(name), form) for name in names)])
    return table(["pair" if "," in rows[0]["subject"] else "shape", "cases", *common, *names], lines)


def kinds_table(total):
    names = programs_of([total])
    shares = [total["programs"][name]["wrong_of_kind"] for name in names]
    return table(["kind", *names], [[kind, *(percent(share[kind]) if kind in share else "-" for share in shares)]
                                    for kind in sorted(set().union(*shares))])


def hulls_table(rows):
    common, form = SIDE_BY_SIDE["convex_hull"]
    rows = [one for one in rows if one["subject"] != "all"]
    rows.sort(key=lambda one: list(SPACES.values()).index(one["space"]))
    names = programs_of(rows)
    return table(["space", "kind", "sets", *common, *names], [
        [one["space"], one["subject"], str(one["cases"]), *(str(one[name]) for name in common),
         *(program_cell(one["programs"].get(name), form) for name in names)] for one in rows])


def wrong_share(rows, program):
    """The share of a program's wrong answers to one question in one space; None if it was not asked."""
    asked = [one for one in rows if program in one["programs"] and one["subject"] != "all"]
    figures = [one["programs"][program] for one in asked]
    if not asked:
        return "-"
    whole = sum(one.get("corners", one["cases"]) for one in asked)
    wrong = sum(one.get(name, 0) for one in figures for name in ("false_yes", "false_no", "off", "missing", "extra"))
    return percent(wrong / whole)


def summary_table(data):
    programs = [name for name in programs_of(data["side_by_side"]) if name != "graze"]
    lines = []
    for question in dict.fromkeys(one["question"] for one in data["answers"]):
        rows = of(data["answers"], question=question)
        compared = [of(data["side_by_side"], question=question, space=space) for space in ("3D float", "3D double")]
        cells = [" / ".join(wrong_share(rows, name) for rows in compared) for name in programs]
        lines.append([f"`{question}`" if question != "point" else "points", f"{sum(one['cases'] for one in rows):,}",
                      str(sum(one["wrong"] for one in rows)), *("" if cell == "- / -" else cell for cell in cells)])
    return table(["question", "cases", "graze wrong", *programs], lines)


def tables_of(data):
    """All tables for which the data have rows, by name."""
    tables = {"run": run_line(data), "summary": summary_table(data)}
    for question in ANSWERS:
        if rows := of(data["answers"], question=question):
            tables[question] = answers_table(rows, question)
        for space in ("3D float", "3D double"):
            if question in SIDE_BY_SIDE and (rows := of(data["side_by_side"], question=question, space=space)):
                tables[f"{question}, {space}"] = programs_table(rows, question)
                if question == "relation":
                    tables[f"{question}, {space}, kinds"] = kinds_table(rows[-1])
    if rows := of(data["side_by_side"], question="convex_hull"):
        tables["convex_hull"] = hulls_table(rows)
    return tables


def filled(text, tables):
    """The page with each table between its marks; marks without a table stay unchanged."""
    return _MARKED.sub(lambda mark: f"{mark[1]}\n{tables[mark[2]]}\n{mark[4]}" if mark[2] in tables else mark[0], text)


def problems(root):
    """The problems of the pages of a project that has the data, as (page, line, text)."""
    if not (root / DATA).is_file():
        return []
    tables = tables_of(json.loads((root / DATA).read_text(encoding="utf-8")))
    found = []
    for page in PAGES:
        text = (root / page).read_text(encoding="utf-8")
        for mark in _MARKED.finditer(text):
            line = text.count("\n", 0, mark.start()) + 1
            if mark[2] not in tables:
                found.append((page, line, f"{DATA} has nothing for <!-- exam: {mark[2]} -->"))
            elif mark[3] != f"\n{tables[mark[2]]}\n":
                found.append((page, line, f"differs from {DATA}; run tools/exam_tables.py --write"))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", nargs="?", type=Path, help=f"the output of the exam (default: {DATA})")
    parser.add_argument("--root", type=Path, default=ROOT, help="root folder of the project")
    parser.add_argument("--write", action="store_true", help="insert the tables into the pages of the project")
    options = parser.parse_args()
    if options.write and options.data:
        parser.error(f"--write only takes {DATA}; copy the data there")
    tables = tables_of(json.loads((options.data or options.root / DATA).read_text(encoding="utf-8")))
    if not options.write:
        print("\n".join(f"### {name}\n\n{text}" for name, text in tables.items()), end="")
        return 0
    for page in PAGES:
        path = options.root / page
        path.write_text(filled(path.read_text(encoding="utf-8"), tables), encoding="utf-8")
    left = problems(options.root)
    for page, line, text in left:
        print(f"{page}:{line}: {text}", file=sys.stderr)
    return 1 if left else 0


if __name__ == "__main__":
    sys.exit(main())
