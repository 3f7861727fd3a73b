// SPDX-License-Identifier: GPL-3.0-or-later
// A comment of a public declaration is shown alone, in a tooltip: it begins with a verb or a noun that names
// its object, never with a word that points at the comment before.
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

/// "12: the line" for each block of `///` lines, and each `///<`, that begins with a word that needs the
/// comment before it.
std::vector<std::string> commentsThatPointElsewhere(std::istream& source) {
  static const std::regex kPoints(
      R"(\s*/// ?(The same|Same|As above|As before|See above|Likewise|Ditto|It|Its|They|Them|Those|These|This|That|Also|And|Then|\.\.\.)(\W.*)?)");
  static const std::regex kBeside(R"(.*///< ?(the same|as above|likewise)(\W.*)?)");
  static const std::regex kComment(R"(\s*///([^<].*)?)");
  std::vector<std::string> found;
  bool within = false;
  std::size_t number = 0;
  for (std::string line; std::getline(source, line);) {
    ++number;
    const bool comment = std::regex_match(line, kComment);
    const bool beside = std::regex_match(line, kBeside);
    if (beside || (comment && !within && std::regex_match(line, kPoints))) {
      found.push_back(std::to_string(number) + ": " + line);
    }
    within = comment;
  }
  return found;
}

TEST(Comments, TheRuleFindsWordsThatPointAtAnotherComment) {
  std::istringstream source(
      "/// Reads a file.\n"
      "void read();\n"
      "/// The same for a folder.\n"  // line 3: found
      "void readAll();\n"
      "/// Writes a file\n"
      "/// that exists already.\n"  // goes on a comment: not found
      "void write();\n"
      "  /// It closes the file.\n"  // line 8: found
      "  void close();  ///< that was read\n"
      "  int bytes = 0;  ///< read so far\n"
      "  int lines = 0;  ///< the same\n");  // line 11: found

  const std::vector<std::string> found = commentsThatPointElsewhere(source);

  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].rfind("3: ", 0), 0U) << found[0];
  EXPECT_EQ(found[1].rfind("8: ", 0), 0U) << found[1];
  EXPECT_EQ(found[2].rfind("11: ", 0), 0U) << found[2];
}

TEST(Comments, OfPublicHeadersCanBeUnderstoodAlone) {
  const fs::path root = TORSIO_SOURCE_DIR;
  std::size_t headers = 0;
  for (const char* folder : {"sim", "assessment"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".h") {
        continue;
      }
      ++headers;
      std::ifstream in(entry.path());
      for (const std::string& line : commentsThatPointElsewhere(in)) {
        ADD_FAILURE() << entry.path().string() << ":" << line;
      }
    }
  }
  EXPECT_GT(headers, 100U);  // sim and assessment have more: the folders were found
}

}  // namespace
