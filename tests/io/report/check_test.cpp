// SPDX-License-Identifier: MIT
#include <algorithm>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>

#include <graze/io/report/check.hpp>

namespace graze::io::report_test {
namespace {

const ReportHead head{"yard.json", 2, 3};
const ReportSummary summary{2, 5, 0.25};

/// A report of the given pairs, with the summary above.
std::string report(ReportFormat format, const std::vector<ReportedPair>& pairs, Colours colours = Colours::off) {
  std::ostringstream out;
  const auto writer = begin_report(out, format, head, colours);
  for (const ReportedPair& pair : pairs) writer->write(pair);
  writer->finish(summary);
  return out.str();
}

const std::vector<ReportedPair> two_pairs{{"ball", "ground", Relation::touching},
                                          {"ground", "wall", Relation::overlapping}};

TEST(Report, as_json_holds_the_head_the_pairs_and_the_summary) {
  const std::string text = report(ReportFormat::json, two_pairs);
  EXPECT_EQ(text, R"({
  "schema": "graze.check/1",
  "scene": "yard.json",
  "dimension": 2,
  "objects": 3,
  "not_read": [],
  "pairs": [
    {"a": "ball", "b": "ground", "relation": "touching"},
    {"a": "ground", "b": "wall", "relation": "overlapping"}
  ],
  "summary": {"pairs": 2, "candidates": 5, "seconds": 0.250000}
}
)");
  EXPECT_EQ(nlohmann::json::parse(text)["pairs"].size(), 2U);
}

TEST(Report, as_json_of_no_pair_is_a_whole_document) {
  const auto document = nlohmann::json::parse(report(ReportFormat::json, {}));
  EXPECT_TRUE(document["pairs"].is_array());
  EXPECT_TRUE(document["pairs"].empty());
}

TEST(Report, as_ndjson_is_one_object_per_line) {
  EXPECT_EQ(report(ReportFormat::ndjson, two_pairs), R"({"a": "ball", "b": "ground", "relation": "touching"}
{"a": "ground", "b": "wall", "relation": "overlapping"}
)");
  EXPECT_EQ(report(ReportFormat::ndjson, {}), "");
}

TEST(Report, as_csv_has_a_header_and_quotes_what_needs_it) {
  const std::vector<ReportedPair> pairs{{"a,b", "say \"hi\"", Relation::touching},
                                        {"two\nlines", "plain", Relation::overlapping}};
  EXPECT_EQ(report(ReportFormat::csv, pairs),
            "a,b,relation\n\"a,b\",\"say \"\"hi\"\"\",touching\n\"two\nlines\",plain,overlapping\n");
  EXPECT_EQ(report(ReportFormat::csv, {}), "a,b,relation\n");
}

TEST(Report, as_a_table_has_aligned_columns_and_a_closing_line) {
  EXPECT_EQ(report(ReportFormat::table, two_pairs),
            "A       B       RELATION\n"
            "ball    ground  touching\n"
            "ground  wall    overlapping\n"
            "\n"
            "2 pairs; 3 objects, 5 candidates, 0.250 seconds\n");
  EXPECT_EQ(report(ReportFormat::table, {}), "2 pairs; 3 objects, 5 candidates, 0.250 seconds\n");
}

TEST(Report, as_a_table_aligns_wide_and_escaped_names) {
  const std::vector<ReportedPair> pairs{{"球", "x", Relation::touching}, {"\x1b[1m", "x", Relation::touching}};
  const std::string text = report(ReportFormat::table, pairs);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_NE(text.find("\n球       x  touching\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n\\x1b[1m  x  touching\n"), std::string::npos) << text;
}

/// The report of a 2D scene with one pair, with details.
std::string detailed(ReportFormat format, PairDetail detail, const ReportedPair& pair) {
  std::ostringstream out;
  const auto writer = begin_report(out, format, {"yard.json", 2, 3, detail});
  writer->write(pair);
  writer->finish(summary);
  return out.str();
}

const ReportedPair standing{
    "ground",          "crate", Relation::overlapping, 0, {0, 1}, {{{-1, 0.125}, 0.25}, {{1, 0}, 0.1}},
    Status::converged, 1e-16};

TEST(Report, tells_contacts_in_every_format) {
  EXPECT_EQ(detailed(ReportFormat::ndjson, PairDetail::contacts, standing),
            R"({"a": "ground", "b": "crate", "relation": "overlapping", "depth": 0.25, "normal": [0, 1], "contacts": )"
            R"([{"point": [-1, 0.125], "depth": 0.25}, {"point": [1, 0], "depth": 0.1}], )"
            R"("status": "converged", "error": 1e-16})"
            "\n");
  const auto document = nlohmann::json::parse(detailed(ReportFormat::json, PairDetail::contacts, standing));
  EXPECT_EQ(document["schema"], "graze.check/1");
  EXPECT_EQ(document["pairs"][0]["contacts"][1]["depth"], 0.1);
  EXPECT_EQ(detailed(ReportFormat::csv, PairDetail::contacts, standing),
            "a,b,relation,depth,x,y,normal_x,normal_y,status,error\n"
            "ground,crate,overlapping,0.25,-1,0.125,0,1,converged,1e-16\n"
            "ground,crate,overlapping,0.1,1,0,0,1,converged,1e-16\n");
  EXPECT_EQ(detailed(ReportFormat::table, PairDetail::contacts, standing),
            "A       B      RELATION     DEPTH  POINT      NORMAL\n"
            "ground  crate  overlapping  0.25   -1, 0.125  0, 1\n"
            "ground  crate  overlapping  0.1    1, 0       0, 1\n"
            "\n"
            "2 pairs; 3 objects, 5 candidates, 0.250 seconds\n");
}

TEST(Report, tells_a_depth_without_end_as_json_can) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const ReportedPair crossing{"a", "b", Relation::overlapping, 0, {0, 0}, {{{1, 2}, infinity}}};
  const auto line = nlohmann::json::parse(detailed(ReportFormat::ndjson, PairDetail::contacts, crossing));
  EXPECT_TRUE(line["depth"].is_null());
  EXPECT_TRUE(line["contacts"][0]["depth"].is_null());
  EXPECT_NE(detailed(ReportFormat::csv, PairDetail::contacts, crossing).find(",inf,1,2,0,0,converged,0\n"),
            std::string::npos);
}

TEST(Report, tells_distances_in_every_format) {
  const ReportedPair near{"a", "b", Relation::apart, 0.5};
  EXPECT_EQ(detailed(ReportFormat::ndjson, PairDetail::distance, near),
            R"({"a": "a", "b": "b", "relation": "apart", "distance": 0.5, "status": "converged", "error": 0})"
            "\n");
  EXPECT_EQ(detailed(ReportFormat::csv, PairDetail::distance, near),
            "a,b,relation,distance,status,error\na,b,apart,0.5,converged,0\n");
  EXPECT_EQ(detailed(ReportFormat::table, PairDetail::distance, near),
            "A  B  RELATION  DISTANCE\n"
            "a  b  apart     0.5\n"
            "\n"
            "2 pairs; 3 objects, 5 candidates, 0.250 seconds\n");
}

TEST(Report, tells_what_has_not_converged_in_every_format) {
  const ReportedPair near{"a", "b", Relation::apart, 0.5, {}, {}, Status::best_bound, 0.015625};
  const auto line = nlohmann::json::parse(detailed(ReportFormat::ndjson, PairDetail::distance, near));
  EXPECT_EQ(line["status"], "best_bound");
  EXPECT_EQ(line["error"], 0.015625);
  EXPECT_EQ(detailed(ReportFormat::csv, PairDetail::distance, near),
            "a,b,relation,distance,status,error\na,b,apart,0.5,best_bound,0.015625\n");
  EXPECT_EQ(detailed(ReportFormat::table, PairDetail::distance, near),
            "A  B  RELATION  DISTANCE\n"
            "a  b  apart     0.5 +- 0.015625\n"
            "\n"
            "2 pairs; 3 objects, 5 candidates, 0.250 seconds\n");
  const ReportedPair deep{"a", "b", Relation::overlapping, 0, {0, 1}, {{{1, 2}, 3}}, Status::best_bound, 0.25};
  EXPECT_EQ(detailed(ReportFormat::csv, PairDetail::contacts, deep),
            "a,b,relation,depth,x,y,normal_x,normal_y,status,error\na,b,overlapping,3,1,2,0,1,best_bound,0.25\n");
  EXPECT_NE(detailed(ReportFormat::table, PairDetail::contacts, deep).find("  3 +- 0.25  1, 2   0, 1\n"),
            std::string::npos);
}

TEST(Report, colours_only_a_table_and_ends_each_colour) {
  EXPECT_EQ(report(ReportFormat::table, {{"a", "b", Relation::overlapping}}, Colours::on),
            "\x1b[1mA  B  RELATION\x1b[0m\n"
            "a  b  \x1b[33moverlapping\x1b[0m\n"
            "\n"
            "2 pairs; 3 objects, 5 candidates, 0.250 seconds\n");
  for (const ReportFormat format : {ReportFormat::json, ReportFormat::ndjson, ReportFormat::csv}) {
    EXPECT_EQ(report(format, two_pairs, Colours::on), report(format, two_pairs));
  }
}

TEST(Report, says_in_json_what_was_not_read_and_everywhere_what_is_missing) {
  ReportHead partial{"yard.json", 2, 3, PairDetail::contacts, {{"curve", 2, Loss::shape}, {"picture", 1}}};
  const auto written = [&partial](ReportFormat format) {
    std::ostringstream out;
    const auto writer = begin_report(out, format, partial);
    writer->finish({});
    return out.str();
  };
  const auto document = nlohmann::json::parse(written(ReportFormat::json));
  ASSERT_EQ(document["not_read"].size(), 2U);
  EXPECT_EQ(document["not_read"][0]["what"], "curve");
  const std::string lines = written(ReportFormat::ndjson);
  EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 1);
  EXPECT_EQ(nlohmann::json::parse(lines.substr(0, lines.find('\n'))),
            nlohmann::json({{"not_read", document["not_read"][0]}}));
  EXPECT_EQ(written(ReportFormat::csv),
            "a,b,relation,depth,x,y,normal_x,normal_y,status,error\n2 x curve,,not_read,,,,,,,\n");
  EXPECT_EQ(written(ReportFormat::table), "not read: 2 x curve\n0 pairs; 3 objects, 0 candidates, 0.000 seconds\n");
}

TEST(Report, streams_json_lines_and_csv_before_the_end) {
  for (const ReportFormat format : {ReportFormat::json, ReportFormat::ndjson, ReportFormat::csv}) {
    std::ostringstream out;
    const auto writer = begin_report(out, format, head);
    writer->write(two_pairs[0]);
    EXPECT_NE(out.str().find("ball"), std::string::npos);
  }
}

TEST(Report, replaces_bytes_in_json_that_are_not_utf8) {
  const auto line = nlohmann::json::parse(report(ReportFormat::ndjson, {{"a\xff", "\x01\"\\", Relation::touching}}));
  EXPECT_EQ(line["a"], "a\xef\xbf\xbd");
  EXPECT_EQ(line["b"], "\x01\"\\");
}

TEST(SummaryLine, uses_the_singular_for_one) {
  EXPECT_EQ(summary_line({"x", 3, 1}, {1, 1, 0}), "1 pair; 1 object, 1 candidate, 0.000 seconds");
}

TEST(SummaryLine, counts_what_has_not_converged) {
  EXPECT_EQ(summary_line({"x", 3, 9}, {5, 7, 0, 2}),
            "5 pairs, 2 not converged; 9 objects, 7 candidates, 0.000 seconds");
}

/// Splits one line of CSV into its fields, by the rules of RFC 4180; it ends with the text.
std::vector<std::string> fields_of(const std::string& text) {
  std::vector<std::string> fields{""};
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') {
      if (quoted && i + 1 < text.size() && text[i + 1] == '"') {
        fields.back() += text[++i];
      } else {
        quoted = !quoted;
      }
    } else if (text[i] == ',' && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += text[i];
    }
  }
  return fields;
}

RC_GTEST_PROP(Report, as_csv_gives_back_any_name, (const std::string& a, const std::string& b)) {
  const std::string text = report(ReportFormat::csv, {{a, b, Relation::touching}});
  const std::string first_line = "a,b,relation\n";
  RC_ASSERT(text.starts_with(first_line) && text.ends_with('\n'));
  const std::string line = text.substr(first_line.size(), text.size() - first_line.size() - 1);
  RC_ASSERT(fields_of(line) == (std::vector<std::string>{a, b, "touching"}));
}

}  // namespace
}  // namespace graze::io::report_test
