// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/centres/protocol.h"

#include <array>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/study/curriculum_content.h"
#include "assessment/catalogue/quantity.h"
#include "assessment/scoring/training_scores.h"
#include "db/connection/connection.h"
#include "db/connection/row_reader.h"
#include "db/repository/study/curriculum_repository.h"
#include "sim/core/digest.h"

namespace torsio {

namespace {

using Json = nlohmann::json;

constexpr const char* kOrgans = "organs";

struct PartName {
  const char* part;
  Phrase name;
};
constexpr std::array<PartName, 7> kParts{{
    {"competence", Text::tr("rule of competence")},
    {"curriculum", Text::tr("curriculum")},
    {"evaluation", Text::tr("evaluation of models")},
    {"groups", Text::tr("cohort and its groups")},
    {kOrgans, Text::tr("organs and their parameters")},
    {"rubrics", Text::tr("scoring sheets")},
    {"rules", Text::tr("rules of this version")},
}};

Json jsonOf(const Value& value) {
  return std::visit(
      [](const auto& stored) -> Json {
        using Kind = std::decay_t<decltype(stored)>;
        if constexpr (std::is_same_v<Kind, std::monostate> || std::is_same_v<Kind, Blob>) {
          return nullptr;
        } else {
          return stored;
        }
      },
      value.storage());
}

/// Returns the rows of a SELECT as objects.
Json rowsOf(Connection& connection, const std::string& select, std::initializer_list<Value> values) {
  Statement row = connection.prepare(select);
  row.execute(values);
  Json rows = Json::array();
  while (row.step()) {
    Json one;
    const std::vector<std::string> names = columnNamesOf(row);
    for (std::size_t i = 0; i < names.size(); ++i) {
      one[names[i]] = jsonOf(row.value(static_cast<int>(i)));
    }
    rows.push_back(std::move(one));
  }
  return rows;
}

Json curriculumOf(Connection& connection, const SiteScope& scope) {
  const auto version = CurriculumRepository(connection).version(scope.versionId);
  if (!version) {
    return nullptr;
  }
  Json part = Json::parse(curriculumJson(withCodes(*version)));
  part["name"] = selectFirst(connection,
                             "SELECT c.name FROM curriculum c JOIN curriculum_version v"
                             " ON v.curriculum_id = c.id WHERE v.id = ?",
                             {scope.versionId}, readText)
                     .value_or("");
  return part;
}

Json groupsOf(Connection& connection, const SiteScope& scope) {
  Json part;
  part["cohort"] =
      rowsOf(connection, "SELECT name, equivalence_margin FROM cohort WHERE id = ?", {scope.cohortId});
  part["groups"] = rowsOf(connection,
                          "SELECT g.number, g.code, g.label, a.code AS arm FROM training_group g LEFT JOIN"
                          " curriculum_arm a ON a.id = g.arm_id WHERE g.cohort_id = ? ORDER BY g.number",
                          {scope.cohortId});
  return part;
}

Json rubricsOf(Connection& connection, const SiteScope& scope) {
  const std::string used = scope.select(*siteTableOf("rubric_revision"), "id");
  Json part;
  part["revisions"] =
      rowsOf(connection,
             "SELECT r.name, v.number, v.scale_lo_steps, v.scale_hi_steps, v.steps_per_point FROM"
             " rubric_revision v JOIN rubric r ON r.id = v.rubric_id WHERE v.id IN (" +
                 used + ") ORDER BY r.name, v.number",
             {});
  part["rows"] =
      rowsOf(connection,
             "SELECT r.name, v.number, w.row_code, w.position, w.label, w.scale_lo_steps, w.scale_hi_steps,"
             " w.steps_per_point, w.weight_milli FROM rubric_row w JOIN rubric_revision v"
             " ON v.id = w.revision_id JOIN rubric r ON r.id = v.rubric_id WHERE v.id IN (" +
                 used + ") ORDER BY r.name, v.number, w.row_code",
             {});
  part["anchors"] = rowsOf(
      connection,
      "SELECT r.name, v.number, a.row_code, a.score_steps, a.meaning FROM rubric_anchor a JOIN"
      " rubric_revision v ON v.id = a.revision_id JOIN rubric r ON r.id = v.rubric_id WHERE v.id IN (" +
          used + ") ORDER BY r.name, v.number, a.row_code, a.score_steps",
      {});
  return part;
}

Json evaluationOf(Connection& connection, const SiteScope& scope) {
  Json part;
  part["campaign"] = rowsOf(
      connection,
      "SELECT name, scale_lo_steps, scale_hi_steps, steps_per_point FROM evaluation_campaign WHERE id = ?",
      {scope.campaignId});
  part["classes"] = rowsOf(connection,
                           "SELECT class_code, weight_milli FROM evaluation_class WHERE campaign_id = ?"
                           " ORDER BY class_code",
                           {scope.campaignId});
  part["indices"] = rowsOf(connection,
                           "SELECT index_number, code, label, weight_milli FROM evaluation_index"
                           " WHERE campaign_id = ? ORDER BY index_number",
                           {scope.campaignId});
  part["models"] = rowsOf(connection,
                          "SELECT model_code, label FROM evaluation_model WHERE campaign_id = ?"
                          " ORDER BY model_code",
                          {scope.campaignId});
  return part;
}

Json competenceOf(Connection& connection, const SiteScope& scope) {
  return rowsOf(connection,
                "SELECT m.code, d.version, d.tolerance_rad, d.tolerance_source, d.adequate, d.inadequate,"
                " d.attempts, d.false_pass_most, d.false_fail_most, d.sum_limit, d.session_correlation,"
                " d.lag_correlation, d.runs_per_session, d.valid_days FROM competence_design d JOIN module m"
                " ON m.id = d.module_id WHERE m.version_id = ? ORDER BY m.code, d.version",
                {scope.versionId});
}

/// A scene on which several organs were twisted (arms of the people themselves) says nothing.
Json organsOf(Connection& connection, const SiteScope& scope) {
  Json part = Json::object();
  std::set<std::string> several;
  Statement row = connection.prepare(
      "SELECT t.scene_id, t.pattern_id, t.organ_hash, t.parameter_hash FROM trial t JOIN enrolment e"
      " ON e.id = t.enrolment_id WHERE e.cohort_id = ? GROUP BY t.scene_id, t.pattern_id, t.organ_hash,"
      " t.parameter_hash");
  row.execute({scope.cohortId});
  while (row.step()) {
    const std::string place = row.text(0) + ", " + row.text(1);
    const std::string hashes = row.text(2) + " " + row.text(3);
    if (part.contains(place)) {
      several.insert(place);
    }
    part[place] = hashes;
  }
  for (const std::string& place : several) {
    part.erase(place);
  }
  return part;
}

/// Returns the first place at which two JSON values differ, and what stands there.
Text firstDifference(const Json& here, const Json& package) {
  const auto shown = [](const Json& whole, const std::string& path) {
    const Json::json_pointer place(path);
    const std::string text = whole.contains(place) ? whole.at(place).dump() : "-";
    constexpr std::size_t kMost = 80;
    return text.size() <= kMost ? text : text.substr(0, kMost) + "...";
  };
  const Json changes = Json::diff(here, package);
  const std::string path = changes.front().at("path").get<std::string>();
  return Text::tr("%1 is %2 here and %3 in the package", path, shown(here, path), shown(package, path));
}

Json parsed(const TrialProtocol& protocol, const std::string& part) {
  const auto found = protocol.parts.find(part);
  return found == protocol.parts.end() ? Json() : Json::parse(found->second, nullptr, false);
}

}  // namespace

std::string TrialProtocol::hash() const {
  Digest digest;
  for (const auto& [name, json] : parts) {
    if (name != kOrgans) {
      digest.update(static_cast<std::int64_t>(name.size()));
      digest.update(name);
      digest.update(static_cast<std::int64_t>(json.size()));
      digest.update(json);
    }
  }
  return digest.hex();
}

TrialProtocol protocolOf(Connection& connection, const SiteScope& scope) {
  const Json rules{{"metrics", kMetricsVersion}, {"scores", kTrainingFormulaVersion}};
  TrialProtocol protocol;
  protocol.parts = {{"competence", competenceOf(connection, scope).dump()},
                    {"curriculum", curriculumOf(connection, scope).dump()},
                    {"evaluation", evaluationOf(connection, scope).dump()},
                    {"groups", groupsOf(connection, scope).dump()},
                    {kOrgans, organsOf(connection, scope).dump()},
                    {"rubrics", rubricsOf(connection, scope).dump()},
                    {"rules", rules.dump()}};
  return protocol;
}

std::vector<Text> protocolDifferences(const TrialProtocol& here, const TrialProtocol& package) {
  std::vector<Text> differences;
  for (const PartName& part : kParts) {
    Json ours = parsed(here, part.part);
    Json theirs = parsed(package, part.part);
    if (part.part == std::string(kOrgans) && ours.is_object() && theirs.is_object()) {
      for (auto own = ours.begin(); own != ours.end();) {
        own = theirs.contains(own.key()) ? std::next(own) : ours.erase(own);
      }
      for (auto other = theirs.begin(); other != theirs.end();) {
        other = ours.contains(other.key()) ? std::next(other) : theirs.erase(other);
      }
    }
    if (ours != theirs) {
      differences.push_back(Text::tr("%1: %2", part.name, firstDifference(ours, theirs)));
    }
  }
  return differences;
}

}  // namespace torsio
