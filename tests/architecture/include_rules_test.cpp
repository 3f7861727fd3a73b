// SPDX-License-Identifier: GPL-3.0-or-later
// The floors of the house, read off the include lines.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
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

/// A floor: its folders in the order of who uses whom, and what it sees of the floors below it.
struct Floor {
  std::string title;
  std::string root;                  ///< what its folders begin with
  std::vector<std::string> folders;  ///< below the root; empty text: the root itself
  std::vector<std::string> sees;     ///< beginnings of folders on lower floors; empty: all of them
};

/// The house from the ground up. A folder includes itself, the folders before it on its floor, and the floors
/// below. A new folder takes its place here; TORSIO_WRITE_TABLE=1 then writes the table of
/// docs/architecture.md anew.
const std::vector<Floor>& floors() {
  static const std::vector<std::string> kServices = {"sim", "assessment", "db", "app/services"};
  static const std::vector<std::string> kAllButFaces = {"sim",          "assessment",  "db",
                                                        "app/services", "app/outputs", "app/connectors"};
  static const std::vector<Floor> kFloors = {
      {"Simulator: ground", "sim/core", {""}, {}},
      {"Simulator: shapes and scans",
       "sim",
       {"geometry/mesh", "geometry/apart", "geometry/apart/host", "geometry/query", "geometry/lattice",
        "imaging/scan", "imaging/tool", "imaging/surface", "imaging/apart", "imaging/apart/host"},
       {}},
      {"Simulator: tissue",
       "sim",
       {"tissue/section", "tissue/view", "tissue/hollow", "tissue/twist", "tissue/rod", "baseline"},
       {"sim/core", "sim/geometry"}},
      {"Simulator: devices",
       "sim/device",
       {"safety", "", "virtual", "hdapi", "inverse3", "steering", "process", "process/host", "drivers"},
       {"sim/core"}},
      {"Simulator: recordings", "sim/record", {""}, {"sim/core"}},
      {"Simulator: scenes and servo", "sim", {"scene", "scene/skin", "servo"}, {}},
      {"Simulator: organs that are shipped", "sim/anatomy", {""}, {"sim/core", "sim/geometry"}},
      {"Assessment",
       "assessment",
       {"domain", "domain/study", "domain/people", "domain/rating", "statistics", "catalogue", "metrics",
        "scoring", "attempt", "results"},
       {"sim/core", "sim/record"}},
      {"Database",
       "db",
       {"connection", "repository/base", "migrations", "repository/people", "repository/study",
        "repository/rating", "repository/trial", "repository/system"},
       {"sim/core", "sim/record", "assessment"}},
      {"Services",
       "app/services",
       {"base", "comparison", "devices", "organs", "access", "scoring", "people", "recording", "study",
        "training", "review", "maintenance", "centres", "installation", "demonstration", "serving"},
       {}},
      {"Outputs", "app/outputs", {"wording", "charts", "pdf", "report", "tables", "dataset"}, {}},
      {"Connectors", "app/connectors", {""}, {"sim/core"}},
      {"Connectors", "app/connectors/mail", {""}, kServices},
      {"Connectors", "app/connectors/xapi", {""}, {"sim", "assessment", "db", "app/services", "app/outputs"}},
      {"Connectors", "app/connectors/tracker", {""}, kServices},
      {"Connectors",
       "app/connectors/foreign",
       {""},
       {"sim", "assessment", "db", "app/services", "app/outputs"}},
      {"Browser desk", "app/web", {"shapes", ""}, kAllButFaces},
      {"Command line",
       "app/cli",
       {""},
       {"sim", "assessment", "db", "app/services", "app/outputs", "app/connectors", "app/web"}},
      {"Window",
       "app/gui",
       {"widgets", "base", "scene", "simulator", "trainee", "physician", "administrator/base",
        "administrator/study", "administrator/curriculum", "administrator/people", "administrator/scoring",
        "administrator/reporting", "administrator/station", "administrator", "organ", "practice", "shell",
        "program"},
       {"sim", "assessment", "app/services", "app/outputs", "app/connectors"}},
      {"Program", "app", {""}, {"sim/core", "app/cli", "app/gui/program"}},
  };
  return kFloors;
}

/// Where a folder lies: number of its floor and place on it.
struct Place {
  std::size_t floor = 0;
  std::size_t order = 0;
};

std::map<std::string, Place> places() {
  std::map<std::string, Place> found;
  for (std::size_t floor = 0; floor < floors().size(); ++floor) {
    const Floor& level = floors()[floor];
    for (std::size_t order = 0; order < level.folders.size(); ++order) {
      const std::string& folder = level.folders[order];
      found[folder.empty() ? level.root : level.root + "/" + folder] = {floor, order};
    }
  }
  return found;
}

bool isWithin(const std::string& folder, const std::string& root) {
  return folder == root || folder.rfind(root + "/", 0) == 0;
}

/// Whether the rule of the floors lets a folder include another.
bool mayInclude(const std::map<std::string, Place>& place, const std::string& from, const std::string& to) {
  const Place& a = place.at(from);
  const Place& b = place.at(to);
  if (a.floor == b.floor) {
    return b.order <= a.order;
  }
  const std::vector<std::string>& sees = floors()[a.floor].sees;
  return b.floor < a.floor &&
         (sees.empty() ||
          std::any_of(sees.begin(), sees.end(), [&](const std::string& root) { return isWithin(to, root); }));
}

/// The sentence that a folder's CMakeLists.txt opens with, without what it uses: the floors say that.
std::string purposeOf(const std::string& folder) {
  std::ifstream in(kRoot / folder / "CMakeLists.txt");
  std::string line;
  std::getline(in, line);  // the licence
  std::string said;
  while (std::getline(in, line) && line.rfind("# ", 0) == 0) {
    said += (said.empty() ? "" : " ") + line.substr(2);
  }
  for (const char* const end : {". Uses", "; uses", ". The "}) {
    said = said.substr(0, said.find(end));
  }
  return said.empty() || said.back() != '.' ? said : said.substr(0, said.size() - 1);
}

/// The table of docs/architecture.md.
std::string tableOfFloors() {
  std::string table = "| folder | what lives there |\n|---|---|\n";
  std::string title;
  for (const Floor& floor : floors()) {
    if (floor.title != title) {
      table += "| **" + floor.title + "** | |\n";
      title = floor.title;
    }
    for (const std::string& below : floor.folders) {
      const std::string folder = below.empty() ? floor.root : floor.root + "/" + below;
      table += "| `" + folder + "` | " + purposeOf(folder) + " |\n";
    }
  }
  return table;
}

/// Library headers that stay inside one folder's .cpp files: prefix -> folders.
const std::map<std::string, std::set<std::string>>& privateLibraries() {
  static const std::map<std::string, std::set<std::string>> kPrivate = {
      {"assimp/", {"sim/geometry"}},
      {"fcl/", {"sim/geometry"}},
      {"dcmtk/", {"sim/imaging/scan"}},
      {"Eigen/", {"sim/baseline", "sim/geometry", "sim/tissue", "assessment/statistics"}},
      {"boost/", {"assessment/scoring", "assessment/statistics"}},
      {"zstd", {"app/connectors/foreign", "sim/record"}},
      {"QSql", {"db/connection"}},
      {"QtSql", {"db/connection"}},
      {"sqlite3", {"db/connection"}},
      {"QtCharts", {"app/outputs/charts", "app/outputs/pdf", "app/gui"}},
      {"sodium",
       {"sim/core", "db/repository/base", "db/repository/people", "app/services/access",
        "app/services/maintenance", "app/web"}},
      {"openssl/", {"db/repository/people", "app/services/maintenance"}},
      {"gnutls", {"app/web"}},
      {"qrencode", {"app/services/access"}},
      {"microhttpd", {"app/web"}},
      {"zlib", {"app/connectors/foreign", "app/web", "sim/imaging"}},
      {"CLI/", {"app/cli", "app/gui/program"}},
      {"curl/", {"app/connectors/mail", "app/services/base"}},
      {"qpdf/", {"app/outputs/pdf"}},
      {"xlsxwriter", {"app/outputs/tables"}},
      {"readstat", {"app/outputs/tables"}},
      {"SDL", {"sim/device/steering"}},
      {"spnav", {"sim/device/steering"}},
  };
  return kPrivate;
}

bool startsWith(const std::string& text, const std::string& prefix) {
  return text.rfind(prefix, 0) == 0;
}

bool isHeader(const std::string& file) {
  return file.size() > 2 && file.substr(file.size() - 2) == ".h";
}

TEST(IncludeRules, AFolderIncludesTheFloorsBelowItAndWhatStandsBeforeItOnItsOwn) {
  const std::map<std::string, Place> place = places();
  for (const Include& include : allIncludes()) {
    if (!include.quoted) {
      continue;
    }
    const std::string to = folderOf(include.target);
    ASSERT_TRUE(place.contains(include.folder)) << include.file << ": give its folder a place on a floor";
    ASSERT_TRUE(place.contains(to)) << include.file << " includes " << include.target;
    EXPECT_TRUE(mayInclude(place, include.folder, to))
        << include.file << " may not include " << include.target;
  }
}

TEST(IncludeRules, TheArchitectureShowsTheFloorsAsTheyAre) {
  const std::string begin = "<!-- floors -->\n";
  const std::string end = "<!-- end of floors -->\n";
  const fs::path path = kRoot / "docs/architecture.md";
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  const std::string document = text.str();
  const std::size_t from = document.find(begin);
  const std::size_t to = document.find(end);
  ASSERT_TRUE(from != std::string::npos && to != std::string::npos);

  const std::string written = document.substr(from + begin.size(), to - from - begin.size());
  if (std::getenv("TORSIO_WRITE_TABLE") != nullptr) {
    std::ofstream(path) << document.substr(0, from + begin.size()) << tableOfFloors() << document.substr(to);
    return;
  }
  EXPECT_EQ(written, tableOfFloors())
      << "write it anew: TORSIO_WRITE_TABLE=1 build/release/tests/architecture/architecture_test";
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

TEST(IncludeRules, EveryFolderSaysWhatLivesThere) {
  for (const auto& [folder, place] : places()) {
    EXPECT_FALSE(purposeOf(folder).empty()) << folder << "/CMakeLists.txt opens without a sentence";
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
      const bool ownToolkit = startsWith(include.folder, "app/gui") ||
                              startsWith(include.folder, "app/cli") ||
                              startsWith(include.folder, "app/outputs");
      if (!ownToolkit) {
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
