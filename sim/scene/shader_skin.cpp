// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/shader_skin.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/core/index.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/rod_organ.h"
#include "sim/tissue/hollow/fold_field.h"
#include "sim/tissue/rod/bent_section.h"
#include "sim/tissue/twist/twist_model_map.h"

namespace torsio {

namespace {

constexpr std::size_t kStraightRows = 513;
constexpr std::size_t kRowsAnElement = 8;  // of a rod
constexpr std::size_t kRowsACell = 4;      // between two places of a span
constexpr std::size_t kSpanRows = (HollowOrgan::kPlaces - 1) * kRowsACell + 1;
constexpr std::size_t kRigidRows = 2;  // of what turns as a whole, and of what never moves

ShaderSkin::Texel texel(const Vec3& v, double w) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}

Vec3 threeOf(const ShaderSkin::Texel& t) {
  return {t[0], t[1], t[2]};
}

/// The turn that takes x, y and z to three axes.
Quat turnTo(const Vec3& e1, const Vec3& e2, const Vec3& e3) {
  return rotationFromRows({e1.x, e2.x, e3.x, e1.y, e2.y, e3.y, e1.z, e2.z, e3.z}).value_or(Quat{});
}

/// The turn whose third axis is `d` and whose first is nearest to `aside`.
Quat turnAlong(const Vec3& d, const Vec3& aside) {
  const Vec3 first = normalized(aside - dot(aside, d) * d);
  return turnTo(first, cross(d, first), d);
}

/// The rows on both sides of a place in the table, and how far it lies between them.
struct Between {
  std::size_t low = 0;
  double share = 0.0;
};

Between between(float row) {
  const double low = std::floor(static_cast<double>(row));
  return {static_cast<std::size_t>(low), static_cast<double>(row) - low};
}

}  // namespace

std::optional<ShaderSkin> ShaderSkin::of(std::shared_ptr<const Scene> scene, std::span<const float> fed) {
  const TwistModel::Tables& tables = scene->model.tables();
  const bool straight = !scene->hollow && !scene->rod;
  if (straight && (tables.linear || tables.poynting || tables.components)) {
    return std::nullopt;
  }
  ShaderSkin skin(std::move(scene));
  if (!skin.findNeighbours()) {
    return std::nullopt;
  }
  skin.layVertices(fed);
  return skin;
}

const RodSkin* ShaderSkin::rodSkin() const noexcept {
  if (scene_->hollow) {
    return scene_->hollow->swing() != nullptr ? &scene_->hollow->swing()->rod().skin() : nullptr;
  }
  return scene_->rod ? &scene_->rod->skin() : nullptr;
}

// Each triangle round a vertex says which neighbour comes after which.
bool ShaderSkin::findNeighbours() {
  const TriangleMesh& mesh = scene_->mesh;
  const std::size_t count = mesh.vertices_m.size();
  std::vector<std::vector<std::array<std::uint32_t, 2>>> steps(count);
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      steps[t[k]].push_back({t[(k + 1) % 3], t[(k + 2) % 3]});
    }
  }
  vertices_.assign(count * kVertexTexels, Texel{});
  for (std::size_t v = 0; v < count; ++v) {
    if (steps[v].empty()) {
      return false;
    }
    vertices_[v * kVertexTexels + 4] = {static_cast<float>(neighbours_.size()),
                                        static_cast<float>(steps[v].size()), 0.0F, 0.0F};
    std::uint32_t at = steps[v].front()[0];
    for (std::size_t i = 0; i < steps[v].size(); ++i) {
      neighbours_.push_back(static_cast<float>(at));
      const auto next =
          std::find_if(steps[v].begin(), steps[v].end(),
                       [at](const std::array<std::uint32_t, 2>& step) { return step[0] == at; });
      if (next == steps[v].end()) {
        return false;
      }
      at = (*next)[1];
    }
    if (at != steps[v].front()[0]) {
      return false;
    }
  }
  return true;
}

void ShaderSkin::layVertices(std::span<const float> fed) {
  const std::size_t count = scene_->mesh.vertices_m.size();
  for (std::size_t v = 0; v < count; ++v) {
    vertices_[v * kVertexTexels + 3][3] = v < fed.size() ? fed[v] : 0.0F;
  }
  if (const RodSkin* skin = rodSkin()) {
    layRodVertices(*skin);
    return;
  }
  OrganState rest;
  computeRows(rest);
  const double perMetre = static_cast<double>(kStraightRows - 1) / scene_->lattice().length_m();
  for (std::size_t v = 0; v < count; ++v) {
    if (scene_->hollow) {
      layVertex(v, hollowRowOf(v));
      layWound(v);
      continue;
    }
    const TwistVertex& vertex = scene_->model.tables().vertices[v];
    layVertex(v, std::clamp(vertex.arc_m * perMetre, 0.0, static_cast<double>(kStraightRows - 1)));
    vertices_[v * kVertexTexels + 1][3] = static_cast<float>(vertex.warp_m2);
  }
}

void ShaderSkin::layRodVertices(const RodSkin& skin) {
  const std::span<const RodSkinPlace> places = skin.vertexPlaces();
  for (std::size_t v = 0; v < places.size(); ++v) {
    const RodSkinPlace& place = places[v];
    Texel* numbers = &vertices_[v * kVertexTexels];
    const double row = (static_cast<double>(place.element) + place.share) * kRowsAnElement;
    numbers[0] = texel({place.section_m[0], place.section_m[1], place.beyond_m}, row);
    numbers[1] = {static_cast<float>(place.left_m[0]), static_cast<float>(place.left_m[1]),
                  static_cast<float>(place.restFibre), static_cast<float>(place.warping_m2)};
  }
}

// Against the rows at rest as the shader interpolates them, so that an organ at rest lies where it is.
void ShaderSkin::layVertex(std::size_t vertex, double row) {
  Texel* numbers = &vertices_[vertex * kVertexTexels];
  const Between at = between(static_cast<float>(row));
  const Texel* low = &rows_[at.low * kRowTexels];
  const Texel* high = low + kRowTexels;
  const auto mix = [&](std::size_t texelOfRow, std::size_t k) {
    return (1.0 - at.share) * low[texelOfRow][k] + at.share * high[texelOfRow][k];
  };
  const Quat turn = normalized(Quat{mix(1, 3), mix(1, 0), mix(1, 1), mix(1, 2)});
  const Vec3 way = scene_->mesh.vertices_m[vertex] - Vec3{mix(0, 0), mix(0, 1), mix(0, 2)};
  numbers[0] = texel(rotate(conjugate(turn), way), row);
  numbers[1] = {0.0F, 0.0F, 1.0F, 0.0F};
}

double ShaderSkin::hollowRowOf(std::size_t vertex) const {
  const HollowOrgan& organ = *scene_->hollow;
  const TwistVertex& where = organ.vertices()[vertex];
  const HollowOrgan::Place place = organ.turningPlace(where.arc_m, where.rest_m);
  if (place.span < 0) {
    return 0.0;
  }
  if (!(place.share > 0.0)) {
    return static_cast<double>(kRigidRows);
  }
  const auto first = 2 * kRigidRows + static_cast<std::size_t>(place.span) * kSpanRows;
  return static_cast<double>(first) + place.share * static_cast<double>(kSpanRows - 1);
}

// A fold of a wound limb is about the section's own axis, its turn about the line.
void ShaderSkin::layWound(std::size_t vertex) {
  const HollowOrgan& organ = *scene_->hollow;
  Texel* numbers = &vertices_[vertex * kVertexTexels];
  numbers[2][3] = static_cast<float>(scene_->lattice().vertexCoordinates()[vertex].angle_rad);
  if (!organ.wound()) {
    return;
  }
  const TwistVertex& where = organ.vertices()[vertex];
  const AxisFrame frame = organ.graspFrame(organ.line().point_m);
  const Quat back = conjugate(turnTo(frame.e1, frame.e2, frame.tangent));
  const Vec3 way = where.rest_m - where.line.point_m;
  const Vec3 across = rotate(back, way - dot(way, where.line.direction) * where.line.direction);
  const Vec3 round = rotate(back, cross(where.line.direction, way));
  numbers[2] = texel(across, numbers[2][3]);
  numbers[3] = texel(round, numbers[3][3]);
  numbers[4][2] = 1.0F;
}

void ShaderSkin::update(const OrganState& state) {
  computeRows(state);
}

void ShaderSkin::computeRows(const OrganState& state) {
  rows_.clear();
  if (const RodSkin* skin = rodSkin()) {
    const bool lies = scene_->hollow || state.pose.count > 0;
    rodRows(*skin, scene_->hollow ? scene_->hollow->curveOf(state)
                   : lies         ? skin->curveOf(state.pose)
                                  : skin->restCurve());
  } else if (scene_->hollow) {
    hollowRows(state);
  } else {
    straightRows(state);
  }
  put({});  // the last row has one behind it
}

void ShaderSkin::put(const Row& row) {
  Quat turn = row.turn;
  if (!rows_.empty()) {  // q and -q turn alike: on the side of the row before
    const Texel& before = rows_[rows_.size() - kRowTexels + 1];
    if (turn.x * before[0] + turn.y * before[1] + turn.z * before[2] + turn.w * before[3] < 0.0) {
      turn = {-turn.w, -turn.x, -turn.y, -turn.z};
    }
  }
  rows_.push_back(texel(row.place_m, row.width));
  rows_.push_back(texel({turn.x, turn.y, turn.z}, turn.w));
  rows_.push_back(texel({row.inwards_per_m[0], row.inwards_per_m[1], row.stretch}, row.warpingRate_per_m));
  rows_.push_back(texel({row.even, row.odd, static_cast<double>(row.waves)}, 0.0));
}

void ShaderSkin::straightRows(const OrganState& state) {
  const SectionLattice& lattice = scene_->lattice();
  const TwistMap map(scene_->model.tables(), lattice, state.twist);
  for (std::size_t i = 0; i < kStraightRows; ++i) {
    const double arc_m = lattice.length_m() * static_cast<double>(i) / static_cast<double>(kStraightRows - 1);
    const TwistLine line = map.centreAt(arc_m);
    const Quat rest = turnAlong(line.direction, lattice.frameAt(arc_m).e1);
    put({.place_m = line.point_m,
         .turn = axisAngle(line.direction, map.identity() ? 0.0 : map.angle(arc_m)) * rest,
         .warpingRate_per_m = map.identity() ? 0.0 : map.warpingRate(arc_m)});
  }
}

void ShaderSkin::rodRows(const RodSkin& skin, const RodCurve& curve) {
  const RodCurve& rest = skin.restCurve();
  const std::size_t elements = at(curve.count - 1);
  for (std::size_t i = 0; i <= elements * kRowsAnElement; ++i) {
    const std::size_t element = std::min(i / kRowsAnElement, elements - 1);
    const double share = static_cast<double>(i - element * kRowsAnElement) / kRowsAnElement;
    const RodCurvePlace now = RodSkin::placeOn(curve, element, share);
    const RodCurvePlace before = RodSkin::placeOn(rest, element, share);
    put({.place_m = now.place_m,
         .turn = now.turn,
         .width = curve.widthAt(element, share) * std::sqrt(before.stretch / now.stretch),
         .inwards_per_m = now.inwards_per_m,
         .stretch = now.stretch,
         .warpingRate_per_m = (now.twist_per_m - before.twist_per_m) / now.stretch});
  }
}

void ShaderSkin::hollowRows(const OrganState& state) {
  const HollowOrgan& organ = *scene_->hollow;
  const TwistLine& line = organ.line();
  for (std::size_t i = 0; i < kRigidRows; ++i) {
    put({.place_m = line.point_m, .turn = axisAngle(line.direction, state.twist.graspAngle_rad)});
  }
  for (std::size_t i = 0; i < kRigidRows; ++i) {
    put({});
  }
  for (int span = 0; span < (organ.wound() ? 1 : organ.spans()); ++span) {
    spanRows(span, state);
  }
}

void ShaderSkin::spanRows(int span, const OrganState& state) {
  const HollowOrgan& organ = *scene_->hollow;
  const WrungSpan& ends = organ.detorsion().spans[at(span)];
  const WrungOrgan* tube = organ.tube(span);
  HollowOrgan::Sections sections;
  std::array<FoldPhase, HollowOrgan::kPlaces> folds{};
  int waves = 0;
  if (state.hollow.present) {
    WrungOrgan::Profile walls;
    organ.sectionsOf(span, state, sections, walls);
    if (tube != nullptr) {
      waves = drawnWaves(tube->waves(state.hollow.reading.pressure_Pa));
      for (std::size_t i = 1; i < HollowOrgan::kPlaces; ++i) {
        folds[i] = foldPhase({waves, foldAmplitude(waves, walls[i].slack), walls[i].foldTurn});
      }
    }
  }
  const AxisFrame frame = organ.graspFrame(organ.line().point_m);
  const Quat lineTurn = turnTo(frame.e1, frame.e2, frame.tangent);
  for (std::size_t i = 0; i < kSpanRows; ++i) {
    const std::size_t cell = std::min(i / kRowsACell, HollowOrgan::kPlaces - 2);
    const double share = static_cast<double>(i - cell * kRowsACell) / kRowsACell;
    const auto mix = [share](double from, double to) { return from + share * (to - from); };
    const double turn_rad = mix(sections[cell].turn_rad, sections[cell + 1].turn_rad);
    Row row;
    row.width = mix(sections[cell].radius, sections[cell + 1].radius);
    row.even = mix(folds[cell].even, folds[cell + 1].even);
    row.odd = mix(folds[cell].odd, folds[cell + 1].odd);
    row.waves = waves;
    if (organ.wound()) {
      row.place_m = organ.line().point_m;
      row.turn = axisAngle(organ.line().direction, turn_rad) * lineTurn;
    } else {
      const double along = static_cast<double>(i) / static_cast<double>(kSpanRows - 1);
      const AxisFrame own =
          scene_->lattice().frameAt((ends.held + along * (ends.mobile - ends.held)) * organ.length_m());
      const TwistLine line = organ.lineOf({own.centre_m, own.tangent}, {span, along});
      row.place_m = line.point_m;
      row.turn = axisAngle(line.direction, turn_rad) * turnAlong(line.direction, own.e1);
      row.stretch = row.width;  // what leans out of its section is as much nearer
    }
    put(row);
  }
}

// The same as in organ_place.glsl, line by line.
Vec3 ShaderSkin::place_m(std::uint32_t vertex) const noexcept {
  const Texel* v = &vertices_[vertex * kVertexTexels];
  const Between at = between(v[0][3]);
  const Texel* low = &rows_[at.low * kRowTexels];
  const Texel* high = low + kRowTexels;
  const auto mix = [&](std::size_t texelOfRow, std::size_t k) {
    return low[texelOfRow][k] + at.share * (static_cast<double>(high[texelOfRow][k]) - low[texelOfRow][k]);
  };
  Vec3 local = threeOf(v[0]);
  const double even = mix(3, 0);
  const double odd = mix(3, 1);
  if (even != 0.0 || odd != 0.0) {
    const int waves = static_cast<int>(low[3][2]);
    const FoldedPoint fold = foldedPoint(waves, {even, odd}, roundWave(waves, v[2][3]));
    const double c = fold.radius * std::cos(fold.turn_rad);
    const double s = fold.radius * std::sin(fold.turn_rad);
    if (v[4][2] > 0.5F) {
      local += (c - 1.0) * threeOf(v[2]) + s * threeOf(v[3]);
    } else {
      local = {c * local.x - s * local.y, s * local.x + c * local.y, fold.radius * local.z};
    }
  }
  const double width = mix(0, 3);
  const std::array<double, 2> w{width * local.x, width * local.y};
  const std::array<double, 2> k{mix(2, 0), mix(2, 1)};
  const std::array<double, 2> u = bent(w, k);
  const double longer = mix(2, 2) * (1.0 - u[0] * k[0] - u[1] * k[1]) / v[1][2];
  const Quat turn = normalized(Quat{mix(1, 3), mix(1, 0), mix(1, 1), mix(1, 2)});
  return Vec3{mix(0, 0), mix(0, 1), mix(0, 2)} +
         rotate(turn, {u[0] + v[1][0], u[1] + v[1][1], longer * local.z + mix(2, 3) * v[1][3]});
}

Vec3 ShaderSkin::normal_m2(std::uint32_t vertex) const noexcept {
  const Texel& ring = vertices_[vertex * kVertexTexels + 4];
  const auto first = static_cast<std::size_t>(ring[0]);
  const auto count = static_cast<std::size_t>(ring[1]);
  const auto way = [&, here = place_m(vertex)](std::size_t i) {
    return place_m(static_cast<std::uint32_t>(neighbours_[first + i])) - here;
  };
  Vec3 sum;
  Vec3 side = way(count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 next = way(i);
    sum += cross(side, next);
    side = next;
  }
  return sum;
}

}  // namespace torsio
