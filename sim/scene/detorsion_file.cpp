// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/detorsion_file.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "sim/core/angle.h"
#include "sim/scene/json_fields.h"

namespace torsio {

namespace {

constexpr double kMetresPerMm = 1e-3;
constexpr double kSquareMetresPerMm2 = 1e-6;
constexpr double kPascalsPerKpa = 1e3;
constexpr double kSecondsPerHour = 3600.0;
constexpr double kMaxPressure_mmHg = 100.0;
constexpr double kMaxTwist_deg = 1440.0;
constexpr double kLeastSpan = 0.02;  // of the organ's length
constexpr std::size_t kMaxSpans = 2;
constexpr std::size_t kMaxWallPlaces = 64;

/// A thickness in millimetres, or pairs of a share of the length and a thickness.
std::vector<std::array<double, 2>> readThickness(JsonFields& wall) {
  constexpr double kMaxThickness_mm = 50.0;
  constexpr const char* kName = "thickness_mm";
  const nlohmann::json& value = wall.child(kName);
  if (value.is_number()) {
    return {{0.0, kMetresPerMm * wall.number(kName, 0.1, kMaxThickness_mm)}};
  }
  const auto refuseIt = [&wall] {
    wall.refuse(kName, Text::tr("is neither a number nor a list of pairs"),
                Text::tr("Write 3, or [[0, 2], [1, 5]]: shares of the length, ascending, and millimetres."));
  };
  std::vector<std::array<double, 2>> places;
  if (!value.is_array() || value.empty() || value.size() > kMaxWallPlaces) {
    refuseIt();
  }
  for (const nlohmann::json& pair : value) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_number() || !pair[1].is_number()) {
      refuseIt();
    }
    const std::array place{pair[0].get<double>(), pair[1].get<double>()};
    const bool ascends = places.empty() || place[0] > places.back()[0];
    if (!(place[0] >= 0.0 && place[0] <= 1.0 && ascends && place[1] > 0.0 && place[1] <= kMaxThickness_mm)) {
      refuseIt();
    }
    places.push_back({place[0], kMetresPerMm * place[1]});
  }
  return places;
}

HollowWall readWall(JsonFields& parent) {
  JsonFields fields(parent.child("wall"), parent.where() + " wall");
  HollowWall wall;
  wall.thickness_m = readThickness(fields);
  wall.gentLimit = fields.number("gent_limit", 0.05, 100.0, wall.gentLimit);
  const auto pressure_Pa = [&fields](const char* name, double most_mmHg) {
    return kPascalsPerMmHg * fields.number(name, 0.0, most_mmHg, 0.0);
  };
  wall.restPressure_Pa = pressure_Pa("rest_pressure_mmhg", kMaxPressure_mmHg);
  wall.pressure_Pa = pressure_Pa("pressure_mmhg", kMaxPressure_mmHg);
  wall.vent = fields.flag("vent", false);
  if (wall.vent || fields.has("vented_pressure_mmhg")) {
    wall.ventedPressure_Pa = pressure_Pa("vented_pressure_mmhg", wall.pressure_Pa / kPascalsPerMmHg);
  }
  wall.sealed = fields.flag("sealed", false);
  wall.foldsNeedRoom = fields.flag("folds_need_room", false);
  wall.source = fields.text("source");
  fields.finish();
  return wall;
}

std::vector<WrungSpan> readSpans(JsonFields& parent) {
  constexpr const char* kName = "spans";
  const nlohmann::json& list = parent.child(kName);
  const auto refuseIt = [&parent](const Text& what) {
    parent.refuse(
        kName, what,
        Text::tr("Write one or two pairs [held, mobile] of shares of the length, such as [[0, 0.4], "
                 "[1, 0.6]]."));
  };
  if (!list.is_array() || list.empty() || list.size() > kMaxSpans) {
    refuseIt(Text::tr("must list one or two pairs"));
  }
  std::vector<WrungSpan> spans;
  for (const nlohmann::json& pair : list) {
    if (!pair.is_array() || pair.size() != 2 || !pair[0].is_number() || !pair[1].is_number()) {
      refuseIt(Text::tr("must list one or two pairs"));
    }
    const WrungSpan span{pair[0].get<double>(), pair[1].get<double>()};
    const auto [low, high] = std::minmax(span.held, span.mobile);
    if (!(low >= 0.0 && high <= 1.0 && high - low >= kLeastSpan)) {
      refuseIt(Text::tr("has a stretch that is too short or beyond the organ"));
    }
    spans.push_back(span);
  }
  // Two limbs have the mobile part between them.
  const bool towards =
      spans.size() < 2 || (spans[0].held < spans[0].mobile) != (spans[1].held < spans[1].mobile);
  const bool apart =
      spans.size() < 2 || (spans[0].held < spans[0].mobile ? spans[0].mobile < spans[1].mobile
                                                           : spans[1].mobile < spans[0].mobile);
  if (!towards || !apart) {
    refuseIt(Text::tr("has two stretches without a mobile part between them"));
  }
  return spans;
}

InitialTwist readStart(JsonFields& parent) {
  JsonFields fields(parent.child("initial_twist"), parent.where() + " initial_twist");
  InitialTwist start;
  start.least_rad = radians(fields.number("least_deg", 1.0, kMaxTwist_deg));
  start.most_rad = radians(fields.number("most_deg", degrees(start.least_rad), kMaxTwist_deg));
  start.step_rad = radians(fields.number("step_deg", 0.0, kMaxTwist_deg, 0.0));
  start.sign = fields.choice("direction", {"counterclockwise", "clockwise"}, 0) == 0 ? 1 : -1;
  start.oppositeShare = fields.number("opposite_share", 0.0, 1.0, 0.0);
  start.since_s = kSecondsPerHour * fields.number("since_h", 0.0, 240.0, 0.0);
  start.source = fields.text("source");
  fields.finish();
  return start;
}

void readSource(JsonFields& fields) {
  static_cast<void>(fields.text("source"));
  fields.finish();
}

PerfusionParameters readPedicle(JsonFields& parent) {
  JsonFields fields(parent.child("pedicle"), parent.where() + " pedicle");
  PerfusionParameters vessels;
  vessels.arterial_mmHg = fields.number("arterial_mmhg", 20.0, 250.0, vessels.arterial_mmHg);
  vessels.venous_mmHg = fields.number("venous_mmhg", 0.0, 0.9 * vessels.arterial_mmHg, vessels.venous_mmHg);
  vessels.shutAtTurn_mmHg = fields.number("shut_at_turn_mmhg", 0.1, 500.0, vessels.shutAtTurn_mmHg);
  vessels.shutPower = fields.number("shut_power", 1.0, 4.0, vessels.shutPower);
  const double mm_per_m = 1.0 / kMetresPerMm;
  vessels.pedicle_m = kMetresPerMm * fields.number("pedicle_mm", 1.0, 1000.0, mm_per_m * vessels.pedicle_m);
  vessels.pedicleReference_m = kMetresPerMm * fields.number("pedicle_reference_mm", 1.0, 1000.0,
                                                            mm_per_m * vessels.pedicleReference_m);
  vessels.pedicleShare = fields.number("pedicle_share", 0.01, 1.0, vessels.pedicleShare);
  vessels.lumenThreshold_mmHg =
      fields.number("lumen_threshold_mmhg", 0.0, 200.0, vessels.lumenThreshold_mmHg);
  vessels.lumenFloor = fields.number("lumen_floor", 0.0, 1.0, vessels.lumenFloor);
  vessels.flowTime_s = fields.number("flow_time_s", 1.0, 36000.0, vessels.flowTime_s);
  vessels.lossTime_s =
      kSecondsPerHour * fields.number("loss_time_h", 0.01, 1000.0, vessels.lossTime_s / kSecondsPerHour);
  vessels.enoughFlow = fields.number("enough_flow", 0.01, 0.99, vessels.enoughFlow);
  readSource(fields);
  return vessels;
}

BaseFriction readBase(JsonFields& parent) {
  JsonFields fields(parent.child("base"), parent.where() + " base");
  BaseFriction base;
  base.stickShare = fields.number("stick_share", 0.0, 10.0, base.stickShare);
  base.relapseShare = fields.number("relapse_share", 0.0, 10.0, base.relapseShare);
  base.relapseFrom_rad = radians(fields.number("relapse_from_deg", 0.0, kMaxTwist_deg, 90.0));
  base.relapseTime_s = fields.number("relapse_time_s", 0.1, 600.0, base.relapseTime_s);
  base.source = fields.text("source");
  fields.finish();
  return base;
}

DetorsionLimits readLimits(JsonFields& parent) {
  JsonFields fields(parent.child("limits"), parent.where() + " limits");
  DetorsionLimits limits;
  limits.jawArea_m2 = kSquareMetresPerMm2 *
                      fields.number("jaw_area_mm2", 0.5, 5000.0, limits.jawArea_m2 / kSquareMetresPerMm2);
  limits.jawForce_N = fields.number("jaw_force_n", 0.1, 200.0, limits.jawForce_N);
  limits.bruise_Pa =
      kPascalsPerKpa * fields.number("bruise_kpa", 1.0, 10000.0, limits.bruise_Pa / kPascalsPerKpa);
  limits.bruise_s = fields.number("bruise_s", 0.0, 60.0, limits.bruise_s);
  limits.tear_Pa =
      kPascalsPerKpa * fields.number("tear_kpa", limits.bruise_Pa / kPascalsPerKpa, 20000.0,
                                     std::max(limits.tear_Pa, limits.bruise_Pa) / kPascalsPerKpa);
  limits.pull_N = fields.number("pull_n", 0.1, 500.0, limits.pull_N);
  limits.residual_rad = radians(fields.number("residual_deg", 0.5, 90.0, 15.0));
  limits.patency = fields.number("patency", 0.0, 1.0, limits.patency);
  limits.flow = fields.number("flow", 0.0, 1.0, limits.flow);
  limits.handsOff_s = fields.number("hands_off_s", 0.0, 600.0, limits.handsOff_s);
  limits.source = fields.text("source");
  fields.finish();
  return limits;
}

TurnStages readStages(JsonFields& parent) {
  constexpr double kSecondsPerMinute = 60.0;
  JsonFields fields(parent.child("stages"), parent.where() + " stages");
  TurnStages stages;
  stages.turn_rad = radians(fields.number("turn_deg", 30.0, kMaxTwist_deg));
  stages.rest_s = kSecondsPerMinute * fields.number("rest_min", 0.1, 600.0);
  readSource(fields);
  return stages;
}

Detorsion readDetorsion(JsonFields& pattern) {
  JsonFields fields(pattern.child("detorsion"), pattern.where() + " detorsion");
  Detorsion detorsion;
  if (fields.has("wall") == fields.has("cord_stiffness_nmm_per_rad")) {
    fields.refuse("wall", Text::tr("and 'cord_stiffness_nmm_per_rad' exclude each other, and one is needed"),
                  Text::tr("Give the wall of a hollow organ, or the stiffness of a solid cord."));
  }
  if (fields.has("wall")) {
    detorsion.wall = readWall(fields);
  } else {
    detorsion.cordStiffness_Nm_per_rad =
        kMetresPerMm * fields.number("cord_stiffness_nmm_per_rad", 0.001, 100'000.0);
  }
  detorsion.spans = readSpans(fields);
  detorsion.start = readStart(fields);
  detorsion.vessels = readPedicle(fields);
  detorsion.base = readBase(fields);
  detorsion.limits = readLimits(fields);
  if (fields.has("stages")) {
    detorsion.stages = readStages(fields);
  }
  detorsion.timeScale = fields.number("time_scale", 1.0, 3600.0, detorsion.timeScale);
  detorsion.briefing = fields.text("briefing", "");
  detorsion.validity = fields.text("validity");
  fields.finish();
  return detorsion;
}

}  // namespace

std::shared_ptr<const Detorsion> readGoal(JsonFields& pattern) {
  const bool detorse = pattern.choice("goal", {"twist", "detorse"}, 0) == 1;
  if (detorse != pattern.has("detorsion")) {
    pattern.refuse("detorsion", Text::tr("is required for, and only allowed with, the goal 'detorse'"),
                   Text::tr("Give both, or leave out both."));
  }
  return detorse ? std::make_shared<const Detorsion>(readDetorsion(pattern)) : nullptr;
}

}  // namespace torsio
