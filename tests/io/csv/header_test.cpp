// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <graze/io/csv/header.hpp>

#include "io/scene_text.hpp"

namespace graze::io::csv_header_test {
namespace {

CsvColumns header(const std::string& line) {
  CsvRecords records(line, "a.csv");
  records.next();
  return read_csv_header({line, "a.csv"}, records.fields());
}

TEST(CsvHeader, SaysTheShapeTheDimensionAndThePlaces) {
  const CsvColumns boxes = header("max_y,max_x,min_y,min_x,id");
  EXPECT_EQ(boxes.shape, CsvShape::box);
  EXPECT_EQ(boxes.dimension, 2);
  EXPECT_EQ(boxes.count, 5U);
  EXPECT_EQ(boxes.numbers, (std::vector<std::size_t>{3, 2, 1, 0}));
  EXPECT_EQ(boxes.number_names, (std::vector<std::string>{"min_x", "min_y", "max_x", "max_y"}));
  EXPECT_EQ(boxes.id, 4U);
  EXPECT_FALSE(boxes.layer);
  const CsvColumns spheres = header("x,y,z,radius,layer");
  EXPECT_EQ(spheres.shape, CsvShape::sphere);
  EXPECT_EQ(spheres.dimension, 3);
  EXPECT_FALSE(spheres.id);
  EXPECT_EQ(spheres.layer, 4U);
  const CsvColumns capsules = header("ax,ay,az,bx,by,bz,radius");
  EXPECT_EQ(capsules.shape, CsvShape::capsule);
  EXPECT_EQ(capsules.numbers.size(), 7U);
  EXPECT_EQ(capsules.number_names.back(), "radius");
}

TEST(CsvHeader, TakesTheFirstKindThatHasAColumn) {
  EXPECT_EQ(header("x,y,radius,min_x,min_y,max_x,max_y").shape, CsvShape::box);
  EXPECT_EQ(header("x,y,radius,min_x,min_y,max_x,max_y").not_read.size(), 3U);
  EXPECT_EQ(header("x,y,radius,ax,ay,bx,by").shape, CsvShape::capsule);
}

TEST(CsvHeader, NamesWhatIsMissing) {
  EXPECT_EQ(error_of([] { header("a,b,c"); }),
            "a.csv: line 1, column 1: there is no column \"min_x\"; boxes need min_x, min_y, max_x, max_y; circles x, "
            "y, radius; capsules ax, ay, bx, by, radius; in 3D also those of z; id and layer are optional");
  EXPECT_EQ(error_of([] { header("AX,AY,BX,BY,radius"); }),
            "a.csv: line 1, column 1: there is no column \"ax\"; is it the one called \"AX\"?");
}

}  // namespace
}  // namespace graze::io::csv_header_test
