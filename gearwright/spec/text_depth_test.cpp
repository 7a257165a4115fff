// Laws: (1) the nesting is found behind every string, comment and name that may hide it; (2) such a
// text is an error of the reader instead of a stack overflow in the parser; (3) brackets and dots in
// strings and comments are not nesting.
#include "gearwright/spec/text_depth.hpp"

#include <gtest/gtest.h>

#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/rexs_file.hpp"

namespace gearwright {
namespace {

constexpr int kMany = 100'000;

std::string times(int n, std::string_view text) {
  std::string all;
  for (int i = 0; i < n; ++i) all += text;
  return all;
}

TEST(TextDepth, DeepTomlIsAnError) {  // (1), (2)
  const std::string name = times(kMany, ".a");
  const std::string list = "{a" + times(200, ".a") + " = [\n";
  for (const std::string& text :
       {"\na" + name + " = 1\n", "\n[a" + name + "]\n", "\n\"\\\"\"" + name + " = 1\n",
        "\n[\"\\\"\"" + name + "]\n", "\n'\\'" + name + " = 1\n",
        "x = {y = \"\"\"\n' \"\"\", a" + name + " = 1}\n",
        "x = {y = '''\n\" ''''', a" + name + " = 1}\n", "# \"\n\"#\"" + name + " = 1\n",
        "x = [\n" + times(120, list)}) {
    EXPECT_EQ(deep_toml_line(text, 256), text.starts_with("x = [") ? 3 : 2) << text.substr(0, 20);
    const auto read = parse_spec(text, SpecFormat::toml);
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().rule.find("nested more than"), std::string::npos) << read.error().rule;
    EXPECT_TRUE(place_of_key({"", text}, ""));
  }
}

TEST(TextDepth, StringsAndCommentsOfTomlDoNotCount) {  // (3)
  const std::string dots = times(kMany, ".[{");
  for (const std::string& text :
       {"a = \"\\\"" + dots + "\"\n", "a = '\\" + dots + "'", "# " + dots + "\na = 1\n",
        "a = \"\"\"\n" + dots + "\"" + dots + "\"\"\"\"\n", "a = '''" + dots + "'''''\n"}) {
    EXPECT_EQ(deep_toml_line(text, 1), std::nullopt) << text.substr(0, 10);
    EXPECT_TRUE(parse_spec(text, SpecFormat::toml)) << text.substr(0, 10);
  }
  EXPECT_EQ(deep_toml_line("a = [" + times(kMany, "[1.5, 2.5],\n") + "]\n", 3), std::nullopt);
  EXPECT_EQ(deep_toml_line(times(kMany, "[a.b]\nc.d = 1.5\n"), 2), std::nullopt);
  EXPECT_EQ(deep_toml_line(times(kMany, "]}"), 1), std::nullopt);
}

TEST(TextDepth, DeepXmlIsAnError) {  // (1), (2)
  for (const char* element :
       {"<a>", "<a x=\"/>\">", "<a x = '/>' y=\"/>\" >", "<a><!--</a>-->", "<a><!--></a>-->",
        "<a><![CDATA[</a>]]>", "<a><?b </a>?>", "<a\"><b\">", "<a=\">", "<a \"=\"/>\">",
        "<a><!DOCTYPE \">", "<a></b><a>"}) {
    const std::string text = times(kMany, element);
    EXPECT_TRUE(has_deep_elements(text, 32)) << element;
    const auto read = read_rexs(text);
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().rule.find("nested more than"), std::string::npos) << read.error().rule;
  }
}

TEST(TextDepth, ElementsWithoutContentAreNotDeep) {  // (3)
  for (const char* element : {"<a/>", "<a b='>'/>", "<a></a>", "<a>x</a >", "<!--<a>-->",
                              "<![CDATA[<a>]]>", "<?a <b>?>", "<a b=\"<c>\"/>"})
    EXPECT_FALSE(has_deep_elements("<r>" + times(kMany, element) + "</r>", 2)) << element;
  for (const char* broken : {"<", "<a", "<a ", "<a b", "<a b=", "<a b=c>", "<a b=\"", "<!--", "<?"})
    EXPECT_FALSE(has_deep_elements(broken, 0)) << broken;
}

}  // namespace
}  // namespace gearwright
