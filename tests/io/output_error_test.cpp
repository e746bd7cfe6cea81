// SPDX-License-Identifier: MIT
#include <type_traits>

#include <gtest/gtest.h>

#include <graze/io/input_error.hpp>
#include <graze/io/output_error.hpp>

namespace graze::io::output_error_test {
namespace {

TEST(OutputError, CarriesItsMessageAndIsNotAnInputError) {
  EXPECT_STREQ(OutputError("cannot write").what(), "cannot write");
  EXPECT_TRUE((std::is_base_of_v<std::runtime_error, OutputError>));
  EXPECT_FALSE((std::is_base_of_v<InputError, OutputError>));
}

}  // namespace
}  // namespace graze::io::output_error_test
