// SPDX-License-Identifier: MIT
#include <type_traits>

#include <gtest/gtest.h>

#include <graze/io/input_error.hpp>
#include <graze/io/output_error.hpp>

namespace graze::io::input_error_test {
namespace {

TEST(InputError, CarriesItsMessageAndIsNotAnOutputError) {
  EXPECT_STREQ(InputError("level.json: this is empty").what(), "level.json: this is empty");
  EXPECT_TRUE((std::is_base_of_v<std::runtime_error, InputError>));
  EXPECT_FALSE((std::is_base_of_v<OutputError, InputError>));
}

}  // namespace
}  // namespace graze::io::input_error_test
