// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/wall_twist.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/short_number.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/hollow_validity.h"
#include "sim/scene/organ_wall.h"
#include "sim/scene/pattern_judgement.h"
#include "sim/tissue/hollow/wrung_organ.h"
#include "sim/tissue/rod/rod_sections.h"

namespace torsio::cli {

namespace {

constexpr double kSmallTurn_rad = radians(0.1);

[[noreturn]] void refuseWall(const std::string& words) {
  throw Error(
      ErrorCode::kUsage, Text::verbatim("this is not the thickness of a wall"), "--wall " + words,
      Text::verbatim("Give millimetres such as 3, or fractions of the length and millimetres: 0:2,1:5"));
}

double numberOf(std::string_view word, const std::string& words) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) {
    refuseWall(words);
  }
  return value;
}

// Maximum pressure for which a sealed wall is solved: P = p R / (G t) = 4 at the first place to reach it.
double mostSealed_Pa(const std::vector<WallPlace>& places, double shear_Pa) {
  constexpr double kMaxPressure = 4.0;
  double most_Pa = 1e9;
  for (const WallPlace& place : places) {
    most_Pa = std::min(most_Pa, kMaxPressure * shear_Pa * place.thickness_m / place.radius_m);
  }
  return most_Pa;
}

}  // namespace

double pressureOf_Pa(const char* option, double pressure_mmHg) {
  constexpr double kMaxPressure_mmHg = 100.0;
  if (!(pressure_mmHg >= 0.0 && pressure_mmHg <= kMaxPressure_mmHg)) {
    refuseParameter(Text::verbatim("the pressure must lie in 0 to 100 mmHg"),
                    option + (" " + std::to_string(pressure_mmHg)),
                    Text::verbatim("Give 0 for an empty organ"));
  }
  return pressure_mmHg * kPascalsPerMmHg;
}

WallValidity validityOf(const Scene& scene, const FoldReport& fold, const OrganState& state) {
  const Text broken = brokenLimit(scene, fold).reason;
  return scene.hollow && broken.empty() ? wallValidity(*scene.hollow, state) : WallValidity{broken, {}};
}

WallMap wallMap(const std::string& words) {
  constexpr double kMillimetre = 1e-3;
  std::vector<std::array<double, 2>> places;
  std::string_view rest = words;
  if (rest.find(':') == std::string_view::npos) {
    return WallMap({{0.0, kMillimetre * numberOf(rest, words)}});
  }
  while (!rest.empty()) {
    const std::string_view word = rest.substr(0, rest.find(','));
    const std::size_t colon = word.find(':');
    if (colon == std::string_view::npos) {
      refuseWall(words);
    }
    places.push_back(
        {numberOf(word.substr(0, colon), words), kMillimetre * numberOf(word.substr(colon + 1), words)});
    rest.remove_prefix(std::min(rest.size(), word.size() + 1));
  }
  return WallMap(places);
}

std::string wallWords(const Scene& scene) {
  if (scene.wallAlong_m.empty()) {
    return scene.wall_m ? std::to_string(1000.0 * *scene.wall_m) : std::string();
  }
  std::string words;
  for (const auto& [share, thickness_m] : scene.wallAlong_m) {
    words += (words.empty() ? "" : ",") + std::to_string(share) + ':' + std::to_string(1000.0 * thickness_m);
  }
  return words;
}

WallTwistResult wallTwist(const Scene& scene, const RodTwistRequest& rod, const WallTwistRequest& request) {
  const auto started = std::chrono::steady_clock::now();
  RodTwistRequest little = rod;
  little.reference = false;
  little.angle_rad = kSmallTurn_rad;
  const RodTwistResult small = rodTwist(scene, little);
  const double from_m = small.nodeArcs_m.front();
  const double to_m = std::min(small.nodeArcs_m.back(), rod.grasp * scene.lattice().length_m());
  HollowContent content;
  content.shearModulus_Pa = rod.shearModulus_Pa;
  content.restPressure_Pa = request.restPressure_Pa;
  content.freeLength = rod.ends == RodEnds::kClampedFree;
  const std::vector<WallPlace> places = wallPlaces(scene.lattice(), rod.wall, from_m, to_m);
  content.highestPressure_Pa = std::max(request.pressure_Pa, request.restPressure_Pa);
  if (request.sealed) {
    content.highestPressure_Pa =
        std::max(content.highestPressure_Pa, mostSealed_Pa(places, rod.shearModulus_Pa));
  }
  const double tautStiffness_Nm_per_rad = small.torque_Nm / kSmallTurn_rad;
  const auto tautWall = [&](const Text& beyond) {
    WallTwistResult taut;
    taut.torque_Nm = tautStiffness_Nm_per_rad * rod.angle_rad;
    taut.pressure_Pa = request.pressure_Pa;
    taut.validity.beyond = beyond;
    return taut;
  };
  std::optional<WrungOrgan> made;
  try {
    made.emplace(places, to_m - from_m, content);
  } catch (const Error& limit) {
    if (limit.code() != ErrorCode::kFolded && !request.ofOrgan) {
      throw;
    }
    return tautWall(limit.happenedText());
  }
  const WrungOrgan& organ = *made;
  WallTwistResult result;
  result.setUp_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - started).count();
  result.pressure_Pa =
      request.sealed ? organ.sealedPressure_Pa(rod.angle_rad, request.pressure_Pa) : request.pressure_Pa;
  if (result.pressure_Pa > content.highestPressure_Pa) {
    return tautWall(
        Text::verbatim("a sealed organ would come under more than %1 mmHg, which is beyond the wall's law",
                       shortNumber(content.highestPressure_Pa / kPascalsPerMmHg)));
  }
  const WrungState state = organ.at(rod.angle_rad, result.pressure_Pa);
  const double bend = tautStiffness_Nm_per_rad / organ.plainStiffness_Nm_per_rad();
  result.torque_Nm = bend * state.torque;
  result.peakTorque_Nm = bend * organ.peakTorque_Nm(result.pressure_Pa);
  result.patency = state.patency;
  result.waist_m = state.waist;
  result.waistPlace = state.waistPlace;
  result.onset_rad = organ.onset_rad(result.pressure_Pa);
  result.closing_rad = organ.closing_rad(result.pressure_Pa);
  result.shortening_m = organ.at(0.0, result.pressure_Pa).length - state.length;
  result.waves = organ.waves(result.pressure_Pa);
  result.validity = wallValidity({.places = places,
                                  .length_m = to_m - from_m,
                                  .shearModulus_Pa = rod.shearModulus_Pa,
                                  .gentLimit = content.gentLimit,
                                  .restPressure_Pa = request.restPressure_Pa,
                                  .pressure_Pa = result.pressure_Pa,
                                  .twist_rad = rod.angle_rad,
                                  .taut_rad = organ.taut_rad(result.pressure_Pa),
                                  .closing_rad = result.closing_rad});
  return result;
}

}  // namespace torsio::cli
