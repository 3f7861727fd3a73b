// SPDX-License-Identifier: GPL-3.0-or-later
// What the documents point at exists: pictures, other documents, files of the project. Prose is wrapped.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
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
