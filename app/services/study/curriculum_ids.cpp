// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/curriculum_ids.h"

#include <map>

#include "db/repository/base/id_source.h"

namespace torsio {

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
