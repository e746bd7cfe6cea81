// SPDX-License-Identifier: MIT
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <graze/io/input_error.hpp>
#include <graze/io/tiled/xml_check.hpp>

namespace graze::io::xml_check_test {
namespace {

std::string error_of(std::string_view text) {
  try {
    require_well_formed_xml(text, "f.tmx");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(XmlCheck, AcceptsWhatXmlAllows) {
  for (const char* text :
       {"<a/>", " \n<a></a>\n ",
        "<?xml version=\"1.0\"?><!-- x --><a b='1' c=\"2\" ><!-- <a b b> & --></a><!-- y --><?p?><?xml-stylesheet?>",
        "<!DOCTYPE map SYSTEM \"http://mapeditor.org/dtd/1.0/map.dtd\">\n<map/>",
        "<!DOCTYPE a [<!ENTITY n \"x\">]><a>&lt;&#65;&#x41;&#x1F600;&quot;</a>", "<a><![CDATA[ & < ]]></a>",
        "<a b='>' c='/>' d = \"'\"/>", "<a\n b='1'\n/>", "<a x='1'><b x='2'/></a>"}) {
    EXPECT_EQ(error_of(text), "no error") << text;
  }
}

TEST(XmlCheck, RefusesASecondRootAndTextAroundTheFirst) {
  EXPECT_EQ(
      error_of("<a>\n</a>\n<b/>"),
      "f.tmx: line 3, column 1: element \"b\" is a second root; the first begins in line 1, and a file has only one");
  EXPECT_EQ(error_of("<a/>\n  garbage\n"),
            "f.tmx: line 2, column 3: \"garbage\" appears after the root element, where XML allows no text; remove it");
  EXPECT_EQ(error_of("x<a/>"),
            "f.tmx: line 1, column 1: \"x\" appears before the root element, where XML allows no text; remove it");
  EXPECT_EQ(error_of("<?xml version='1.0'?>\n<?xml version='1.0'?><a/>"),
            "f.tmx: line 2, column 1: an XML declaration is only allowed at the beginning of a file; "
            "remove it");
  EXPECT_EQ(error_of("<a/><![CDATA[]]>"),
            "f.tmx: line 1, column 5: there is a CDATA section outside the root element; remove it");
}

TEST(XmlCheck, RefusesAnAttributeThatIsGivenTwice) {
  EXPECT_EQ(error_of("<a>\n<b x='0' y='1' x='2'/></a>"),
            "f.tmx: line 2, column 16: the attribute \"x\" is given twice; remove one");
  EXPECT_EQ(error_of("<a><tile gid=\"1\"/>\n<tile gid=\"1\" gid=\"2\"/></a>"),
            "f.tmx: line 2, column 15: the attribute \"gid\" is given twice; remove one");
  EXPECT_EQ(error_of("<b x='0'y='1'/>"),
            "f.tmx: line 1, column 9: there is no blank between two attributes; insert one");
}

TEST(XmlCheck, RefusesReferencesThatNothingExpands) {
  EXPECT_EQ(
      error_of("<!DOCTYPE a [<!ENTITY n \"x\">]>\n<a b='&n;'/>"),
      "f.tmx: line 2, column 7: the entity \"&n;\" is not supported: graze reads &lt; &gt; &amp; &apos; &quot; and "
      "numbers such as &#65; only; write its text instead");
  EXPECT_NE(error_of("<a>&nbsp;</a>").find("the entity \"&nbsp;\" is not supported"), std::string::npos);
  for (const char* text : {"<a b='x & y'/>", "<a>&</a>", "<a>& ;</a>", "<a b='&lt'/>"}) {
    EXPECT_NE(error_of(text).find("write &amp; for the character itself"), std::string::npos) << text;
  }
  for (const char* text : {"<a>&#0;</a>", "<a>&#x110000;</a>", "<a>&#xD800;</a>", "<a>&#;</a>", "<a>&#6a;</a>"}) {
    EXPECT_NE(error_of(text).find("is not supported"), std::string::npos) << text;
  }
}

TEST(XmlCheck, RefusesCharactersThatXmlDoesNotAllow) {
  EXPECT_EQ(error_of("<a>\x01</a>"), "f.tmx: line 1, column 4: the character U+0001 is not allowed in XML; remove it");
  EXPECT_EQ(error_of(std::string_view("<a/>\0", 5)),
            "f.tmx: line 1, column 5: the character U+0000 is not allowed in XML; remove it");
  EXPECT_EQ(error_of("<a b='<'/>"), "f.tmx: line 1, column 7: an attribute's value contains \"<\"; write &lt; instead");
}

TEST(XmlCheck, LeavesWhatIsCutOffToTheParser) {
  for (const char* text : {"<", "<a", "<a b", "<a b=", "<a b='", "<!--", "<?", "<!DOCTYPE", "</", "<a/", ""}) {
    EXPECT_EQ(error_of(text), "no error") << text;
  }
  EXPECT_EQ(error_of("<a><![CDATA["), "no error");
}

}  // namespace
}  // namespace graze::io::xml_check_test
