// SPDX-License-Identifier: GPL-3.0-or-later
// Files that mean harm where Torsio imports: a data set with its curriculum, a
// rubric, a map of recordings, a package of a site. Each is told in a sentence,
// within bounds of time and memory, and nothing of it is kept.
#include <algorithm>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/connectors/foreign/foreign_import.h"
#include "app/connectors/foreign/foreign_map.h"
#include "app/services/centres/site_package.h"
#include "app/services/study/rubric_service.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/app/outputs/dataset/foreign_readers.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/cost.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;
using testing::Cost;
using testing::OwnFolder;

constexpr double kLongest_s = 10.0;  // on a busy machine
constexpr std::int64_t kMaxMemory_bytes = 250'000'000;
constexpr std::size_t kTenMegabytes = 10'000'000;

using NamedText = std::pair<const char*, std::string>;

/// `field`: a text at the top level of this kind of file.
std::vector<NamedText> hostileTexts(const std::string& field) {
  const auto with = [&](const std::string& value) { return "{\"" + field + "\": " + value + "}"; };
  std::string objects;
  for (int i = 0; i < 200'000; ++i) {
    objects += "{\"a\":";
  }
  return {{"a million brackets", with(std::string(1'000'000, '['))},
          {"a million brackets, closed", with(std::string(1'000'000, '[') + std::string(1'000'000, ']'))},
          {"objects within each other", with(objects + "1" + std::string(200'000, '}'))},
          {"10 MB of free text", with("\"" + std::string(kTenMegabytes, 'x') + "\"")},
          {"10 MB of a name", "{\"" + std::string(kTenMegabytes, 'x') + "\": 1}"},
          {"10 MB of no JSON", std::string(kTenMegabytes, 'x')},
          {"10 MB of an unclosed text", "{\"" + std::string(kTenMegabytes, 'x')},
          {"20 MB of nothing", with("[" + std::string(20'000'000, ' ') + "]")},
          {"a number beyond all", with("1e999999")},
          {"NUL in a text", with("\"a\\u0000b\"")},
          {"a turned direction in a text", with("\"Arm \u202e A\"")},
          {"an invisible character in a text", with("\"Arm\u200b A\"")},
          {"a terminal's command", with("\"\\u001b[2J\"")},
          {"bytes that are not UTF-8", with("\"\xff\xfe\"")},
          {"half a surrogate", with("\"\\ud800\"")},
          {"NUL bytes", std::string(1'000, '\0')},
          {"nothing", ""}};
}

/// Reads something hostile and checks how it ends.
void expectTold(const std::string& name, const std::function<void()>& read) {
  SCOPED_TRACE(name);
  const Cost cost;
  std::string told;
  try {
    read();
    ADD_FAILURE() << "taken";
  } catch (const Error& error) {
    told = error.what();
  }
  std::cout << "  " << name << ": " << cost << ": " << told.substr(0, 160) << "\n";
  EXPECT_FALSE(told.empty());
  EXPECT_LT(told.size(), 1'000U);
  EXPECT_LT(cost.time_s(), kLongest_s);
  EXPECT_LT(cost.memory_bytes(), kMaxMemory_bytes);
}

TEST(HostileImport, AFileOfJsonIsToldInTimeWithLittleMemory) {
  const OwnFolder own;
  for (const auto& [name, text] : hostileTexts("format")) {
    expectTold(std::string("rubric, ") + name, [&] { (void)parseRubric(text, "r"); });
    const fs::path map = own.path() / "map.json";
    writeFileAtomically(map, text);
    expectTold(std::string("map, ") + name, [&] { (void)readForeignMap(map, ForeignLayout::kCsv); });
  }
}

/// The smallest study that is one, up to where `recording` is read.
std::string studyWith(const std::string& recording, const std::string& more = "") {
  return R"({"format": "torsio study 1", "cohort": {"name": "A", "description": ""}, "groups": [],
    "trainees": [{"code": "T-1", "group": "", "sex": "", "level": "", "state": "enrolled"}], "raters": [],
    "scale": {"lowest": 0, "highest": 100, "steps_per_point": 1}, "occasions": [], "marks": [],
    "exposures": [], "deviations": [], )" +
         more + R"("recordings": [{"file": ")" + recording + R"(", "trainee": "T-1"}]})";
}

TEST(HostileImport, ADataSetIsToldAndNothingOfItIsKept) {
  const OwnFolder own;
  const fs::path set = own.path() / "set";
  fs::create_directories(set / "recordings");
  StudyCentre centre;
  const auto before = centre.rowCounts();
  const auto expectRefused = [&](const std::string& name, const std::string& study) {
    writeFileAtomically(set / "study.json", study);
    expectTold("data set, " + name,
               [&] { (void)importDataset(centre.as("administrator"), set, centre.assets(), ""); });
  };
  for (const auto& [name, text] : hostileTexts("format")) {
    expectRefused(name, text);
    writeFileAtomically(set / "curriculum.json", text);
    expectRefused(std::string("curriculum, ") + name,
                  studyWith("", R"("curriculum": {"name": "A", "description": ""},)"));
  }
  writeFileAtomically(own.path() / "outside.torsio", "not yours");
  fs::create_symlink(own.path() / "outside.torsio", set / "recordings" / "link.torsio");
  for (const std::string& file :
       {std::string("../outside.torsio"), std::string("recordings/../../outside.torsio"),
        (own.path() / "outside.torsio").string(), std::string("/dev/zero"), std::string("/etc/passwd"),
        std::string("recordings/link.torsio"), std::string("..\\\\outside.torsio"), std::string("."),
        std::string(""), std::string("recordings/none\\u0000.torsio")}) {
    expectRefused("a recording named " + file, studyWith(file));
  }
  writeFileAtomically(set / "recordings" / "huge.torsio", std::string(kTenMegabytes, '\xff'));
  expectRefused("a recording of noise", studyWith("recordings/huge.torsio"));
  expectRefused("an origin of a million brackets",
                studyWith("recordings/huge.torsio",
                          "\"origin\": " + std::string(1'000'000, '[') + std::string(1'000'000, ']') + ","));
  EXPECT_EQ(centre.rowCounts(), before);
}

TEST(HostileImport, AFileOutsideTheDataSetIsSaidToBeOutside) {
  const OwnFolder own;
  const fs::path set = own.path() / "set";
  fs::create_directories(set);
  StudyCentre centre;
  for (const char* file : {"../outside.torsio", "/dev/zero"}) {
    writeFileAtomically(set / "study.json", studyWith(file));
    try {
      (void)importDataset(centre.as("administrator"), set, centre.assets(), "");
      ADD_FAILURE() << "taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.happened(), "the study names a file outside its data set");
    }
  }
}

TEST(HostileImport, APackageOfASiteIsToldInTimeWithLittleMemory) {
  const OwnFolder own;
  const fs::path file = own.path() / "a.torsio-site";
  const auto number = [](std::uint64_t value, int bytes) {
    std::string out;
    for (int i = 0; i < bytes; ++i) {
      out += static_cast<char>((value >> (8 * i)) & 0xFFU);
    }
    return out;
  };
  const auto text = [&](const std::string& words) { return number(words.size(), 4) + words; };
  const std::string magic = "torsio-site 1\n";
  std::string tables;
  for (int i = 0; i < 100'000; ++i) {
    tables += "T" + text("table" + std::to_string(i)) + number(1, 2) + text("id");
  }
  const std::vector<NamedText> hostile{
      {"another file", std::string(kTenMegabytes, 'x')},
      {"nothing", ""},
      {"a table of four billion bytes", magic + "T" + number(0xFFFFFFFFU, 4)},
      {"a table of 65,535 columns", magic + "T" + text("trial") + number(0xFFFFU, 2)},
      {"a value of four billion bytes", magic + "T" + text("trial") + number(1, 2) + text("id") + "R" +
                                            text("") + "\x03" + number(0xFFFFFFFFU, 4)},
      {"a table named ../../etc", magic + "T" + text("../../etc") + number(1, 2) + text("id")},
      {"a hundred thousand tables", magic + tables},
      {"a manifest of a million brackets", magic + "M" + text(std::string(1'000'000, '[')) + "S" + text("")},
      {"a manifest of 10 MB", magic + "M" + text(std::string(kTenMegabytes, 'x')) + "S" + text("")},
      {"a manifest with NUL",
       magic + "M" + text(std::string("{\"centre\": {\"name\": \"a\0b\"}}", 28)) + "S" + text("")},
  };
  for (const auto& [name, bytes] : hostile) {
    writeFileAtomically(file, bytes);
    expectTold(std::string("site package, ") + name, [&] { (void)checkSitePackage(file); });
  }
  expectTold("site package, /dev/zero", [] { (void)checkSitePackage("/dev/zero"); });
}

}  // namespace
}  // namespace torsio
