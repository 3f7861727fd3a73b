// SPDX-License-Identifier: GPL-3.0-or-later
// Problems that prevent publishing a draft.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

#include "app/services/base/identifiers.h"
#include "app/services/study/curriculum_content.h"
#include "assessment/catalogue/quantity.h"
#include "assessment/domain/study/curriculum.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/scene/rod_organ.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_file.h"

namespace torsio {

namespace {

/// Returns whether the pattern's own target, which its scene guarantees, is at least as far in the same
/// direction.
bool withinPattern(const TwistPattern& pattern, double target_rad) {
  return std::abs(target_rad) <= std::abs(pattern.targetAngle_rad) &&
         (target_rad < 0.0) == (pattern.targetAngle_rad < 0.0);
}

double turnedTowards_rad(const SceneRequest& request, double target_rad) {
  const Scene scene = loadScene(request);
  if (!scene.rod) {
    return target_rad;
  }
  const double reached_rad = scene.rod->pointAt(target_rad).angle_rad;
  constexpr double kRounding = 1e-9;
  return std::abs(reached_rad - target_rad) < kRounding ? target_rad : reached_rad;
}

/// Returns how far a scene's organ can be turned towards `target_rad` with a pattern: the target, or the
/// angle before which the organ folds or slips back by a whole turn. Calculated (half a second, cached per
/// process) only for a target beyond that of a pattern with a task; any other target is returned unchanged.
/// Throws like loadScene(). Any thread.
double targetReach_rad(const std::filesystem::path& assets, const std::string& sceneId,
                       const std::string& patternId, double target_rad) {
  static std::mutex mutex;
  static std::map<std::tuple<std::filesystem::path, std::string, std::string, double>, double> known;
  for (const PatternDescription& one : readSceneFile(assets, sceneId).patterns) {
    if (one.pattern.id == patternId && (!one.pattern.task || withinPattern(one.pattern, target_rad))) {
      return target_rad;
    }
  }
  const std::scoped_lock lock(mutex);
  const auto [entry, isNew] = known.try_emplace({assets, sceneId, patternId, target_rad}, target_rad);
  if (isNew) {
    SceneRequest request;
    request.assets = assets;
    request.id = sceneId;
    request.pattern = patternId;
    try {
      entry->second = turnedTowards_rad(request, target_rad);
    } catch (...) {
      known.erase(entry);
      throw;
    }
  }
  return entry->second;
}

/// Collects the problems of a draft in reading order.
class Examination {
 public:
  Examination(const CurriculumVersion& content, const std::filesystem::path& assets, const Occasions& known)
      : content_(content), assets_(assets), known_(known) {}

  std::vector<CurriculumProblem> run() {
    if (content_.modules.empty() && content_.arms.empty()) {
      add(Text::tr("curriculum"), Text::tr("has neither modules nor arms"),
          Text::tr("Add a module, or begin with a template"));
    }
    readScenes();
    checkCodes();
    for (std::size_t row = 0; row < content_.modules.size(); ++row) {
      goTo(CurriculumSpot::Part::kModule, row);
      checkModule(content_.modules[row]);
    }
    goTo(CurriculumSpot::Part::kWhole);
    checkCircle();
    for (std::size_t row = 0; row < content_.arms.size(); ++row) {
      goTo(CurriculumSpot::Part::kArm, row);
      checkArm(content_.arms[row]);
    }
    checkOccasions();
    return std::move(problems_);
  }

 private:
  void add(const Text& where, const Text& what, const Text& remedy,
           CurriculumField field = CurriculumField::kCode) {
    CurriculumSpot spot = at_;
    spot.field = field;
    problems_.push_back({where, what, remedy, spot});
  }

  /// Sets the location of the following problems.
  void goTo(CurriculumSpot::Part part, std::size_t row = 0) { at_ = {.part = part, .row = row}; }

  void readScenes() {
    if (assets_.empty()) {
      return;
    }
    for (const std::string& scene : sceneIds(assets_)) {
      try {
        for (const PatternDescription& one : readSceneFile(assets_, scene).patterns) {
          patterns_[scene][one.pattern.id] = one.pattern.detorsion != nullptr;
        }
      } catch (const Error& problem) {
        add(Text::tr("scene %1", scene), problem.happenedText(), problem.remedyText());
      }
    }
  }

  void checkCodes() {
    std::set<std::string> alike;  // by likenessOf()
    for (std::size_t row = 0; row < content_.modules.size(); ++row) {
      const TrainingModule& module = content_.modules[row];
      goTo(CurriculumSpot::Part::kModule, row);
      if (module.code.empty()) {
        add(Text::tr("module \"%1\"", module.title), Text::tr("has no code"),
            Text::tr("Give it a short one, such as M1"));
      } else if (!alike.insert(likenessOf(module.code)).second) {
        add(Text::tr("module %1", module.code), Text::tr("has the code of another module"),
            Text::tr("Rename one of them"));
      }
      modules_.insert(module.code);
      checkReadable(Text::tr("module %1", module.code), {&module.code, &module.title});
    }
    alike.clear();
    for (std::size_t row = 0; row < content_.arms.size(); ++row) {
      const StudyArm& arm = content_.arms[row];
      goTo(CurriculumSpot::Part::kArm, row);
      if (arm.code.empty()) {
        add(Text::tr("arm \"%1\"", arm.label), Text::tr("has no code"),
            Text::tr("Give it a short one, such as G1"));
      } else if (!alike.insert(likenessOf(arm.code)).second) {
        add(Text::tr("arm %1", arm.code), Text::tr("has the code of another arm"),
            Text::tr("Rename one of them"));
      }
      checkReadable(Text::tr("arm %1", arm.code), {&arm.code, &arm.label});
      for (const TrainingPhase& phase : arm.phases) {
        checkReadable(Text::tr("arm %1", arm.code), {&phase.label});
      }
    }
  }

  void checkReadable(const Text& where, std::initializer_list<const std::string*> texts) {
    for (const std::string* text : texts) {
      if (const Text flaw = flawOf(*text, kLongestField); !flaw.empty()) {
        add(where, Text::tr("has a text that %1", flaw), Text::tr("Type it again"), CurriculumField::kTitle);
      }
    }
  }

  void checkModule(const TrainingModule& module) {
    const Text where = Text::tr("module %1", module.code);
    if (module.title.empty()) {
      add(where, Text::tr("has no title"), Text::tr("Say in a few words what is practised"),
          CurriculumField::kTitle);
    }
    checkScene(module, where);
    if (module.targetAngle_rad == 0.0 && !undoes(module)) {
      add(where, Text::tr("has a target of 0 degrees"), Text::tr("Enter how far to twist"),
          CurriculumField::kTarget);
    }
    if (module.tolerance_rad <= 0.0) {
      add(where, Text::tr("has no tolerance"), Text::tr("Enter at least one degree"),
          CurriculumField::kTarget);
    }
    if (module.maxForce_N && *module.maxForce_N <= 0.0) {
      add(where, Text::tr("allows no force"), Text::tr("Enter a limit above 0 N, or none"),
          CurriculumField::kLimits);
    }
    if (module.maxTorque_Nm && *module.maxTorque_Nm <= 0.0) {
      add(where, Text::tr("allows no torque"), Text::tr("Enter a limit above 0 N m, or none"),
          CurriculumField::kLimits);
    }
    for (const std::string& required : module.requires_) {
      if (required == module.code) {
        add(where, Text::tr("requires itself"), Text::tr("Remove it from its own prerequisites"),
            CurriculumField::kPrerequisites);
      } else if (!modules_.contains(required)) {
        add(where, Text::tr("requires \"%1\", which is not a module of this curriculum", required),
            Text::tr("Choose prerequisites from the list"), CurriculumField::kPrerequisites);
      }
    }
    checkMastery(module, where);
  }

  void checkScene(const TrainingModule& module, const Text& where) {
    if (assets_.empty()) {
      return;
    }
    const auto scene = patterns_.find(module.sceneId);
    if (scene == patterns_.end()) {
      add(where, Text::tr("has an unknown scene \"%1\"", module.sceneId),
          Text::tr("Choose one from the list"), CurriculumField::kScene);
      return;
    }
    if (!scene->second.contains(module.patternId)) {
      add(where, Text::tr("has a pattern \"%1\" that the scene %2 lacks", module.patternId, module.sceneId),
          Text::tr("Choose one from the list"), CurriculumField::kScene);
      return;
    }
    try {
      const double reach_rad =
          targetReach_rad(assets_, module.sceneId, module.patternId, module.targetAngle_rad);
      if (reach_rad != module.targetAngle_rad) {
        add(where,
            Text::tr("asks for a turn of %1 degrees, but the organ folds or slips back beyond %2",
                     std::lround(degrees(module.targetAngle_rad)),
                     std::lround(std::trunc(degrees(reach_rad)))),
            Text::tr("Enter a smaller target"), CurriculumField::kTarget);
      }
    } catch (const Error& problem) {
      add(where, problem.happenedText(), problem.remedyText(), CurriculumField::kScene);
    }
  }

  /// Returns whether the module's organ starts twisted, so that its target is 0 degrees.
  [[nodiscard]] bool undoes(const TrainingModule& module) const {
    const auto scene = patterns_.find(module.sceneId);
    if (scene == patterns_.end()) {
      return false;
    }
    const auto pattern = scene->second.find(module.patternId);
    return pattern != scene->second.end() && pattern->second;
  }

  void checkMastery(const TrainingModule& module, const Text& where) {
    std::set<std::string> seen;
    for (const MasteryCriterion& rule : module.mastery) {
      const Text place = Text::tr("%1, mastery %2", where, rule.metric);
      const std::optional<Quantity> quantity = quantityOf(rule.metric);
      if (!quantity) {
        add(place, Text::tr("is measured by nothing"), Text::tr("Choose a metric from the list"),
            CurriculumField::kMastery);
      } else if (const std::string_view unit = rowOf(*quantity).unit; rule.unit != unit) {
        add(place, Text::tr("is given in \"%1\"", rule.unit), Text::tr("Give it in %1", unit),
            CurriculumField::kMastery);
      }
      if (!seen.insert(rule.metric).second) {
        add(place, Text::tr("is listed twice"), Text::tr("Keep one of the two rules"),
            CurriculumField::kMastery);
      }
      if (rule.comparison != "at_least" && rule.comparison != "at_most") {
        add(place, Text::tr("compares by \"%1\"", rule.comparison), Text::tr("Choose at least or at most"),
            CurriculumField::kMastery);
      }
      if (module.attemptLimit && rule.consecutive > *module.attemptLimit) {
        add(place,
            Text::tr("asks for %1 in a row, but only %2 {attempt is|attempts are} allowed", rule.consecutive,
                     *module.attemptLimit),
            Text::tr("Allow more attempts, or ask for fewer"), CurriculumField::kMastery);
      }
    }
  }

  /// Repeatedly removes the modules whose prerequisites are all removed; the rest form a cycle.
  void checkCircle() {
    std::map<std::string, std::vector<ModuleId>> open;
    for (const TrainingModule& module : content_.modules) {
      open[module.code] = module.requires_;
    }
    for (std::size_t before = 0; before != open.size();) {
      before = open.size();
      std::erase_if(open, [&](const auto& entry) {
        return std::none_of(entry.second.begin(), entry.second.end(), [&](const std::string& code) {
          return code != entry.first && open.contains(code);
        });
      });
    }
    if (open.empty()) {
      return;
    }
    std::string names;
    for (const auto& [code, required] : open) {
      names += (names.empty() ? "" : ", ") + code;
    }
    add(Text::tr("modules %1", names), Text::tr("require each other, so nobody could ever begin them"),
        Text::tr("Remove one prerequisite"));
  }

  void checkArm(const StudyArm& arm) {
    const Text where = Text::tr("arm %1", arm.code);
    if (arm.label.empty()) {
      add(where, Text::tr("has no name"), Text::tr("Say in a few words what it goes through"),
          CurriculumField::kTitle);
    }
    if (arm.phases.empty()) {
      add(where, Text::tr("has no phases"), Text::tr("Add at least one"), CurriculumField::kPhases);
    }
    for (std::size_t i = 0; i < arm.phases.size(); ++i) {
      const TrainingPhase& phase = arm.phases[i];
      const Text place = Text::tr("%1, phase %2", where, i + 1);
      if (phase.label.empty()) {
        add(place, Text::tr("has no name"), Text::tr("Give it one, such as \"virtual 0-20 min\""),
            CurriculumField::kPhases);
      }
      if (phase.duration_us <= 0) {
        add(place, Text::tr("takes no time"), Text::tr("Enter its minutes"), CurriculumField::kPhases);
      }
      if (!phase.moduleId.empty() && !modules_.contains(phase.moduleId)) {
        add(place, Text::tr("practises \"%1\", which is not a module of this curriculum", phase.moduleId),
            Text::tr("Choose one from the list, or none for any module"), CurriculumField::kPhases);
      }
      if (!phase.moduleId.empty() && phase.kind == PhaseKind::kReal) {
        add(place, Text::tr("names a module of the simulator, but happens on the real arm"),
            Text::tr("Remove the module"), CurriculumField::kPhases);
      }
    }
  }

  void checkOccasions() {
    std::set<std::string> seen;
    std::int64_t longest_us = 0;
    for (const StudyArm& arm : content_.arms) {
      std::int64_t total_us = 0;
      for (const TrainingPhase& phase : arm.phases) {
        total_us += phase.duration_us;
      }
      longest_us = std::max(longest_us, total_us);
    }
    std::int64_t before_us = 0;
    for (std::size_t row = 0; row < known_.size(); ++row) {
      const Occasion& occasion = known_.at(row);
      goTo(CurriculumSpot::Part::kOccasion, row);
      for (const PlannedOccasion& point : content_.plannedOccasions) {
        if (point.code != occasion.code) {
          continue;
        }
        const Text where = Text::tr("occasion %1", point.code);
        if (!seen.insert(point.code).second) {
          add(where, Text::tr("is listed twice"), Text::tr("Keep one of the two"), CurriculumField::kTime);
        }
        if (point.afterExposure_us < before_us) {
          add(where, Text::tr("comes before the one that it follows"),
              Text::tr("Give each the time of the last or a later one"), CurriculumField::kTime);
        }
        before_us = point.afterExposure_us;
        if (!content_.arms.empty() && point.afterExposure_us > longest_us) {
          add(where, Text::tr("is later than the training time of every study arm"),
              Text::tr("Give an earlier time, or longer phases"), CurriculumField::kTime);
        }
      }
    }
    goTo(CurriculumSpot::Part::kWhole);
    for (const PlannedOccasion& point : content_.plannedOccasions) {
      if (!seen.contains(point.code)) {
        add(Text::tr("occasion \"%1\"", point.code), Text::tr("is not known"),
            Text::tr("Choose one from the list"));
      }
    }
  }

  const CurriculumVersion& content_;
  const std::filesystem::path& assets_;
  const Occasions& known_;
  CurriculumSpot at_;
  std::set<std::string> modules_;
  std::map<std::string, std::map<std::string, bool>> patterns_;  // by scene; whether the pattern starts
                                                                 // twisted
  std::vector<CurriculumProblem> problems_;
};

}  // namespace

std::vector<CurriculumProblem> curriculumProblems(const CurriculumVersion& content,
                                                  const std::filesystem::path& assets,
                                                  const Occasions& known) {
  return Examination(content, assets, known).run();
}

}  // namespace torsio
