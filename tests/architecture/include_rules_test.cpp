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
const std::vector<std::string> kTopFolders = {"app", "sim", "assessment", "db", "tools"};

/// The folder of a path from the root: "app/gui/base/x.h" gives "app/gui/base".
std::string folderOf(const std::string& path) {
  return path.substr(0, path.rfind('/'));
}

std::vector<Include> allIncludes() {
  static const std::regex kLine(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<Include> includes;
  for (const std::string& top : kTopFolders) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / top)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") {
        continue;
      }
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

/// Folders each folder may include, besides itself: what there is, and nothing else. A new arrow is a
/// decision, made here; docs/architecture.md draws the same table.
const std::map<std::string, std::set<std::string>>& allowed() {
  static const std::map<std::string, std::set<std::string>> kAllowed = {
      {"app", {"app/cli", "app/gui/program", "sim/core"}},
      {"app/access",
       {"app/base", "assessment/domain/people", "assessment/domain/study", "db/connection", "db/migrations",
        "db/repository/base", "db/repository/people", "db/repository/study", "db/repository/system",
        "sim/core"}},
      {"app/base", {"sim/core"}},
      {"app/cli",
       {"app/access",
        "app/base",
        "app/comparison",
        "app/demonstration",
        "app/devices",
        "app/exchange",
        "app/maintenance",
        "app/organs",
        "app/people",
        "app/recording",
        "app/report",
        "app/reporting",
        "app/study",
        "app/tracker",
        "app/web",
        "app/xapi",
        "assessment/attempt",
        "assessment/metrics",
        "assessment/domain/people",
        "assessment/results",
        "assessment/scoring",
        "assessment/statistics",
        "assessment/domain/study",
        "db/connection",
        "sim/core",
        "sim/baseline",
        "sim/device/drivers",
        "sim/geometry/mesh",
        "sim/imaging/apart",
        "sim/imaging/surface",
        "sim/record",
        "sim/scene",
        "sim/servo",
        "sim/tissue/hollow",
        "sim/tissue/rod",
        "sim/tissue/section",
        "sim/tissue/twist"}},
      {"app/comparison",
       {"app/base", "assessment/results", "sim/core", "sim/baseline", "sim/geometry/mesh", "sim/scene",
        "sim/tissue/view"}},
      {"app/demonstration",
       {"app/access",
        "app/base",
        "app/recording",
        "app/report",
        "app/scoring",
        "app/study",
        "assessment/attempt",
        "assessment/domain/people",
        "assessment/domain/rating",
        "assessment/results",
        "assessment/domain/study",
        "db/connection",
        "db/migrations",
        "db/repository/base",
        "db/repository/people",
        "db/repository/rating",
        "db/repository/study",
        "db/repository/system",
        "db/repository/trial",
        "sim/core",
        "sim/record",
        "sim/scene"}},
      {"app/devices",
       {"app/base", "assessment/results", "assessment/domain/study", "sim/core", "sim/device",
        "sim/device/drivers", "sim/device/safety", "sim/device/virtual", "sim/scene", "sim/servo"}},
      {"app/exchange",
       {"app/access",
        "app/base",
        "app/people",
        "app/recording",
        "app/reporting",
        "app/scoring",
        "app/study",
        "assessment/attempt",
        "assessment/metrics",
        "assessment/domain/people",
        "assessment/domain/rating",
        "assessment/results",
        "assessment/scoring",
        "assessment/domain/study",
        "db/connection",
        "db/migrations",
        "db/repository/base",
        "db/repository/people",
        "db/repository/rating",
        "db/repository/study",
        "db/repository/trial",
        "sim/core",
        "sim/record"}},
      {"app/gui/administrator",
       {"app/gui/administrator/curriculum", "app/gui/administrator/people", "app/gui/administrator/reporting",
        "app/gui/administrator/scoring", "app/gui/administrator/station", "app/gui/administrator/study",
        "app/gui/base", "app/gui/widgets"}},
      {"app/gui/administrator/base",
       {"app/access", "app/gui/base", "app/gui/widgets", "app/maintenance", "app/people", "app/report",
        "app/reporting", "app/study", "app/training", "assessment/metrics", "assessment/domain/people",
        "assessment/domain/rating", "assessment/domain/study", "sim/core"}},
      {"app/gui/administrator/curriculum",
       {"app/access", "app/base", "app/gui/administrator/base", "app/gui/base", "app/gui/widgets",
        "app/recording", "app/study", "assessment/statistics", "assessment/domain/study", "sim/core",
        "sim/scene"}},
      {"app/gui/administrator/people",
       {"app/access", "app/base", "app/gui/administrator/base", "app/gui/base", "app/gui/widgets",
        "app/maintenance", "app/people", "app/serving", "assessment/domain/people", "sim/core"}},
      {"app/gui/administrator/reporting",
       {"app/exchange", "app/gui/administrator/base", "app/gui/base", "app/gui/widgets", "app/report",
        "app/reporting", "app/study", "assessment/results", "sim/core"}},
      {"app/gui/administrator/scoring",
       {"app/access", "app/gui/administrator/base", "app/gui/base", "app/gui/physician", "app/gui/widgets",
        "app/mail", "app/people", "app/review", "app/study", "assessment/domain/people",
        "assessment/domain/rating", "sim/core"}},
      {"app/gui/administrator/station",
       {"app/access", "app/devices", "app/gui/administrator/base", "app/gui/base", "app/gui/widgets",
        "app/maintenance", "app/recording", "app/reporting", "app/tracker", "app/training", "app/xapi",
        "assessment/domain/people", "sim/core", "sim/device/drivers"}},
      {"app/gui/administrator/study",
       {"app/access", "app/devices", "app/gui/administrator/base", "app/gui/base", "app/gui/widgets",
        "app/study", "assessment/domain/rating", "assessment/statistics", "assessment/domain/study",
        "sim/core"}},
      {"app/gui/base",
       {"app/access", "app/base", "app/gui/widgets", "app/recording", "app/report",
        "assessment/domain/people", "assessment/results", "sim/core", "sim/scene"}},
      {"app/gui/organ",
       {"app/base", "app/gui/base", "app/gui/scene", "app/gui/widgets", "app/organs", "sim/core",
        "sim/geometry/mesh", "sim/imaging/apart", "sim/imaging/surface", "sim/scene"}},
      {"app/gui/physician",
       {"app/gui/base", "app/gui/scene", "app/gui/simulator", "app/gui/trainee", "app/gui/widgets",
        "app/recording", "app/review", "app/training", "assessment/attempt", "assessment/domain/rating",
        "assessment/scoring", "sim/core", "sim/tissue/hollow", "sim/tissue/perfusion"}},
      {"app/gui/practice",
       {"app/base", "app/comparison", "app/gui/base", "app/gui/organ", "app/gui/scene", "app/gui/simulator",
        "app/gui/trainee", "app/gui/widgets", "app/recording", "app/report", "app/tracker",
        "assessment/attempt", "sim/core", "sim/baseline", "sim/geometry/mesh", "sim/geometry/query",
        "sim/imaging/surface", "sim/scene"}},
      {"app/gui/program",
       {"app/access", "app/base", "app/demonstration", "app/gui/administrator", "app/gui/base",
        "app/gui/physician", "app/gui/practice", "app/gui/scene", "app/gui/shell", "app/gui/simulator",
        "app/gui/trainee", "app/gui/widgets", "app/recording", "app/report", "assessment/domain/people",
        "sim/core", "sim/device/virtual", "sim/scene"}},
      {"app/gui/scene",
       {"app/gui/widgets", "sim/core", "sim/device/virtual", "sim/geometry/apart", "sim/geometry/lattice",
        "sim/geometry/mesh", "sim/scene", "sim/scene/skin", "sim/servo", "sim/tissue/perfusion",
        "sim/tissue/twist"}},
      {"app/gui/shell",
       {"app/access", "app/base", "app/demonstration", "app/gui/base", "app/gui/scene", "app/gui/widgets",
        "app/maintenance", "app/recording", "app/xapi", "assessment/domain/people", "sim/core"}},
      {"app/gui/simulator",
       {"app/devices", "app/gui/base", "app/gui/scene", "app/gui/widgets", "app/recording", "app/report",
        "sim/core", "sim/device/virtual", "sim/record", "sim/scene", "sim/servo"}},
      {"app/gui/trainee",
       {"app/base",
        "app/demonstration",
        "app/devices",
        "app/gui/base",
        "app/gui/scene",
        "app/gui/simulator",
        "app/gui/widgets",
        "app/people",
        "app/recording",
        "app/tracker",
        "app/training",
        "assessment/attempt",
        "assessment/metrics",
        "assessment/domain/people",
        "assessment/domain/rating",
        "assessment/domain/study",
        "sim/core",
        "sim/device",
        "sim/device/virtual",
        "sim/scene",
        "sim/servo"}},
      {"app/gui/widgets", {"app/report", "sim/core"}},
      {"app/mail",
       {"app/access", "app/base", "app/study", "db/connection", "db/repository/people",
        "db/repository/system", "sim/core"}},
      {"app/maintenance",
       {"app/access", "app/base", "app/recording", "assessment/domain/people", "assessment/domain/study",
        "db/connection", "db/migrations", "db/repository/base", "db/repository/people",
        "db/repository/system", "db/repository/trial", "sim/core", "sim/record"}},
      {"app/organs", {"sim/core", "sim/scene", "sim/anatomy"}},
      {"app/people",
       {"app/access", "app/base", "assessment/domain/people", "db/connection", "db/repository/base",
        "db/repository/people", "sim/core"}},
      {"app/recording",
       {"app/access",
        "app/base",
        "app/devices",
        "assessment/attempt",
        "assessment/metrics",
        "assessment/results",
        "assessment/statistics",
        "assessment/domain/study",
        "db/connection",
        "db/migrations",
        "db/repository/base",
        "db/repository/study",
        "db/repository/trial",
        "sim/core",
        "sim/baseline",
        "sim/device",
        "sim/device/virtual",
        "sim/record",
        "sim/scene",
        "sim/servo"}},
      {"app/report", {"assessment/results", "sim/core"}},
      {"app/reporting",
       {"app/access",
        "app/base",
        "app/recording",
        "app/report",
        "app/scoring",
        "app/study",
        "assessment/attempt",
        "assessment/domain/people",
        "assessment/domain/rating",
        "assessment/results",
        "assessment/domain/study",
        "db/connection",
        "db/migrations",
        "db/repository/base",
        "db/repository/people",
        "db/repository/rating",
        "db/repository/study",
        "db/repository/trial",
        "sim/core",
        "sim/scene"}},
      {"app/review",
       {"app/access",
        "app/base",
        "app/recording",
        "app/study",
        "assessment/attempt",
        "assessment/domain/people",
        "assessment/domain/rating",
        "assessment/scoring",
        "assessment/statistics",
        "assessment/domain/study",
        "db/connection",
        "db/repository/base",
        "db/repository/people",
        "db/repository/rating",
        "db/repository/study",
        "db/repository/system",
        "db/repository/trial",
        "sim/core",
        "sim/record",
        "sim/scene"}},
      {"app/scoring",
       {"app/base", "assessment/domain/people", "assessment/domain/rating", "assessment/results",
        "assessment/scoring", "assessment/domain/study", "db/connection", "db/repository/base",
        "db/repository/people", "db/repository/rating", "db/repository/study", "sim/core"}},
      {"app/study",
       {"app/access", "app/base", "app/devices", "app/scoring", "assessment/metrics",
        "assessment/domain/people", "assessment/domain/rating", "assessment/statistics",
        "assessment/domain/study", "db/connection", "db/repository/base", "db/repository/people",
        "db/repository/rating", "db/repository/study", "db/repository/trial", "sim/core", "sim/scene"}},
      {"app/tracker", {"app/base", "app/recording", "assessment/results", "sim/core", "sim/record"}},
      {"app/training",
       {"app/access",
        "app/base",
        "app/devices",
        "app/recording",
        "app/study",
        "assessment/attempt",
        "assessment/metrics",
        "assessment/domain/people",
        "assessment/domain/rating",
        "assessment/statistics",
        "assessment/domain/study",
        "db/connection",
        "db/repository/base",
        "db/repository/people",
        "db/repository/rating",
        "db/repository/study",
        "db/repository/system",
        "db/repository/trial",
        "sim/core",
        "sim/record",
        "sim/scene",
        "sim/servo"}},
      {"app/xapi",
       {"app/access", "app/base", "app/exchange", "app/recording", "assessment/metrics",
        "assessment/domain/people", "db/connection", "db/repository/base", "db/repository/study",
        "db/repository/system", "db/repository/trial", "sim/core"}},
      {"app/serving", {"app/access", "db/connection", "sim/core"}},
      {"app/web",
       {"app/access",
        "app/base",
        "app/mail",
        "app/recording",
        "app/report",
        "app/review",
        "app/study",
        "app/training",
        "app/web/shapes",
        "assessment/attempt",
        "assessment/metrics",
        "assessment/domain/people",
        "assessment/domain/rating",
        "assessment/scoring",
        "db/connection",
        "sim/core",
        "sim/geometry/mesh",
        "sim/scene",
        "sim/scene/skin",
        "sim/servo",
        "sim/tissue/hollow"}},
      {"app/web/shapes", {"sim/core"}},
      {"assessment/attempt",
       {"assessment/metrics", "assessment/statistics", "assessment/domain/study", "sim/core", "sim/record"}},
      {"assessment/metrics", {"assessment/statistics", "sim/core"}},
      {"assessment/domain/people", {"assessment/domain/study", "sim/core"}},
      {"assessment/domain/rating", {"assessment/scoring", "assessment/domain/study", "sim/core"}},
      {"assessment/results",
       {"assessment/domain/rating", "assessment/scoring", "assessment/statistics", "sim/core"}},
      {"assessment/scoring", {"sim/core"}},
      {"assessment/statistics", {"sim/core"}},
      {"assessment/domain/study", {"assessment/scoring", "sim/core"}},
      {"db/connection", {"sim/core"}},
      {"db/migrations", {"db/connection", "db/repository/base", "sim/core"}},
      {"db/repository/base",
       {"assessment/domain/people", "assessment/domain/study", "db/connection", "sim/core"}},
      {"db/repository/people",
       {"assessment/domain/people", "db/connection", "db/repository/base", "sim/core"}},
      {"db/repository/rating",
       {"assessment/domain/people", "assessment/domain/rating", "assessment/scoring", "db/connection",
        "db/repository/base", "sim/core"}},
      {"db/repository/study",
       {"assessment/domain/people", "assessment/domain/study", "db/connection", "db/repository/base",
        "sim/core"}},
      {"db/repository/system",
       {"assessment/domain/people", "db/connection", "db/migrations", "db/repository/base",
        "db/repository/people", "db/repository/trial", "sim/core", "sim/record"}},
      {"db/repository/trial",
       {"assessment/attempt", "assessment/domain/people", "assessment/domain/rating", "assessment/scoring",
        "assessment/domain/study", "db/connection", "db/repository/base", "sim/core", "sim/record"}},
      {"sim/core", {}},
      {"sim/baseline",
       {"sim/core", "sim/geometry/lattice", "sim/geometry/mesh", "sim/tissue/rod", "sim/tissue/twist",
        "sim/tissue/view"}},
      {"sim/device", {"sim/core", "sim/device/safety"}},
      {"sim/device/drivers",
       {"sim/core", "sim/device", "sim/device/controller", "sim/device/inverse3", "sim/device/process",
        "sim/device/spacemouse", "sim/device/virtual"}},
      {"sim/device/controller", {"sim/core", "sim/device", "sim/device/steering"}},
      {"sim/device/spacemouse", {"sim/core", "sim/device", "sim/device/steering", "sim/device/virtual"}},
      {"sim/device/inverse3", {"sim/core", "sim/device", "sim/device/safety"}},
      {"sim/device/steering", {"sim/core", "sim/device"}},
      {"sim/device/hdapi", {"sim/core", "sim/device", "sim/device/safety"}},
      {"sim/device/process", {"sim/core", "sim/device", "sim/device/hdapi"}},
      {"sim/device/process/host",
       {"sim/core", "sim/device", "sim/device/hdapi", "sim/device/inverse3", "sim/device/process"}},
      {"sim/device/safety", {"sim/core"}},
      {"sim/device/virtual", {"sim/core", "sim/device"}},
      {"sim/geometry/apart", {"sim/core", "sim/geometry/mesh"}},
      {"sim/geometry/apart/host", {"sim/core", "sim/geometry/apart", "sim/geometry/mesh"}},
      {"sim/geometry/lattice", {"sim/core", "sim/geometry/mesh"}},
      {"sim/geometry/mesh", {"sim/core"}},
      {"sim/geometry/query", {"sim/core", "sim/geometry/mesh"}},
      {"sim/imaging/apart",
       {"sim/core", "sim/geometry/apart", "sim/geometry/mesh", "sim/imaging/scan", "sim/imaging/surface"}},
      {"sim/imaging/apart/host",
       {"sim/core", "sim/geometry/apart", "sim/imaging/apart", "sim/imaging/surface"}},
      {"sim/imaging/scan", {"sim/core"}},
      {"sim/imaging/surface", {"sim/core", "sim/geometry/mesh", "sim/imaging/scan", "sim/imaging/tool"}},
      {"sim/imaging/tool", {"sim/core", "sim/imaging/scan"}},
      {"sim/record", {"sim/core"}},
      {"sim/scene",
       {"sim/core", "sim/geometry/apart", "sim/geometry/lattice", "sim/geometry/mesh", "sim/geometry/query",
        "sim/imaging/apart", "sim/imaging/surface", "sim/imaging/tool", "sim/tissue/hollow",
        "sim/tissue/perfusion", "sim/tissue/rod", "sim/tissue/section", "sim/tissue/twist",
        "sim/tissue/view"}},
      {"sim/scene/skin", {"sim/core", "sim/geometry/lattice", "sim/geometry/mesh", "sim/scene"}},
      {"sim/servo",
       {"sim/core", "sim/device", "sim/device/safety", "sim/device/virtual", "sim/geometry/mesh",
        "sim/geometry/query", "sim/record", "sim/scene", "sim/tissue/hollow", "sim/tissue/perfusion",
        "sim/tissue/rod", "sim/tissue/twist"}},
      {"sim/tissue/reference", {"sim/core"}},
      {"sim/tissue/hollow", {"sim/core"}},
      {"sim/tissue/perfusion", {"sim/core"}},
      {"sim/tissue/rod",
       {"sim/core", "sim/geometry/lattice", "sim/geometry/mesh", "sim/tissue/section", "sim/tissue/twist"}},
      {"sim/tissue/section", {"sim/core"}},
      {"sim/tissue/twist",
       {"sim/core", "sim/geometry/lattice", "sim/tissue/reference", "sim/tissue/section", "sim/tissue/view"}},
      {"sim/tissue/view", {}},
      {"sim/anatomy", {"sim/core", "sim/geometry/mesh", "sim/geometry/query"}},
  };
  return kAllowed;
}

/// Library headers that stay inside one folder's .cpp files: prefix -> folders.
const std::map<std::string, std::set<std::string>>& privateLibraries() {
  static const std::map<std::string, std::set<std::string>> kPrivate = {
      {"assimp/", {"sim/geometry"}},
      {"fcl/", {"sim/geometry"}},
      {"dcmtk/", {"sim/imaging/scan"}},
      {"Eigen/", {"sim/baseline", "sim/geometry", "sim/tissue", "assessment/statistics"}},
      {"boost/", {"assessment/scoring", "assessment/statistics"}},
      {"zstd", {"sim/record"}},
      {"QSql", {"db/connection"}},
      {"QtSql", {"db/connection"}},
      {"QtCharts", {"app/report", "app/gui"}},
      {"sodium",
       {"sim/core", "db/repository/base", "db/repository/people", "app/access", "app/maintenance",
        "app/web"}},
      {"gnutls", {"app/web"}},
      {"qrencode", {"app/access"}},
      {"microhttpd", {"app/web"}},
      {"zlib", {"app/web", "sim/imaging"}},
      {"CLI/", {"app/cli"}},
      {"xlsxwriter", {"app/exchange"}},
      {"readstat", {"app/exchange"}},
      {"SDL", {"sim/device/controller"}},
      {"spnav", {"sim/device/spacemouse"}},
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
    if (!include.quoted) {
      continue;
    }
    const std::string to = folderOf(include.target);
    ASSERT_TRUE(allowed().contains(include.folder)) << include.file << ": folder without a row in the table";
    EXPECT_TRUE(to == include.folder || allowed().at(include.folder).contains(to))
        << include.file << " may not include " << include.target;
  }
}

TEST(IncludeRules, NothingOutsideItsFolderKnowsTheVendorOfADevice) {
  // Words of vendors and of their interfaces. What a person reads about a device comes from its driver.
  static const std::regex kVendor(
      R"(hdapi|openhaptics|libHD|phantom omni|3d systems|sdl|spnav|spacenav|spacemouse|3dconnexion|haply|inverse3)",
      std::regex::icase);
  for (const char* const top : {"app", "assessment", "db", "sim"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / top)) {
      const std::string file = fs::relative(entry.path(), kRoot).generic_string();
      const std::string extension = entry.path().extension().string();
      if ((extension != ".h" && extension != ".cpp") || startsWith(file, "sim/device/")) {
        continue;
      }
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        EXPECT_FALSE(std::regex_search(line, kVendor)) << file << ": " << line;
      }
    }
  }
}

TEST(IncludeRules, ADeviceIsOneFolderAndOneLineInTheList) {
  for (const Include& include : allIncludes()) {
    if (!include.quoted || !startsWith(include.target, "sim/device/")) {
      continue;
    }
    const std::string to = folderOf(include.target);
    // The servo borrows the safety and the simulated hands; the window feeds the pointer.
    const bool open = to == "sim/device" || to == "sim/device/drivers" || to == "sim/device/safety" ||
                      to == "sim/device/virtual";
    EXPECT_TRUE(open || startsWith(include.folder, "sim/device/")) << include.file << ": " << include.target;
  }
}

TEST(IncludeRules, NoFolderReachesItself) {
  std::map<std::string, std::set<std::string>> arrows;
  for (const Include& include : allIncludes()) {
    if (include.quoted && folderOf(include.target) != include.folder) {
      arrows[include.folder].insert(folderOf(include.target));
    }
  }
  // A folder whose arrows all lead to folders without arrows is taken away; what remains goes round in a
  // ring.
  for (bool taken = true; taken;) {
    taken = false;
    for (auto folder = arrows.begin(); folder != arrows.end();) {
      const bool free = std::none_of(folder->second.begin(), folder->second.end(),
                                     [&](const std::string& to) { return arrows.contains(to); });
      taken |= free;
      folder = free ? arrows.erase(folder) : std::next(folder);
    }
  }
  for (const auto& [folder, targets] : arrows) {
    ADD_FAILURE() << folder << " is in a ring, or leads to one";
  }
}

/// Every header that a file sees, directly or through others.
std::set<std::string> headersSeenBy(const std::string& file,
                                    const std::map<std::string, std::vector<std::string>>& includes) {
  std::set<std::string> seen;
  std::vector<std::string> waiting{file};
  while (!waiting.empty()) {
    const std::string next = waiting.back();
    waiting.pop_back();
    const auto found = includes.find(next);
    if (found == includes.end()) {
      continue;
    }
    for (const std::string& header : found->second) {
      if (seen.insert(header).second) {
        waiting.push_back(header);
      }
    }
  }
  return seen;
}

TEST(IncludeRules, TheWindowSeesNoHeaderOfTheDatabaseNotEvenThroughOthers) {
  // What a backup and a move to a server report are the only things that a page shows as db/ has them.
  const std::set<std::string> reports = {"db/migrations/backup.h", "db/repository/system/record_copy.h",
                                         "db/repository/system/schema_tables.h"};
  std::map<std::string, std::vector<std::string>> includes;
  for (const Include& include : allIncludes()) {
    if (include.quoted) {
      includes[include.file].push_back(include.target);
    }
  }

  std::size_t files = 0;
  for (const auto& [file, targets] : includes) {
    if (!startsWith(file, "app/gui/")) {
      continue;
    }
    ++files;
    for (const std::string& header : headersSeenBy(file, includes)) {
      EXPECT_TRUE(!startsWith(header, "db/") || reports.contains(header)) << file << " sees " << header;
    }
  }

  EXPECT_GT(files, 100U);
}

TEST(IncludeRules, EveryFolderIsATargetThatSaysWhatLivesThere) {
  for (const auto& [folder, targets] : allowed()) {
    if (folder == "app") {
      continue;  // main.cpp
    }
    std::ifstream in(kRoot / folder / "CMakeLists.txt");
    std::string licence;
    std::string sentence;
    std::getline(in, licence);
    std::getline(in, sentence);
    EXPECT_TRUE(startsWith(sentence, "# ")) << folder << "/CMakeLists.txt opens without a sentence";
  }
}

TEST(IncludeRules, QuotedIncludesAreWrittenFromTheRootAndExist) {
  for (const Include& include : allIncludes()) {
    if (!include.quoted) {
      continue;
    }
    EXPECT_TRUE(fs::exists(kRoot / include.target) || startsWith(include.target, "ui_"))
        << include.file << " includes " << include.target;
  }
}

TEST(IncludeRules, LibrariesStayInsideTheFolderThatOwnsThem) {
  for (const Include& include : allIncludes()) {
    for (const auto& [prefix, folders] : privateLibraries()) {
      if (!startsWith(include.target, prefix)) {
        continue;
      }
      const auto owner = [&](const std::string& folder) { return startsWith(include.folder, folder); };
      EXPECT_TRUE(std::any_of(folders.begin(), folders.end(), owner))
          << include.file << " may not include <" << include.target << ">";
      if (!startsWith(include.folder, "app/gui") && include.folder != "app/report") {
        EXPECT_FALSE(isHeader(include.file)) << include.file << " shows <" << include.target << "> to others";
      }
    }
  }
}

TEST(IncludeRules, SimAndAssessmentKnowNoQt) {
  for (const Include& include : allIncludes()) {
    if (!startsWith(include.file, "sim/") && !startsWith(include.file, "assessment/")) {
      continue;
    }
    const bool qt = include.target.size() > 1 && include.target[0] == 'Q' &&
                    std::isupper(static_cast<unsigned char>(include.target[1])) != 0;
    EXPECT_FALSE(qt || startsWith(include.target, "Qt")) << include.file << " includes " << include.target;
  }
}

TEST(IncludeRules, NoQtTypeInThePublicHeadersOfTheDatabase) {
  for (const Include& include : allIncludes()) {
    if (!startsWith(include.file, "db/") || !isHeader(include.file)) {
      continue;
    }
    EXPECT_FALSE(startsWith(include.target, "Q")) << include.file << " includes " << include.target;
  }
}

TEST(SourceRules, EverySourceNamesItsLicenceInTheFirstLine) {
  std::vector<std::string> tops = kTopFolders;
  tops.push_back("tests");
  for (const std::string& top : tops) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / top)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp") {
        continue;
      }
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
    if (name[0] == '.' || ignored.contains(name)) {
      continue;
    }
    EXPECT_TRUE(expected.contains(name)) << name;
  }
}

}  // namespace
