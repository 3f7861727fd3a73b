// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/foreign/foreign_map.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/connectors/foreign/foreign_marks.h"
#include "app/connectors/foreign/map_part.h"
#include "app/services/base/csv_table.h"
#include "app/services/base/identifiers.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/foreign_recording.h"
#include "sim/core/plausible.h"
#include "sim/core/time_units.h"
#include "sim/scene/json_fields.h"

namespace torsio {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, ForeignLayout>, 5> kForeignLayouts = {
    {{"jigsaws", ForeignLayout::kJigsaws},
     {"rosma", ForeignLayout::kRosma},
     {"perktutor", ForeignLayout::kPerkTutor},
     {"csv", ForeignLayout::kCsv},
     {"parquet", ForeignLayout::kParquet}}};

struct RotationRow {
  std::string_view name;
  RotationForm form;
  std::size_t numbers;
};
constexpr std::array<RotationRow, 5> kRotations = {{{"none", RotationForm::kNone, 0},
                                                    {"quaternion wxyz", RotationForm::kQuaternionWxyz, 4},
                                                    {"quaternion xyzw", RotationForm::kQuaternionXyzw, 4},
                                                    {"matrix rows", RotationForm::kMatrixRows, 9},
                                                    {"matrix columns", RotationForm::kMatrixColumns, 9}}};

/// The stored value of one unit that the map names.
double unitOf(Stated quantity, const MapPart& part, const char* key) {
  const std::string word = part.text(key);
  const std::optional<StatedUnit> unit = statedUnit(quantity, word);
  if (!unit) {
    part.refuseAt(key, Text::tr("'%1' must be one of: %2", word, unitWords(quantity)),
                  Text::tr("Name one of them"));
  }
  return unit->si;
}

RotationForm rotationOf(const MapPart& part) {
  const std::string word = part.text("rotation");
  std::string words;
  for (const RotationRow& row : kRotations) {
    if (row.name == word) {
      return row.form;
    }
    words += (words.empty() ? "" : ", ") + std::string(row.name);
  }
  part.refuseAt("rotation", Text::tr("'%1' must be one of: %2", word, words), Text::tr("Name one of them"));
}

/// Parses "2026-01-05T08:00:00Z".
std::optional<std::int64_t> utcOf(const std::string& text) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  int hour = 0;
  int minute = 0;
  int second = 0;
  int read = 0;
  const int fields = std::sscanf(text.c_str(), "%4d-%2u-%2uT%2d:%2d:%2dZ%n", &year, &month, &day, &hour,
                                 &minute, &second, &read);
  const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month),
                                         std::chrono::day(day)};
  const bool sound = fields == 6 && static_cast<std::size_t>(read) == text.size() && date.ok() && hour < 24 &&
                     minute < 60 && second < 60 && hour >= 0 && minute >= 0 && second >= 0;
  if (!sound) {
    return std::nullopt;
  }
  return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::sys_days(date).time_since_epoch())
             .count() +
         hour * kHour_us + minute * kMinute_us + second * kSecond_us;
}

void readTimes(const MapPart& map, ForeignLayout layout, ForeignMap& out) {
  const bool stamped = layout == ForeignLayout::kPerkTutor;
  if (map.has("rate_Hz") == (map.has("time") || stamped)) {
    map.refuseAt("rate_Hz", Text::tr("either the file has times, or the map states the rate"),
                 stamped || namesColumns(layout) ? Text::tr("Leave one of the two out")
                                                 : Text::tr("State the rate: these files have no time"));
  }
  if (map.has("rate_Hz")) {
    out.rate_Hz = map.number("rate_Hz");
    if (!isPlausible(Stated::kPosePeriod, 1.0 / *out.rate_Hz)) {
      map.refuseAt("rate_Hz",
                   Text::tr("not a valid rate: %1 from line to line is plausible",
                            plausibleRange(Stated::kPosePeriod)),
                   Text::tr("State lines a second, up to 10000"));
    }
  } else if (!stamped) {
    if (!namesColumns(layout)) {
      map.refuseAt("time", Text::tr("these files have no time"), Text::tr("State rate_Hz instead"));
    }
    const MapPart time = map.part("time");
    time.allow({"column", "unit"});
    out.timeColumn = time.text("column");
    out.timeUnit = time.text("unit");
    out.timeUnit_s = unitOf(Stated::kPosePeriod, time, "unit");
    out.timeConfirmed = map.yesOrNo(kTimeConfirmed);
  }
}

void readColumns(const MapPart& map, ForeignLayout layout, ForeignMap& out) {
  if (namesColumns(layout)) {
    const std::vector<std::string> position = map.texts("position", out.position.size());
    std::copy(position.begin(), position.end(), out.position.begin());
    if (out.rotation != RotationForm::kNone) {
      out.rotationColumns = map.texts("rotation_columns", numbersOf(out.rotation));
    }
  } else {
    out.instrument = map.text("instrument");
  }
  if (map.has("grip")) {
    const MapPart grip = map.part("grip");
    grip.allow({"column", "open", "closed"});
    out.grip = {grip.textOr("column", ""), grip.number("open"), grip.number("closed")};
    if (out.grip->open == out.grip->closed) {
      grip.refuseAt("closed", Text::tr("the open and the closed jaw read the same"),
                    Text::tr("State what the file says of each"));
    }
    if (layout == ForeignLayout::kPerkTutor) {
      map.refuseAt("grip", Text::tr("these files say nothing of the jaw"), Text::tr("Leave it out"));
    }
    if (namesColumns(layout)) {
      (void)grip.text("column");
    }
  }
}

/// The map has to say whether a line without a pose is a gap.
void readGaps(const MapPart& map, ForeignLayout layout, ForeignMap& out) {
  if (!map.has("gaps")) {
    return;
  }
  const bool tables = layout == ForeignLayout::kRosma || namesColumns(layout);
  if (!tables || map.text("gaps") != "leave out") {
    map.refuseAt("gaps", Text::tr("only \"leave out\" is allowed here, and only for tables"),
                 Text::tr("Remove it: lines without a pose are then refused"));
  }
  out.leavesGaps = true;
}

template <typename List>
void requireKnown(const List& list, const std::string& name, const MapPart& part, const char* key) {
  const bool known = std::any_of(list.begin(), list.end(), [&](const auto& one) { return one.name == name; });
  if (!known) {
    part.refuseAt(key, Text::tr("the map lists no person '%1'", name), Text::tr("Enter them in its lists"));
  }
}

void readPeople(const MapPart& map, ForeignMap& out) {
  std::set<std::string> codes;
  Identifiers alikeGroups("group");
  for (const MapPart& group : map.list("groups")) {
    group.allow({"code", "label"});
    out.groups.push_back({group.text("code"), group.label("label")});
    alikeGroups.take(out.groups.back().code, group.placeOf("code"));
    codes.insert(out.groups.back().code);
  }
  std::set<std::string> names;
  Identifiers alikePeople("name");
  for (const MapPart& person : map.list("people")) {
    person.allow({"name", "group", "level"});
    out.people.push_back({person.text("name"), person.text("group"), person.labelOr("level", "")});
    alikePeople.take(out.people.back().name, person.placeOf("name"));
    if (!codes.contains(out.people.back().group)) {
      person.refuseAt("group", Text::tr("there is no such group"), Text::tr("Enter it under \"groups\""));
    }
    if (!names.insert(out.people.back().name).second) {
      person.refuseAt("name", Text::tr("duplicate name"), Text::tr("Name each person once"));
    }
  }
  if (!map.has("raters")) {
    return;
  }
  for (const MapPart& rater : map.list("raters")) {
    rater.allow({"name", "class"});
    out.raters.push_back({rater.text("name"), rater.text("class")});
    alikePeople.take(out.raters.back().name, rater.placeOf("name"));
    if (!names.insert(out.raters.back().name).second) {
      rater.refuseAt("name", Text::tr("duplicate name"), Text::tr("Name each person once"));
    }
  }
}

std::int64_t wholeIn(const MapPart& part, const char* key, const Text& remedy) {
  const double value = part.number(key);
  if (!(value >= -1e6 && value <= 1e6) || value != static_cast<double>(static_cast<std::int64_t>(value))) {
    part.refuseAt(key, Text::tr("a whole number belongs here"), remedy);
  }
  return static_cast<std::int64_t>(value);
}

void readRecordings(const MapPart& map, const fs::path& folder, ForeignLayout layout, ForeignMap& out) {
  std::set<std::string> names;
  Identifiers alikeOccasions("occasion");
  for (const MapPart& one : map.list("recordings")) {
    one.allow({"file", "episode", "person", "task", "phase", "occasion", "started"});
    ForeignRecording recording;
    recording.name = one.text("file");
    recording.file = folder / recording.name;
    if (one.has("episode")) {
      if (layout != ForeignLayout::kParquet) {
        one.refuseAt("episode", Text::tr("only a Parquet file may hold several recordings"),
                     Text::tr("Write each recording into a file of its own"));
      }
      recording.episode = wholeIn(one, "episode", Text::tr("Write the number of the episode"));
      recording.name += "#" + std::to_string(*recording.episode);
    }
    recording.person = one.text("person");
    recording.task = one.label("task");
    recording.phase = one.labelOr("phase", "");
    recording.occasion = one.labelOr("occasion", "");
    if (!recording.occasion.empty()) {
      alikeOccasions.take(recording.occasion, one.placeOf("occasion"));
    }
    requireKnown(out.people, recording.person, one, "person");
    if (!names.insert(recording.name).second) {
      one.refuseAt("file", Text::tr("duplicate file"), Text::tr("Name each recording once"));
    }
    if (one.has("started")) {
      recording.startedUtc_us = utcOf(one.text("started"));
      if (!recording.startedUtc_us) {
        one.refuseAt("started", Text::tr("not a valid time"), Text::tr("Write 2026-01-05T08:00:00Z (UTC)"));
      }
    }
    out.recordings.push_back(std::move(recording));
  }
  if (out.recordings.empty()) {
    map.refuseAt("recordings", Text::tr("the map lists no recording"), Text::tr("List at least one"));
  }
}

void readMarks(const MapPart& map, const fs::path& folder, ForeignLayout layout, ForeignMap& out) {
  if (!map.has("marks")) {
    return;
  }
  const MapPart marks = map.part("marks");
  marks.allow({"table", "meta_file", "rater", "lowest", "highest", "steps_per_point", kScaleConfirmed});
  out.scaleConfirmed = marks.yesOrNo(kScaleConfirmed);
  const auto whole = [&marks](const char* key) {
    return wholeIn(marks, key, Text::tr("Check the scale of the marks"));
  };
  out.scale.stepsPerPoint = whole("steps_per_point");
  out.scale.lo = whole("lowest") * out.scale.stepsPerPoint;
  out.scale.hi = whole("highest") * out.scale.stepsPerPoint;
  validateScale(out.scale);
  if (marks.has("meta_file")) {
    if (layout != ForeignLayout::kJigsaws) {
      marks.refuseAt("meta_file", Text::tr("only JIGSAWS has such a file"), Text::tr("Name a table instead"));
    }
    const std::string rater = marks.text("rater");
    requireKnown(out.raters, rater, marks, "rater");
    out.marks = jigsawsMarks(folder / marks.text("meta_file"), rater, out);
  } else {
    out.marks = tabledMarks(folder / marks.text("table"), out);
  }
  if (!out.scaleConfirmed) {
    std::vector<std::int64_t> steps;
    std::transform(out.marks.begin(), out.marks.end(), std::back_inserter(steps),
                   [](const ForeignMark& mark) { return mark.steps; });
    requireScaleUsed(
        steps, out.scale, marks.placeOf("highest"),
        Text::tr("Write the right scale into the map, or \"scale_confirmed\": true if it is right"));
  }
}

/// The record takes one mark per person, rater and occasion.
void requireSingleMarks(const ForeignMap& map) {
  std::set<std::string> given;
  for (const ForeignMark& mark : map.marks) {
    const auto recording =
        std::find_if(map.recordings.begin(), map.recordings.end(),
                     [&](const ForeignRecording& one) { return one.name == mark.recording; });
    if (recording->occasion.empty()) {
      refuse(Text::tr("this recording has a mark and no occasion"), map.name + ", " + mark.recording,
             Text::tr("Name its occasion in the map: first, second"));
    }
    if (!given.insert(recording->person + "\n" + mark.rater + "\n" + recording->occasion).second) {
      refuse(Text::tr("%1 marked %2 twice at one occasion", mark.rater, recording->person),
             map.name + ", " + mark.recording, Text::tr("Give each recording a separate occasion"));
    }
  }
}

}  // namespace

ForeignLayout foreignLayout(const std::string& word) {
  for (const auto& [name, layout] : kForeignLayouts) {
    if (name == word) {
      return layout;
    }
  }
  throw Error(ErrorCode::kUsage, Text::tr("there is no such layout of recordings"), word,
              Text::tr("Use jigsaws, rosma, perktutor, csv or parquet"));
}

std::size_t numbersOf(RotationForm form) noexcept {
  return kRotations[static_cast<std::size_t>(form)].numbers;
}

std::string rotationName(RotationForm form) {
  return std::string(kRotations[static_cast<std::size_t>(form)].name);
}

ForeignMap readForeignMap(const fs::path& file, ForeignLayout layout) {
  const std::string text = jsonTextIn(file);
  const auto json = nlohmann::json::parse(text);
  ForeignMap out;
  out.name = file.filename().string();
  Digest digest;
  digest.update(text);
  out.contentHash = digest.hex();
  const MapPart map(json, out.name);
  map.allow({"cohort",   "description",  "source",     "frame",
             "unit",     kUnitConfirmed, "rotation",   "rotation_columns",
             "position", "rate_Hz",      "time",       kTimeConfirmed,
             "gaps",     "instrument",   "grip",       "groups",
             "people",   "raters",       "recordings", "marks"});
  out.cohort = map.label("cohort");
  out.description = map.textOr("description", "");
  out.source = map.text("source");
  out.frame = map.text("frame");
  out.unit = map.text("unit");
  out.metresPerUnit = unitOf(Stated::kHandReach, map, "unit");
  out.unitConfirmed = map.yesOrNo(kUnitConfirmed);
  out.rotation = rotationOf(map);
  readTimes(map, layout, out);
  readColumns(map, layout, out);
  readGaps(map, layout, out);
  readPeople(map, out);
  const fs::path folder = file.parent_path();
  readRecordings(map, folder, layout, out);
  readMarks(map, folder, layout, out);
  requireSingleMarks(out);
  return out;
}

}  // namespace torsio
