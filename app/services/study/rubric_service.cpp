// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/rubric_service.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/rating/rubric_repository.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/scene/json_fields.h"

namespace torsio {

namespace {

using nlohmann::json;

constexpr const char* kRubricFormat = "torsio rubric 1";
constexpr double kMaxPoints = 1000.0;
constexpr int kMaxSteps = 1000;
constexpr double kMaxWeight = 100.0;
constexpr double kMilli = 1000.0;

ScoreScale readScale(JsonFields& fields) {
  ScoreScale scale{.lo = -1'000'000, .hi = 1'000'000};
  scale.stepsPerPoint = fields.integer("steps_per_point", 1, kMaxSteps, 1);
  const std::string where = fields.where();
  const ScoreScale open = scale;
  scale.lo = stepsFromPoints(fields.number("from", -kMaxPoints, kMaxPoints), open, where);
  scale.hi = stepsFromPoints(fields.number("to", -kMaxPoints, kMaxPoints), open, where);
  return scale;
}

RubricLine readRow(const json& source, const std::string& place) {
  JsonFields fields(source, place);
  RubricLine row;
  row.code = fields.text("code");
  row.label = fields.text("label");
  row.scale = readScale(fields);
  if (fields.has("anchors")) {
    for (const json& part : fields.child("anchors")) {
      JsonFields anchor(part, place + ", anchors");
      row.anchors.push_back(
          {stepsFromPoints(anchor.number("score", -kMaxPoints, kMaxPoints), row.scale, anchor.where()),
           anchor.text("meaning")});
      anchor.finish();
    }
  }
  row.weight_milli = std::llround(fields.number("weight", 0.0, kMaxWeight, 1.0) * kMilli);
  fields.finish();
  return row;
}

json scaleJson(const ScoreScale& scale) {
  return {{"from", pointsFromSteps(scale.lo, scale)},
          {"to", pointsFromSteps(scale.hi, scale)},
          {"steps_per_point", scale.stepsPerPoint}};
}

RubricRevisionId storeRevision(SessionContext& session, const RubricId& rubricId, RubricRevision revision,
                               std::int64_t number, const std::string& note) {
  revision.id = session.ids().newUuid();
  revision.rubricId = rubricId;
  revision.number = number;
  revision.note = note;
  revision.createdBy = session.actor().userId;
  revision.createdUtc_us = session.now_us();
  RubricRepository(session.connection()).addRevision(revision);
  session.note(number == 1 ? AuditAction::kRubricAdd : AuditAction::kRubricRevise,
               AuditObject::kRubricRevision, revision.id, {{"rubric", rubricId}, {"number", number}});
  return revision.id;
}

std::optional<Error> flawOf(const ScoreScale& scale) {
  try {
    validateScale(scale);
  } catch (const Error& refused) {
    return refused;
  }
  return std::nullopt;
}

/// Reports problems of a row's anchors with `say(field, what, remedy)`.
template <typename Say>
void reportAnchors(const RubricLine& row, const Say& say) {
  std::set<std::int64_t> scores;
  for (const RubricAnchor& anchor : row.anchors) {
    if (!isOnScale(anchor.score_steps, row.scale)) {
      say(RubricField::kAnchors, Text::tr("an anchor is outside the scale"),
          Text::tr("Move it, or widen the scale"));
    }
    if (!scores.insert(anchor.score_steps).second) {
      say(RubricField::kAnchors, Text::tr("two anchors are at the same mark"), Text::tr("Join them"));
    }
    if (anchor.meaning.empty()) {
      say(RubricField::kAnchors, Text::tr("an anchor has no words"), Text::tr("Say what the mark means"));
    }
  }
}

}  // namespace

std::vector<RubricProblem> rubricProblems(const RubricRevision& revision) {
  std::vector<RubricProblem> problems;
  const Text whole = Text::tr("rubric");
  if (const std::optional<Error> flaw = flawOf(revision.overall)) {
    problems.push_back(
        {RubricField::kOverall, 0, flaw->happenedText(), flaw->whereText(), flaw->remedyText()});
  }
  if (revision.rows.empty()) {
    problems.push_back({RubricField::kRows, 0, Text::tr("the rubric has no rows"), whole,
                        Text::tr("Add at least one criterion")});
    return problems;
  }
  std::set<std::string> codes;
  for (std::size_t i = 0; i < revision.rows.size(); ++i) {
    const RubricLine& row = revision.rows[i];
    const Text where(row.label.empty() ? "row " + row.code : row.label);
    const auto say = [&](RubricField field, Text what, Text remedy) {
      problems.push_back({field, i, std::move(what), where, std::move(remedy)});
    };
    if (row.code.empty() || row.label.empty()) {
      say(RubricField::kLabel, Text::tr("a row has no code or no label"), Text::tr("Fill both in"));
    } else if (!codes.insert(row.code).second) {
      say(RubricField::kLabel, Text::tr("two rows have the same code"), Text::tr("Rename one of them"));
    }
    if (row.weight_milli < 0 || row.weight_milli > std::llround(kMaxWeight * kMilli)) {
      say(RubricField::kWeight, Text::tr("a weight is out of range"), Text::tr("Use 0 to 100"));
    }
    if (const std::optional<Error> flaw = flawOf(row.scale)) {
      say(RubricField::kScale, flaw->happenedText(), flaw->remedyText());
    }
    reportAnchors(row, say);
  }
  if (std::none_of(revision.rows.begin(), revision.rows.end(),
                   [](const RubricLine& row) { return row.weight_milli > 0; })) {
    problems.push_back({RubricField::kWeight, 0, Text::tr("no row has a weight"), whole,
                        Text::tr("Give at least one criterion a weight above 0")});
  }
  return problems;
}

void checkRubric(const RubricRevision& revision) {
  if (const std::vector<RubricProblem> problems = rubricProblems(revision); !problems.empty()) {
    const RubricProblem& first = problems.front();
    refuseParameter(first.what, first.where, first.remedy);
  }
}

std::string codeForCriterion(const RubricRevision& revision, const std::string& label) {
  std::string stem;
  for (const char letter : label) {
    if ((letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9')) {
      stem += letter;
    } else if (letter >= 'A' && letter <= 'Z') {
      stem += static_cast<char>(letter - 'A' + 'a');
    } else if (!stem.empty() && stem.back() != '_') {
      stem += '_';
    }
  }
  while (!stem.empty() && stem.back() == '_') {
    stem.pop_back();
  }
  if (stem.empty()) {
    stem = "criterion";
  }
  const auto taken = [&revision](const std::string& code) {
    return std::any_of(revision.rows.begin(), revision.rows.end(),
                       [&code](const RubricLine& row) { return row.code == code; });
  };
  std::string code = stem;
  for (int number = 2; taken(code); ++number) {
    code = stem + "_" + std::to_string(number);
  }
  return code;
}

std::string rubricText(const std::string& title, const RubricRevision& revision) {
  json rows = json::array();
  for (const RubricLine& line : revision.rows) {
    json row = scaleJson(line.scale);
    row["code"] = line.code;
    row["label"] = line.label;
    row["weight"] = static_cast<double>(line.weight_milli) / kMilli;
    if (!line.anchors.empty()) {
      row["anchors"] = json::array();
      for (const RubricAnchor& anchor : line.anchors) {
        row["anchors"].push_back(
            {{"score", pointsFromSteps(anchor.score_steps, line.scale)}, {"meaning", anchor.meaning}});
      }
    }
    rows.push_back(std::move(row));
  }
  const json rubric{{"format", kRubricFormat},
                    {"title", title},
                    {"overall", scaleJson(revision.overall)},
                    {"rows", std::move(rows)}};
  return rubric.dump(2) + "\n";
}

RubricTemplate parseRubric(const std::string& text, const std::string& id) {
  requireSoundJson(text, id);
  const json source = json::parse(text);
  JsonFields fields(source, id);
  if (const std::string format = fields.text("format"); format != kRubricFormat) {
    fields.refuse("format", Text::tr("is '%1'", format), Text::tr("This program reads %1.", kRubricFormat));
  }
  RubricTemplate rubric;
  rubric.id = id;
  rubric.title = fields.text("title");
  rubric.source = fields.text("source", "");
  JsonFields overall(fields.child("overall"), id + ", overall");
  rubric.revision.overall = readScale(overall);
  overall.finish();
  const json& rows = fields.child("rows");
  if (!rows.is_array()) {
    fields.refuse("rows", Text::tr("must be a list in brackets"), Text::tr("Write [ ... ]."));
  }
  for (const json& row : rows) {
    rubric.revision.rows.push_back(
        readRow(row, id + ", row " + std::to_string(rubric.revision.rows.size() + 1)));
  }
  fields.finish();
  checkRubric(rubric.revision);
  return rubric;
}

std::vector<RubricTemplate> rubricTemplates(const std::filesystem::path& assets) {
  const std::filesystem::path folder = assets / "rubrics";
  if (!std::filesystem::is_directory(folder)) {
    throw Error(ErrorCode::kFileMissing, Text::tr("no such folder"), folder.string(),
                Text::tr("Restore it from the installation"));
  }
  std::vector<RubricTemplate> templates;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") {
      continue;
    }
    templates.push_back(parseRubric(readFile(entry.path()), entry.path().stem().string()));
  }
  std::sort(templates.begin(), templates.end(),
            [](const RubricTemplate& a, const RubricTemplate& b) { return a.id < b.id; });
  return templates;
}

std::vector<RubricRow> rubrics(SessionContext& session) {
  session.require(Operation::kPersonViewCoded);
  const RubricRepository repository(session.connection());
  std::vector<RubricRow> rows;
  for (const Rubric& rubric : repository.rubrics()) {
    RubricRow row{rubric.id, rubric.name, {}};
    for (const RubricRevisionId& id : repository.revisionIds(rubric.id)) {
      row.revisions.push_back(repository.revision(id).value());
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

RubricRevisionId addRubric(SessionContext& session, const std::string& name, const RubricRevision& first,
                           bool demonstration) {
  session.require(Operation::kCurriculumEdit);
  if (name.empty()) {
    refuseParameter(Text::tr("the rubric has no name"), Text::tr("rubric"), Text::tr("Enter one"));
  }
  checkRubric(first);
  Transaction transaction(session.connection());
  const RubricId rubricId = session.ids().newUuid();
  RubricRepository(session.connection()).addRubric(rubricId, name, session.now_us(), demonstration);
  const RubricRevisionId id = storeRevision(session, rubricId, first, 1, first.note);
  transaction.commit();
  return id;
}

RubricRevisionId reviseRubric(SessionContext& session, const RubricId& rubricId, const RubricRevision& next,
                              const std::string& note) {
  session.require(Operation::kCurriculumEdit);
  checkRubric(next);
  Transaction transaction(session.connection());
  const std::size_t before = RubricRepository(session.connection()).revisionIds(rubricId).size();
  if (before == 0) {
    refuseParameter(Text::tr("there is no such rubric"), rubricId, Text::tr("Choose one from the list"));
  }
  const RubricRevisionId id =
      storeRevision(session, rubricId, next, static_cast<std::int64_t>(before + 1), note);
  transaction.commit();
  return id;
}

}  // namespace torsio
