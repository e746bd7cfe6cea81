// SPDX-License-Identifier: MIT
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include <graze/io/report/found.hpp>

namespace graze::io::found_test {
namespace {

std::string written(ReportFormat format, const FoundReport& report, Colours colours = Colours::off) {
  std::ostringstream out;
  write_found(out, format, report, colours);
  return out.str();
}

FoundReport report_of_a_ray() {
  FoundReport report;
  report.head = {"s.json", 2, 7};
  report.detail = FoundDetail::hit;
  report.objects = {{"a,b", "sphere", 0.1, {1, -2.5}, {0, 1}}, {"c", "aabb", 1e300, {1, 2}, {-1, 0}}};
  report.seconds = 0.25;
  return report;
}

TEST(Found, AsJson) {
  EXPECT_EQ(written(ReportFormat::json, report_of_a_ray()), R"({
  "schema": "graze.query/1",
  "scene": "s.json",
  "dimension": 2,
  "objects": 7,
  "not_read": [],
  "found": [
    {"name": "a,b", "type": "sphere", "t": 0.1, "point": [1, -2.5], "normal": [0, 1]},
    {"name": "c", "type": "aabb", "t": 1e+300, "point": [1, 2], "normal": [-1, 0]}
  ],
  "summary": {"found": 2, "seconds": 0.250000}
}
)");
  FoundReport empty;
  empty.head = {"s.json", 3, 0};
  EXPECT_NE(written(ReportFormat::json, empty).find("\"found\": [],\n"), std::string::npos);
}

TEST(Found, SaysInEveryFormatWhatWasNotRead) {
  FoundReport report;
  report.head = {"s.json", 2, 7, PairDetail::none, {{"curve", 2, Loss::shape}}};
  EXPECT_NE(written(ReportFormat::json, report).find(R"("not_read": [{"what": "curve", "count": 2)"),
            std::string::npos);
  EXPECT_EQ(written(ReportFormat::ndjson, report).find(R"({"not_read": {"what": "curve")"), 0U);
  EXPECT_EQ(written(ReportFormat::csv, report), "name,type\n2 x curve,not_read\n");
  EXPECT_EQ(written(ReportFormat::table, report), "not read: 2 x curve\n0 found; 7 objects, 0.000 seconds\n");
}

TEST(Found, AsLinesAndAsCsv) {
  FoundReport report = report_of_a_ray();
  report.objects.resize(1);
  EXPECT_EQ(written(ReportFormat::ndjson, report),
            "{\"name\": \"a,b\", \"type\": \"sphere\", \"t\": 0.1, \"point\": [1, -2.5], \"normal\": [0, 1]}\n");
  EXPECT_EQ(written(ReportFormat::csv, report), "name,type,t,x,y,normal_x,normal_y\n\"a,b\",sphere,0.1,1,-2.5,0,1\n");
  report.detail = FoundDetail::distance;
  EXPECT_EQ(written(ReportFormat::csv, report), "name,type,distance\n\"a,b\",sphere,0.1\n");
  report.detail = FoundDetail::none;
  EXPECT_EQ(written(ReportFormat::csv, report), "name,type\n\"a,b\",sphere\n");
}

TEST(Found, AsATableWithColumnsAsWideAsTheirText) {
  EXPECT_EQ(written(ReportFormat::table, report_of_a_ray()),
            "NAME  TYPE    T       POINT    NORMAL\n"
            "a,b   sphere  0.1     1, -2.5  0, 1\n"
            "c     aabb    1e+300  1, 2     -1, 0\n"
            "\n"
            "2 found; 7 objects, 0.250 seconds\n");
  FoundReport nothing;
  nothing.head = {"s.json", 2, 1};
  EXPECT_EQ(written(ReportFormat::table, nothing), "0 found; 1 object, 0.000 seconds\n");
}

TEST(Found, ATableHidesWhatATerminalWouldObeyAndMayBeBold) {
  FoundReport report;
  report.head = {"s.json", 2, 1};
  report.objects = {{"\x1b[2J", "point"}};
  EXPECT_NE(written(ReportFormat::table, report).find("\\x1b[2J"), std::string::npos);
  EXPECT_EQ(written(ReportFormat::table, report, Colours::on).find("\x1b[1mNAME"), 0U);
}

}  // namespace
}  // namespace graze::io::found_test
