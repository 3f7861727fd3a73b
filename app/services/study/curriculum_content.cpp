// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/curriculum_content.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "db/repository/base/id_source.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"
#include "sim/scene/json_fields.h"

namespace torsio {

namespace {

using nlohmann::json;

constexpr const char* kFormat = "torsio curriculum 1";
constexpr double kMaxSeconds = 1e6;
constexpr double kMaxDegrees = 3600.0;
constexpr double kMost = 1e9;
constexpr int kMaxCount = 1'000'000;
constexpr int kMaxTwists = 1'000;

/// Rounds to billionths of a degree, so that 60 is shown as 60 again.
double writtenDegrees(double angle_rad) {
  constexpr double kDigits = 1e9;
  return std::round(degrees(angle_rad) * kDigits) / kDigits;
}

json moduleJson(const TrainingModule& module) {
  json out{{"code", module.code},
           {"title", module.title},
           {"scene", module.sceneId},
           {"pattern", module.patternId},
           {"mode", storedText(module.mode)},
           {"target_deg", writtenDegrees(module.targetAngle_rad)},
           {"tolerance_deg", writtenDegrees(module.tolerance_rad)},
           {"hold_s", static_cast<double>(module.hold_us) / kSecond_us},
           {"requires", module.requires_},
           {"mastery", json::array()}};
  if (module.leastTwists > 1) {
    out["least_twists"] = module.leastTwists;
  }
  if (module.maxForce_N) {
    out["max_force_n"] = *module.maxForce_N;
  }
  if (module.maxTorque_Nm) {
    out["max_torque_nm"] = *module.maxTorque_Nm;
  }
  if (module.attemptLimit) {
    out["attempt_limit"] = *module.attemptLimit;
  }
  for (const MasteryCriterion& rule : module.mastery) {
    out["mastery"].push_back({{"metric", rule.metric},
                              {"comparison", rule.comparison},
                              {"threshold", rule.threshold},
                              {"unit", rule.unit},
                              {"consecutive", rule.consecutive}});
  }
  return out;
}

json armJson(const StudyArm& arm) {
  json out{{"code", arm.code},
           {"label", arm.label},
           {"rest_min", static_cast<double>(arm.restAllowance_us) / kMinute_us},
           {"rest_splittable", arm.restSplittable},
           {"phases", json::array()}};
  for (const TrainingPhase& phase : arm.phases) {
    json step{{"kind", storedText(phase.kind)},
              {"label", phase.label},
              {"minutes", static_cast<double>(phase.duration_us) / kMinute_us}};
    if (!phase.moduleId.empty()) {
      step["module"] = phase.moduleId;
    }
    out["phases"].push_back(std::move(step));
  }
  return out;
}

/// Returns the elements of an optional array.
std::vector<json> elements(JsonFields& fields, const std::string& name) {
  if (!fields.has(name)) {
    return {};
  }
  const json& list = fields.child(name);
  if (!list.is_array()) {
    fields.refuse(name, Text::tr("must be a list in brackets"), Text::tr("Write [ ... ]."));
  }
  return list.get<std::vector<json>>();
}

std::string placeIn(const JsonFields& fields, const std::string& name, std::size_t index) {
  return fields.where() + ", " + name + " " + std::to_string(index + 1);
}

bool flag(JsonFields& fields, const std::string& name) {
  if (!fields.has(name)) {
    return false;
  }
  const json& value = fields.child(name);
  if (!value.is_boolean()) {
    fields.refuse(name, Text::tr("must be true or false"), Text::tr("Correct the value."));
  }
  return value.get<bool>();
}

std::int64_t microseconds(JsonFields& fields, const std::string& name, double most, double unit_us,
                          double fallback) {
  return std::llround(fields.number(name, 0.0, most, fallback) * unit_us);
}

/// Parses the text of a field to a value, `fallback` if missing; `message` is the error for invalid texts.
template <typename Value>
Value readTerm(JsonFields& fields, const std::string& name, Value fallback, const Text& message) {
  const std::optional<Value> value =
      fromStoredText<Value>(fields.text(name, std::string(storedText(fallback))));
  if (!value) {
    fields.refuse(name, message, Text::tr("Choose one of the two"));
  }
  return *value;
}

MasteryCriterion readRule(const json& source, const std::string& place) {
  JsonFields fields(source, place);
  MasteryCriterion rule;
  rule.metric = fields.text("metric", "");
  rule.comparison = fields.text("comparison", rule.comparison);
  rule.threshold = fields.number("threshold", -kMost, kMost, 0.0);
  rule.unit = fields.text("unit", "");
  rule.consecutive = fields.integer("consecutive", 1, kMaxCount, 1);
  fields.finish();
  return rule;
}

TrainingModule readModule(const json& source, const std::string& place) {
  JsonFields fields(source, place);
  TrainingModule module;
  module.code = fields.text("code", "");
  module.id = module.code;
  module.title = fields.text("title", "");
  module.sceneId = fields.text("scene", "");
  module.patternId = fields.text("pattern", "");
  module.mode = readTerm(fields, "mode", module.mode, Text::tr("is neither practice nor graded"));
  module.targetAngle_rad = radians(fields.number("target_deg", -kMaxDegrees, kMaxDegrees, 0.0));
  module.tolerance_rad = radians(fields.number("tolerance_deg", 0.0, kMaxDegrees, 0.0));
  module.hold_us = microseconds(fields, "hold_s", kMaxSeconds, kSecond_us, 0.0);
  module.leastTwists = fields.integer("least_twists", 1, kMaxTwists, 1);
  if (fields.has("max_force_n")) {
    module.maxForce_N = fields.number("max_force_n", 0.0, kMost);
  }
  if (fields.has("max_torque_nm")) {
    module.maxTorque_Nm = fields.number("max_torque_nm", 0.0, kMost);
  }
  if (fields.has("attempt_limit")) {
    module.attemptLimit = fields.integer("attempt_limit", 1, kMaxCount, 1);
  }
  for (const json& required : elements(fields, "requires")) {
    if (!required.is_string()) {
      fields.refuse("requires", Text::tr("must list codes of modules"), Text::tr("Put them in quotes."));
    }
    module.requires_.push_back(required.get<std::string>());
  }
  const std::vector<json> rules = elements(fields, "mastery");
  for (std::size_t i = 0; i < rules.size(); ++i) {
    module.mastery.push_back(readRule(rules[i], placeIn(fields, "mastery", i)));
  }
  fields.finish();
  return module;
}

StudyArm readArm(const json& source, const std::string& place) {
  JsonFields fields(source, place);
  StudyArm arm;
  arm.code = fields.text("code", "");
  arm.id = arm.code;
  arm.label = fields.text("label", "");
  arm.restAllowance_us = microseconds(fields, "rest_min", kMaxMinutes, kMinute_us, 0.0);
  arm.restSplittable = flag(fields, "rest_splittable");
  const std::vector<json> phases = elements(fields, "phases");
  for (std::size_t i = 0; i < phases.size(); ++i) {
    JsonFields step(phases[i], placeIn(fields, "phases", i));
    TrainingPhase phase;
    phase.kind =
        readTerm(step, "kind", phase.kind, Text::tr("is neither on the virtual nor on the real arm"));
    phase.label = step.text("label", "");
    phase.duration_us = microseconds(step, "minutes", kMaxMinutes, kMinute_us, 0.0);
    phase.moduleId = step.text("module", "");
    step.finish();
    arm.phases.push_back(std::move(phase));
  }
  fields.finish();
  return arm;
}

CurriculumVersion readContent(JsonFields& fields) {
  if (const std::string format = fields.text("format"); format != kFormat) {
    fields.refuse("format", "is '" + format + "'", std::string("This program reads ") + kFormat + ".");
  }
  CurriculumVersion content;
  const std::vector<json> modules = elements(fields, "modules");
  for (std::size_t i = 0; i < modules.size(); ++i) {
    content.modules.push_back(readModule(modules[i], placeIn(fields, "modules", i)));
  }
  const std::vector<json> arms = elements(fields, "arms");
  for (std::size_t i = 0; i < arms.size(); ++i) {
    content.arms.push_back(readArm(arms[i], placeIn(fields, "arms", i)));
  }
  const std::vector<json> points = elements(fields, "occasions");
  for (std::size_t i = 0; i < points.size(); ++i) {
    JsonFields point(points[i], placeIn(fields, "occasions", i));
    PlannedOccasion stored{point.text("code", ""),
                           microseconds(point, "after_min", kMaxMinutes, kMinute_us, 0.0)};
    point.finish();
    content.plannedOccasions.push_back(std::move(stored));
  }
  return content;
}

json parsed(const std::string& text, const std::string& name) {
  try {
    return json::parse(text);
  } catch (const json::exception& problem) {
    refuse(Text::tr("is not JSON: %1", problem.what()), name, Text::tr("Correct the text"));
  }
}

}  // namespace

std::string curriculumJson(const CurriculumVersion& content) {
  json out{
      {"format", kFormat}, {"modules", json::array()}, {"arms", json::array()}, {"occasions", json::array()}};
  for (const TrainingModule& module : content.modules) {
    out["modules"].push_back(moduleJson(module));
  }
  for (const StudyArm& arm : content.arms) {
    out["arms"].push_back(armJson(arm));
  }
  for (const PlannedOccasion& point : content.plannedOccasions) {
    out["occasions"].push_back(
        {{"code", point.code}, {"after_min", static_cast<double>(point.afterExposure_us) / kMinute_us}});
  }
  return out.dump(2);
}

CurriculumVersion parseCurriculum(const std::string& text, const std::string& name) {
  const json source = parsed(text, name);
  JsonFields fields(source, name);
  CurriculumVersion content = readContent(fields);
  fields.finish();
  return content;
}

std::vector<CurriculumTemplate> curriculumTemplates(const std::filesystem::path& assets) {
  const std::filesystem::path folder = assets / "curricula";
  if (!std::filesystem::is_directory(folder)) {
    throw Error(ErrorCode::kFileMissing, Text::tr("no such folder"), folder.string(),
                Text::tr("Restore it from the installation"));
  }
  std::vector<CurriculumTemplate> templates;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") {
      continue;
    }
    const std::string name = entry.path().filename().string();
    const json source = parsed(readFile(entry.path()), name);
    JsonFields fields(source, name);
    CurriculumTemplate shipped;
    shipped.id = entry.path().stem().string();
    shipped.title = fields.text("title");
    shipped.description = fields.text("description");
    shipped.content = readContent(fields);
    fields.finish();
    templates.push_back(std::move(shipped));
  }
  std::sort(templates.begin(), templates.end(),
            [](const CurriculumTemplate& a, const CurriculumTemplate& b) { return a.id < b.id; });
  return templates;
}

CurriculumVersion withCodes(CurriculumVersion version) {
  std::map<ModuleId, ModuleId> codes;
  for (const TrainingModule& module : version.modules) {
    codes[module.id] = module.code;
  }
  for (TrainingModule& module : version.modules) {
    module.id = module.code;
    for (ModuleId& required : module.requires_) {
      required = codes[required];
    }
  }
  for (StudyArm& arm : version.arms) {
    arm.id = arm.code;
    for (TrainingPhase& phase : arm.phases) {
      phase.id = {};
      if (!phase.moduleId.empty()) {
        phase.moduleId = codes[phase.moduleId];
      }
    }
  }
  return version;
}

CurriculumVersion withIds(CurriculumVersion draft, IdSource& ids) {
  std::map<ModuleId, ModuleId> idOf;
  for (TrainingModule& module : draft.modules) {
    module.id = ids.newUuid();
    idOf[module.code] = module.id;
  }
  for (TrainingModule& module : draft.modules) {
    for (ModuleId& required : module.requires_) {
      required = idOf.at(required);
    }
  }
  for (StudyArm& arm : draft.arms) {
    arm.id = ids.newUuid();
    for (TrainingPhase& phase : arm.phases) {
      phase.id = ids.newUuid();
      if (!phase.moduleId.empty()) {
        phase.moduleId = idOf.at(phase.moduleId);
      }
    }
  }
  return draft;
}

}  // namespace torsio
