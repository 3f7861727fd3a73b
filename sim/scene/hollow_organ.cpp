// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/hollow_organ.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/random.h"
#include "sim/scene/organ_wall.h"
#include "sim/tissue/hollow/tube_onset.h"
#include "sim/tissue/section/polygon.h"
#include "sim/tissue/section/wall_section.h"

namespace torsio {

namespace {

constexpr std::uint64_t kStartStream = 41;
constexpr double kMaxShut_rad = radians(720.0);
constexpr double kSlopeStep_rad = radians(0.5);
constexpr double kPeakStep_rad = radians(2.0);
// Share of a span, from its ends, along which a wall goes over into its neighbour, which keeps its radius.
constexpr double kClampedShare = 0.08;
// Of two limbs, which draw nearer to each other as a whole: a foot that stands apart leans over to the other.
constexpr double kWoundHeldShare = 0.25;
constexpr double kWoundShare = 0.35;

/// How free a wall is to change its radius: 0 at the ends of a span, 1 away from them, smooth between.
double freeShare(double share, double heldShare, double mobileShare) noexcept {
  const double way = std::clamp(std::min(share / heldShare, (1.0 - share) / mobileShare), 0.0, 1.0);
  return way * way * (3.0 - 2.0 * way);
}

bool alike(const std::vector<WallPlace>& a, const std::vector<WallPlace>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const WallPlace& x, const WallPlace& y) {
    return x.radius_m == y.radius_m && x.thickness_m == y.thickness_m;
  });
}

HollowContent contentOf(const HollowOrgan::Parts& parts) {
  const HollowWall& wall = parts.detorsion.wall;
  HollowContent content;
  content.shearModulus_Pa = parts.shearModulus_Pa;
  content.gentLimit = wall.gentLimit;
  content.foldsNeedRoom = wall.foldsNeedRoom;
  content.restPressure_Pa = wall.restPressure_Pa;
  content.highestPressure_Pa = std::max(wall.restPressure_Pa, wall.pressure_Pa);
  return content;
}

/// Share of a span, 0 held to 1 mobile; outside the span below 0 or above 1.
double shareOf(const WrungSpan& span, double fraction) noexcept {
  return (fraction - span.held) / (span.mobile - span.held);
}

constexpr int kGasHalvings = 20;

constexpr int kMobilePlaces = 40;
constexpr int kWallSteps = 40;
constexpr double kThickestOfRod = 0.35;  // of a section's radius: so narrow a stretch is bent as nearly solid
constexpr double kThickestTube = 0.45;   // t / R: beyond it nothing is left inside

/// The wall at the middles of equal steps between two arc lengths, where it leaves a tube.
std::vector<WallPlace> tubesBetween(const SectionLattice& lattice, const WallMap& wall, double from_m,
                                    double to_m) {
  const auto [low_m, high_m] = std::minmax(from_m, to_m);
  std::vector<double> arcs_m;
  for (int i = 0; i < kMobilePlaces; ++i) {
    arcs_m.push_back(low_m + (high_m - low_m) * (i + 0.5) / kMobilePlaces);
  }
  std::vector<WallPlace> places;
  const std::vector<LatticeOutline> outlines = lattice.outlinesAt(arcs_m);
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const double thickness_m = wall.thickness_m(arcs_m[i] / lattice.length_m());
    const double radius_m = perimeter(outlines[i].points_m) / kTurn - 0.5 * thickness_m;
    if (thickness_m <= kThickestTube * radius_m) {
      places.push_back({radius_m, thickness_m});
    }
  }
  return places;
}

/// Volume of the round tubes of the wall's perimeters, m^3, which a pressure widens by the balance of their
/// hoops; `step_m`: length of each.
double widenedVolume_m3(const std::vector<WallPlace>& places, double step_m, const HollowWall& wall,
                        double shear_Pa, double pressure_Pa) {
  double volume_m3 = 0.0;
  for (const auto& [radius_m, thickness_m] : places) {
    const double rest =
        restStretch(wall.restPressure_Pa * radius_m / (shear_Pa * thickness_m), wall.gentLimit);
    const double unloaded_m = radius_m / rest;
    const double scaled = pressure_Pa * unloaded_m / (shear_Pa * thickness_m * rest);
    const double widened_m = unloaded_m * tautTube(scaled, wall.gentLimit, 0.0).stretch;
    volume_m3 += step_m * kPi * widened_m * widened_m;
  }
  return volume_m3;
}

}  // namespace

HollowOrgan::HollowOrgan(const Parts& parts)
    : detorsion_(parts.detorsion),
      vessels_(parts.detorsion.vessels),
      shear_Pa_(parts.shearModulus_Pa),
      length_m_(parts.lattice->length_m()),
      graspArc_m_(parts.graspArc * parts.lattice->length_m()) {
  if (placeOf(graspArc_m_).span >= 0) {
    refuseParameter(Text::tr("the pattern grips the organ where it is wrung"), Text::tr("field 'grasp'"),
                    Text::tr("Grip between the mobile ends of the spans."));
  }
  if (!detorsion_.wall.thickness_m.empty()) {
    solveLimbs(parts);
  }
  if (detorsion_.wall.sealed) {
    fillMobilePart(parts);
  }
  basePeak_Nm_ = peakTorque_Nm(detorsion_.wall.pressure_Pa);
  for (const Vec3& vertex_m : parts.vertices_m) {
    const double arc_m = parts.lattice->nearestArc_m(vertex_m);
    const AxisFrame frame = parts.lattice->frameAt(arc_m);
    vertices_.push_back({vertex_m, {frame.centre_m, frame.tangent}, arc_m});
  }
  drawLine(*parts.lattice);
  for (std::size_t i = 0; i < kPlaces; ++i) {
    free_[i] = freeShareOf(static_cast<double>(i) / static_cast<double>(kPlaces - 1));
  }
  if (parts.patches != nullptr) {
    reach_ = HollowReach(*this, *parts.patches);
  }
}

void HollowOrgan::solveLimbs(const Parts& parts) {
  const WallMap map(detorsion_.wall.thickness_m);
  const HollowContent content = contentOf(parts);
  std::vector<std::vector<WallPlace>> walls;
  std::vector<std::future<std::shared_ptr<const WrungOrgan>>> solving;
  std::vector<std::size_t> solvedAs;
  for (const WrungSpan& span : detorsion_.spans) {
    const double span_m = std::abs(span.mobile - span.held) * length_m_;
    walls.push_back(wallPlaces(*parts.lattice, map, span.held * length_m_, span.mobile * length_m_));
    const bool again = walls.size() > 1 && alike(walls[0], walls[1]) &&
                       std::abs(detorsion_.spans[0].mobile - detorsion_.spans[0].held) * length_m_ == span_m;
    if (!again) {
      solving.push_back(std::async(std::launch::async, [wall = walls.back(), span_m, content] {
        return std::make_shared<const WrungOrgan>(wall, span_m, content);
      }));
    }
    solvedAs.push_back(solving.size() - 1);
  }
  std::vector<std::shared_ptr<const WrungOrgan>> solved;
  for (auto& one : solving) {
    solved.push_back(one.get());
  }
  for (std::size_t i = 0; i < walls.size(); ++i) {
    Limb limb;
    limb.tube = solved[solvedAs[i]];
    std::copy_n(walls[i].begin(), std::min(walls[i].size(), kWallPlaces), limb.wall.begin());
    limbs_.push_back(std::move(limb));
  }
}

OrganState HollowOrgan::start(std::uint64_t seed) const {
  const InitialTwist& twist = detorsion_.start;
  Random random = Random::forStream(seed, kStartStream);
  const double place = random.uniform();
  const double way_rad = twist.most_rad - twist.least_rad;
  double angle_rad = twist.least_rad + place * way_rad;
  if (twist.step_rad > 0.0) {
    const double steps = std::floor(way_rad / twist.step_rad + 1e-9) + 1.0;
    angle_rad = twist.least_rad + twist.step_rad * std::min(std::floor(place * steps), steps - 1.0);
  }
  const bool opposite = random.uniform() < twist.oppositeShare;
  OrganState state = stateAt((opposite ? -twist.sign : twist.sign) * angle_rad);
  const double pressure_mmHg = state.hollow.reading.pressure_Pa / kPascalsPerMmHg;
  const PerfusionState blood = vessels_.after(angle_rad, pressure_mmHg, twist.since_s);
  state.hollow.reading.flow = blood.flow;
  state.hollow.reading.dose = blood.dose;
  state.hollow.congestion = blood.congestion;
  state.hollow.saturation = blood.saturation;
  return state;
}

OrganState HollowOrgan::stateAt(double angle_rad) const noexcept {
  const double pressure_Pa = detorsion_.wall.pressure_Pa;
  OrganState state;
  state.twist = {graspArc_m_, angle_rad};
  lay(state);
  HollowPose& pose = state.hollow;
  pose.present = true;
  pose.start_rad = angle_rad;
  // So long that flow has settled, so short that no dose has gathered.
  const double settled_s = 20.0 * detorsion_.vessels.flowTime_s;
  const PerfusionState blood = vessels_.after(angle_rad, pressure_Pa / kPascalsPerMmHg, settled_s);
  pose.reading.pressure_Pa = pressure_Pa;
  pose.reading.patency = patency(angle_rad, pressure_Pa);
  pose.reading.flow = vessels_.steadyFlow(angle_rad, pressure_Pa / kPascalsPerMmHg);
  pose.congestion = blood.congestion;
  pose.saturation = blood.saturation;
  return state;
}

void HollowOrgan::swingOn(std::shared_ptr<const RodOrgan> rod) {
  const TurnTask& task = rod->task();
  line_ = {task.axisFrom_m, normalized(task.axisTo_m - task.axisFrom_m)};
  wound_ = false;
  swing_ =
      std::make_shared<const HollowSwing>(std::move(rod), graspArc_m_ / length_m_, detorsion_.start.most_rad);
  basePeak_Nm_ = peakTorque_Nm(detorsion_.wall.pressure_Pa);
}

std::vector<TwistLaw> HollowOrgan::twistLaws() const {
  std::vector<TwistLaw> laws;
  for (std::size_t i = 0; i < limbs_.size(); ++i) {
    const auto [low, high] = std::minmax(detorsion_.spans[i].held, detorsion_.spans[i].mobile);
    laws.push_back({low * length_m_, high * length_m_,
                    [tube = limbs_[i].tube, pressure_Pa = detorsion_.wall.pressure_Pa](double twist_rad) {
                      return tube->torque_Nm(twist_rad, pressure_Pa);
                    }});
  }
  return laws;
}

WallMap HollowOrgan::wallMap(const SectionLattice& lattice) const {
  if (limbs_.empty()) {
    return {};
  }
  const WallMap drawn(detorsion_.wall.thickness_m);
  std::vector<double> arcs_m;
  for (int i = 0; i <= kWallSteps; ++i) {
    arcs_m.push_back(length_m_ * i / kWallSteps);
  }
  std::vector<std::array<double, 2>> map;
  const std::vector<LatticeOutline> outlines = lattice.outlinesAt(arcs_m);
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const double share = arcs_m[i] / length_m_;
    map.push_back({share, std::min(drawn.thickness_m(share),
                                   kThickestOfRod * perimeter(outlines[i].points_m) / kTurn)});
  }
  return WallMap(map);
}

void HollowOrgan::lay(OrganState& state) const noexcept {
  if (swing_) {
    state.pose = swing_->poseAt(state.twist.graspAngle_rad);
  }
}

RodCurve HollowOrgan::curveOf(const OrganState& state) const noexcept {
  const RodOrgan& rod = swing_->rod();
  RodCurve curve = rod.skin().curveOf(state.pose.count > 0 ? state.pose : rod.rod().rest());
  for (int span = 0; span < static_cast<int>(limbs_.size()); ++span) {
    Sections sections;
    sectionsOf(span, state, sections);
    for (std::size_t i = 0; i < static_cast<std::size_t>(curve.count); ++i) {
      const Place place = placeOf(rod.arcs_m()[i]);
      if (place.span == span) {
        const double at = place.share * static_cast<double>(kPlaces - 1);
        const std::size_t cell = std::min(static_cast<std::size_t>(at), kPlaces - 2);
        const double share = at - static_cast<double>(cell);
        curve.widths[i] = sections[cell].radius + share * (sections[cell + 1].radius - sections[cell].radius);
      }
    }
  }
  return curve;
}

double HollowOrgan::torque_Nm(double angle_rad, double pressure_Pa) const noexcept {
  if (swing_) {
    const HollowSwing::Load load = swing_->at(angle_rad);
    double torque_Nm = load.torque_Nm;
    const double start_Pa = detorsion_.wall.pressure_Pa;
    for (std::size_t i = 0; i < limbs_.size() && pressure_Pa != start_Pa; ++i) {
      const WrungOrgan& tube = *limbs_[i].tube;
      torque_Nm += load.twistRate[i] * (tube.torque_Nm(load.twist_rad[i], pressure_Pa) -
                                        tube.torque_Nm(load.twist_rad[i], start_Pa));
    }
    return torque_Nm;
  }
  double torque_Nm = limbs_.empty() ? detorsion_.cordStiffness_Nm_per_rad * angle_rad : 0.0;
  const WrungOrgan* asked = nullptr;
  double one_Nm = 0.0;
  for (const Limb& limb : limbs_) {
    if (limb.tube.get() != asked) {  // limbs that are alike share a tube
      asked = limb.tube.get();
      one_Nm = asked->torque_Nm(angle_rad, pressure_Pa);
    }
    torque_Nm += one_Nm;
  }
  return torque_Nm;
}

double HollowOrgan::storedEnergy_J(double angle_rad, double pressure_Pa) const noexcept {
  constexpr int kSteps = 64;
  double sum_Nm = 0.5 * (torque_Nm(0.0, pressure_Pa) + torque_Nm(angle_rad, pressure_Pa));
  for (int i = 1; i < kSteps; ++i) {
    sum_Nm += torque_Nm(angle_rad * i / kSteps, pressure_Pa);
  }
  return sum_Nm * angle_rad / kSteps;
}

double HollowOrgan::slope_Nm_per_rad(double angle_rad, double pressure_Pa) const noexcept {
  return (torque_Nm(angle_rad + kSlopeStep_rad, pressure_Pa) -
          torque_Nm(angle_rad - kSlopeStep_rad, pressure_Pa)) /
         (2.0 * kSlopeStep_rad);
}

double HollowOrgan::peakTorque_Nm(double pressure_Pa) const noexcept {
  if (swing_) {
    double peak_Nm = 0.0;
    for (double angle_rad = 0.0; angle_rad <= detorsion_.start.most_rad; angle_rad += kPeakStep_rad) {
      peak_Nm = std::max(peak_Nm, std::abs(torque_Nm(detorsion_.start.sign * angle_rad, pressure_Pa)));
    }
    return peak_Nm;
  }
  double peak_Nm = limbs_.empty() ? detorsion_.cordStiffness_Nm_per_rad * detorsion_.start.most_rad : 0.0;
  for (const Limb& limb : limbs_) {
    peak_Nm += limb.tube->peakTorque_Nm(pressure_Pa);
  }
  return peak_Nm;
}

double HollowOrgan::patency(double angle_rad, double pressure_Pa) const noexcept {
  double patency = 1.0;
  for (int i = 0; i < static_cast<int>(limbs_.size()); ++i) {
    patency = std::min(patency, tube(i)->at(wrungBy_rad(i, angle_rad), pressure_Pa).patency);
  }
  return patency;
}

double HollowOrgan::waist_m(double angle_rad, double pressure_Pa) const noexcept {
  double waist_m = limbs_.empty() ? 0.0 : std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(limbs_.size()); ++i) {
    waist_m = std::min(waist_m, tube(i)->at(wrungBy_rad(i, angle_rad), pressure_Pa).waist);
  }
  return waist_m;
}

double HollowOrgan::whenWrungBy_rad(int span, double twist_rad) const noexcept {
  if (!swing_) {
    return twist_rad;
  }
  const double most_rad = std::abs(within_rad(detorsion_.start.sign * kMaxShut_rad));
  for (double angle_rad = 0.0; angle_rad <= most_rad; angle_rad += kSlopeStep_rad) {
    if (std::abs(wrungBy_rad(span, detorsion_.start.sign * angle_rad)) >= twist_rad) {
      return angle_rad;
    }
  }
  return std::numeric_limits<double>::infinity();
}

double HollowOrgan::onset_rad(double pressure_Pa) const {
  double onset_rad = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(limbs_.size()); ++i) {
    onset_rad = std::min(onset_rad, whenWrungBy_rad(i, tube(i)->onset_rad(pressure_Pa)));
  }
  return onset_rad;
}

double HollowOrgan::closing_rad(double pressure_Pa) const noexcept {
  double closing_rad = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(limbs_.size()); ++i) {
    closing_rad = std::min(closing_rad, whenWrungBy_rad(i, tube(i)->closing_rad(pressure_Pa)));
  }
  return closing_rad;
}

double HollowOrgan::shut_rad(double pressure_Pa) const noexcept {
  double angle_rad = closing_rad(pressure_Pa);
  while (angle_rad < kMaxShut_rad && patency(angle_rad, pressure_Pa) > kShutPatency) {
    angle_rad += radians(1.0);
  }
  return angle_rad;
}

HollowOrgan::Place HollowOrgan::placeOf(double arc_m) const noexcept {
  const double fraction = arc_m / length_m_;
  for (std::size_t i = 0; i < detorsion_.spans.size(); ++i) {
    const double share = shareOf(detorsion_.spans[i], fraction);
    if (share < 1.0) {
      return {static_cast<int>(i), std::max(share, 0.0)};
    }
  }
  return {};
}

HollowOrgan::Section HollowOrgan::sectionIn(int span, double share, const OrganState& state) const noexcept {
  const double angle_rad = state.twist.graspAngle_rad;
  const WrungOrgan* wrung = tube(span);
  if (wrung == nullptr) {
    return {angle_rad * share, 1.0};
  }
  const WrungPlace place =
      wrung->placeAt(share, wrungBy_rad(span, angle_rad), state.hollow.reading.pressure_Pa);
  return {angle_rad * place.turn, 1.0 + (place.radius - 1.0) * freeShareOf(share)};
}

double HollowOrgan::freeShareOf(double share) const noexcept {
  return wound_ ? freeShare(share, kWoundHeldShare, kWoundShare)
                : freeShare(share, kClampedShare, kClampedShare);
}

void HollowOrgan::sectionsOf(int span, const OrganState& state, Sections& sections) const noexcept {
  WrungOrgan::Profile walls;
  sectionsOf(span, state, sections, walls);
}

void HollowOrgan::sectionsOf(int span, const OrganState& state, Sections& sections,
                             WrungOrgan::Profile& walls) const noexcept {
  const double angle_rad = state.twist.graspAngle_rad;
  const WrungOrgan* wrung = tube(span);
  if (wrung != nullptr) {
    wrung->profileAt(wrungBy_rad(span, angle_rad), state.hollow.reading.pressure_Pa, walls);
  }
  for (std::size_t i = 0; i < kPlaces; ++i) {
    const double even = static_cast<double>(i) / static_cast<double>(kPlaces - 1);
    sections[i] = wrung == nullptr
                      ? Section{angle_rad * even, 1.0}
                      : Section{angle_rad * walls[i].turn, 1.0 + (walls[i].radius - 1.0) * free_[i]};
  }
  sections.front() = {};
  sections.back() = {angle_rad, 1.0};
  if (wound_) {
    wind(sections);
  }
}

HollowOrgan::Section HollowOrgan::sectionAt(double arc_m, const OrganState& state) const noexcept {
  const Place place = placeOf(arc_m);
  if (place.span < 0) {
    return {state.twist.graspAngle_rad, 1.0};
  }
  return place.share > 0.0 ? sectionIn(place.span, place.share, state) : Section{};
}

double HollowOrgan::wallShear_Pa(double arc_m, const OrganState& state) const noexcept {
  const Place place = placeOf(arc_m);
  if (place.span < 0 || !(place.share > 0.0) || limbs_.empty()) {
    return 0.0;
  }
  const Limb& limb = limbs_[static_cast<std::size_t>(place.span)];
  const double angle_rad = state.twist.graspAngle_rad;
  const double torque_Nm =
      limb.tube->torque_Nm(wrungBy_rad(place.span, angle_rad), state.hollow.reading.pressure_Pa);
  const auto at = static_cast<std::size_t>(std::lround(place.share * static_cast<double>(kWallPlaces - 1)));
  const double radius_m = limb.wall[at].radius_m * sectionIn(place.span, place.share, state).radius;
  return std::abs(torque_Nm) / (kTurn * radius_m * radius_m * limb.wall[at].thickness_m);
}

double HollowOrgan::cordTwist_rad_per_m(double arc_m, const OrganState& state) const noexcept {
  const Place place = placeOf(arc_m);
  if (!limbs_.empty() || place.span < 0 || !(place.share > 0.0)) {
    return 0.0;
  }
  const WrungSpan& span = detorsion_.spans[static_cast<std::size_t>(place.span)];
  return std::abs(state.twist.graspAngle_rad / (length_m_ * (span.mobile - span.held)));
}

const WrungOrgan* HollowOrgan::tube(int span) const noexcept {
  const bool known = span >= 0 && static_cast<std::size_t>(span) < limbs_.size();
  return known ? limbs_[static_cast<std::size_t>(span)].tube.get() : nullptr;
}

void HollowOrgan::fillMobilePart(const Parts& parts) {
  const std::vector<WrungSpan>& spans = detorsion_.spans;
  const bool forward = spans.front().held < spans.front().mobile;
  const double openEnd = forward ? 1.0 : 0.0;  // of one span the mobile part goes on to the organ's end
  const double from_m = spans.front().mobile * length_m_;
  const double to_m = (spans.size() > 1 ? spans.back().mobile : openEnd) * length_m_;
  const WallMap map(detorsion_.wall.thickness_m);
  const std::vector<WallPlace> places = tubesBetween(*parts.lattice, map, from_m, to_m);
  highestPressure_Pa_ = std::max(detorsion_.wall.restPressure_Pa, detorsion_.wall.pressure_Pa);
  for (std::size_t i = 0; i < kGasPressures; ++i) {
    const double pressure_Pa =
        highestPressure_Pa_ * static_cast<double>(i) / static_cast<double>(kGasPressures - 1);
    mobileVolume_m3_[i] = widenedVolume_m3(places, std::abs(to_m - from_m) / kMobilePlaces, detorsion_.wall,
                                           parts.shearModulus_Pa, pressure_Pa);
  }
}

double HollowOrgan::volume_m3(double angle_rad, double pressure_Pa) const noexcept {
  double place = 0.0;
  if (highestPressure_Pa_ > 0.0) {
    place = std::clamp(pressure_Pa / highestPressure_Pa_, 0.0, 1.0) * static_cast<double>(kGasPressures - 1);
  }
  const std::size_t low = std::min(static_cast<std::size_t>(place), kGasPressures - 2);
  const double share = place - static_cast<double>(low);
  double volume_m3 = mobileVolume_m3_[low] + share * (mobileVolume_m3_[low + 1] - mobileVolume_m3_[low]);
  for (int i = 0; i < static_cast<int>(limbs_.size()); ++i) {
    volume_m3 += tube(i)->at(wrungBy_rad(i, angle_rad), pressure_Pa).volume;
  }
  return volume_m3;
}

double HollowOrgan::gas_J(double angle_rad, double pressure_Pa) const noexcept {
  return detorsion_.wall.sealed ? (kAtmosphere_Pa + pressure_Pa) * volume_m3(angle_rad, pressure_Pa) : 0.0;
}

double HollowOrgan::sealedPressure_Pa(double angle_rad, double gas_J) const noexcept {
  // More pressure, more volume: the product rises with it, so halving finds the one pressure.
  double low_Pa = 0.0;
  double high_Pa = highestPressure_Pa_;
  for (int k = 0; k < kGasHalvings; ++k) {
    const double middle_Pa = 0.5 * (low_Pa + high_Pa);
    const bool more = (kAtmosphere_Pa + middle_Pa) * volume_m3(angle_rad, middle_Pa) > gas_J;
    (more ? high_Pa : low_Pa) = middle_Pa;
  }
  return 0.5 * (low_Pa + high_Pa);
}

}  // namespace torsio
