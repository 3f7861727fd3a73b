// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/organs/person_arm.h"

#include "sim/anatomy/forearm.h"
#include "sim/anatomy/shipped_files.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/short_number.h"

namespace torsio {

namespace {

void requireWithin(const PersonLength& range, double length_mm, const Text& name) {
  if (!(length_mm >= range.least_mm && length_mm <= range.most_mm)) {
    refuseParameter(Text::tr("%1 mm is outside the range of this measurement", shortNumber(length_mm)), name,
                    Text::tr("Give %1 to %2 mm", shortNumber(range.least_mm), shortNumber(range.most_mm)));
  }
}

ArmMeasures measuresOf(const PersonArm& person) {
  ArmMeasures measures;
  if (person.wristWidth_mm || person.wristThickness_mm) {
    const double width_mm = person.wristWidth_mm.value_or(kWristWidth.man_mm);
    const double thickness_mm = person.wristThickness_mm.value_or(kWristThickness.man_mm);
    requireWithin(kWristWidth, width_mm, Text::tr("width of the wrist"));
    requireWithin(kWristThickness, thickness_mm, Text::tr("thickness of the wrist"));
    setWrist(measures, width_mm, thickness_mm);
  }
  requireWithin(kForearmLength, person.forearmLength_mm, Text::tr("length of the forearm"));
  requireWithin(kPalmLength, person.palmLength_mm, Text::tr("length of the palm"));
  requireWithin(kHandBreadth, person.handBreadth_mm, Text::tr("breadth of the hand"));
  requireWithin(kHandThickness, person.handThickness_mm, Text::tr("thickness of the hand"));
  measures.forearmLength_mm = person.forearmLength_mm;
  measures.palmLength_mm = person.palmLength_mm;
  measures.handBreadth_mm = person.handBreadth_mm;
  measures.handThickness_mm = person.handThickness_mm;
  for (std::size_t finger = 0; finger < kFingers.size(); ++finger) {
    requireWithin(kFingers[finger], person.fingers_mm[finger], Text::tr("finger %1", finger + 1));
  }
  measures.fingerLength_mm = person.fingers_mm;
  return measures;
}

}  // namespace

JudgedArm importArm(const PersonArm& person, const std::filesystem::path& assets) {
  const auto arm = std::make_shared<const Arm>(makeArm(measuresOf(person)));
  OrganImportRequest request;
  request.assets = assets;
  request.file = "arm.ply";
  // The patterns of the shipped forearm: the elbow is fixed, the hand follows the wrist.
  request.anatomy = "forearm";
  request.ends = {
      .fixedEnd_m = arm->fixedEnd_m, .freeEnd_m = arm->wrist_m, .fixedCut = {}, .freeCut = {0.0, 0.0, 1.0}};
  return {importOrgan(request, [&arm] { return RawMesh{.mesh = arm->surface, .ignored = {}}; }), arm};
}

void writeArmMarkers(const std::filesystem::path& organFile, const Arm& arm) {
  std::filesystem::path markers = organFile;
  markers.replace_filename(organFile.stem().string() + "_markers.json");
  writeFileAtomically(markers, armMarkersJson(arm, organFile.filename().string()));
}

}  // namespace torsio
