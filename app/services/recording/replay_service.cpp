// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/replay_service.h"

#include <limits>
#include <vector>

#include "app/services/recording/detorsion_rules.h"
#include "app/services/recording/kept_digests.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/scene/scene.h"

namespace torsio {

namespace {

/// Returns the single trial whose id is `text` or begins with it.
std::string fullTrialId(TrialRepository& trials, const std::string& text) {
  TrialFilter everything;
  everything.limit = std::numeric_limits<std::int32_t>::max();
  std::vector<std::string> found;
  for (const TrialListing& listing : trials.list(everything)) {
    if (listing.trialId.text().rfind(text, 0) == 0) {
      found.push_back(listing.trialId);
    }
  }
  if (found.size() == 1) {
    return found.front();
  }
  refuse(found.empty() ? Text::tr("no run has this id") : Text::tr("several runs begin like this"),
         Text::tr("run %1", text),
         found.empty() ? Text::tr("Check the id and the database") : Text::tr("Give more of the id"));
}

}  // namespace

Trial loadStoredTrial(const std::string& database, const TrialId& trialId) {
  Connection connection = openRecord(database, OpenMode::kReadOnly);
  TrialRepository trials(connection);
  return trials.load(fullTrialId(trials, trialId));
}

LoadedRun loadStoredRun(const std::string& database, const TrialId& trialId,
                        const std::filesystem::path& assets) {
  Connection connection = openRecord(database, OpenMode::kReadOnly);
  TrialRepository trials(connection);
  LoadedRun run{.trial = trials.load(fullTrialId(trials, trialId)), .rules = {}};
  const TrialHeader& header = run.trial.header;
  const TrialContext context = trials.context(header.trialId).value_or(TrialContext{});
  ExerciseRules exercises(assets);
  run.rules =
      recordedRules(exercises.of(connection, header.sceneId, header.patternId, context.moduleId), header);
  return run;
}

ReplayResult replayStoredTrial(const ReplayRequest& request) {
  const Trial trial = loadStoredTrial(request.database, request.trialId);
  SceneRequest wanted = sceneRequestFor(trial.header.parametersJson);
  wanted.assets = request.assets;
  wanted.id = trial.header.sceneId;
  wanted.pattern = trial.header.patternId;
  wanted.organFile = request.organFile;
  wanted.organScale_m = request.organScale_m;
  const Scene scene = loadScene(wanted);
  return {trial.header, trial.summary, replayTrial(scene, trial)};
}

}  // namespace torsio
