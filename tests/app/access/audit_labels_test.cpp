// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever the sources note in the audit trail has plain words: found in the sources, so that a new action
// cannot be forgotten.
#include "app/access/audit_labels.h"

#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/file_io.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = TORSIO_SOURCE_DIR;

std::vector<std::string> found(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> all;
  for (auto at = std::sregex_iterator(text.begin(), text.end(), expression); at != std::sregex_iterator();
       ++at) {
    all.push_back((*at)[1].str());
  }
  return all;
}

/// What a column may hold, by the CHECK of its table in the schema.
std::vector<std::string> allowed(const std::string& table, const std::string& column) {
  const std::string sql = readFile(kRoot / "db/migrations/0001_first_release.sql");
  const std::size_t begin = sql.find("CREATE TABLE " + table + " (");
  const std::vector<std::string> lists =
      found(sql.substr(begin, sql.find(");\n{{", begin) - begin),
            "  " + column + " TEXT NOT NULL CHECK \\(" + column + " IN \\(([^)]*)\\)");
  EXPECT_EQ(lists.size(), 1U) << table << " " << column;
  return lists.empty() ? std::vector<std::string>{} : found(lists.front(), "'([a-z_]+)'");
}

/// Codes that are put together: what may follow the dot.
std::vector<std::string> endingsOf(const std::string& prefix) {
  if (prefix == "alignment.") {
    return allowed("alignment_decision", "decision");
  }
  if (prefix == "retention.") {
    return allowed("retention_hold", "kind");
  }
  if (prefix == "curriculum.") {
    std::vector<std::string> states = allowed("curriculum_state", "state");
    std::erase(states, "draft");  // as it begins; nobody moves it back
    return states;
  }
  ADD_FAILURE() << "what may follow \"" << prefix << "\" is not known here";
  return {};
}

/// Codes of one file whose action is a value, by what stands for it.
std::vector<std::string> codesBehind(const std::string& value, const std::string& source) {
  // Copies of what somebody else noted.
  if (value == "note.action" || value == "row.text()") {
    return {};
  }
  if (value == "kDemonstrationRemoved") {
    return {"demonstration.remove"};
  }
  // A parameter: whatever looks like a code in this file.
  if (value == "action") {
    return found(source, "\"([a-z_]+\\.[a-z_]+)\"");
  }
  ADD_FAILURE() << "which action is " << value << "?";
  return {};
}

std::set<std::string> actionsOf(const std::string& source) {
  std::set<std::string> actions;
  for (const std::string& right : found(source, "\\.action = ([^;]*?)(?:;|,\\s*\\.|\\})")) {
    const std::vector<std::string> literals = found(right, "\"([a-z_]+\\.[a-z_]*)\"");
    if (literals.empty()) {
      for (const std::string& code : codesBehind(right, source)) {
        actions.insert(code);
      }
    }
    for (const std::string& literal : literals) {
      if (literal.back() != '.') {
        actions.insert(literal);
        continue;
      }
      for (const std::string& ending : endingsOf(literal)) {
        actions.insert(literal + ending);
      }
    }
  }
  return actions;
}

struct Noted {
  std::set<std::string> actions;
  std::set<std::string> kinds;
};

Noted noted() {
  Noted all;
  for (const char* folder : {"app", "db"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      if (entry.path().extension() != ".cpp") {
        continue;
      }
      const std::string source = readFile(entry.path());
      all.actions.merge(actionsOf(source));
      for (const std::string& kind : found(source, "\\bobjectKind = \"([a-z_]+)\"")) {
        all.kinds.insert(kind);
      }
    }
  }
  // seals.h: what the repositories seal themselves.
  for (const std::string& kind :
       found(readFile(kRoot / "db/repository/base/seals.h"), "kSealed[A-Za-z]+ = \"([a-z_]+)\"")) {
    all.kinds.insert(kind);
  }
  return all;
}

TEST(AuditLabels, EveryActionThatTheSourcesNoteHasALabel) {
  const Noted all = noted();

  EXPECT_GE(all.actions.size(), 90U);
  for (const char* action : {"mark.submit", "user.sign_in_failed", "retention.extend", "curriculum.closed",
                             "database.restore", "demonstration.remove"}) {
    EXPECT_TRUE(all.actions.contains(action)) << action << " was not found in the sources";
  }
  for (const std::string& action : all.actions) {
    const std::string words = auditActionLabel(action).str();
    EXPECT_NE(words, action) << "give it words in app/access/audit_labels.cpp";
    EXPECT_EQ(words.find_first_of("._"), std::string::npos) << words;
  }
}

TEST(AuditLabels, EveryKindOfObjectThatTheSourcesNoteHasALabel) {
  const Noted all = noted();

  EXPECT_GE(all.kinds.size(), 30U);
  for (const std::string& kind : all.kinds) {
    const Text words = auditObjectLabel(kind);
    EXPECT_FALSE(words.empty()) << kind;
    EXPECT_EQ(words.str().find('_'), std::string::npos) << kind << ": give it words";
  }
}

TEST(AuditLabels, NoTwoActionsReadTheSame) {
  std::map<std::string, std::string> actionOf;
  for (const std::string& action : noted().actions) {
    const auto [other, isNew] = actionOf.emplace(auditActionLabel(action).str(), action);
    EXPECT_TRUE(isNew) << action << " and " << other->second;
  }
}

TEST(AuditLabels, AnActionOfAnotherVersionKeepsItsCode) {
  EXPECT_EQ(auditActionLabel("mark.polish").str(), "mark.polish");
  EXPECT_EQ(auditObjectLabel("polish").str(), "polish");
}

}  // namespace
}  // namespace torsio
