# SPDX-License-Identifier: MIT
"""Output: complete files or none, full disks, closed pipes, closed streams."""

import json
import os
import resource
import signal
import subprocess
import time
import unittest

from graze_program import CAN_BE_LIMITED, PROGRAM, ROOT, TIMEOUT_SECONDS, CommandLineTest, environment, run_graze


class Output(CommandLineTest):
    def many_boxes(self, count=150):
        """Boxes that all overlap each other: about 11,000 pairs, several times the capacity of a pipe."""
        lines = "".join(f"box_{i},0,0,1,1\n" for i in range(count))
        return self.write("many.csv", "id,min_x,min_y,max_x,max_y\n" + lines)

    def run_until_pipe_is_closed(self, *arguments):
        """Reads one line of the output and closes it, as `head -1` does."""
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   env=environment())
        with process:
            first = process.stdout.readline()
            process.stdout.close()
            said = process.stderr.read()
            return first, said, process.wait(TIMEOUT_SECONDS)

    def test_a_closed_pipe_ends_the_program_quietly(self):
        scene = self.many_boxes()
        for report_format in ("table", "json", "ndjson", "csv"):
            with self.subTest(report_format):
                first, said, code = self.run_until_pipe_is_closed("check", "--format", report_format, scene)
                self.assertNotEqual(first, b"")
                self.assertEqual((said, code), (b"", -signal.SIGPIPE))

    def test_a_closed_pipe_leaves_no_half_written_file(self):
        kept = self.write("report", "precious")
        _, said, code = self.run_until_pipe_is_closed("check", "--output", kept, "--svg", "-", self.many_boxes(600))
        self.assertEqual((said, code), (b"", -signal.SIGPIPE))
        self.assertEqual(kept.read_text(), "precious")
        self.assert_no_litter("many.csv", "report")

    def test_a_stream_begins_before_the_end_of_the_search(self):
        # 50,000 boxes at one position have more than 10^9 pairs, too many to wait for or to hold.
        scene = self.many_boxes(50000)
        for report_format in ("ndjson", "csv", "table"):
            with self.subTest(report_format):
                first, said, code = self.run_until_pipe_is_closed("check", "--format", report_format, scene)
                self.assertEqual((said, code), (b"", -signal.SIGPIPE))
                self.assertNotEqual(first, b"")
        first, _, _ = self.run_until_pipe_is_closed("check", "--format", "ndjson", scene)
        self.assertEqual(json.loads(first), {"a": "box_0", "b": "box_1", "relation": "overlapping"})

    def most_memory_of(self, *arguments):
        """The program's peak resident size in bytes, and the number of lines that it wrote."""
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                   env=environment())
        with process.stdout:
            lines = sum(block.count(b"\n") for block in iter(lambda: process.stdout.read(1 << 20), b""))
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 0)
        return usage.ru_maxrss * 1024, lines

    def test_memory_does_not_grow_with_the_number_of_pairs(self):
        # Four million pairs would take 100 MB as candidates, and 600 MB as rows of a table.
        few = self.write("few.csv", self.many_boxes(200).read_bytes())
        boxes = 2900 if CAN_BE_LIMITED else 400  # if memory cannot be measured, only the number of lines is tested
        scene = self.many_boxes(boxes)
        for report_format in ("csv", "table"):
            with self.subTest(report_format):
                small, _ = self.most_memory_of("check", "--format", report_format, few)
                large, lines = self.most_memory_of("check", "--format", report_format, scene)
                self.assertGreaterEqual(lines, boxes * (boxes - 1) // 2)
                if CAN_BE_LIMITED:
                    self.assertLess(large - small, 150 << 20)

    def write_slowly(self, **options):
        """A run that would write for hours, after its temporary file has been created."""
        report = self.write("report", "precious")
        process = subprocess.Popen([PROGRAM, "check", "--format", "csv", "--output", report, self.many_boxes(50000)],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, env=environment(), **options)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        deadline = time.monotonic() + TIMEOUT_SECONDS
        while not any(file.stat().st_size for file in self.folder.glob(".graze-*.tmp")):
            self.assertLess(time.monotonic(), deadline, "there is no temporary file")
            self.assertIsNone(process.poll(), "the program has ended")
            time.sleep(0.01)
        return process

    def test_signals_that_end_the_program_leave_no_half_written_file(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGXCPU):
            with self.subTest(number):
                process = self.write_slowly(preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CORE, (0, 0)))
                process.send_signal(number)
                self.assertEqual(process.wait(TIMEOUT_SECONDS), -number)
                self.assertEqual((self.folder / "report").read_text(), "precious")
                self.assert_no_litter("many.csv", "report")

    def test_a_signal_that_was_ignored_stays_ignored(self):
        process = self.write_slowly(preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        process.send_signal(signal.SIGHUP)
        time.sleep(0.2)
        self.assertIsNone(process.poll())
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(TIMEOUT_SECONDS), -signal.SIGTERM)
        self.assert_no_litter("many.csv", "report")

    def test_a_file_that_becomes_too_large_is_an_error(self):
        report = self.write("report", "precious")
        limit = {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (100000, 100000))}
        self.refused("check", "--format", "csv", "--output", report, self.many_boxes(1000), **limit,
                     says=["report", "File too large", "the target is unchanged"])
        self.assertEqual(report.read_text(), "precious")
        self.assert_no_litter("many.csv", "report")

    def test_what_a_killed_run_left_behind_is_removed_by_the_next(self):
        process = self.write_slowly()
        process.kill()
        process.wait(TIMEOUT_SECONDS)
        self.assertEqual(len(list(self.folder.glob(".graze-*.tmp"))), 1)
        self.succeed("convert", self.yard(), self.folder / "other.json")
        self.assert_no_litter("many.csv", "other.json", "report", "yard.json")

    def test_the_file_of_a_run_that_goes_on_is_left_alone(self):
        process = self.write_slowly()
        self.succeed("convert", self.yard(), self.folder / "other.json")
        self.assertEqual(len(list(self.folder.glob(".graze-*.tmp"))), 1)
        process.terminate()
        process.wait(TIMEOUT_SECONDS)
        self.assert_no_litter("many.csv", "other.json", "report", "yard.json")

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no /dev/full")
    def test_a_full_disk_is_an_error(self):
        scene = self.yard()
        commands = [("check", scene), ("check", "--format", "csv", scene), ("info", scene), ("convert", scene, "-"),
                    ("--help",), ("--version",), ("check", "--help")]
        for command in commands:
            with self.subTest(command), open("/dev/full", "wb") as full:
                self.refused(*command, stdout=full, says=["standard output", "No space left on device"])
        self.refused("check", "--output", "/dev/full", scene, says="/dev/full")
        self.refused("check", "--svg", "-", "--output", "/dev/full", scene, says="/dev/full")

    def test_outputs_that_cannot_be_written_are_named(self):
        scene = self.yard()
        nowhere = self.folder / "no folder" / "file"
        for option in ("--output", "--svg"):
            done = run_graze("check", option, nowhere, scene)
            self.assertEqual(done.returncode, 3)
            self.assertIn(b"no folder", done.stderr)
        self.refused("check", "--output", self.folder, scene, says=str(self.folder))
        self.refused("convert", scene, self.folder / "no folder" / "out.json", says="no folder")
        self.refused("check", "--output", "", scene, says="")

    def test_a_report_keeps_its_old_content_when_the_picture_fails(self):
        report = self.write("report", "precious")
        self.refused("check", "--output", report, "--svg", self.folder / "no folder" / "picture.svg", self.yard())
        self.assertEqual(report.read_text(), "precious")
        self.assert_no_litter("report", "yard.json")

    def test_files_keep_their_old_content_when_the_input_is_refused(self):
        report, picture = self.write("report", "old report"), self.write("picture.svg", "old picture")
        self.refused("check", "--output", report, "--svg", picture, self.write("broken.csv", "id,min_x\n"))
        self.assertEqual((report.read_text(), picture.read_text()), ("old report", "old picture"))
        self.assert_no_litter("broken.csv", "picture.svg", "report")

    def test_an_existing_file_is_replaced_whole(self):
        report = self.write("report", "x" * 100000)
        self.succeed("check", "--format", "csv", "--output", report, self.yard())
        self.assertEqual(report.read_text().splitlines()[0], "a,b,relation")
        self.assertEqual(len(report.read_text().splitlines()), 4)

    def run_in_shell(self, command):
        """`$GRAZE` in the command is the program."""
        done = subprocess.run(["sh", "-c", command], cwd=self.folder, capture_output=True, timeout=TIMEOUT_SECONDS,
                              check=False, env=environment(GRAZE=PROGRAM))
        return done.returncode, done.stdout.decode(), done.stderr.decode()

    def test_closed_standard_streams_do_not_end_up_in_files(self):
        scene = ROOT / "data" / "platform_level.tmx"
        code, _, _ = self.run_in_shell(f'"$GRAZE" check --format csv --output report "{scene}" 2>&-')
        self.assertEqual(code, 0)
        self.assertTrue((self.folder / "report").read_text().startswith("a,b,relation\n"))
        self.assertNotIn("graze:", (self.folder / "report").read_text())
        code, _, said = self.run_in_shell(f'"$GRAZE" check "{scene}" >&-')
        self.assertEqual(code, 3)
        self.assertIn("the standard output cannot be written", said)
        code, text, said = self.run_in_shell('"$GRAZE" check - <&-')
        self.assertEqual((code, text), (3, ""))
        self.assertIn("the standard input cannot be read", said)

    def test_an_error_stream_that_cannot_be_written_changes_no_answer(self):
        if not os.path.exists("/dev/full"):
            self.skipTest("there is no /dev/full")
        with open("/dev/full", "wb") as full:
            text, _ = self.succeed("check", "--format", "csv", self.yard(), stderr=full)
        self.assertEqual(len(text.splitlines()), 4)


if __name__ == "__main__":
    unittest.main()
