// SPDX-License-Identifier: GPL-3.0-or-later
// The arrow device -> servo -> tissue -> recorder -> db -> assessment -> report, read off the include lines.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

struct Include {
  std::string file;    // from the root
  std::string folder;  // of the including file: "sim/tissue"
  std::string target;  // what stands between the quotes or brackets
  bool quoted = false;
};

const fs::path kRoot = TORSIO_SOURCE_DIR;
const std::vector<std::string> kTopFolders = {"app", "sim", "assessment", "db"};

/// The first two levels of a path from the root: "app/session/x.h" gives "app/session"; "app/main.cpp" stays.
std::string folderOf(const std::string& path) {
  const std::size_t first = path.find('/');
  const std::size_t second = first == std::string::npos ? first : path.find('/', first + 1);
  return path.substr(0, second);
}

std::vector<Include> allIncludes() {
  static const std::regex kLine(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<Include> includes;
  for (const std::string& top : kTopFolders) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / top)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      const std::string file = fs::relative(entry.path(), kRoot).generic_string();
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        std::smatch match;
        if (std::regex_search(line, match, kLine)) {
          includes.push_back({file, folderOf(file), match[2].str(), match[1].str() == "\""});
        }
      }
    }
  }
  return includes;
}

/// Folders each folder may include, besides itself. docs/architecture.md draws the same table.
const std::map<std::string, std::set<std::string>>& allowed() {
  static const std::map<std::string, std::set<std::string>> kAllowed = {
      {"sim/base", {}},
      {"sim/geometry", {"sim/base"}},
      {"sim/imaging", {"sim/base", "sim/geometry"}},
      {"sim/tissue", {"sim/base", "sim/geometry"}},
      {"sim/device", {"sim/base"}},
      {"sim/record", {"sim/base"}},
      {"sim/scene", {"sim/base", "sim/geometry", "sim/tissue"}},
      {"sim/servo", {"sim/base", "sim/geometry", "sim/tissue", "sim/device", "sim/record", "sim/scene"}},
      {"assessment/scoring", {"sim/base"}},
      {"assessment/statistics", {"sim/base"}},
      {"assessment/metrics", {"sim/base", "sim/record", "assessment/statistics"}},
      {"assessment/attempt", {"sim/base", "sim/record", "assessment/statistics", "assessment/metrics"}},
      {"assessment/study", {"sim/base", "assessment/scoring", "assessment/statistics"}},
      {"assessment/report",
       {"sim/base", "sim/record", "assessment/scoring", "assessment/statistics", "assessment/metrics",
        "assessment/study"}},
      {"db/connection", {"sim/base"}},
      {"db/migrations", {"sim/base", "db/connection"}},
      {"db/repository",
       {"sim/base", "sim/record", "db/connection", "db/migrations", "assessment/scoring",
        "assessment/study"}},
      {"app/session",
       {"sim/base", "sim/geometry", "sim/tissue", "sim/device", "sim/record", "sim/scene", "sim/servo",
        "assessment/scoring", "assessment/statistics", "assessment/metrics", "assessment/attempt",
        "assessment/study", "assessment/report", "db/connection", "db/migrations", "db/repository",
        "app/report"}},
      {"app/report", {"sim/base", "assessment/report"}},
      {"app/cli",
       {"sim/base", "sim/geometry", "sim/tissue", "sim/record", "sim/scene", "assessment/scoring",
        "assessment/statistics", "assessment/metrics", "assessment/attempt", "assessment/study",
        "assessment/report", "app/session", "app/report"}},
      {"app/gui",
       {"sim/base", "sim/geometry", "sim/tissue", "sim/device", "sim/record", "sim/scene", "sim/servo",
        "assessment/scoring", "assessment/metrics", "assessment/attempt", "assessment/study",
        "assessment/report", "app/session", "app/report"}},
      {"app/main.cpp", {"app/cli", "app/gui", "app/session"}},
  };
  return kAllowed;
}

/// Library headers that stay inside one folder's .cpp files: prefix -> folders.
const std::map<std::string, std::set<std::string>>& privateLibraries() {
  static const std::map<std::string, std::set<std::string>> kPrivate = {
      {"assimp/", {"sim/geometry"}},
      {"fcl/", {"sim/geometry"}},
      {"Eigen/", {"sim/geometry", "sim/tissue", "assessment/statistics"}},
      {"boost/", {"assessment/scoring", "assessment/statistics"}},
      {"zstd", {"sim/record"}},
      {"QSql", {"db/connection"}},
      {"QtSql", {"db/connection"}},
      {"QtCharts", {"app/report", "app/gui"}},
      {"sodium", {"sim/base", "db/repository", "app/session"}},
      {"CLI/", {"app/cli"}},
  };
  return kPrivate;
}

bool startsWith(const std::string& text, const std::string& prefix) {
  return text.rfind(prefix, 0) == 0;
}

bool isHeader(const std::string& file) {
  return file.size() > 2 && file.substr(file.size() - 2) == ".h";
}

TEST(IncludeRules, EveryFolderIncludesOnlyWhatItMay) {
  for (const Include& include : allIncludes()) {
    if (!include.quoted) continue;
    const std::string to = folderOf(include.target);
    ASSERT_TRUE(allowed().contains(include.folder)) << include.file << ": folder without a row in the table";
    EXPECT_TRUE(to == include.folder || allowed().at(include.folder).contains(to))
        << include.file << " may not include " << include.target;
  }
}

TEST(IncludeRules, QuotedIncludesAreWrittenFromTheRootAndExist) {
  for (const Include& include : allIncludes()) {
    if (!include.quoted) continue;
    EXPECT_TRUE(fs::exists(kRoot / include.target) || startsWith(include.target, "ui_"))
        << include.file << " includes " << include.target;
  }
}

TEST(IncludeRules, LibrariesStayInsideTheFolderThatOwnsThem) {
  for (const Include& include : allIncludes()) {
    for (const auto& [prefix, folders] : privateLibraries()) {
      if (!startsWith(include.target, prefix)) continue;
      EXPECT_TRUE(folders.contains(include.folder))
          << include.file << " may not include <" << include.target << ">";
      if (include.folder != "app/gui" && include.folder != "app/report") {
        EXPECT_FALSE(isHeader(include.file)) << include.file << " shows <" << include.target << "> to others";
      }
    }
  }
}

TEST(IncludeRules, SimAndAssessmentKnowNoQt) {
  for (const Include& include : allIncludes()) {
    if (!startsWith(include.file, "sim/") && !startsWith(include.file, "assessment/")) continue;
    const bool qt = include.target.size() > 1 && include.target[0] == 'Q' &&
                    std::isupper(static_cast<unsigned char>(include.target[1])) != 0;
    EXPECT_FALSE(qt || startsWith(include.target, "Qt")) << include.file << " includes " << include.target;
  }
}

TEST(IncludeRules, NoQtTypeInThePublicHeadersOfTheDatabase) {
  for (const Include& include : allIncludes()) {
    if (!startsWith(include.file, "db/") || !isHeader(include.file)) continue;
    EXPECT_FALSE(startsWith(include.target, "Q")) << include.file << " includes " << include.target;
  }
}

TEST(SourceRules, EverySourceNamesItsLicenceInTheFirstLine) {
  std::vector<std::string> tops = kTopFolders;
  tops.push_back("tests");
  for (const std::string& top : tops) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / top)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") continue;
      std::ifstream in(entry.path());
      std::string first;
      std::getline(in, first);
      EXPECT_EQ(first, "// SPDX-License-Identifier: GPL-3.0-or-later") << entry.path();
    }
  }
}

TEST(SourceRules, TheTopLevelHoldsOnlyTheNamedFolders) {
  const std::set<std::string> expected = {"CMakeLists.txt",
                                          "CMakePresets.json",
                                          "README.md",
                                          "CHANGELOG.md",
                                          "LICENSE",
                                          "app",
                                          "sim",
                                          "assessment",
                                          "db",
                                          "assets",
                                          "tests",
                                          "docs",
                                          "tools",
                                          "CONTRIBUTING.md",
                                          "SECURITY.md",
                                          "CITATION.cff"};
  const std::set<std::string> ignored = {"build", "torsio-demo", "compile_commands.json"};
  for (const auto& entry : fs::directory_iterator(kRoot)) {
    const std::string name = entry.path().filename().string();
    if (name[0] == '.' || ignored.contains(name)) continue;
    EXPECT_TRUE(expected.contains(name)) << name;
  }
}

}  // namespace
