# SPDX-License-Identifier: MIT
"""graze-mpi: the same bytes as graze on one machine, counts of what is sent, and errors that end all ranks."""

import json
import os
import subprocess
import unittest

CLI, MPI, MPIEXEC = os.environ["GRAZE_CLI"], os.environ["GRAZE_MPI"], os.environ["MPIEXEC"]


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=250)


def run_mpi(ranks, *arguments):
    return run(MPIEXEC, "-n", str(ranks), MPI, *arguments)


class Program(unittest.TestCase):
    def output_of(self, done):
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_pairs_are_the_same_bytes_as_on_one_machine(self):
        for ranks, options in ((1, ["brownian:3000"]), (3, ["brownian:20000", "--seed", "3", "--format", "csv"]),
                               (2, ["2d:heavy:2k", "--frame", "2", "--format", "json"]), (4, ["giants:2", "--format", "json"])):
            with self.subTest(ranks=ranks, options=options):
                expected = self.output_of(run(CLI, "pairs", "--generate", *options))
                self.assertEqual(self.output_of(run_mpi(ranks, "pairs", "--generate", *options)), expected)

    def test_bench_counts_what_is_sent_and_finds_the_same_pairs_with_any_number_of_ranks(self):
        results = [json.loads(self.output_of(run_mpi(ranks, "bench", "--generate", "brownian:8000", "--frames", "3", "--format",
                                                     "json"))) for ranks in (1, 2, 4)]
        for result, ranks in zip(results, (1, 2, 4), strict=True):
            self.assertEqual(result["schema"], "graze.mpi-bench/1")
            self.assertEqual(result["ranks"], ranks)
            for frame, of_one in zip(result["frames"], results[0]["frames"], strict=True):
                self.assertEqual((frame["pairs"], frame["checksum"]), (of_one["pairs"], of_one["checksum"]))
                self.assertEqual(frame["boxes"], 8000)
                self.assertEqual(len(frame["by_rank"]), ranks)
                for name in ("boxes", "searched", "ghosts", "messages", "bytes", "pairs"):
                    self.assertEqual(frame[name], sum(rank[name] for rank in frame["by_rank"]))
                self.assertTrue(0 < frame["balance"] <= 1)
                if ranks == 1:
                    self.assertEqual((frame["ghosts"], frame["messages"], frame["bytes"]), (0, 0, 0))
                else:
                    self.assertAlmostEqual(frame["ghosts"] / frame["ghosts_model"], 1, delta=0.1)
                    self.assertGreaterEqual(frame["bytes"], 24 * frame["ghosts"])

    def test_bench_writes_a_table(self):
        lines = self.output_of(run_mpi(2, "bench", "--generate", "2d:brownian:500", "--frames", "2")).splitlines()
        self.assertEqual(lines[0], "2d:brownian:500, seed 1, 2 ranks with 1 threads each, skin 0.5")
        self.assertEqual([line.split()[:2] for line in lines[2:5]], [["0", "0"], ["0", "1"], ["0", "all"]])
        self.assertRegex(lines[-1], r"^mean: .* ms; ghosts in the last frame: \d+, by the model \d+; checksum [0-9a-f]{16}$")

    def test_wrong_usage_ends_all_ranks_with_one_message(self):
        for arguments, message in ((["pairs"], "--generate"), (["pears"], "did you mean"), ([], "a command is missing"),
                                   (["bench", "--generate", "brownian:10", "--skin", "-1"], '--skin is "-1"'),
                                   (["pairs", "--generate", "brownian"], "needs a number of boxes")):
            with self.subTest(arguments=arguments):
                done = run_mpi(2, *arguments)
                self.assertEqual(done.returncode, 2)
                self.assertEqual(done.stderr.count("graze: error: "), 1, done.stderr)
                self.assertIn(message, done.stderr)

    def test_help_and_version(self):
        self.assertIn("pairs", self.output_of(run_mpi(2, "--help")))
        self.assertIn("--skin", self.output_of(run_mpi(1, "bench", "--help")))
        self.assertRegex(self.output_of(run_mpi(2, "--version")), r"^graze-mpi \d+\.\d+\.\d+\n$")


if __name__ == "__main__":
    unittest.main()
