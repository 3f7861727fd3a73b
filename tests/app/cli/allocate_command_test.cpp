// SPDX-License-Identifier: GPL-3.0-or-later
// torsio allocate and --replay: which changes of a file are detected, and how.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/maintenance/signing_key.h"
#include "sim/core/error.h"
#include "tests/app/cli/table_commands.h"

namespace torsio {
namespace {

using nlohmann::json;

/// Commands of a station without settings.
class AllocateCommand : public TableCommands {
 protected:
  void SetUp() override { setenv("XDG_CONFIG_HOME", (folder_ / "settings").c_str(), 1); }
  void TearDown() override { unsetenv("XDG_CONFIG_HOME"); }

  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::string design() const {
    return write("design.json",
                 R"({"study": "S1", "arms": ["1", "2", "3"], "persons": [)" + personList() + "]}");
  }
  /// Creates a key; returns its public part.
  [[nodiscard]] std::string key(const std::string& name) const {
    EXPECT_EQ(runTorsio("audit key " + file(name), folder_).code, 0);
    return publicOf(readKey(file(name)));
  }
  [[nodiscard]] json replayed(const json& allocation, const std::string& options = {}, int code = 0) const {
    return answer("allocate --replay " + write("kept.json", allocation.dump()) + options, code);
  }
  /// Error message of a replay.
  [[nodiscard]] std::string refusal(const json& allocation, const std::string& options = {}) const {
    const json out = replayed(allocation, options, static_cast<int>(ErrorCode::kVerifyFailed));
    EXPECT_FALSE(out.value("sound", true));
    return out.value("reason", "");
  }

  void expectAlike(const std::string& order, const std::string& words) const {
    expectRefused("allocate --seed 1 --design " + write("alike.json", order), {words});
  }

  static std::string personList() {
    std::string list;
    for (int i = 1; i <= 30; ++i) {
      list.append(i > 1 ? ", \"P" : "\"P").append(std::to_string(i)).append("\"");
    }
    return list;
  }

  static std::string armsOf(const json& allocation) {
    std::string arms;
    for (const json& record : allocation["records"]) {
      arms += record["arm"].get<std::string>();
    }
    return arms;
  }
};

TEST_F(AllocateCommand, NamesThatLookAlikeAreRefused) {
  expectAlike(R"({"study": "S1", "arms": ["A", "a"], "participants": 2, "persons": ["P1", "P2"]})",
              "arm \"a\" looks like \"A\"");
  expectAlike(R"({"study": "S1", "arms": ["A", "B"], "participants": 2, "persons": ["P1", "P\uff11"]})",
              "persons[0]");
  expectAlike(R"({"study": "S1", "arms": ["A", "B\u0007"], "participants": 2, "persons": ["P1", "P2"]})",
              "invisible character U+0007");
}

TEST_F(AllocateCommand, ReproducesThePermutationOfItsSeedAndReplaysIt) {
  // mt19937_64 with seed 20240601, Fisher-Yates from the end; checked by an independent program.
  const std::string design =
      write("design.json",
            R"({"study": "S1", "method": "complete permutation", "arms": ["1", "2", "3"], "persons": [)" +
                personList() + "]}");
  const ProgramRun run = runTorsio("allocate --seed 20240601 --design " + design, folder_);
  ASSERT_EQ(run.code, 0) << run.err;
  json allocation = json::parse(run.out);
  EXPECT_EQ(armsOf(allocation), "111223221333311211322231233321");
  EXPECT_EQ(allocation["counts"]["2"], 10);
  const json replay = answer("allocate --replay " + write("kept.json", run.out));
  EXPECT_TRUE(replay["sound"].get<bool>());
  EXPECT_EQ(replay["records"], 30);

  allocation["records"][4]["arm"] = "1";
  const json forged = answer("allocate --replay " + write("forged.json", allocation.dump()),
                             static_cast<int>(ErrorCode::kVerifyFailed));
  EXPECT_FALSE(forged["sound"].get<bool>());
  EXPECT_EQ(forged["first_wrong_position"], 4);
}

TEST_F(AllocateCommand, SaltsItsCommitmentAndDetectsTruncationAndWrongCounts) {
  const std::string design =
      write("design.json", R"({"study": "S1", "arms": ["1", "2", "3"], "persons": [)" + personList() + "]}");
  const json first = answer("allocate --seed 5 --design " + design);
  const json second = answer("allocate --seed 5 --design " + design);
  EXPECT_EQ(first["salt"].get<std::string>().size(), 64U);
  EXPECT_NE(first["salt"], second["salt"]);
  EXPECT_NE(first["commitment"], second["commitment"]);
  EXPECT_EQ(armsOf(first), armsOf(second));
  EXPECT_EQ(answer("allocate --seed 5 --salt " + first["salt"].get<std::string>() + " --design " + design),
            first);
  const auto found = [&](const json& changed, const std::string& head = {}) {
    return answer("allocate --replay " + write("changed.json", changed.dump()) +
                      (head.empty() ? "" : " --head '" + head + "'"),
                  static_cast<int>(ErrorCode::kVerifyFailed))["reason"]
        .get<std::string>();
  };

  json cut = first;
  cut["records"].erase(29);
  EXPECT_NE(found(cut).find("cut off"), std::string::npos);
  json counted = first;
  counted["counts"]["2"] = 11;
  EXPECT_NE(found(counted).find("counts"), std::string::npos);
  EXPECT_NE(found(second, first["head"].get<std::string>()).find("head"), std::string::npos);
  const ProgramRun badSalt = runTorsio("allocate --seed 5 --salt abc --design " + design, folder_);
  EXPECT_EQ(badSalt.code, static_cast<int>(ErrorCode::kUsage));
}

TEST_F(AllocateCommand, StratifiesByFactors) {
  // Order of sexes and blocks of three from the same reference, without joint remainders.
  const std::string sexes = "MMFMFMMFFMMFMFMMFFMMFMMFMFMMFF";
  std::string persons;
  for (std::size_t i = 0; i < sexes.size(); ++i) {
    persons += std::string(i > 0 ? "," : "") + R"({"code": "P)" + std::to_string(i) +
               R"(", "levels": {"sex": ")" + sexes[i] + R"("}})";
  }
  const std::string design =
      write("strata.json",
            R"({"study": "S", "method": "stratified blocks", "arms": ["1", "2", "3"], "block_sizes": [3],
          "factors": [{"name": "sex", "levels": ["M", "F"]}], "joint_leftovers": false, "persons": [)" +
                persons + "]}");
  const ProgramRun run = runTorsio("allocate --seed 20240601 --design " + design, folder_);
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(armsOf(json::parse(run.out)), "122313131223321323121131223133");
  EXPECT_TRUE(answer("allocate --replay " + write("strata-kept.json", run.out))["sound"].get<bool>());
}

TEST_F(AllocateCommand, RejectsInvalidDesigns) {
  const auto refused = [&](const std::string& text, const std::string& mention) {
    const ProgramRun run = runTorsio("allocate --seed 1 --design " + write("bad.json", text), folder_);
    EXPECT_NE(run.code, 0);
    EXPECT_LT(run.code, 70) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_NE(run.err.find(mention), std::string::npos) << run.err;
  };
  refused("{", "JSON");
  refused("[]", "bad.json");
  refused(R"({"study": "S", "arms": ["1"], "persons": ["a"]})", "two arms");
  refused(R"({"study": "S", "arms": ["1", "2"], "persons": ["a", "b", "c"]})", "multiple");
  refused(R"({"study": "S", "arms": ["1", "2"], "persons": ["a", "a"]})", "a");
  refused(R"({"study": "S", "arms": ["1", "2"], "persons": "a"})", "persons");
  refused(R"({"study": "S", "arms": ["1", 2], "persons": ["a", "b"]})", "arms");
  refused(R"({"study": "S", "arms": ["1", "2"], "person": ["a", "b"]})", "persons");
  for (const char* seed : {"-1", "18446744073709551616", "1e3", "0x10", ""}) {
    const ProgramRun run = runTorsio("allocate --design x.json --seed '" + std::string(seed) + "'", folder_);
    EXPECT_EQ(run.code, static_cast<int>(ErrorCode::kUsage)) << seed;
    EXPECT_EQ(run.out, "");
  }
  const ProgramRun noSeed = runTorsio("allocate --design x.json", folder_);
  EXPECT_EQ(noSeed.code, static_cast<int>(ErrorCode::kUsage));
}

TEST_F(AllocateCommand, SignsTheHeadAndReplayNamesTheKey) {
  const std::string owner = key("key");
  const json made = answer("allocate --seed 5 --key " + file("key") + " --design " + design());
  const std::string head = made["head"].get<std::string>();
  EXPECT_NE(head.find(" 30 "), std::string::npos);  // number of records
  EXPECT_NE(head.find(" " + owner + " "), std::string::npos);

  const json named = replayed(made, " --key " + file("key"));
  EXPECT_EQ(named["signature"]["state"], "genuine");
  EXPECT_EQ(named["signature"]["key"], owner);
  EXPECT_EQ(named["signature"]["compared_with"], owner);
  EXPECT_GT(named["signature"]["signed_utc_us"].get<std::int64_t>(), 0);
  EXPECT_EQ(named["not_checked"], json({"head kept elsewhere"}));
  EXPECT_EQ(named["head"], head.substr(0, head.find(' ', head.find(" 30 ") + 4)));
  EXPECT_EQ(replayed(made, " --public-key " + owner)["signature"]["state"], "genuine");

  std::string capitals = owner;
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  EXPECT_EQ(replayed(made, " --public-key " + capitals)["signature"]["state"], "genuine");

  const json unknown = replayed(made);
  EXPECT_EQ(unknown["signature"]["state"], "genuine, key not known");
  EXPECT_TRUE(unknown["signature"]["compared_with"].is_null());
  EXPECT_NE(unknown["signature"]["means"].get<std::string>().find("--public-key"), std::string::npos);
}

TEST_F(AllocateCommand, ReplayNamesTheManipulationOfASignedFile) {
  const std::string owner = key("key");
  const std::string byOwner = " --public-key " + owner;
  const std::string call = "allocate --seed 5 --design " + design() + " --key ";
  const json made = answer(call + file("key"));
  const auto told = [&](const json& changed, const std::string& word, const std::string& options = {}) {
    const std::string reason = refusal(changed, byOwner + options);
    EXPECT_NE(reason.find(word), std::string::npos) << reason;
  };

  json cut = made;
  cut["records"].erase(29);
  cut["counts"] = json::object();
  told(cut, "cut off");
  cut["head"] = "torsio-allocation 1 29 " + std::string(64, '0');  // the attacker writes another head
  told(cut, "cut off");
  json counted = made;
  counted["counts"]["2"] = 11;
  told(counted, "counts");

  // The file contains seed and salt: swap two persons and rewrite everything.
  const std::string people = personList();
  std::string swapped = people;
  swapped.replace(swapped.find("\"P1\", \"P2\""), 10, "\"P2\", \"P1\"");
  write("design.json", R"({"study": "S1", "arms": ["1", "2", "3"], "persons": [)" + swapped + "]}");
  const std::string again =
      "allocate --seed 5 --salt " + made["salt"].get<std::string>() + " --design " + file("design.json");
  const json unsignedAnew = answer(again);
  told(unsignedAnew, "not signed");
  EXPECT_TRUE(replayed(unsignedAnew)["sound"].get<bool>());  // undetectable without a key
  EXPECT_EQ(replayed(unsignedAnew)["signature"]["state"], "none");
  (void)key("foreign");
  const json foreignAnew = answer(again + " --key " + file("foreign"));
  told(foreignAnew, "not signed by this key");
  json lent = unsignedAnew;
  lent["head"] = made["head"];
  told(lent, "persons changed places");

  std::string line = made["head"].get<std::string>();
  json aged = made;
  aged["head"] =
      line.replace(line.find(" " + owner) - 1, 1, line[line.find(" " + owner) - 1] == '0' ? "1" : "0");
  told(aged, "not genuine");
  json shortened = made;
  shortened["head"] = made["head"].get<std::string>().substr(0, made["head"].get<std::string>().size() - 9);
  told(shortened, "not genuine");
  EXPECT_NE(refusal(shortened).find("not genuine"), std::string::npos);  // even without a key
}

TEST_F(AllocateCommand, WithoutASignatureReplayStatesWhatItCannotCheck) {
  const json old = answer("allocate --seed 5 --design " + design());
  const json replay = replayed(old);
  EXPECT_EQ(replay["signature"]["state"], "none");
  EXPECT_NE(replay["signature"]["means"].get<std::string>().find("not signed"), std::string::npos);
  EXPECT_EQ(replay["not_checked"], json({"head kept elsewhere", "signature"}));
  json headless = old;
  headless.erase("head");
  headless["records"].erase(29);
  headless.erase("counts");
  EXPECT_EQ(replayed(headless)["not_checked"],
            json({"counts", "head in the file", "head kept elsewhere", "signature"}));
  const std::string kept = " --head '" + old["head"].get<std::string>() + "'";
  EXPECT_NE(refusal(headless, kept).find("cut off"), std::string::npos);
  EXPECT_NE(runTorsio("allocate --seed 5 --design " + design(), folder_).err.find("not signed"),
            std::string::npos);
}

TEST_F(AllocateCommand, TheStationsKeySignsAndAHeadOfAReplacedKeyStaysValid) {
  const std::string first = key("first");
  ASSERT_EQ(runTorsio("audit station --key " + file("first") + " --witness " + file("heads"), folder_).code,
            0);
  const json made = answer("allocate --seed 5 --design " + design());
  EXPECT_EQ(replayed(made)["signature"]["compared_with"], first);
  EXPECT_EQ(replayed(made)["signature"]["state"], "genuine");

  // Replaces the station's key, like torsio audit key NEW --replaces OLD.
  const auto signedAt = replayed(made)["signature"]["signed_utc_us"].get<std::int64_t>();
  KeyReplacement line{.old = first, .length = 0, .utc_us = 1};
  const SecretKey fresh = drawKey();
  line.fresh = publicOf(fresh);
  const auto replace = [&](std::int64_t utc_us) {
    line.utc_us = utc_us;
    line.signatureOfOld = signedWith(readKey(file("first")), line.signedText());
    line.signatureOfFresh = signedWith(fresh, line.signedText());
    writeKey(file("second"), fresh, line.line());
    EXPECT_EQ(runTorsio("audit station --key " + file("second"), folder_).code, 0);
  };
  replace(signedAt + 1);
  EXPECT_EQ(replayed(made)["signature"]["state"], "genuine");
  EXPECT_EQ(replayed(made)["signature"]["compared_with"], line.fresh);
  replace(signedAt - 1);  // signed after the key was replaced
  EXPECT_NE(refusal(made).find("not in use"), std::string::npos);

  (void)key("foreign");
  const json foreign = answer("allocate --seed 5 --key " + file("foreign") + " --design " + design());
  EXPECT_NE(refusal(foreign).find("not signed by this key"), std::string::npos);
  expectRefused("allocate --seed 5 --key " + file("nowhere") + " --design " + design(), {"nowhere"},
                ErrorCode::kFileMissing);
}

}  // namespace
}  // namespace torsio
