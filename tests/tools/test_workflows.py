# SPDX-License-Identifier: MIT
"""The workflows of CI are valid YAML, and call commands, scripts and presets that exist."""

import itertools
import json
import re
import subprocess
import unittest

import yaml

from project_tree import ROOT

WORKFLOWS = sorted((ROOT / ".github/workflows").glob("*.yml"))
USAGE = subprocess.run([ROOT / "dev", "help"], capture_output=True, text=True, check=True).stdout
COMMANDS = set(re.findall(r"^  (\w+)", USAGE, re.MULTILINE))
PRESETS = {preset["name"] for preset in json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))["configurePresets"]}


def variants(job):
    """The sets of values of a job's matrix; one that is empty for a job without."""
    matrix = dict(job.get("strategy", {}).get("matrix", {}))
    included = matrix.pop("include", [])
    lists = [[(name, value) for value in values] for name, values in matrix.items()]
    return [dict(values) for values in itertools.product(*lists)] if lists else included or [{}]


def commands(job):
    """Every command line of a job, with the values of its matrix."""
    for values in variants(job):
        for step in job["steps"]:
            for line in step.get("run", "").splitlines():
                yield re.sub(r"\$\{\{ *matrix\.(\w+) *\}\}", lambda match: str(values[match[1]]), line)


class WorkflowTest(unittest.TestCase):
    def jobs(self):
        for path in WORKFLOWS:
            for name, job in yaml.safe_load(path.read_text(encoding="utf-8"))["jobs"].items():
                yield f"{path.name}: {name}", job

    def test_every_workflow_says_when_it_runs_and_what(self):
        self.assertGreaterEqual({path.stem for path in WORKFLOWS}, {"ci", "platforms", "release", "site"})
        for path in WORKFLOWS:
            workflow = yaml.safe_load(path.read_text(encoding="utf-8"))
            self.assertTrue(workflow["name"], path)
            self.assertTrue(workflow[True], path)  # YAML reads the key `on` as true
            self.assertTrue(workflow["jobs"], path)

    def test_every_job_ends_and_has_steps_that_do_one_thing(self):
        for name, job in self.jobs():
            self.assertIn("runs-on", job, name)
            for step in job["steps"]:
                self.assertEqual(("run" in step) + ("uses" in step), 1, f"{name}: {step}")
            self.assertLessEqual(set([job["needs"]] if isinstance(job.get("needs"), str) else job.get("needs", [])),
                                 {other.split(": ")[1] for other, _ in self.jobs()}, name)

    def test_commands_scripts_and_presets_exist(self):
        seen = 0
        for name, job in self.jobs():
            for line in commands(job):
                for word in re.findall(r"(?<!\S)\./dev (\w+)", line):
                    self.assertIn(word, COMMANDS, f"{name}: {line}")
                    seen += 1
                for word in re.findall(r"--preset[ =]([\w-]+)", line):
                    self.assertIn(word, PRESETS, f"{name}: {line}")
                for word in re.findall(r"\b(?:packaging|tests|data)/[\w./-]+", line):
                    self.assertTrue((ROOT / word).exists(), f"{name}: {line}")
                    seen += 1
        self.assertGreater(seen, 10)

    def test_ci_runs_the_same_commands_as_the_script_of_the_project(self):
        steps = re.search(r"^steps=\((.*)\)$", (ROOT / ".ci/run").read_text(encoding="utf-8"), re.MULTILINE)[1]
        wanted = {quoted or word for quoted, word in re.findall(r'"([^"]+)"|(\S+)', steps)}
        ran = {line for _, job in self.jobs() for line in commands(job)}
        self.assertLessEqual({f"./dev {step}" for step in wanted}, ran)


if __name__ == "__main__":
    unittest.main()
