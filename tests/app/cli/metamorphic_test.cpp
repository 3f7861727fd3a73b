// SPDX-License-Identifier: GPL-3.0-or-later
// What no statistic may depend on: the order of the lines, the names of people and groups, the unit and the
// origin of the scores, and which group comes first. Every command that reads a table is tried on data
// without a pattern.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/cli/table_commands.h"

namespace torsio {
namespace {

using nlohmann::json;
using Line = std::vector<std::string>;

/// A table without a pattern, and how a command reads it.
struct Reading {
  std::string name;
  std::string command;  ///< before the name of the file
  std::string options;  ///< behind it
  std::string header;
  std::vector<Line> lines;
  std::size_t score = 0;  ///< its column
  bool scales = true;     ///< the scores have no fixed scale, so that another unit is possible
};

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : source_(seed) {}
  /// A whole number from 0 to `below` - 1.
  std::size_t roll(std::size_t below) { return static_cast<std::size_t>(source_() % below); }

 private:
  std::mt19937_64 source_;
};

std::string printed(double value) {
  return json(value).dump();
}

/// Scores of some mean and spread with one decimal.
std::string scoreFrom(Dice& dice, double mean) {
  const double spread = static_cast<double>(dice.roll(21) + dice.roll(21)) - 20.0;
  return printed(std::round(10.0 * (mean + 0.1 * spread)) / 10.0);
}

std::vector<Line> ratingsOf(std::size_t targets, std::size_t raters, bool whole) {
  Dice dice(7);
  std::vector<Line> lines;
  for (std::size_t t = 0; t < targets; ++t) {
    const std::size_t own = 2 + dice.roll(4);
    for (std::size_t r = 0; r < raters; ++r) {
      lines.push_back({named("t", t), named("r", r),
                       whole ? printed(static_cast<double>(own + dice.roll(3)))
                             : scoreFrom(dice, 4.0 + static_cast<double>(own))});
    }
  }
  return lines;
}

/// subject,group,occasion,score; `groups` of `size`.
std::vector<Line> study(std::size_t groups, std::size_t size, std::size_t occasions) {
  Dice dice(11);
  std::vector<Line> lines;
  for (std::size_t g = 0; g < groups; ++g) {
    for (std::size_t s = 0; s < size; ++s) {
      const double own = 0.1 * static_cast<double>(dice.roll(20));
      for (std::size_t o = 0; o < occasions; ++o) {
        lines.push_back({named("s", g * size + s), named("g", g), named("o", o),
                         scoreFrom(dice, 4.0 + own + 0.4 * static_cast<double>(o * (g + 1)))});
      }
    }
  }
  return lines;
}

std::vector<Line> without(std::vector<Line> lines, std::size_t column) {
  for (Line& line : lines) {
    line.erase(line.begin() + static_cast<std::ptrdiff_t>(column));
  }
  return lines;
}

std::vector<Line> marked(std::vector<Line> lines, std::size_t raters) {
  Dice dice(13);
  std::vector<Line> all;
  for (const Line& line : lines) {
    for (std::size_t r = 0; r < raters; ++r) {
      all.push_back({line[0], line[1], line[2], named("r", r), scoreFrom(dice, std::stod(line[3]))});
    }
  }
  return all;
}

std::vector<Line> attempts(bool judged) {
  Dice dice(17);
  std::vector<Line> lines;
  for (std::size_t s = 0; s < 4; ++s) {
    for (std::size_t i = 1; i <= 24; ++i) {
      const double mean = 4.0 + 12.0 / static_cast<double>(i);
      lines.push_back({named("s", s), std::to_string(i),
                       judged ? (dice.roll(5) == 0 ? "fail" : "pass") : scoreFrom(dice, mean)});
    }
  }
  return lines;
}

std::vector<Line> evaluation() {
  Dice dice(19);
  std::vector<Line> lines;
  for (const char* model : {"PM", "FEM"}) {
    for (const char* one : {"A", "B", "C"}) {
      for (std::size_t r = 0; r < 4; ++r) {
        for (std::size_t j = 1; j <= 9; ++j) {
          lines.push_back({std::to_string(j), one + std::to_string(r), one, model,
                           printed(static_cast<double>(dice.roll(101)) / 10.0)});
        }
      }
    }
  }
  return lines;
}

std::vector<Line> contrasted() {
  Dice dice(23);
  std::vector<Line> lines;
  for (std::size_t s = 0; s < 24; ++s) {
    const bool master = s % 2 == 1;
    lines.push_back({named("s", s), master ? "master" : "novice", scoreFrom(dice, master ? 7.0 : 4.0)});
  }
  return lines;
}

std::vector<Line> judged() {
  Dice dice(29);
  std::vector<Line> lines;
  for (std::size_t j = 0; j < 5; ++j) {
    for (std::size_t i = 0; i < 6; ++i) {
      lines.push_back({named("j", j), named("i", i), std::to_string(40 + dice.roll(41))});
    }
  }
  return lines;
}

std::vector<Line> borderline() {
  Dice dice(31);
  std::vector<Line> lines;
  for (std::size_t s = 0; s < 20; ++s) {
    const std::size_t global = 1 + dice.roll(5);
    lines.push_back(
        {named("s", s), std::to_string(global), scoreFrom(dice, 3.0 + static_cast<double>(global))});
  }
  return lines;
}

std::vector<Line> experts() {
  Dice dice(37);
  std::vector<Line> lines;
  for (std::size_t s = 0; s < 12; ++s) {
    lines.push_back({named("e", s), scoreFrom(dice, 9.0)});
  }
  return lines;
}

std::vector<Reading> readings() {
  const std::string ratingsHead = "target,rater,score";
  std::vector<Reading> all;
  for (const char* method :
       {"overview", "icc", "krippendorff --resamples 999", "bland-altman", "generalizability"}) {
    all.push_back({std::string("agreement ") + method, "agreement --ratings",
                   std::string("--method ") + method, ratingsHead, ratingsOf(9, 4, false), 2});
  }
  all.push_back({"agreement kappa", "agreement --ratings", "--method kappa", ratingsHead,
                 ratingsOf(14, 4, true), 2, false});
  all.push_back({"agreement rasch", "agreement --ratings", "--method rasch", ratingsHead,
                 ratingsOf(14, 4, true), 2, false});
  for (const std::size_t groups : {2U, 3U}) {
    all.push_back({"compare " + std::to_string(groups), "compare-groups", "--bootstrap mean --resamples 499",
                   "subject,group,score", without(study(groups, 7, 1), 2), 2});
    all.push_back({"compare occasions " + std::to_string(groups), "compare-groups",
                   "--residuals --margin 0.7", "subject,group,occasion,score", study(groups, 8, 3), 3});
    all.push_back({"compare marks " + std::to_string(groups), "compare-groups", "",
                   "subject,group,occasion,rater,score", marked(study(groups, 6, 2), 3), 4});
  }
  for (const char* test : {"t", "signed-rank", "permutation", "friedman"}) {
    all.push_back({std::string("paired ") + test, "compare-groups",
                   std::string("--bootstrap median --resamples 499 --paired ") + test,
                   "subject,occasion,score,group",
                   [] {
                     std::vector<Line> lines = study(2, 9, 3);
                     for (Line& line : lines) {
                       line = {line[0], line[2], line[3], line[1]};
                     }
                     return lines;
                   }(),
                   2});
  }
  for (const char* test : {"signed-rank", "permutation"}) {  // panel means of three marks
    Reading means{std::string("paired means ") + test, "compare-groups",
                  std::string("--paired ") + test,     "subject,occasion,score",
                  without(study(1, 9, 2), 1),          2};
    for (Line& line : means.lines) {
      line[2] = printed(
          (std::stod(line[2]) * 10.0 + static_cast<double>(line[0].size() + line[2].size() % 3)) / 30.0);
    }
    means.scales = false;
    all.push_back(std::move(means));
  }
  all.push_back(
      {"learning", "learning", "--threshold 5", "subject,attempt,value", attempts(false), 2, false});
  all.push_back({"learning judged", "learning", "", "subject,attempt,value", attempts(true), 2, false});
  all.push_back({"evaluate", "evaluate --ratings", "--resamples 499", "index,rater,class,model,score",
                 evaluation(), 4, false});
  all.push_back({"contrasting groups", "standard-setting", "--method contrasting-groups",
                 "subject,group,score", contrasted(), 2});
  all.push_back({"angoff", "standard-setting", "--method angoff", "judge,item,percent", judged(), 2, false});
  all.push_back({"borderline", "standard-setting", "--method borderline-regression --borderline 2",
                 "subject,global,score", borderline(), 2});
  all.push_back({"proficiency", "standard-setting", "--method proficiency", "expert,value", experts(), 1});
  return all;
}

std::string textOf(const Reading& reading) {
  std::string text = reading.header + "\n";
  for (const Line& line : reading.lines) {
    addRow(text, line);
  }
  return text;
}

/// The answer as named values: an entry of a list goes by what it is about instead of by its place.
void flatten(const json& node, const std::string& path, std::map<std::string, json>& into) {
  if (node.is_object()) {
    for (const auto& [key, value] : node.items()) {
      flatten(value, path + "/" + key, into);
    }
    return;
  }
  if (!node.is_array()) {
    into[path] = node;
    return;
  }
  std::multiset<std::string> words;
  for (std::size_t i = 0; i < node.size(); ++i) {
    std::string about;
    if (node[i].is_object()) {
      for (const char* key :
           {"model", "class", "index", "rater", "raters", "target", "subject", "person", "group", "groups",
            "expert", "judge", "item", "occasion", "effect", "category", "threshold"}) {
        json own = node[i].value(key, json());
        if (own.is_array()) {
          std::sort(own.begin(), own.end());  // the same pair in either direction
        }
        about += own.is_null() || own.is_number_float() ? "" : own.dump();
      }
    }
    if (node[i].is_string()) {
      words.insert(node[i].get<std::string>());
    } else {
      flatten(node[i], path + "[" + (about.empty() ? std::to_string(i) : about) + "]", into);
    }
  }
  for (const std::string& word : words) {
    into[path + "{" + word + "}"] = true;
  }
}

std::map<std::string, json> flat(const json& node) {
  std::map<std::string, json> values;
  flatten(node, "", values);
  return values;
}

bool isNear(double a, double b) {
  return std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)});
}

class Metamorphic : public TableCommands {
 protected:
  json read(const Reading& reading, const std::string& variant) const {
    const std::string file = write(variant + ".csv", textOf(reading));
    return answer(reading.command + " " + file + " " + reading.options);
  }

  /// Expects the same values under the same names.
  static void expectSame(const json& before, const json& after, const std::string& what) {
    const std::map<std::string, json> had = flat(before);
    const std::map<std::string, json> has = flat(after);
    EXPECT_EQ(had.size(), has.size()) << what;
    int told = 0;
    for (const auto& [path, value] : had) {
      const auto found = has.find(path);
      const bool same = found != has.end() && (value.is_number() && found->second.is_number()
                                                   ? isNear(value.get<double>(), found->second.get<double>())
                                                   : value == found->second);
      if (!same && ++told <= 5) {
        ADD_FAILURE() << what << ": " << path << " was " << value << ", is "
                      << (found == has.end() ? json("missing") : found->second);
      }
    }
  }
};

std::vector<std::string> columnsOf(const Reading& reading) {
  std::vector<std::string> columns(1);
  for (const char c : reading.header) {
    if (c == ',') {
      columns.emplace_back();
    } else {
      columns.back() += c;
    }
  }
  return columns;
}

/// The lines in another order. Groups and occasions keep theirs, which decides what is subtracted from what:
/// the line that names one first stays in front.
Reading shuffled(Reading reading, std::uint64_t seed) {
  const std::vector<std::string> columns = columnsOf(reading);
  std::set<std::pair<std::size_t, std::string>> seen;
  std::vector<Line> first;
  std::vector<Line> rest;
  for (const Line& line : reading.lines) {
    bool isNew = false;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      isNew =
          ((columns[c] == "group" || columns[c] == "occasion") && seen.emplace(c, line[c]).second) || isNew;
    }
    (isNew ? first : rest).push_back(line);
  }
  Dice dice(seed);
  for (std::size_t i = rest.size(); i > 1; --i) {
    std::swap(rest[i - 1], rest[dice.roll(i)]);
  }
  reading.lines = std::move(first);
  reading.lines.insert(reading.lines.end(), rest.begin(), rest.end());
  return reading;
}

TEST_F(Metamorphic, TheOrderOfTheLinesChangesNothing) {
  for (const Reading& reading : readings()) {
    SCOPED_TRACE(reading.name);
    const json before = read(reading, "before");
    for (const std::uint64_t seed : {1U, 2U}) {
      expectSame(before, read(shuffled(reading, seed), "after"), reading.name);
    }
  }
}

/// Renames in a way that reverses nothing: names are compared when two people are put in order.
TEST_F(Metamorphic, NamesChangeNothing) {
  const std::set<std::string> people{"target", "subject", "rater", "group", "judge", "item", "expert"};
  for (const Reading& reading : readings()) {
    if (reading.name == "contrasting groups") {
      continue;  // its groups have fixed names
    }
    SCOPED_TRACE(reading.name);
    Reading renamed = reading;
    const std::vector<std::string> columns = columnsOf(reading);
    for (Line& line : renamed.lines) {
      for (std::size_t c = 0; c < columns.size(); ++c) {
        line[c] = (people.contains(columns[c]) ? "Name of " : "") + line[c];
      }
    }
    std::string text = read(renamed, "after").dump();
    for (std::size_t at = text.find("Name of "); at != std::string::npos; at = text.find("Name of ")) {
      text.erase(at, 8);
    }
    expectSame(read(reading, "before"), json::parse(text), reading.name);
  }
}

/// 3 x + 20: a value stays, or changes as a mean, a difference, a variance or its inverse does. Left out is
/// what has no unit to change with, by the last word of its path.
TEST_F(Metamorphic, AnotherUnitAndOriginChangeValuesAsTheyMust) {
  constexpr double kFactor = 3.0;
  constexpr double kShift = 20.0;
  // Likelihoods move by a constant, intercepts with the slope; coefficients for a ratio scale or for
  // categories need that scale.
  const std::set<std::string> unitless{"restricted_criterion", "ratio", "nominal", "log_likelihood",
                                       "intercept"};
  for (Reading reading : readings()) {
    if (!reading.scales) {
      continue;
    }
    SCOPED_TRACE(reading.name);
    if (const std::size_t margin = reading.options.find("--margin 0.7"); margin != std::string::npos) {
      reading.options.replace(margin, 12, "--margin 2.1");
    }
    Reading first = reading;
    if (const std::size_t margin = first.options.find("--margin 2.1"); margin != std::string::npos) {
      first.options.replace(margin, 12, "--margin 0.7");
    }
    for (Line& line : reading.lines) {
      line[reading.score] =
          printed(std::round(10.0 * (kFactor * std::stod(line[reading.score]) + kShift)) / 10.0);
    }
    const std::map<std::string, json> had = flat(read(first, "before"));
    const std::map<std::string, json> has = flat(read(reading, "after"));
    for (const auto& [path, value] : has) {
      EXPECT_TRUE(had.contains(path)) << path << " is new: " << value;
    }
    int told = 0;
    for (const auto& [path, value] : had) {
      const bool left = std::any_of(unitless.begin(), unitless.end(), [&](const std::string& word) {
        return path.find("/" + word) != std::string::npos;
      });
      if (left || !value.is_number()) {
        continue;
      }
      const auto found = has.find(path);
      ASSERT_NE(found, has.end()) << path;
      const double before = value.get<double>();
      const double after = found->second.get<double>();
      const bool follows = isNear(before, after) || isNear(kFactor * before + kShift, after) ||
                           isNear(kFactor * before, after) || isNear(kFactor * kFactor * before, after) ||
                           isNear(before / kFactor, after);
      if (!follows && ++told <= 8) {
        ADD_FAILURE() << reading.name << ": " << path << " was " << before << ", is " << after;
      }
    }
  }
}

/// The other group first: what is subtracted from what is reversed, and nothing else.
TEST_F(Metamorphic, TheOtherGroupFirstReversesDifferencesOnly) {
  for (const Reading& reading : readings()) {
    if (reading.header.find("group") == std::string::npos || reading.name == "contrasting groups" ||
        reading.name.find('3') != std::string::npos) {
      continue;
    }
    SCOPED_TRACE(reading.name);
    Reading reversed = reading;
    const std::vector<std::string> columns = columnsOf(reading);
    const std::size_t group =
        static_cast<std::size_t>(std::find(columns.begin(), columns.end(), "group") - columns.begin());
    std::stable_sort(reversed.lines.begin(), reversed.lines.end(),
                     [&](const Line& a, const Line& b) { return a[group] > b[group]; });
    const std::map<std::string, json> had = flat(read(reading, "before"));
    const std::map<std::string, json> has = flat(read(reversed, "after"));
    EXPECT_EQ(had.size(), has.size());
    const double pairs =
        had.at("/groups[\"g0\"]/n").get<double>() * had.at("/groups[\"g1\"]/n").get<double>();
    int told = 0;
    for (const auto& [path, value] : has) {
      if (!value.is_number()) {
        continue;
      }
      const double after = value.get<double>();
      const auto follows = [&](const std::string& from) {
        const auto found = had.find(from);
        if (found == had.end() || !found->second.is_number()) {
          return false;
        }
        const double before = found->second.get<double>();
        // A rank sum and a probability to be larger are those of the other group.
        const bool ofTheOther =
            isNear(1.0 - before, after) ||
            (path.find("mann_whitney") != std::string::npos && isNear(pairs - before, after));
        return isNear(before, after) || isNear(-before, after) || ofTheOther;
      };
      const auto swapped = [&path](const std::string& word, const std::string& other) {
        const std::size_t at = path.rfind(word);
        return at == std::string::npos ? path : path.substr(0, at) + other + path.substr(at + word.size());
      };
      if (!follows(path) && !follows(swapped("/lower", "/upper")) && !follows(swapped("/upper", "/lower")) &&
          ++told <= 8) {
        ADD_FAILURE() << reading.name << ": " << path << " became " << after;
      }
    }
  }
}

}  // namespace
}  // namespace torsio
