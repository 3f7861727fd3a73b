// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/service_texts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <map>
#include <string_view>

namespace torsio {

namespace {

namespace fs = std::filesystem;

enum class Kind { kWord, kLiteral, kSign };

struct Token {
  Kind kind = Kind::kSign;
  std::string text;
  int line = 0;
};

bool wordChar(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Words, string literals (neighbours joined) and signs; comments and characters are left out.
class Lexer {
 public:
  explicit Lexer(const std::string& source) : source_(source) {}

  std::vector<Token> run() {
    while (at_ < source_.size()) {
      step();
    }
    return std::move(tokens_);
  }

 private:
  [[nodiscard]] bool begins(std::string_view what) const {
    return source_.compare(at_, what.size(), what) == 0;
  }

  void step() {
    const char c = source_[at_];
    if (c == '\n') {
      ++line_;
    }
    if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++at_;
    } else if (begins("//")) {
      at_ = std::min(source_.find('\n', at_), source_.size());
    } else if (begins("R\"(")) {
      skipTo(")\"");
    } else if (c == '"') {
      literal();
    } else if (c == '\'') {
      character();
    } else if (wordChar(c)) {
      word();
    } else {
      tokens_.push_back({Kind::kSign, std::string(1, c), line_});
      ++at_;
    }
  }

  void skipTo(std::string_view end) {
    const std::size_t found = std::min(source_.find(end, at_), source_.size() - end.size());
    line_ += static_cast<int>(std::count(source_.begin() + static_cast<std::ptrdiff_t>(at_),
                                         source_.begin() + static_cast<std::ptrdiff_t>(found), '\n'));
    at_ = found + end.size();
  }

  void literal() {
    std::string text;
    for (++at_; at_ < source_.size() && source_[at_] != '"'; ++at_) {
      if (source_[at_] == '\\') {
        ++at_;
        text += source_[at_] == 'n' ? '\n' : source_[at_];
      } else {
        text += source_[at_];
      }
    }
    ++at_;
    if (!tokens_.empty() && tokens_.back().kind == Kind::kLiteral) {
      tokens_.back().text += text;
    } else {
      tokens_.push_back({Kind::kLiteral, text, line_});
    }
  }

  void character() {
    for (++at_; at_ < source_.size() && source_[at_] != '\''; ++at_) {
      if (source_[at_] == '\\') {
        ++at_;
      }
    }
    ++at_;
  }

  void word() {
    std::string text;
    // An apostrophe between digits belongs to the number.
    while (at_ < source_.size() &&
           (wordChar(source_[at_]) || (source_[at_] == '\'' && std::isdigit(text[0])))) {
      text += source_[at_++];
    }
    tokens_.push_back({Kind::kWord, text, line_});
  }

  const std::string& source_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<Token> tokens_;
};

bool is(const Token& token, std::string_view text) {
  return token.kind != Kind::kLiteral && token.text == text;
}

/// Whether somebody would read it: two letters in a row beside the places.
bool hasWords(const std::string& text) {
  const auto letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  if (text.rfind("--", 0) == 0) {
    return false;  // an option of the command line
  }
  return std::adjacent_find(text.begin(), text.end(),
                            [&](char a, char b) { return letter(a) && letter(b); }) != text.end();
}

class Reader {
 public:
  Reader(const std::vector<Token>& tokens, std::string file, ServiceTexts& texts)
      : tokens_(tokens), file_(std::move(file)), texts_(texts) {}

  void run() {
    for (std::size_t i = 1; i + 1 < tokens_.size(); ++i) {
      findSpeaker(i);
    }
    for (std::size_t i = 1; i < tokens_.size(); ++i) {
      if (is(tokens_[i], "(") || is(tokens_[i], "{")) {
        readCall(i);
      }
    }
  }

  /// Report models: what is written into the members that hold texts, and what is given to functions whose
  /// parameter is a `const Text&`.
  void runReport() {
    for (std::size_t i = 1; i + 2 < tokens_.size(); ++i) {
      findTextParameter(i);
    }
    for (std::size_t i = 2; i + 2 < tokens_.size(); ++i) {
      readMember(i);
    }
    for (std::size_t i = 1; i < tokens_.size(); ++i) {
      if (is(tokens_[i], "(") && textArguments_.contains(tokens_[nameBefore(i)].text)) {
        readTextArguments(i);
      }
    }
  }

  /// Reasons why a statistic is not defined.
  void runStatistics() {
    speakers_ = {"undefined"};
    run();
  }

 private:
  /// A parameter with one of the telling names makes its function one that speaks.
  void findSpeaker(std::size_t i) {
    static constexpr std::array<std::string_view, 5> kNames{"what", "why", "remedy", "problem", "sentence"};
    if (std::find(kNames.begin(), kNames.end(), tokens_[i].text) == kNames.end()) {
      return;
    }
    const bool parameter = is(tokens_[i - 1], "&") || is(tokens_[i - 1], "*") || is(tokens_[i - 1], "Text");
    const bool ends = is(tokens_[i + 1], ",") || is(tokens_[i + 1], ")") || is(tokens_[i + 1], "=");
    if (!parameter || !ends) {
      return;
    }
    int depth = 0;
    for (std::size_t k = i; k-- > 1;) {
      if (is(tokens_[k], ")")) {
        ++depth;
      }
      if (is(tokens_[k], ";")) {
        return;
      }
      if (!is(tokens_[k], "(") || depth-- > 0) {
        continue;
      }
      if (tokens_[k - 1].kind == Kind::kWord) {
        speakers_.insert(tokens_[k - 1].text);
      }
      if (is(tokens_[k - 1], "]")) {
        speakers_.insert(nameOfLambda(k - 1));
      }
      return;
    }
  }

  std::string nameOfLambda(std::size_t close) const {
    std::size_t k = close;
    while (k > 2 && !is(tokens_[k], "[")) {
      --k;
    }
    return k > 2 && is(tokens_[k - 1], "=") ? tokens_[k - 2].text : std::string();
  }

  /// Who is called with the parenthesis at `open`: "Text" for `Text(..)`, `Text name(..)` and `Text{..}`.
  std::string callee(std::size_t open) const {
    if (open < 1 || tokens_[open - 1].kind != Kind::kWord) {
      return {};
    }
    if (open >= 2 && is(tokens_[open - 2], "Text")) {
      return "Text";
    }
    return tokens_[open - 1].text;
  }

  /// `const Text& name` in the list of parameters: the place in the call is remembered.
  void findTextParameter(std::size_t i) {
    if (!is(tokens_[i - 1], "const") || !is(tokens_[i], "Text") || !is(tokens_[i + 1], "&")) {
      return;
    }
    int depth = 0;
    int angles = 0;
    std::size_t place = 0;
    for (std::size_t k = i; k-- > 1;) {
      if (is(tokens_[k], ";") || is(tokens_[k], "{")) {
        return;
      }
      if (is(tokens_[k], ">")) {
        ++angles;
      }
      if (is(tokens_[k], "<")) {
        --angles;
      }
      if (is(tokens_[k], ")")) {
        ++depth;
      }
      if (is(tokens_[k], ",") && depth == 0 && angles == 0) {
        ++place;
      }
      if (!is(tokens_[k], "(") || depth-- > 0) {
        continue;
      }
      const std::string name =
          is(tokens_[k - 1], "]") ? nameOfLambda(k - 1) : std::string(tokens_[k - 1].text);
      if (tokens_[k - 1].kind == Kind::kWord || is(tokens_[k - 1], "]")) {
        textArguments_[name].insert(place);
      }
      return;
    }
  }

  /// Of a call `name(` or `name<Type>(`.
  std::size_t nameBefore(std::size_t open) const {
    std::size_t k = open - 1;
    if (is(tokens_[k], ">")) {
      while (k > 1 && !is(tokens_[k], "<")) {
        --k;
      }
      --k;
    }
    return k;
  }

  void readTextArguments(std::size_t open) {
    const std::set<std::size_t>& places = textArguments_.at(tokens_[nameBefore(open)].text);
    std::size_t argument = 0;
    int depth = 0;
    for (std::size_t k = open; k < tokens_.size(); ++k) {
      if (is(tokens_[k], "(") || is(tokens_[k], "{")) {
        if (k != open && tokens_[k - 1].kind == Kind::kWord) {
          k = closing(k);
          continue;
        }
        ++depth;
      }
      if (is(tokens_[k], ")") || is(tokens_[k], "}")) {
        --depth;
      }
      if (depth == 0) {
        return;
      }
      if (depth == 1 && is(tokens_[k], ",")) {
        ++argument;
      }
      if (tokens_[k].kind == Kind::kLiteral && places.contains(argument) && hasWords(tokens_[k].text)) {
        take(k);
      }
    }
  }

  /// `table.columns = {"Group", ...};`, `section.paragraphs.push_back("...");`
  void readMember(std::size_t i) {
    static constexpr std::array<std::string_view, 17> kMembers{
        "title",      "subtitle",   "columns",   "rows",      "notes", "paragraphs",
        "name",       "xLabel",     "yLabel",    "formula",   "flags", "facts",
        "references", "categories", "simulated", "occasions", "design"};
    const bool member = is(tokens_[i - 1], ".") || (is(tokens_[i - 2], "-") && is(tokens_[i - 1], ">"));
    if (!member || std::find(kMembers.begin(), kMembers.end(), tokens_[i].text) == kMembers.end()) {
      return;
    }
    const bool assigned = is(tokens_[i + 1], "=") && !is(tokens_[i + 2], "=");
    const bool grown = is(tokens_[i + 1], ".") && i + 3 < tokens_.size() &&
                       (is(tokens_[i + 2], "push_back") || is(tokens_[i + 2], "insert"));
    if (!assigned && !grown) {
      return;
    }
    int depth = 0;
    for (std::size_t k = assigned ? i + 2 : i + 3; k < tokens_.size(); ++k) {
      const Token& token = tokens_[k];
      if (is(token, "(") || is(token, "{")) {
        if (tokens_[k - 1].kind == Kind::kWord && !is(tokens_[k - 1], "push_back") &&
            !is(tokens_[k - 1], "insert")) {
          k = closing(k);
          continue;
        }
        ++depth;
      }
      if (is(token, ")") || is(token, "}")) {
        --depth;
      }
      if (is(token, ";") || depth < 0) {
        return;
      }
      const bool compared = is(tokens_[k - 1], "=") && is(tokens_[k - 2], "=");
      if (token.kind == Kind::kLiteral && !compared && hasWords(token.text)) {
        take(k);
      }
    }
  }

  void readCall(std::size_t open) {
    const std::string name = callee(open);
    if (!speakers_.contains(name)) {
      return;
    }
    if (name == "refuse" && open >= 2 && is(tokens_[open - 2], ".")) {
      return;  // a member of a reader of files: what it says stands in the file's own terms
    }
    int depth = 0;
    int argument = 0;
    for (std::size_t k = open; k < tokens_.size(); ++k) {
      const Token& token = tokens_[k];
      if (is(token, "(") || is(token, "{") || is(token, "[")) {
        // Who stands deeper speaks for itself, or says nothing that is read.
        if (k != open && tokens_[k - 1].kind == Kind::kWord && !is(tokens_[k - 1], "string")) {
          k = closing(k);
          continue;
        }
        ++depth;
      }
      if (is(token, ")") || is(token, "}") || is(token, "]")) {
        --depth;
      }
      if (depth == 0) {
        return;
      }
      if (depth == 1 && is(token, ",")) {
        ++argument;
      }
      if (token.kind != Kind::kLiteral || !hasWords(token.text)) {
        continue;
      }
      if (name == "DbError" && argument == 1) {
        continue;  // the SQL operation
      }
      if (name == "Text" && argument > 0) {
        continue;
      }
      take(k);
    }
  }

  std::size_t closing(std::size_t open) const {
    int depth = 0;
    for (std::size_t k = open; k < tokens_.size(); ++k) {
      if (is(tokens_[k], "(") || is(tokens_[k], "{") || is(tokens_[k], "[")) {
        ++depth;
      }
      if (is(tokens_[k], ")") || is(tokens_[k], "}") || is(tokens_[k], "]")) {
        --depth;
      }
      if (depth == 0) {
        return k;
      }
    }
    return tokens_.size() - 1;
  }

  void take(std::size_t k) {
    const Token& token = tokens_[k];
    const bool wrapped = k >= 2 && is(tokens_[k - 1], "(") && is(tokens_[k - 2], "string");
    const std::size_t after = wrapped ? k + 2 : k + 1;
    const std::size_t before = wrapped ? k - 3 : k - 1;
    if (is(tokens_[before], "+") || (after < tokens_.size() && is(tokens_[after], "+"))) {
      texts_.glued.push_back({file_, token.line, token.text});
    } else {
      texts_.patterns.insert(token.text);
    }
  }

  const std::vector<Token>& tokens_;
  std::string file_;
  ServiceTexts& texts_;
  std::set<std::string> speakers_{"Error",  "DbError",         "Text",        "progress",
                                  "refuse", "refuseParameter", "refuseOption"};
  std::map<std::string, std::set<std::size_t>> textArguments_;
};

}  // namespace

void readAssetTexts(const std::string& json, ServiceTexts& texts) {
  static constexpr std::array<std::string_view, 4> kFields{"title", "label", "meaning", "description"};
  const std::vector<Token> tokens = Lexer(json).run();
  for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
    const bool named = tokens[i].kind == Kind::kLiteral && is(tokens[i + 1], ":") &&
                       tokens[i + 2].kind == Kind::kLiteral &&
                       std::find(kFields.begin(), kFields.end(), tokens[i].text) != kFields.end();
    if (named && hasWords(tokens[i + 2].text)) {
      texts.patterns.insert(tokens[i + 2].text);
    }
  }
}

void readServiceTexts(const std::string& source, const std::string& file, ServiceTexts& texts) {
  const std::vector<Token> tokens = Lexer(source).run();
  if (file.starts_with("assessment/statistics/")) {
    Reader(tokens, file, texts).runStatistics();
    return;
  }
  Reader(tokens, file, texts).run();
  static constexpr std::array<std::string_view, 3> kReport{"assessment/report/", "app/reporting/",
                                                           "app/demonstration/demonstration.cpp"};
  if (std::any_of(kReport.begin(), kReport.end(), [&](auto part) { return file.starts_with(part); })) {
    Reader(tokens, file, texts).runReport();
  }
}

ServiceTexts readServiceTexts(const fs::path& root) {
  static constexpr std::array<const char*, 24> kFolders{"sim/base",
                                                        "sim/device",
                                                        "sim/geometry",
                                                        "sim/scene",
                                                        "db",
                                                        "app/access",
                                                        "app/base",
                                                        "app/demonstration",
                                                        "app/devices",
                                                        "app/maintenance",
                                                        "app/people",
                                                        "app/recording",
                                                        "app/reporting",
                                                        "app/review",
                                                        "app/scoring",
                                                        "app/study",
                                                        "app/training",
                                                        "app/report",
                                                        "app/gui",
                                                        "assessment/report",
                                                        "assessment/statistics",
                                                        "assessment/study",
                                                        "assets/curricula",
                                                        "assets/rubrics"};
  ServiceTexts texts;
  for (const char* folder : kFolders) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (!entry.is_regular_file()) {
        continue;
      }
      const std::string extension = entry.path().extension().string();
      std::ifstream in(entry.path());
      const std::string source{std::istreambuf_iterator<char>(in), {}};
      if (extension == ".json") {
        readAssetTexts(source, texts);
      }
      if (extension != ".h" && extension != ".cpp") {
        continue;
      }
      readServiceTexts(source, fs::relative(entry.path(), root).generic_string(), texts);
    }
  }
  return texts;
}

}  // namespace torsio
