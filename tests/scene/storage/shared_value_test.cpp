// SPDX-License-Identifier: MIT
#include <string>

#include <gtest/gtest.h>

#include <graze/scene/storage/shared_value.hpp>

namespace graze::detail::shared_value_test {
namespace {

TEST(SharedValue, ACopyThatWasSharedStaysAsItIs) {
  SharedValue<std::string> value;
  value.change() = "old";
  const SharedValue<std::string> first = value.share();
  value.change() = "new";
  const SharedValue<std::string> second = value.share();
  value.change() = "newest";
  EXPECT_EQ(*first, "old");
  EXPECT_EQ(*second, "new");
  EXPECT_EQ(*value, "newest");
}

TEST(SharedValue, IsCopiedOnlyByTheFirstChange) {
  SharedValue<std::string> value;
  value.change() = "one";
  const std::string* before = &*value;
  const SharedValue<std::string> shared = value.share();
  EXPECT_EQ(&*shared, before);
  value.change();
  const std::string* after = &*value;
  EXPECT_NE(after, before);
  value.change();
  EXPECT_EQ(&*value, after);
}

TEST(SharedValue, AnOrdinaryCopyGoesItsOwnWay) {
  SharedValue<std::string> value;
  SharedValue<std::string> copy = value;
  copy.change() = "copy";
  EXPECT_TRUE(value->empty());
  value = copy;
  value.change() = "value";
  EXPECT_EQ(*copy, "copy");
}

TEST(SharedValue, ExchangesWithAnotherUnlessACopyReadsIt) {
  SharedValue<std::string> value;
  value.change() = "old";
  std::string other = "new";
  value.exchange(other);
  EXPECT_EQ(*value, "new");
  EXPECT_EQ(other, "old");
  const SharedValue<std::string> shared = value.share();
  other = "newest";
  value.exchange(other);
  EXPECT_EQ(*value, "newest");
  EXPECT_EQ(*shared, "new");
  EXPECT_TRUE(other.empty());
  const std::string* const own = &*value;
  value.change();
  EXPECT_EQ(&*value, own);
}

}  // namespace
}  // namespace graze::detail::shared_value_test
