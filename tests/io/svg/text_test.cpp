// SPDX-License-Identifier: MIT
#include <clocale>
#include <string>

#include <gtest/gtest.h>
#include <pugixml.hpp>
#include <rapidcheck/gtest.h>

#include <graze/io/svg/text.hpp>

namespace graze::io::svg::svg_text_test {
namespace {

TEST(SvgText, escapes_what_xml_gives_a_meaning_to) {
  EXPECT_EQ(escaped("a <b> & \"c\" 'd'"), "a &lt;b&gt; &amp; &quot;c&quot; &apos;d&apos;");
  EXPECT_EQ(escaped("line\nfeed\ttab\rreturn"), "line&#10;feed&#9;tab&#13;return");
  EXPECT_EQ(escaped("Prüfstück 球 🎱"), "Prüfstück 球 🎱");
  EXPECT_EQ(escaped(""), "");
}

TEST(SvgText, replaces_what_xml_forbids) {
  EXPECT_EQ(escaped(std::string("a\0b\x01\x1f", 5)), "a\uFFFDb\uFFFD\uFFFD");
  EXPECT_EQ(escaped("\uFFFE\uFFFF\uFFFD"), "\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(escaped("\xff"), "\uFFFD");
  EXPECT_EQ(escaped("\xC3"), "\uFFFD");                      // cut off
  EXPECT_EQ(escaped("\xC0\x80"), "\uFFFD\uFFFD");            // overlong
  EXPECT_EQ(escaped("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");  // a surrogate
}

TEST(SvgText, shortens_by_characters_not_bytes) {
  EXPECT_EQ(shortened("abcdef", 6), "abcdef");
  EXPECT_EQ(shortened("abcdefg", 6), "abcde…");
  EXPECT_EQ(shortened("äöüß", 3), "äö…");
  EXPECT_EQ(shortened("ab", 1), "…");
  EXPECT_EQ(character_count("äö球🎱"), 4U);
}

TEST(SvgText, writes_numbers_short) {
  EXPECT_EQ(number(12.5), "12.5");
  EXPECT_EQ(number(3), "3");
  EXPECT_EQ(number(100), "100");
  EXPECT_EQ(number(0.0004), "0");
  EXPECT_EQ(number(-0.0004), "0");
  EXPECT_EQ(number(-7.1236), "-7.124");
}

TEST(SvgText, writes_numbers_with_a_point_in_every_locale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8", "C"}) {
    std::setlocale(LC_ALL, name);  // those that are not installed leave the locale as it is
    EXPECT_EQ(number(1234.5), "1234.5") << name;
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(SvgText, writes_lengths_for_people) {
  EXPECT_EQ(length_text(250), "250");
  EXPECT_EQ(length_text(0.05), "0.05");
  EXPECT_EQ(length_text(1e12), "1e+12");
  EXPECT_EQ(length_text(2e-9), "2e-09");
}

TEST(SvgText, counts_in_singular_and_plural) {
  EXPECT_EQ(counted(0, "pair"), "0 pairs");
  EXPECT_EQ(counted(1, "pair"), "1 pair");
  EXPECT_EQ(counted(2, "pair"), "2 pairs");
  EXPECT_EQ(counted(1, "touch", "touches"), "1 touch");
  EXPECT_EQ(counted(3, "touch", "touches"), "3 touches");
}

RC_GTEST_PROP(SvgText, escaped_bytes_of_any_kind_are_well_formed_xml, (const std::string& bytes)) {
  const std::string text = "<t a=\"" + escaped(bytes) + "\">" + escaped(bytes) + "</t>";
  pugi::xml_document document;
  RC_ASSERT(document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_ws_pcdata_single));
  const std::string content = document.child("t").child_value();
  RC_ASSERT(character_count(content) == character_count(bytes));
}

}  // namespace
}  // namespace graze::io::svg::svg_text_test
