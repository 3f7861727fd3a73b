// SPDX-License-Identifier: GPL-3.0-or-later
// One word for one thing (docs/glossary.md): names and comments of the code, and the documents, have the
// field's words and not the former ones. What screens say is checked beside the translations.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;

/// A former word, and the one that is said now. With a `*` at its end it is the beginning of a name, with one
/// at its beginning the end of one.
struct FormerWord {
  std::string_view word;
  const char* now;
};

// Stored names stay as they are: tables, columns, actions of the audit trail.
constexpr FormerWord kFormerWords[] = {
    {"Workplace", "SessionContext"},
    {"StationLine", "StationWriter"},
    {"StationPulse", "StationHeartbeat"},
    {"sign of life", "heartbeat"},
    {"signs of life", "heartbeats"},
    {"TrainingArm", "TrainingSetting"},
    {"StoredArm", "StudyArm"},
    {"ShellWindow", "MainWindow, SimulatorWindow"},
    {"scoring point*", "occasion"},
    {"ScoringPoint*", "Occasion"},
    {"scoring_point*", "occasion"},
    {"spoken(", "translated()"},
    {"debrief_words", "debrief_labels"},
    {"servo_words", "servo_labels"},
    {"alert_words", "alert_labels"},
    {"audit_words", "audit_labels"},
    {"case_words", "case_labels"},
    {"warm-up*", "rater calibration"},
    {"Warm-up*", "rater calibration"},
    {"warmUp*", "raterCalibration"},
    {"third rater*", "adjudicator"},
    {"*ThirdRater*", "Adjudicator"},
    {"askForThird", "askForAdjudicator"},
    {"alignmentCases", "discrepancyCases"},
    {"alignment view", "discrepancy review"},
    {"insertOnce", "insertIdempotent"},
    {"kAside", "kIgnored"},
    {"usual()", "medianOf()"},
    {"TrialOrder", "RecordingSpec"},
    {"led_", "usesHaptic_"},
    {"CareDesk", "MaintenanceDesk"},
    {"CareTaker", "Maintainer"},
    {"CareOptions", "MaintenanceOptions"},
    {"care command*", "maintenance command"},
    {"care page*", "maintenance page"},
    {"CsvLook", "CsvStyle"},
    {"ChartLook", "ChartStyle"},
    {"RunDay*", "DayBoard, TodaysSessionsPage"},
    {"runDay*", "dayBoard"},
    {"run_day*", "day_board, todays_sessions_page"},
    {"run day", "today's sessions"},
    {"askRaters*", "inviteRaters"},
    {"let go on target", "released on target"},
    {"let go on the target", "released on target"},
    {"the office", "an administrator"},
    {"Who was put where", "Allocations"},
    {"Hide names", "Collapse sidebar"},
    {"What counts now", "Current design"},
    {"Ask raters", "Invite raters"},
};

bool isOfAName(char character) {
  return std::isalnum(static_cast<unsigned char>(character)) != 0 || character == '_';
}

/// Places of a former word in a text; a longer name that contains it is another one.
std::vector<std::size_t> placesOf(const FormerWord& former, const std::string& text) {
  std::string_view word = former.word;
  const bool anyEnd = word.ends_with('*');
  const bool anyBeginning = word.starts_with('*');
  word.remove_suffix(anyEnd ? 1 : 0);
  word.remove_prefix(anyBeginning ? 1 : 0);
  std::vector<std::size_t> places;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = anyBeginning || at == 0 || !isOfAName(text[at - 1]);
    const bool ends = anyEnd || end == text.size() || !isOfAName(word.back()) || !isOfAName(text[end]);
    if (begins && ends) {
      places.push_back(at);
    }
  }
  return places;
}

/// "12: Workplace (say SessionContext)" for each former word.
std::vector<std::string> formerWordsIn(const std::string& text) {
  std::vector<std::string> found;
  for (const FormerWord& former : kFormerWords) {
    for (const std::size_t at : placesOf(former, text)) {
      const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
      found.push_back(std::to_string(line) + ": " + std::string(former.word) + " (say " + former.now + ")");
    }
  }
  return found;
}

bool isRead(const fs::path& file) {
  static constexpr std::string_view kKinds[] = {".h", ".cpp", ".js", ".py", ".md", ".txt", ".json"};
  const std::string name = file.filename().string();
  if (name == "words_test.cpp" || name == "translation_test.cpp") {
    return false;  // they list the former words
  }
  return std::find(std::begin(kKinds), std::end(kKinds), file.extension().string()) != std::end(kKinds);
}

TEST(Words, TheRuleFindsFormerNamesAndLeavesStoredOnesAlone) {
  const std::string text =
      "class CareDesk {\n"                            // found
      "/// Marks of a scoring point.\n"               // found
      "SealRule{\"rater_warmup\"},\n"                 // a table
      "the tissue is twisted with care\n"             //
      "RunDayBoard runDayBoard();\n"                  // found twice
      "the officer of that day, mingled_\n"           //
      "assignThirdRater, twists let go on target\n";  // found twice

  std::vector<std::string> found = formerWordsIn(text);

  std::sort(found.begin(), found.end());
  const std::vector<std::string> wanted{"1: CareDesk (say MaintenanceDesk)",
                                        "2: scoring point* (say occasion)",
                                        "5: RunDay* (say DayBoard, TodaysSessionsPage)",
                                        "5: runDay* (say dayBoard)",
                                        "7: *ThirdRater* (say Adjudicator)",
                                        "7: let go on target (say released on target)"};
  EXPECT_EQ(found, wanted);
}

TEST(Words, OfCodeAndDocumentsAreThoseOfTheGlossary) {
  const fs::path root = TORSIO_SOURCE_DIR;
  std::size_t files = 0;
  for (const char* folder : {"app", "assessment", "assets", "db", "docs", "sim", "tests", "tools"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (!entry.is_regular_file() || !isRead(entry.path()) || entry.file_size() > (std::size_t{1} << 20U)) {
        continue;
      }
      ++files;
      std::ifstream in(entry.path());
      const std::string text(std::istreambuf_iterator<char>(in), {});
      for (const std::string& word : formerWordsIn(text)) {
        ADD_FAILURE() << entry.path().string() << ":" << word;
      }
    }
  }
  EXPECT_GT(files, 1000U);  // there are more: the folders were found
}

}  // namespace
