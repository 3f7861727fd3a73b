// SPDX-License-Identifier: GPL-3.0-or-later
// The manual page, the completion and docs/cli.md know the same commands and options as the parser.
#include <algorithm>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/file_io.h"
#include "tests/app/cli/program.h"

namespace torsio {
namespace {

class Manual : public ::testing::Test {
 protected:
  std::filesystem::path folder_ = emptyFolder("manual");
  std::string page_ = runTorsio("manual page", folder_).out;
  std::string completion_ = runTorsio("manual completion", folder_).out;

  /// The words that follow each command, as the parser has them.
  [[nodiscard]] std::map<std::string, std::vector<std::string>> wordsOfCommands() const {
    std::map<std::string, std::vector<std::string>> all;
    std::istringstream lines(completion_);
    const std::regex entry("      \"(torsio[a-z -]*)\"\\) words=\"([^\"]*)\" ;;");
    std::smatch found;
    for (std::string line; std::getline(lines, line);) {
      if (std::regex_match(line, found, entry)) {
        std::istringstream words(found[2].str());
        for (std::string word; words >> word;) {
          all[found[1].str()].push_back(word);
        }
      }
    }
    return all;
  }
  /// What bash offers after these words, the last of which is being typed.
  [[nodiscard]] std::vector<std::string> offered(const std::vector<std::string>& words) const {
    std::ofstream(folder_ / "completion") << completion_;
    std::string script = "source " + (folder_ / "completion").string() + "; COMP_WORDS=(";
    for (const std::string& word : words) {
      script += "\"" + word + "\" ";
    }
    script +=
        "); COMP_CWORD=" + std::to_string(words.size() - 1) + "; _torsio; printf '%s\\n' \"${COMPREPLY[@]}\"";
    std::ofstream(folder_ / "ask") << script;
    const ProgramRun run = runProgram("bash", (folder_ / "ask").string(), folder_);
    EXPECT_EQ(run.err, "");
    std::vector<std::string> all;
    std::istringstream lines(run.out);
    for (std::string line; std::getline(lines, line);) {
      all.push_back(line);
    }
    return all;
  }
};

std::string withoutEscapes(std::string text) {
  for (std::size_t at = text.find('\\'); at != std::string::npos; at = text.find('\\', at)) {
    text.erase(at, 1);
  }
  return text;
}

TEST_F(Manual, ThePageHasEveryCommandAndOption) {
  const std::string page = withoutEscapes(page_);
  const auto all = wordsOfCommands();
  ASSERT_GT(all.size(), 60U);
  EXPECT_EQ(all.count("torsio screenshots"), 1U);
  const std::vector<std::string>& window = all.at("torsio");
  EXPECT_NE(std::find(window.begin(), window.end(), "--kiosk"), window.end());
  for (const auto& [command, words] : all) {
    EXPECT_TRUE(command == "torsio" || page.find(".SS " + command + "\n") != std::string::npos) << command;
    for (const std::string& word : words) {
      EXPECT_NE(page.find(word), std::string::npos) << command << " " << word;
    }
  }
}

TEST_F(Manual, ThePageIsSetWithoutAWarning) {
  std::ofstream(folder_ / "torsio.1") << page_;
  const ProgramRun set = runProgram("sh",
                                    "-c 'command -v groff >/dev/null || exit 77; groff -ww -z -man -Tutf8 " +
                                        (folder_ / "torsio.1").string() + "'",
                                    folder_);
  if (set.code == 77) {
    GTEST_SKIP() << "groff is not installed";
  }
  EXPECT_EQ(set.code, 0);
  EXPECT_EQ(set.err, "");
}

TEST_F(Manual, BashCompletesCommandsOptionsAndChoices) {
  EXPECT_EQ(offered({"torsio", "screens"}), (std::vector<std::string>{"screenshots"}));
  EXPECT_EQ(offered({"torsio", "device", "che"}), (std::vector<std::string>{"check"}));
  EXPECT_EQ(offered({"torsio", "device", "check", "--forc"}), (std::vector<std::string>{"--force-test"}));
  EXPECT_EQ(offered({"torsio", "--theme", ""}), (std::vector<std::string>{"light", "dark"}));
  EXPECT_EQ(offered({"torsio", "db", "backup", "--database", ""}), (std::vector<std::string>{""}))
      << "names of files";
}

TEST_F(Manual, TheDocumentHasEveryCommandOptionAndExitCodeAndNoOther) {
  const std::string document = readFile(TORSIO_SOURCE_DIR "/docs/cli.md");
  std::set<std::string> options;
  for (const auto& [command, words] : wordsOfCommands()) {
    for (const std::string& word : words) {
      if (word.starts_with("--")) {
        options.insert(word);
      }
      if (word != "-h") {
        EXPECT_NE(document.find(word), std::string::npos) << command << " " << word;
      }
    }
  }
  const std::regex option("--[a-z][a-z-]*");
  for (std::sregex_iterator at(document.begin(), document.end(), option), end; at != end; ++at) {
    EXPECT_EQ(options.count(at->str()), 1U) << at->str() << " is no option";
  }
  const std::string page = withoutEscapes(page_);
  const std::regex code("\\n\\| ([0-9]+) \\| ([a-z ]+) \\|");
  int codes = 0;
  for (std::sregex_iterator at(document.begin(), document.end(), code), end; at != end; ++at) {
    EXPECT_NE(page.find((*at)[1].str() + " " + (*at)[2].str()), std::string::npos) << at->str();
    ++codes;
  }
  EXPECT_EQ(codes, 15);
}

}  // namespace
}  // namespace torsio
