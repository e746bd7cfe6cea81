// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "scratch_folder.hpp"

namespace graze::io {

/// A temporary folder for a test, with a space and an umlaut in its name.
class TiledFolder : public test::ScratchFolder {
 public:
  TiledFolder() : ScratchFolder("graze h\xc3\xb6hle " + name_of_test()) {}

 private:
  static std::string name_of_test() {
    const auto& test = *testing::UnitTest::GetInstance()->current_test_info();
    return std::string(test.test_suite_name()) + "." + test.name();
  }
};

}  // namespace graze::io
