// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/text_packing.h"
#include "sim/device/process/device_channel.h"

namespace torsio {

namespace {

/// One order of fields for both ways.
template <typename Way, typename Report>
void texts(Way& way, Report& report) {
  way.text(report.library.path);
  way.list(report.library.searched);
  way.list(report.library.missingSymbols);
  way.list(report.library.absentOptionals);
  way.text(report.library.sentence);
  way.text(report.library.remedy);
  way.text(report.finding.sentence);
  way.text(report.finding.remedy);
  way.list(report.finding.notes);
  way.text(report.happened);
  way.text(report.where);
  way.text(report.remedy);
  way.text(report.capabilities.model);
  way.text(report.identity.model);
  way.text(report.identity.vendor);
  way.text(report.identity.serial);
  way.text(report.identity.driverVersion);
  way.text(report.identity.libraryVersion);
  way.text(report.identity.openedAs);
  way.list(report.identity.assumed);
  way.list(report.identity.notes);
}

}  // namespace

std::string packed(const ChannelReport& report) {
  TextPacker way;
  const DeviceCapabilities& c = report.capabilities;
  way.number(static_cast<double>(report.library.status));
  way.number(report.finding.available ? 1.0 : 0.0);
  for (const double value :
       {c.maxForce_N, c.continuousForce_N, c.maxStiffness_N_per_m, c.workspaceMin_m.x, c.workspaceMin_m.y,
        c.workspaceMin_m.z, c.workspaceMax_m.x, c.workspaceMax_m.y, c.workspaceMax_m.z}) {
    way.number(value);
  }
  way.number(report.identity.inputDof);
  way.number(report.identity.outputDof);
  texts(way, report);
  return way.bytes();
}

ChannelReport unpacked(const std::string& bytes) {
  ChannelReport report;
  TextUnpacker way(bytes);
  const std::size_t status = way.count(static_cast<std::size_t>(HdapiLoadStatus::kSymbolMissing));
  report.library.status = static_cast<HdapiLoadStatus>(status);
  report.finding.available = way.number() == 1.0;
  DeviceCapabilities& c = report.capabilities;
  for (double* value : {&c.maxForce_N, &c.continuousForce_N, &c.maxStiffness_N_per_m, &c.workspaceMin_m.x,
                        &c.workspaceMin_m.y, &c.workspaceMin_m.z, &c.workspaceMax_m.x, &c.workspaceMax_m.y,
                        &c.workspaceMax_m.z}) {
    *value = way.number();
  }
  report.identity.inputDof = static_cast<int>(way.number());
  report.identity.outputDof = static_cast<int>(way.number());
  texts(way, report);
  c.rendersForce = true;
  c.realTime = true;
  return report;
}

}  // namespace torsio
