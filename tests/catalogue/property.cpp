// SPDX-License-Identifier: MIT
#include <functional>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "catalogue.hpp"

GRAZE_TEST_NUMBERS()

namespace graze::test {

void check_property(const std::function<void()>& property) { rc::detail::checkGTest(property); }

}  // namespace graze::test
