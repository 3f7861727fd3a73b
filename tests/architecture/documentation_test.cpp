// SPDX-License-Identifier: GPL-3.0-or-later
// What the documents point at exists: pictures, other documents, files of the project. Prose is wrapped.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> documents() {
  const fs::path root = TORSIO_SOURCE_DIR;
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(root)) {
    if (entry.path().extension() == ".md") {
      found.push_back(entry.path());
    }
  }
  for (const char* folder :
       {".github", "app", "assessment", "assets", "db", "docs", "sim", "tests", "tools"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() == ".md") {
        found.push_back(entry.path());
      }
    }
  }
  return found;
}

/// The targets of `[words](target)` that are paths, without what follows a `#`.
std::vector<std::string> linkedPaths(const fs::path& document) {
  std::ifstream in(document);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  static const std::regex kLink(R"(\]\(([^)\s#]+)(#[^)]*)?\))");
  std::vector<std::string> paths;
  for (std::sregex_iterator link(text.begin(), text.end(), kLink); link != std::sregex_iterator(); ++link) {
    if (const std::string target = (*link)[1]; target.find("://") == std::string::npos) {
      paths.push_back(target);
    }
  }
  return paths;
}

/// Number of characters (not bytes) of UTF-8 text.
std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
}

/// A line that is nothing but a link, a picture or an address: it cannot be wrapped.
bool isLinkOnly(const std::string& line) {
  static const std::regex kLinkOnly(R"(\s*([-*]|\d+\.)?\s*(!?\[[^\]]*\]\([^)]*\)|<?https?://\S+)[.:,;]?\s*)");
  return std::regex_match(line, kLinkOnly);
}

/// "12: the line" for each line of prose that is longer than `columns`. Tables, headings, code between
/// fences, indented code after an empty line, and lines that are only a link may be longer.
std::vector<std::string> longLinesOfProse(std::istream& document, std::size_t columns) {
  std::vector<std::string> found;
  bool fenced = false;
  bool mayBeCode = true;  // after an empty line, or within indented code
  std::size_t number = 0;
  for (std::string line; std::getline(document, line);) {
    ++number;
    const std::size_t begin = line.find_first_not_of(' ');
    if (begin == std::string::npos) {
      mayBeCode = true;
      continue;
    }
    if (line.compare(begin, 3, "```") == 0) {
      fenced = !fenced;
    }
    const bool code = fenced || (mayBeCode && begin >= 4);
    mayBeCode = code;
    const bool exempt = code || line[begin] == '|' || line[begin] == '#' || isLinkOnly(line);
    if (!exempt && characters(line) > columns) {
      found.push_back(std::to_string(number) + ": " + line);
    }
  }
  return found;
}

/// "Suite.Name" of every test of the project.
std::set<std::string> namesOfTests() {
  static const std::regex kTest(R"(\bTEST(?:_F|_P)?\((\w+),\s*(\w+)\))");
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(TORSIO_SOURCE_DIR) / "tests")) {
    if (entry.path().extension() != ".cpp") {
      continue;
    }
    std::ifstream in(entry.path());
    const std::string text(std::istreambuf_iterator<char>(in), {});
    for (std::sregex_iterator test(text.begin(), text.end(), kTest); test != std::sregex_iterator(); ++test) {
      names.insert((*test)[1].str() + "." + (*test)[2].str());
    }
  }
  return names;
}

TEST(SecurityPage, NamesOnlyTestsThatExist) {
  static const std::regex kNamed(R"(`([A-Z]\w+\.[A-Z]\w+)`)");
  const std::set<std::string> tests = namesOfTests();
  std::ifstream in(fs::path(TORSIO_SOURCE_DIR) / "docs" / "security.md");
  std::size_t promises = 0;
  bool table = false;
  for (std::string line; std::getline(in, line);) {
    table = line.starts_with("## ") ? line == "## Each promise and the test that holds it" : table;
    std::size_t named = 0;
    for (std::sregex_iterator name(line.begin(), line.end(), kNamed); name != std::sregex_iterator();
         ++name) {
      ++named;
      EXPECT_TRUE(tests.contains((*name)[1])) << (*name)[1] << " is no test: " << line;
    }
    const bool promise = table && line.starts_with("| ") && !line.starts_with("| promise");
    EXPECT_TRUE(!promise || named > 0) << "no test holds this: " << line;
    promises += promise ? 1 : 0;
  }
  EXPECT_GT(promises, 25U);
}

TEST(Documentation, TheRuleOfLongLinesFindsProseAndLeavesTablesAndCodeAlone) {
  const std::string filler(90, 'x');
  std::istringstream document("short\n" + filler + " prose that is too long\n" +    // line 2: found
                              "| " + filler + " | a row of a table |\n" +           //
                              "```\n" + filler + " code between fences\n```\n\n" +  //
                              "    " + filler + " indented code\n\n" +              //
                              "- a list\n" +                                        //
                              "    " + filler + " that goes on\n" +                 // line 11: found
                              "[" + filler + "](a/long/path/that/cannot/wrap.md)\n");

  const std::vector<std::string> found = longLinesOfProse(document, 100);

  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].rfind("2: ", 0), 0U) << found[0];
  EXPECT_EQ(found[1].rfind("11: ", 0), 0U) << found[1];
}

TEST(Documentation, ProseIsWrappedAtOneHundredColumns) {
  for (const fs::path& document : documents()) {
    std::ifstream in(document);
    for (const std::string& line : longLinesOfProse(in, 100)) {
      ADD_FAILURE() << document.string() << ":" << line;
    }
  }
}

TEST(Documentation, EveryLinkLeadsToAFile) {
  std::size_t links = 0;
  for (const fs::path& document : documents()) {
    for (const std::string& path : linkedPaths(document)) {
      ++links;
      EXPECT_TRUE(fs::exists(document.parent_path() / path))
          << document.string() << " points at " << path << ", which is not there";
    }
  }
  EXPECT_GT(links, 40U);  // the guide alone has more: the expression finds them
}

}  // namespace
