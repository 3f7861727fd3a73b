// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/hollow_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/contracts.h"
#include "sim/core/portable_math.h"
#include "sim/tissue/view/twist_kernels.h"

namespace torsio {

HollowSkin::HollowSkin(const HollowOrgan& organ, const OrganState& state) noexcept
    : organ_(organ), angle_rad_(state.twist.graspAngle_rad) {
  for (int span = 0; span < (organ.wound() ? 1 : organ.spans()); ++span) {
    fill(span, state, limbs_[static_cast<std::size_t>(span)]);
  }
}

void HollowSkin::fill(int span, const OrganState& state, Limb& limb) const noexcept {
  WrungOrgan::Profile walls;
  organ_.sectionsOf(span, state, limb.sections, walls);
  const WrungOrgan* tube = organ_.tube(span);
  if (tube == nullptr) {
    return;
  }
  limb.waves = drawnWaves(tube->waves(state.hollow.reading.pressure_Pa));
  for (std::size_t i = 1; i < kPlaces; ++i) {
    limb.folds[i] = foldPhase({limb.waves, foldAmplitude(limb.waves, walls[i].slack), walls[i].foldTurn});
  }
}

HollowSkin::Place HollowSkin::placeAt(const Limb& limb, double share) const noexcept {
  const double at = share * static_cast<double>(kPlaces - 1);
  const std::size_t cell = std::min(static_cast<std::size_t>(at), kPlaces - 2);
  const double rest = at - static_cast<double>(cell);
  const auto mix = [rest](double from, double to) { return from + rest * (to - from); };
  const HollowOrgan::Section& low = limb.sections[cell];
  const HollowOrgan::Section& high = limb.sections[cell + 1];
  const FoldPhase& before = limb.folds[cell];
  const FoldPhase& after = limb.folds[cell + 1];
  return {{mix(low.turn_rad, high.turn_rad), mix(low.radius, high.radius)},
          {mix(before.even, after.even), mix(before.odd, after.odd)}};
}

bool HollowSkin::rests() const noexcept {
  const auto still = [](const Limb& limb) {
    return std::all_of(limb.sections.begin(), limb.sections.end(),
                       [](const HollowOrgan::Section& s) { return s.turn_rad == 0.0 && s.radius == 1.0; }) &&
           std::all_of(limb.folds.begin(), limb.folds.end(),
                       [](const FoldPhase& fold) { return fold.even == 0.0 && fold.odd == 0.0; });
  };
  return angle_rad_ == 0.0 && std::all_of(limbs_.begin(), limbs_.end(), still);
}

// Folds belong where the wall is narrower: at the place whose turn and radius the vertex has.
Vec3 HollowSkin::vertex(const TwistVertex& vertex, double round_rad) const noexcept {
  const HollowOrgan::Place where = organ_.turningPlace(vertex.arc_m, vertex.rest_m);
  if (where.span < 0) {
    return organ_.moved(vertex.rest_m, vertex.line, where, {angle_rad_, 1.0}, {});
  }
  const Limb& limb = limbs_[static_cast<std::size_t>(where.span)];
  const Place place = placeAt(limb, where.share);
  const FoldedPoint fold = foldedPoint(limb.waves, place.fold, roundWave(limb.waves, round_rad));
  return organ_.moved(vertex.rest_m, vertex.line, where, place.section, {fold.turn_rad, fold.radius});
}

namespace {

constexpr std::size_t kLanes = static_cast<std::size_t>(kKernelBlock);
constexpr std::size_t kOwnStreams = 15;
constexpr std::size_t kWoundStreams = 12;
constexpr std::size_t kPlaces = HollowOrgan::kPlaces;
constexpr std::size_t kLastRows = kPlaces - 3;  // where the last three begin
constexpr auto kRow = static_cast<std::size_t>(kHollowRow);
constexpr std::size_t kCellQuantities = 13;
static_assert(FoldDepths::kSteps == kHollowDepths);
static_assert(kPlaces + kLanes > kRow && kPlaces <= kRow);

void putLane(float* lane, const Vec3& v) {
  lane[0] = static_cast<float>(v.x);
  lane[kLanes] = static_cast<float>(v.y);
  lane[2 * kLanes] = static_cast<float>(v.z);
}

std::size_t blocksFor(std::size_t vertices) {
  return (vertices + kLanes - 1) / kLanes;
}

std::uint32_t slotOf(std::size_t block, std::size_t lane) {
  return static_cast<std::uint32_t>(block * 3 * kLanes + lane);
}

}  // namespace

HollowView::HollowView(std::shared_ptr<const Scene> scene, Isa isa)
    : scene_(std::move(scene)), isa_(isa), slots_(scene_->mesh.vertices_m.size()) {
  TORSIO_EXPECTS(scene_->hollow != nullptr);
  const HollowOrgan& organ = *scene_->hollow;
  if (organ.swing() != nullptr) {  // it lies as its rod does
    return;
  }
  const AxisFrame frame = organ.graspFrame(organ.line().point_m);
  first_ = frame.e1;
  second_ = frame.e2;
  spans_.resize(organ.wound() ? 1 : static_cast<std::size_t>(organ.spans()));
  std::vector<std::size_t> still;
  std::vector<std::size_t> mobile;
  std::vector<std::vector<Entry>> wrung(spans_.size());
  const std::vector<TwistVertex>& vertices = organ.vertices();
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const HollowOrgan::Place place = organ.turningPlace(vertices[v].arc_m, vertices[v].rest_m);
    if (place.span < 0) {
      mobile.push_back(v);
    } else if (place.share > 0.0) {
      wrung[static_cast<std::size_t>(place.span)].push_back(
          {v, place.share * static_cast<double>(kPlaces - 1)});
    } else {
      still.push_back(v);
    }
  }
  layMobile(mobile);
  for (std::size_t i = 0; i < spans_.size(); ++i) {
    laySpan(std::move(wrung[i]), spans_[i]);
    layWrung(static_cast<int>(i));
  }
  stillBlocks_ = blocksFor(still.size());
  out_ = KernelBuffer<float>((blocks_ + stillBlocks_) * 3 * kLanes, 2 * kLanes);
  layStill(still);
}

std::size_t HollowView::streams() const noexcept {
  return scene_->hollow->wound() ? kWoundStreams : kOwnStreams;
}

void HollowView::layStill(std::span<const std::size_t> vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    slots_[vertices[i]] = slotOf(blocks_ + i / kLanes, i % kLanes);
    putLane(&out_[slots_[vertices[i]]], scene_->mesh.vertices_m[vertices[i]]);
  }
}

void HollowView::layMobile(std::span<const std::size_t> vertices) {
  const std::size_t blocks = blocksFor(vertices.size());
  mobile_ = KernelBuffer<float>(blocks * 3 * kLanes);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    slots_[vertices[i]] = slotOf(i / kLanes, i % kLanes);
    putLane(&mobile_[slots_[vertices[i]]],
            scene_->mesh.vertices_m[vertices[i]] - scene_->hollow->line().point_m);
  }
  mobileBlocks_ = static_cast<int>(blocks);
  blocks_ += blocks;
  bytes_ += vertices.size() * 6 * sizeof(float);
}

// Cell by cell, in the mesh's order within a cell. A block takes sixteen vertices, or fewer where the next
// lies beyond the three rows that it begins with; its empty lanes repeat the last.
void HollowView::laySpan(std::vector<Entry> entries, Span& span) {
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return std::floor(a.row) < std::floor(b.row); });
  std::vector<std::vector<Entry>> blocks;
  for (const Entry& entry : entries) {
    if (blocks.empty() || blocks.back().size() == kLanes || entry.row > span.firstRows.back() + 2) {
      blocks.emplace_back();
      span.firstRows.push_back(static_cast<int>(std::min(static_cast<std::size_t>(entry.row), kLastRows)));
    }
    blocks.back().push_back(entry);
  }
  span.firstBlock = blocks_;
  span.in = KernelBuffer<float>(blocks.size() * streams() * kLanes);
  span.rounds_rad.resize(blocks.size() * kLanes);
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const Entry& entry = blocks[k][std::min(lane, blocks[k].size() - 1)];
      putSpanVertex(entry, span.firstRows[k], &span.in[k * streams() * kLanes + lane]);
      span.rounds_rad[k * kLanes + lane] = scene_->lattice().vertexCoordinates()[entry.vertex].angle_rad;
    }
    for (std::size_t lane = 0; lane < blocks[k].size(); ++lane) {
      slots_[blocks[k][lane].vertex] = slotOf(blocks_ + k, lane);
    }
  }
  blocks_ += blocks.size();
  bytes_ += entries.size() * (streams() + 3) * sizeof(float);
}

void HollowView::putSpanVertex(const Entry& entry, int firstRow, float* lane) const {
  const HollowOrgan& organ = *scene_->hollow;
  const TwistVertex& vertex = organ.vertices()[entry.vertex];
  const TwistLine& own = vertex.line;
  const Vec3 u = vertex.rest_m - own.point_m;
  const Vec3 along = dot(own.direction, u) * own.direction;
  const Vec3 across = u - along;
  const TwistLine turning = organ.lineOf(own, organ.turningPlace(vertex.arc_m, vertex.rest_m));
  // The section of a vertex is that of the foot of its perpendicular, so that `along` is rounding only.
  if (organ.wound()) {
    const auto inFrame = [this](const Vec3& v) -> Vec3 {
      return {dot(first_, v), dot(second_, v), dot(scene_->hollow->line().direction, v)};
    };
    putLane(lane, inFrame(vertex.rest_m - turning.point_m));
    putLane(lane + 3 * kLanes, inFrame(across));
    putLane(lane + 6 * kLanes, inFrame(cross(own.direction, across)));
  } else {
    const Vec3 lift = dot(turning.direction, across) * turning.direction;
    putLane(lane, own.point_m + along);
    putLane(lane + 3 * kLanes, lift);
    putLane(lane + 6 * kLanes, across - lift);
    putLane(lane + 9 * kLanes, cross(turning.direction, across));
  }
  lane[(streams() - 1) * kLanes] = static_cast<float>(entry.row - (firstRow + 1));
}

void HollowView::putWaves(Span& span, int waves) noexcept {
  const std::size_t cosines = (streams() - 3) * kLanes;
  for (std::size_t k = 0; k < span.rounds_rad.size(); ++k) {
    const RoundWave wave = roundWave(waves, span.rounds_rad[k]);
    float* lane = &span.in[k / kLanes * streams() * kLanes + k % kLanes + cosines];
    lane[0] = static_cast<float>(wave.cos);
    lane[kLanes] = static_cast<float>(wave.sin);
  }
  span.waves = waves;
}

void HollowView::moveMobile(double angle_rad) noexcept {
  const TwistLine& line = scene_->hollow->line();
  const SinCos a = portableSinCos(angle_rad);
  const Vec3& d = line.direction;
  const auto turned = [&](const Vec3& axis) {
    return a.cos * axis + ((1.0 - a.cos) * dot(d, axis)) * d + a.sin * cross(d, axis);
  };
  const Vec3 columns[3] = {turned({1.0, 0.0, 0.0}), turned({0.0, 1.0, 0.0}), turned({0.0, 0.0, 1.0})};
  float motion[12] = {};
  for (std::size_t k = 0; k < 3; ++k) {
    motion[k] = static_cast<float>(columns[k].x);
    motion[3 + k] = static_cast<float>(columns[k].y);
    motion[6 + k] = static_cast<float>(columns[k].z);
  }
  motion[9] = static_cast<float>(line.point_m.x);
  motion[10] = static_cast<float>(line.point_m.y);
  motion[11] = static_cast<float>(line.point_m.z);
  twistKernels(isa_).lattice(mobile_.data(), 1, mobileBlocks_, motion, out_.data());
}

// A cord is one solved span: an even turn, nothing narrower.
void HollowView::layWrung(int span) {
  const HollowOrgan& organ = *scene_->hollow;
  const WrungOrgan* tube = organ.tube(span);
  const auto alike =
      std::find_if(wrung_.begin(), wrung_.end(), [tube](const Wrung& known) { return known.tube == tube; });
  spans_[static_cast<std::size_t>(span)].wrung =
      static_cast<std::size_t>(std::distance(wrung_.begin(), alike));
  if (alike != wrung_.end()) {
    return;
  }
  Wrung& wrung = wrung_.emplace_back();
  wrung.tube = tube;
  const std::size_t count = tube == nullptr ? 1 : tube->solvedCount();
  wrung.solved = KernelBuffer<float>(count * 4 * kRow);
  wrung.places = KernelBuffer<float>(4 * kRow);
  wrung.cells = KernelBuffer<float>(kCellQuantities * kRow);
  const std::array<double, kPlaces>& free = organ.freedom();
  for (std::size_t k = 0; k < count; ++k) {
    float* row = &wrung.solved[k * 4 * kRow];
    WrungOrgan::Profile walls;
    if (tube != nullptr) {
      tube->profileOf(k, walls);
    }
    for (std::size_t i = 0; i < kPlaces; ++i) {
      const double even = static_cast<double>(i) / static_cast<double>(kPlaces - 1);
      const bool end = i == 0 || i + 1 == kPlaces;
      row[i] = static_cast<float>(end || tube == nullptr ? even : walls[i].turn);
      row[kRow + i] = static_cast<float>(tube == nullptr ? 1.0 : 1.0 + (walls[i].radius - 1.0) * free[i]);
      if (i > 0 && tube != nullptr) {  // the held section has no folds
        row[2 * kRow + i] = static_cast<float>(1.0 - walls[i].slack);
        row[3 * kRow + i] = static_cast<float>(walls[i].foldTurn);
      }
    }
  }
}

void HollowView::mixPlaces(const OrganState& state, Wrung& wrung) const noexcept {
  const double angle_rad = state.twist.graspAngle_rad;
  const TwistKernels& kernels = twistKernels(isa_);
  HollowMix mix;
  std::fill_n(mix.solved, 4, wrung.solved.data());
  mix.weights[0] = 1.0F;
  if (wrung.tube != nullptr) {
    const double pressure_Pa = state.hollow.reading.pressure_Pa;
    const WringTable::Mix exact = wrung.tube->mixAt(angle_rad, pressure_Pa);
    for (std::size_t k = 0; k < exact.solved.size(); ++k) {
      mix.solved[k] = wrung.solved.data() + exact.solved[k] * 4 * kRow;
      mix.weights[k] = static_cast<float>(exact.weights[k]);
    }
    wrung.waves = drawnWaves(wrung.tube->waves(pressure_Pa));
  }
  mix.turn = static_cast<float>(angle_rad / kPi);
  mix.waves = static_cast<float>(angle_rad < 0.0 ? -wrung.waves : wrung.waves);
  const FoldDepths& depths = foldDepths(wrung.waves);
  mix.depths = depths.depths.data();
  mix.depthsEach = depths.each;
  kernels.hollowPlaces(mix, wrung.places.data());
  if (scene_->hollow->wound()) {
    windPlaces(angle_rad, wrung);
  }
  kernels.hollowCells(wrung.places.data(), wrung.cells.data());
}

void HollowView::windPlaces(double angle_rad, Wrung& wrung) const noexcept {
  HollowOrgan::Sections sections;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    sections[i] = {kPi * wrung.places[i], wrung.places[kRow + i]};
  }
  sections.back().turn_rad = angle_rad;
  scene_->hollow->wind(sections);
  for (std::size_t i = 0; i < kPlaces; ++i) {
    wrung.places[i] = static_cast<float>(sections[i].turn_rad * (1.0 / kPi));
    wrung.places[kRow + i] = static_cast<float>(sections[i].radius);
  }
}

void HollowView::moveSpan(Span& span) noexcept {
  const Wrung& wrung = wrung_[span.wrung];
  if (span.waves != wrung.waves) {
    putWaves(span, wrung.waves);
  }
  HollowFrame frame{wrung.cells.data(), static_cast<float>(wrung.waves)};
  const auto put = [](const Vec3& v, float* out) {
    out[0] = static_cast<float>(v.x);
    out[1] = static_cast<float>(v.y);
    out[2] = static_cast<float>(v.z);
  };
  put(scene_->hollow->line().point_m, frame.point);
  put(scene_->hollow->line().direction, frame.direction);
  put(first_, frame.first);
  put(second_, frame.second);
  const TwistKernels& kernels = twistKernels(isa_);
  (scene_->hollow->wound() ? kernels.hollowWound : kernels.hollowOwn)(
      span.in.data(), span.firstRows.data(), static_cast<int>(span.firstRows.size()), frame,
      out_.data() + span.firstBlock * 3 * kLanes);
}

bool HollowView::updateBlocks(const OrganState& state) noexcept {
  TORSIO_EXPECTS(scene_->hollow->swing() == nullptr);
  if (state.twist.graspAngle_rad == 0.0 && HollowSkin(*scene_->hollow, state).rests()) {
    return false;
  }
  moveMobile(state.twist.graspAngle_rad);
  for (Wrung& wrung : wrung_) {
    mixPlaces(state, wrung);
  }
  for (Span& span : spans_) {
    moveSpan(span);
  }
  return true;
}

void HollowView::deform(const OrganState& state, std::span<Vec3> out_m) noexcept {
  if (scene_->hollow->swing() != nullptr) {
    scene_->deform(state, out_m);
    return;
  }
  const std::size_t count = std::min(slots_.size(), out_m.size());
  if (!updateBlocks(state)) {
    std::copy_n(scene_->mesh.vertices_m.begin(), count, out_m.begin());
    return;
  }
  const float* drawn = out_.data();
  for (std::size_t v = 0; v < count; ++v) {
    const float* lane = drawn + slots_[v];
    out_m[v] = {lane[0], lane[kLanes], lane[2 * kLanes]};
  }
}

}  // namespace torsio
