// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/bookmarks.h"

#include <cmath>

#include "db/repository/base/id_source.h"
#include "db/repository/trial/remark_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio {

RemarkId keepBookmark(SessionContext& session, const TrialListing& trial, double at_s,
                      const std::string& text) {
  const double length_s = trial.summary ? spanOf_s(trial.summary->samples) : 0.0;
  if (!std::isfinite(at_s) || at_s < 0.0 || at_s > length_s) {
    refuseParameter(Text::tr("the moment lies outside the recording"), trial.trialId,
                    Text::tr("Choose a time within it"));
  }
  const RemarkId id = session.ids().newUuid();
  RemarkRepository(session.connection())
      .add({.id = id,
            .trialId = trial.trialId,
            .author = session.actor().userId,
            .authorPersonId = session.actor().personId,
            .purpose = "bookmark",
            .tick = std::llround(at_s * 1e3),
            .time_us = std::llround(at_s * 1e6),
            .text = text,
            .createdUtc_us = session.now_us(),
            .demonstration = trial.demonstration});
  return id;
}

}  // namespace torsio
