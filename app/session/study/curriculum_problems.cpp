// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps a draft from being published.
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include "app/session/study/curriculum_content.h"
#include "app/session/training/attempts.h"
#include "assessment/metrics/metric_cards.h"
#include "sim/base/error.h"
#include "sim/scene/scene.h"

namespace torsio {

namespace {

/// Unit of a metric that a mastery rule may name; empty: there is no such metric.
std::optional<std::string_view> unitOf(const std::string& metric) {
  if (metric == kOnTargetMetric) return "1";
  if (metric == kTargetsReachedMetric) return "count";
  for (const MetricCard& card : metricCards()) {
    if (card.id == metric) return card.unit;
  }
  return std::nullopt;
}

/// Goes through a draft in reading order and collects what is wrong.
class Examination {
 public:
  Examination(const StoredCurriculumVersion& content, const std::filesystem::path& assets)
      : content_(content), assets_(assets) {}

  std::vector<CurriculumProblem> run() {
    if (content_.modules.empty() && content_.arms.empty()) {
      add("curriculum", "has neither modules nor arms", "Add a module, or begin with a template");
    }
    readScenes();
    checkCodes();
    for (const StoredModule& module : content_.modules) checkModule(module);
    checkCircle();
    for (const StoredArm& arm : content_.arms) checkArm(arm);
    checkScoringPoints();
    return std::move(problems_);
  }

 private:
  void add(const std::string& where, const std::string& what, const std::string& remedy) {
    problems_.push_back({where, what, remedy});
  }

  void readScenes() {
    if (assets_.empty()) return;
    for (const std::string& scene : sceneIds(assets_)) {
      try {
        patterns_[scene] = patternIds(assets_, scene);
      } catch (const Error& problem) {
        add("scene " + scene, problem.happened(), problem.remedy());
      }
    }
  }

  void checkCodes() {
    std::set<std::string> seen;
    for (const StoredModule& module : content_.modules) {
      if (module.code.empty()) {
        add("module \"" + module.title + "\"", "has no code", "Give it a short one, such as M1");
      } else if (!seen.insert(module.code).second) {
        add("module " + module.code, "has the code of another module", "Rename one of them");
      }
    }
    modules_ = seen;
    seen.clear();
    for (const StoredArm& arm : content_.arms) {
      if (arm.code.empty()) {
        add("arm \"" + arm.label + "\"", "has no code", "Give it a short one, such as G1");
      } else if (!seen.insert(arm.code).second) {
        add("arm " + arm.code, "has the code of another arm", "Rename one of them");
      }
    }
  }

  void checkModule(const StoredModule& module) {
    const std::string where = "module " + module.code;
    if (module.title.empty()) add(where, "has no title", "Say in a few words what is practised");
    checkScene(module, where);
    const std::vector<std::string>& kinds = exerciseKinds();
    if (std::find(kinds.begin(), kinds.end(), module.exerciseKind) == kinds.end()) {
      add(where, "has an unknown exercise \"" + module.exerciseKind + "\"", "Choose one from the list");
    }
    if (module.mode != "practice" && module.mode != "graded") {
      add(where, "is neither practice nor graded", "Choose one of the two");
    }
    if (module.targetAngle_rad == 0.0) add(where, "has a target of 0 degrees", "Enter how far to twist");
    if (module.tolerance_rad <= 0.0) add(where, "has no tolerance", "Enter at least one degree");
    if (module.maxForce_N && *module.maxForce_N <= 0.0) {
      add(where, "allows no force", "Enter a limit above 0 N, or none");
    }
    if (module.maxTorque_Nm && *module.maxTorque_Nm <= 0.0) {
      add(where, "allows no torque", "Enter a limit above 0 N m, or none");
    }
    for (const std::string& required : module.requires_) {
      if (required == module.code) {
        add(where, "requires itself", "Remove it from its own prerequisites");
      } else if (!modules_.contains(required)) {
        add(where, "requires \"" + required + "\", which is no module of this curriculum",
            "Choose prerequisites from the list");
      }
    }
    checkMastery(module, where);
  }

  void checkScene(const StoredModule& module, const std::string& where) {
    if (assets_.empty()) return;
    const auto scene = patterns_.find(module.sceneId);
    if (scene == patterns_.end()) {
      add(where, "has an unknown scene \"" + module.sceneId + "\"", "Choose one from the list");
      return;
    }
    if (std::find(scene->second.begin(), scene->second.end(), module.patternId) == scene->second.end()) {
      add(where, "has a pattern \"" + module.patternId + "\" that the scene " + module.sceneId + " lacks",
          "Choose one from the list");
    }
  }

  void checkMastery(const StoredModule& module, const std::string& where) {
    std::set<std::string> seen;
    for (const StoredMasteryRule& rule : module.mastery) {
      const std::string place = where + ", mastery " + rule.metric;
      const std::optional<std::string_view> unit = unitOf(rule.metric);
      if (!unit) {
        add(place, "is measured by nothing", "Choose a metric from the list");
      } else if (rule.unit != *unit) {
        add(place, "is given in \"" + rule.unit + "\"", "Give it in " + std::string(*unit));
      }
      if (!seen.insert(rule.metric).second) add(place, "stands twice", "Keep one of the two rules");
      if (rule.comparison != "at_least" && rule.comparison != "at_most") {
        add(place, "compares by \"" + rule.comparison + "\"", "Choose at least or at most");
      }
      if (module.attemptLimit && rule.consecutive > *module.attemptLimit) {
        add(place,
            "asks for " + std::to_string(rule.consecutive) + " in a row, but only " +
                std::to_string(*module.attemptLimit) + " attempts are allowed",
            "Allow more attempts, or ask for fewer");
      }
    }
  }

  /// Takes away, again and again, the modules whose prerequisites are all gone; what stays runs in a circle.
  void checkCircle() {
    std::map<std::string, std::vector<std::string>> open;
    for (const StoredModule& module : content_.modules) open[module.code] = module.requires_;
    for (std::size_t before = 0; before != open.size();) {
      before = open.size();
      std::erase_if(open, [&](const auto& entry) {
        return std::none_of(entry.second.begin(), entry.second.end(), [&](const std::string& code) {
          return code != entry.first && open.contains(code);
        });
      });
    }
    if (open.empty()) return;
    std::string names;
    for (const auto& [code, required] : open) names += (names.empty() ? "" : ", ") + code;
    add("modules " + names, "wait for each other: nobody could ever begin them", "Remove one prerequisite");
  }

  void checkArm(const StoredArm& arm) {
    const std::string where = "arm " + arm.code;
    if (arm.label.empty()) add(where, "has no name", "Say in a few words what it goes through");
    if (arm.phases.empty()) add(where, "has no phases", "Add at least one");
    for (std::size_t i = 0; i < arm.phases.size(); ++i) {
      const StoredPhase& phase = arm.phases[i];
      const std::string place = where + ", phase " + std::to_string(i + 1);
      if (phase.kind != "virtual" && phase.kind != "real") {
        add(place, "is neither on the virtual nor on the real arm", "Choose one of the two");
      }
      if (phase.label.empty()) add(place, "has no name", "Give it one, such as \"virtual 0-20 min\"");
      if (phase.duration_us <= 0) add(place, "takes no time", "Enter its minutes");
      if (!phase.moduleId.empty() && !modules_.contains(phase.moduleId)) {
        add(place, "practises \"" + phase.moduleId + "\", which is no module of this curriculum",
            "Choose one from the list, or none for any module");
      }
      if (!phase.moduleId.empty() && phase.kind == "real") {
        add(place, "names a module of the simulator, but happens on the real arm", "Remove the module");
      }
    }
  }

  void checkScoringPoints() {
    std::set<std::string> seen;
    std::int64_t longest_us = 0;
    for (const StoredArm& arm : content_.arms) {
      std::int64_t total_us = 0;
      for (const StoredPhase& phase : arm.phases) total_us += phase.duration_us;
      longest_us = std::max(longest_us, total_us);
    }
    std::int64_t before_us = -1;
    for (const char* code : {"pre", "mid", "post"}) {
      for (const StoredScoringPoint& point : content_.scoringPoints) {
        if (point.code != code) continue;
        const std::string where = std::string("scoring point ") + code;
        if (!seen.insert(code).second) add(where, "stands twice", "Keep one of the two");
        if (point.afterExposure_us <= before_us) {
          add(where, "does not come after the one before", "Give each a later time than the last");
        }
        before_us = point.afterExposure_us;
        if (!content_.arms.empty() && point.afterExposure_us > longest_us) {
          add(where, "comes later than any arm trains", "Give an earlier time, or longer phases");
        }
      }
    }
    for (const StoredScoringPoint& point : content_.scoringPoints) {
      if (!seen.contains(point.code)) {
        add("scoring point \"" + point.code + "\"", "is not known", "Choose pre, mid or post");
      }
    }
  }

  const StoredCurriculumVersion& content_;
  const std::filesystem::path& assets_;
  std::set<std::string> modules_;
  std::map<std::string, std::vector<std::string>> patterns_;
  std::vector<CurriculumProblem> problems_;
};

}  // namespace

const std::vector<std::string>& exerciseKinds() {
  static const std::vector<std::string> kKinds{"twist to target", "hold", "follow"};
  return kKinds;
}

std::vector<CurriculumProblem> curriculumProblems(const StoredCurriculumVersion& content,
                                                  const std::filesystem::path& assets) {
  return Examination(content, assets).run();
}

}  // namespace torsio
