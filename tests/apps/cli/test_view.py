# SPDX-License-Identifier: MIT
"""`graze view` and `graze check --html`: pages that contain a scene and its pairs, and the address that shows them."""

import http.client
import json
import re
import subprocess
import unittest
from pathlib import Path

from graze_program import IMAGE_LAYER, PROGRAM, ROOT, TIMEOUT_SECONDS, YARD, YARD_PAIRS, CommandLineTest, environment

PLACE = '<script type="application/json" id="graze-report">'
TEMPLATE = f"<!doctype html>\n<title>graze</title>{PLACE}</script>\n<p>end</p>\n"


class ViewTest(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.template = self.write("template.html", TEMPLATE)

    def env(self, template=None):
        return environment(GRAZE_REPORT_TEMPLATE=str(template or self.template))

    def data_of(self, page):
        """The data in the page as a browser would parse it: up to the first end of a script."""
        head, rest = page.split(PLACE)
        text, tail = rest.split("</script>", 1)
        self.assertEqual((head, tail), tuple(TEMPLATE.split(PLACE + "</script>")))
        self.assertNotIn("<", text)
        data = json.loads(text)
        self.assertEqual(list(data), ["source", "scene", "check"])
        return data

    def view(self, scene, *options):
        page = self.folder / "page.html"
        self.succeed("view", scene, "--html", page, *options, env=self.env())
        return self.data_of(page.read_text(encoding="utf-8"))


class Page(ViewTest):
    def test_it_holds_the_scene_and_what_check_reports(self):
        scene = self.yard()
        data = self.view(scene)
        self.assertEqual(data["source"], scene.name)
        self.assertEqual([item["name"] for item in json.loads(data["scene"])["objects"]], [item["name"] for item in YARD["objects"]])
        self.assertEqual([(pair["a"], pair["b"], pair["relation"]) for pair in data["check"]["pairs"]], YARD_PAIRS)
        report = json.loads(self.succeed("check", "--format", "json", scene)[0])
        self.assertEqual(data["check"]["scene"], scene.name)
        for one in (data["check"], report):
            del one["summary"]["seconds"], one["scene"]
        self.assertEqual(data["check"], report)

    def test_it_tells_nothing_of_folders(self):
        page = self.folder / "page.html"
        # Part of the map is not read, and this must be reported.
        for scene in (self.yard().resolve(), (ROOT / "data" / "platform_level.tmx").resolve()):
            for command in (("view",), ("check", "--output", self.folder / "report.txt")):
                with self.subTest(scene=scene.name, command=command[0]):
                    self.succeed(*command, scene, "--html", page, env=self.env())
                    self.assertNotIn(str(scene.parent), page.read_text(encoding="utf-8"))

    def test_check_writes_the_same_page_with_the_pairs_that_were_asked_for(self):
        scene, page = self.yard(), self.folder / "page.html"
        text, _ = self.succeed("check", "--interior", "--format", "csv", "--html", page, scene, env=self.env())
        self.assertEqual(text, "a,b,relation\ncrate,ball,overlapping\n")
        data = self.data_of(page.read_text(encoding="utf-8"))
        self.assertEqual(data["check"]["pairs"], [{"a": "crate", "b": "ball", "relation": "overlapping"}])

    def test_a_template_that_is_a_folder_is_refused_as_one(self):
        self.refused("view", "--html", self.folder / "v.html", self.yard(), env=self.env(self.folder),
                     says=[str(self.folder), "is a folder; GRAZE_REPORT_TEMPLATE must name a file"])
        self.assert_no_litter("template.html", "yard.json")

    def test_it_says_what_was_not_read(self):
        data = self.view(self.write("layers.tmx", IMAGE_LAYER))
        self.assertEqual([omission["what"] for omission in data["check"]["not_read"]], ["image layer"])
        self.refused("view", "--strict", "--html", self.folder / "none.html", self.folder / "layers.tmx", env=self.env(),
                     says="refused because of --strict")

    def test_names_cannot_end_the_script_nor_begin_a_comment(self):
        name = "</script><script>alert(1)</script><!-- \u2028 \" \\"
        scene = self.write("names.json", {**YARD, "objects": [{**YARD["objects"][2], "name": name}]})
        self.assertEqual(json.loads(self.view(scene)["scene"])["objects"][0]["name"], name)

    def test_numbers_that_javascript_cannot_hold_survive(self):
        scene = self.write("user.json", {**YARD, "objects": [{**YARD["objects"][2], "user": 2**64 - 1}]})
        self.assertIn(str(2**64 - 1), self.view(scene)["scene"])

    def test_maps_and_tables_become_scenes(self):
        for name in ("platform_level.tmx", "workshop.json"):
            with self.subTest(name):
                data = self.view(ROOT / "data" / name)
                self.assertEqual(len(json.loads(data["scene"])["objects"]), data["check"]["objects"])

    def test_a_page_goes_to_the_standard_output_and_the_summary_to_the_error_stream(self):
        page, said = self.succeed("view", self.yard(), "--html", "-", env=self.env())
        self.assertEqual(len(self.data_of(page)["check"]["pairs"]), 3)
        self.assertRegex(said, r"\Agraze: 3 pairs; 4 objects, 3 candidates, .* seconds\n\Z")

    def test_a_missing_template_names_the_places_and_the_way_out(self):
        missing = self.folder / "none.html"
        self.refused("view", self.yard(), "--html", self.folder / "page.html", env=self.env(missing),
                     says=["there is no template for HTML reports", str(missing), "./dev web", "GRAZE_REPORT_TEMPLATE"])
        self.assertFalse((self.folder / "page.html").exists())

    def test_a_template_without_a_place_is_refused(self):
        wrong = self.write("wrong.html", "<!doctype html><p>nothing</p>")
        self.refused("check", self.yard(), "--html", self.folder / "page.html", env=self.env(wrong), says=["wrong.html", "no place for data"])

    def test_an_installed_program_finds_the_template_beside_it(self):
        place = self.folder / "prefix" / "share" / "graze" / "report.html"
        self.write(place, TEMPLATE)
        program = self.write("prefix/bin/graze", Path(PROGRAM).read_bytes())
        program.chmod(0o755)
        page, _ = self.succeed("view", self.yard(), "--html", "-", program=program, env=environment(
            GRAZE_REPORT_TEMPLATE="", LD_LIBRARY_PATH=str(Path(PROGRAM).parent)))
        self.assertEqual(len(self.data_of(page)["check"]["pairs"]), 3)

    def test_outputs_that_would_overwrite_each_other_or_the_scene_are_refused(self):
        scene, page = self.yard(), str(self.folder / "page.html")
        content = scene.read_bytes()
        self.refused("view", scene, "--html", scene, code=2, says="would be overwritten")
        self.refused("check", scene, "--html", scene, code=2, says="would be overwritten")
        self.refused("check", scene, "--html", page, "--output", page, code=2, says="--output and --html name the same file")
        self.refused("check", scene, "--html", page, "--svg", page, code=2, says="--svg and --html name the same file")
        self.refused("check", scene, "--html", "-", code=2, says="--html - needs --output FILE")
        self.refused("check", scene, "--html", "-", "--svg", "-", "--output", page, code=2, says="--svg - and --html -")
        self.assertEqual(scene.read_bytes(), content)

    def test_a_bad_scene_leaves_an_existing_page_as_it_was(self):
        page = self.write("page.html", "precious")
        self.refused("view", self.write("bad.json", "{}"), "--html", page, env=self.env(), says="bad.json")
        self.assertEqual(page.read_text(), "precious")


class Server(ViewTest):
    def setUp(self):
        super().setUp()
        self.process = subprocess.Popen([PROGRAM, "view", str(self.yard())], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        env=self.env())
        self.addCleanup(self.stop)
        address = self.process.stdout.readline().decode()
        self.assertRegex(address, r"\Ahttp://127\.0\.0\.1:\d+/\n\Z")
        self.port = int(re.search(r":(\d+)/", address)[1])

    def stop(self):
        self.process.kill()
        self.process.wait(TIMEOUT_SECONDS)
        self.process.stdout.close()
        self.process.stderr.close()

    def ask(self, method="GET", path="/", **headers):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=TIMEOUT_SECONDS)
        self.addCleanup(connection.close)
        connection.request(method, path, headers=headers)
        reply = connection.getresponse()
        return reply.status, reply.read().decode()

    def test_the_address_shows_the_page_again_and_again(self):
        for _ in range(3):
            status, page = self.ask()
            self.assertEqual(status, 200)
            self.assertEqual(len(self.data_of(page)["check"]["pairs"]), 3)
        self.assertEqual(self.ask(path="/?from=somewhere")[0], 200)
        self.assertEqual(self.ask(Host=f"localhost:{self.port}")[0], 200)

    def test_nothing_else_is_shown(self):
        self.assertEqual(self.ask(path="/yard.json")[0], 404)
        self.assertEqual(self.ask(path="/../../etc/passwd")[0], 404)
        self.assertEqual(self.ask(method="POST")[0], 405)

    def test_a_page_from_elsewhere_cannot_read_it_under_its_own_name(self):
        status, page = self.ask(Host="evil.example")
        self.assertEqual(status, 403)
        self.assertNotIn("crate", page)

    def test_whoever_connects_and_goes_stops_nobody(self):
        for _ in range(20):
            connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=TIMEOUT_SECONDS)
            connection.connect()
            connection.close()
        self.assertEqual(self.ask()[0], 200)


if __name__ == "__main__":
    unittest.main()
