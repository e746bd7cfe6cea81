# SPDX-License-Identifier: MIT
"""tools/site_examples.py on the XML and the page that Doxygen would make of a few functions."""

from pathlib import Path

from project_tree import TreeTest

from site_examples import Examples

ENTRY = '<a id="a{0}" name="a{0}"></a>\n<h2 class="memtitle">f</h2>\n<div class="memdoc">\n\n</div>\n</div>\n'


class SiteExamplesTest(TreeTest):
    def setUp(self):
        super().setUp()
        members = [("namespacegraze", "namespace", "graze", ["far", "near"]), ("classgraze_1_1Box", "class", "graze::Box", ["grow"])]
        for compound, kind, full_name, functions in members:
            self.write(f"xml/{compound}.xml", f'<doxygen><compounddef id="{compound}" kind="{kind}"><compoundname>{full_name}'
                       "</compoundname>" + "".join(
                           f'<memberdef kind="function" id="{compound}_1a{name}" prot="public"><name>{name}</name>'
                           f'<location file="graze/{name}.hpp"/></memberdef>' for name in functions) + "</compounddef></doxygen>")
        self.write("xml/index.xml", '<doxygenindex><compound refid="one_8cpp-example" kind="example"><name>one.cpp</name></compound>'
                   "</doxygenindex>")

    def examples(self, code):
        self.write("examples/one.cpp", f"// SPDX-License-Identifier: MIT\n{code}\n")
        return Examples(self.tree, [Path("examples/one.cpp"), Path("graze/far.cpp")])

    def problems(self, code):
        return [problem.split(";")[0] for problem in self.examples(code).problems(self.tree / "xml")]

    def test_a_function_that_is_only_mentioned_is_unused(self):
        self.assertEqual(self.problems("int far = 1;  // near(2)\nBox box; box.grow(1);"),
                         ["graze/far.hpp: no example uses far", "graze/near.hpp: no example uses near"])

    def test_a_member_needs_an_object(self):
        self.assertEqual(self.problems('f("near(1)"); Box box; far(1); near<2>(3); grow(1);'), ["graze/grow.hpp: no example uses grow"])

    def test_entries_list_the_examples_that_call_them(self):
        self.write("html/graze.html", "head\n" + ENTRY.format("far") + ENTRY.format("near") + ENTRY.format("grow"))
        self.examples("far(1); thing.grow(1);").link(self.tree / "html", self.tree / "xml")
        far, near, grow = (self.tree / "html/graze.html").read_text(encoding="utf-8").split("<h2")[1:]
        self.assertIn('<dd><a class="el" href="one_8cpp-example.html">one.cpp</a>.</dd>', far)
        self.assertNotIn("Examples", near)
        self.assertNotIn("Examples", grow)  # of a Box, which the example does not have

    def test_an_example_has_a_page_which_leads_to_its_recipe(self):
        self.assertEqual(self.examples("").pages(lambda path: None), "/** @example one.cpp\n*/\n")
        self.assertIn("@ref label", self.examples("").pages(lambda path: "label"))
