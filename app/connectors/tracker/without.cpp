// SPDX-License-Identifier: GPL-3.0-or-later
// Built instead of the connector (TORSIO_TRACKER=OFF): no tracker and no outlet are set, so none is ever
// opened.
#include "app/connectors/tracker/instrument_outlet.h"
#include "app/connectors/tracker/tracker_choice.h"
#include "app/connectors/tracker/tracker_link.h"
#include "sim/core/error.h"

namespace torsio {

TrackerChoice rememberedTracker() {
  return {};
}

void rememberTracker(const TrackerChoice& /*choice*/) {
  throw Error(ErrorCode::kUsage, Text::tr("this program was built without trackers"), Text(), Text());
}

std::shared_ptr<InstrumentOutlet> outletOfThisStation() {
  return nullptr;
}

InstrumentOutlet::~InstrumentOutlet() = default;
void InstrumentOutlet::show(const LiveState& /*state*/) {}

TrackerLink::TrackerLink(const TrackerPlace& place) : place_(place) {}
TrackerLink::~TrackerLink() = default;
TrackerView TrackerLink::view() const {
  return {};
}
void TrackerLink::record(std::shared_ptr<SpscRing<Sample>> /*ring*/) {}
std::int64_t TrackerLink::lateRecorded() const {
  return 0;
}

}  // namespace torsio
