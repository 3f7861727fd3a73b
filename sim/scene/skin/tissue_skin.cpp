// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/skin/tissue_skin.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "sim/core/angle.h"
#include "sim/scene/skin/tissue_palette.h"
#include "sim/scene/skin/vessels.h"

namespace torsio {

namespace {

constexpr double kPixel_m = 0.00030;  // a fine vessel is two pixels wide
constexpr int kMaxPixels = 1'600'000;
constexpr double kCell_m = 0.004;
constexpr std::uint32_t kNobody = 0xFFFFFFFFU;

float centre(std::size_t pixel) {
  return static_cast<float>(pixel) + 0.5F;
}

/// One point of the skin at rest.
struct SkinPoint {
  Vec3 rest_m;
  Light tint{};
  double arc_m = 0.0;
  double angle_rad = 0.0;
  float side = 1.0F;  ///< 0 on the caps, where the ridge angle means nothing
};

/// A piece of a vessel in the plane of one triangle, metres.
struct FlatPiece {
  std::array<float, 2> from{};
  std::array<float, 2> way{};
  float perLength2 = 0.0F;
  float radius = 0.0F;
  float soft = 0.0F;
  float reach = 0.0F;
  float strength = 0.0F;
};

/// How far a point lies in a vessel and in the blush round it, 0 to 1.
struct Blood {
  float inside = 0.0F;
  float round = 0.0F;
};

class Painter {
 public:
  Painter(const Scene& scene, const TissueLook& look, TissueSkin& skin)
      : scene_(scene),
        mesh_(scene.mesh),
        look_(look),
        palette_(paletteOf(look.kind)),
        base_(linear(look.colour)),
        skin_(skin),
        vessels_(growVessels(mesh_, scene.lattice(), look)) {
    for (const Vec3& v : mesh_.vertices_m) {
      tints_.push_back(mottle(look, v));
    }
    seenBy_.assign(vessels_.size(), kNobody);
    for (std::uint32_t i = 0; i < vessels_.size(); ++i) {
      sort(i);
    }
  }

  void paint() {
    assignPixels();
    skin_.rgba.assign(owners_.size() * 4, 255);
    // Between the pieces lies the tissue's own colour: what a smaller copy of the map mixes in is not seen.
    const std::array<std::uint8_t, 3> ground{encoded(base_[0]), encoded(base_[1]), encoded(base_[2])};
    for (std::size_t i = 0; i < owners_.size(); ++i) {
      std::copy(ground.begin(), ground.end(), &skin_.rgba[4 * i]);
    }
    const std::vector<std::size_t> pixels = byOwner();
    std::uint32_t last = kNobody;
    for (const std::size_t i : pixels) {
      if (owners_[i] != last) {
        gather(last = owners_[i]);
      }
      const auto width = static_cast<std::size_t>(skin_.charts.width);
      const std::size_t row = i / width;
      const SkinPoint point = pointAt(last, centre(i - row * width), centre(row));
      const Blood blood = bloodAt(flatPlace(point.rest_m));
      const Light colour = colourAt(point, blood);
      for (std::size_t k = 0; k < 3; ++k) {
        const float c = std::clamp(colour[k], 0.0F, 1.0F);
        skin_.rgba[4 * i + k] = encodedTable()[static_cast<std::size_t>(std::lround(c * 4095.0F))];
      }
      skin_.rgba[4 * i + 3] = static_cast<std::uint8_t>(std::lround(255.0F * heightAt(point, blood)));
    }
  }

 private:
  float reach(const VesselPiece& v) const {
    return 3.0F * v.radius_m + 0.0010F + static_cast<float>(palette_.softness_m);
  }

  bool farFrom(const VesselPiece& v, const Vec3& place_m, double span_m) const {
    const Vec3 away = place_m - (v.from_m + v.to_m) * 0.5;
    const double reach_m = span_m + static_cast<double>(reach(v)) + 0.5 * norm(v.to_m - v.from_m);
    return dot(away, away) > reach_m * reach_m;
  }

  /// The pixels that show something, triangle after triangle.
  [[nodiscard]] std::vector<std::size_t> byOwner() const {
    std::vector<std::size_t> begins(mesh_.triangles.size() + 1, 0);
    for (const std::uint32_t owner : owners_) {
      if (owner != kNobody) {
        ++begins[owner + 1];
      }
    }
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    std::vector<std::size_t> pixels(begins.back());
    for (std::size_t i = 0; i < owners_.size(); ++i) {
      if (owners_[i] != kNobody) {
        pixels[begins[owners_[i]]++] = i;
      }
    }
    return pixels;
  }

  static std::uint64_t cell(std::int64_t x, std::int64_t y, std::int64_t z) {
    constexpr std::int64_t kMiddle = 1 << 20;
    return (static_cast<std::uint64_t>(x + kMiddle) << 42U) ^
           (static_cast<std::uint64_t>(y + kMiddle) << 21U) ^ static_cast<std::uint64_t>(z + kMiddle);
  }

  template <typename Visit>
  static void cellsOf(const Vec3& low, const Vec3& high, const Visit& visit) {
    const auto index = [](double v) { return static_cast<std::int64_t>(std::floor(v / kCell_m)); };
    for (std::int64_t x = index(low.x); x <= index(high.x); ++x) {
      for (std::int64_t y = index(low.y); y <= index(high.y); ++y) {
        for (std::int64_t z = index(low.z); z <= index(high.z); ++z) {
          visit(cell(x, y, z));
        }
      }
    }
  }

  void sort(std::uint32_t i) {
    const VesselPiece& v = vessels_[i];
    const double r = static_cast<double>(reach(v));
    const Vec3 low{std::min(v.from_m.x, v.to_m.x) - r, std::min(v.from_m.y, v.to_m.y) - r,
                   std::min(v.from_m.z, v.to_m.z) - r};
    const Vec3 high{std::max(v.from_m.x, v.to_m.x) + r, std::max(v.from_m.y, v.to_m.y) + r,
                    std::max(v.from_m.z, v.to_m.z) + r};
    cellsOf(low, high, [&](std::uint64_t key) { cells_[key].push_back(i); });
  }

  /// The vessels that a triangle can show.
  void gather(std::uint32_t t) {
    std::vector<std::uint32_t> near;
    const TriangleMesh::Triangle& corner = mesh_.triangles[t];
    const BoundingBox box = boxOf(
        std::array{mesh_.vertices_m[corner[0]], mesh_.vertices_m[corner[1]], mesh_.vertices_m[corner[2]]});
    cellsOf(box.low, box.high, [&](std::uint64_t key) {
      const auto found = cells_.find(key);
      if (found == cells_.end()) {
        return;
      }
      for (const std::uint32_t i : found->second) {
        if (std::exchange(seenBy_[i], t) != t) {
          near.push_back(i);
        }
      }
    });
    const Vec3 middle_m = (box.low + box.high) * 0.5;
    const double span_m = 0.5 * norm(box.high - box.low);
    std::erase_if(near, [&](std::uint32_t i) { return farFrom(vessels_[i], middle_m, span_m); });
    flatten(corner, near);
  }

  /// The same pieces in the plane of the triangle: a map has a million pixels.
  void flatten(const TriangleMesh::Triangle& corner, const std::vector<std::uint32_t>& near) {
    origin_m_ = mesh_.vertices_m[corner[0]];
    right_ = normalized(mesh_.vertices_m[corner[1]] - origin_m_);
    const Vec3 normal = normalized(cross(right_, mesh_.vertices_m[corner[2]] - origin_m_));
    up_ = cross(normal, right_);
    near_.clear();
    for (const std::uint32_t i : near) {
      const VesselPiece& v = vessels_[i];
      FlatPiece flat;
      flat.from = flatPlace(v.from_m);
      const std::array<float, 2> to = flatPlace(v.to_m);
      flat.way = {to[0] - flat.from[0], to[1] - flat.from[1]};
      const float length2 = flat.way[0] * flat.way[0] + flat.way[1] * flat.way[1];
      flat.perLength2 = length2 > 0.0F ? 1.0F / length2 : 0.0F;
      flat.radius = v.radius_m;
      flat.soft = 0.45F * v.radius_m + static_cast<float>(palette_.softness_m);
      flat.reach = reach(v);
      flat.strength = v.strength;
      near_.push_back(flat);
    }
  }

  [[nodiscard]] std::array<float, 2> flatPlace(const Vec3& p) const {
    return {static_cast<float>(dot(p - origin_m_, right_)), static_cast<float>(dot(p - origin_m_, up_))};
  }

  std::array<float, 3> weights(std::uint32_t t, float x, float y) const {
    const auto& corner = skin_.charts.triangles[t];
    const auto& a = skin_.charts.corners[corner[0]].place;
    const auto& b = skin_.charts.corners[corner[1]].place;
    const auto& c = skin_.charts.corners[corner[2]].place;
    const float area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (std::abs(area) < 1e-6F) {
      return {1.0F, 0.0F, 0.0F};
    }
    const float u = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area;
    const float v = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
    return {1.0F - u - v, u, v};
  }

  /// Which triangle each pixel shows: its own, and round a piece that of the neighbour.
  void assignPixels() {
    const int width = skin_.charts.width;
    const int height = skin_.charts.height;
    owners_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kNobody);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      cover(t, width);
    }
    for (int ring = 0; ring < kChartMargin; ++ring) {
      std::vector<std::pair<std::size_t, std::uint32_t>> grown;
      for (int y = 1; y + 1 < height; ++y) {
        for (int x = 1; x + 1 < width; ++x) {
          const auto i =
              static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
          if (owners_[i] != kNobody) {
            continue;
          }
          const auto w = static_cast<std::size_t>(width);
          for (const std::size_t other : {i - 1, i + 1, i - w, i + w}) {
            if (owners_[other] == kNobody) {
              continue;
            }
            grown.emplace_back(i, owners_[other]);
            break;
          }
        }
      }
      for (const auto& [i, owner] : grown) {
        owners_[i] = owner;
      }
    }
  }

  void cover(std::uint32_t t, int width) {
    const auto& corner = skin_.charts.triangles[t];
    float left = 1e9F, right = -1e9F, top = 1e9F, bottom = -1e9F;
    for (const std::uint32_t c : corner) {
      const auto& place = skin_.charts.corners[c].place;
      left = std::min(left, place[0]), right = std::max(right, place[0]);
      top = std::min(top, place[1]), bottom = std::max(bottom, place[1]);
    }
    constexpr float kSlack = -1e-3F;
    for (int y = static_cast<int>(top) - 1; y <= static_cast<int>(bottom) + 1; ++y) {
      for (int x = static_cast<int>(left) - 1; x <= static_cast<int>(right) + 1; ++x) {
        const auto w = weights(t, static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
        if (w[0] < kSlack || w[1] < kSlack || w[2] < kSlack) {
          continue;
        }
        owners_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)] =
            t;
      }
    }
  }

  SkinPoint pointAt(std::uint32_t t, float x, float y) const {
    const auto w = weights(t, x, y);
    const TriangleMesh::Triangle& corner = mesh_.triangles[t];
    const auto coordinates = scene_.lattice().vertexCoordinates();
    const auto parts = scene_.lattice().vertexParts();
    SkinPoint point;
    point.side = 0.0F;
    const double first_rad = coordinates[corner[0]].angle_rad;
    point.angle_rad = first_rad;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto share = static_cast<double>(w[k]);
      const LatticeCoordinate& c = coordinates[corner[k]];
      point.rest_m += mesh_.vertices_m[corner[k]] * share;
      point.arc_m += share * c.arc_m;
      point.angle_rad += share * std::remainder(c.angle_rad - first_rad, kTurn);
      point.side += parts[corner[k]] == LatticePart::kSide ? w[k] : 0.0F;
      for (std::size_t i = 0; i < 3; ++i) {
        point.tint[i] += w[k] * tints_[corner[k]][i];
      }
    }
    // The lattice's coordinates grow vague towards the ends.
    const double place = point.arc_m / scene_.lattice().length_m();
    point.side *= ease(0.02F, 0.12F, static_cast<float>(std::min(place, 1.0 - place)));
    return point;
  }

  Light colourAt(const SkinPoint& point, const Blood& blood) const {
    constexpr double kGrain_m = 0.0011;
    Light colour{};
    const float grain =
        palette_.grain * (tissueNoise(point.rest_m / kGrain_m) +
                          0.7F * tissueNoise(point.rest_m / (2.6 * kGrain_m) + Vec3{5, 1, 9}));
    for (std::size_t k = 0; k < 3; ++k) {
      // Blood makes the grain: red changes least.
      colour[k] = base_[k] * point.tint[k] * (1.0F + grain * (k == 0 ? 0.5F : 1.0F));
    }
    if (point.side > 0.0F) {
      colour = withFibres(colour, point);
    }
    return withVessels(colour, blood);
  }

  /// 0 to 1: what the lamp meets where no shader makes relief. Waves of some pixels only, nothing glitters.
  [[nodiscard]] float heightAt(const SkinPoint& point, const Blood& blood) const {
    const auto wave = [&](double length_m, double shift) {
      return tissueNoise(point.rest_m / length_m + Vec3{shift, -shift, 2.0 * shift});
    };
    float height = 0.5F;
    if (look_.kind == TissueKind::kSkin) {
      // Fields of the skin: zero lines of a wave stretched round the limb are creases.
      const Vec3 stretched{point.rest_m.x / 0.0034, point.rest_m.y / 0.0034, point.rest_m.z / 0.0016};
      height += 0.16F * std::min(1.0F, 3.0F * std::abs(tissueNoise(stretched))) - 0.08F;
      height += 0.16F * wave(0.0075, 3.0) + 0.07F * wave(0.0014, 5.0);
    } else {
      height += 0.24F * wave(0.0073, 1.0) + 0.12F * wave(0.0026, 7.0);
    }
    height += 0.12F * look_.bandShare * point.side * bandAt(point.angle_rad);
    return std::clamp(height + 0.14F * blood.inside, 0.0F, 1.0F);
  }

  /// 1 in a band along the organ, 0 beside it.
  [[nodiscard]] float bandAt(double angle_rad) const {
    if (look_.bands == 0) {
      return 0.0F;
    }
    const double away = std::remainder(angle_rad, kTurn / look_.bands) / look_.bandHalf_rad;
    return static_cast<float>(std::exp(-away * away * away * away));
  }

  Light withFibres(Light colour, const SkinPoint& point) const {
    constexpr double kAlong_m = 0.016;
    constexpr double kAcross = 46.0;  // fibres round the organ, times two pi
    const Vec3 stretched{point.arc_m / kAlong_m, kAcross * std::cos(point.angle_rad),
                         kAcross * std::sin(point.angle_rad)};
    float change = palette_.fibres * (tissueNoise(stretched) + 0.6F * tissueNoise(stretched * 2.3));
    if (palette_.folds > 0.0F) {
      constexpr double kFold_m = 0.0046;
      const auto bend = static_cast<double>(tissueNoise(point.rest_m / 0.008));
      change += palette_.folds * static_cast<float>(std::sin(kTurn * (point.arc_m / kFold_m) + 1.6 * bend));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      colour[k] *= 1.0F + point.side * change * (k == 0 ? 0.45F : 1.0F);
    }
    colour = mixed(colour, palette_.band, look_.bandShare * point.side * bandAt(point.angle_rad));
    if (look_.borderFat > 0.0F) {
      for (const double border : {0.0, std::numbers::pi}) {
        if (look_.bands > 0 && border == 0.0) {
          continue;
        }
        const double away = std::remainder(point.angle_rad - border, kTurn) / 0.36;
        const auto close = static_cast<float>(std::exp(-away * away));
        if (close < 0.02F) {
          continue;
        }
        const float lobules = ease(
            -0.45F, 0.65F, tissueNoise(point.rest_m / 0.006) + 0.5F * tissueNoise(point.rest_m / 0.0022));
        colour = mixed(colour, palette_.fat, look_.borderFat * point.side * close * lobules);
      }
    }
    return colour;
  }

  [[nodiscard]] Blood bloodAt(const std::array<float, 2>& place) const {
    Blood blood;
    for (const FlatPiece& v : near_) {
      const float x = place[0] - v.from[0];
      const float y = place[1] - v.from[1];
      const float share = std::clamp((x * v.way[0] + y * v.way[1]) * v.perLength2, 0.0F, 1.0F);
      const float dx = x - v.way[0] * share;
      const float dy = y - v.way[1] * share;
      const float distance2 = dx * dx + dy * dy;
      if (distance2 > v.reach * v.reach) {
        continue;
      }
      const float distance = std::sqrt(distance2);
      blood.inside =
          std::max(blood.inside, v.strength * (1.0F - ease(v.radius - v.soft, v.radius + v.soft, distance)));
      blood.round = std::max(blood.round, v.strength * (1.0F - ease(0.0F, v.reach, distance)));
    }
    return blood;
  }

  Light withVessels(Light colour, const Blood& blood) const {
    colour = scaled(colour, palette_.blush, palette_.blushShare * blood.round);
    return scaled(colour, palette_.vessel, palette_.vesselShare * blood.inside);
  }

  const Scene& scene_;
  const TriangleMesh& mesh_;
  TissueLook look_;
  TissuePalette palette_;
  Light base_;
  TissueSkin& skin_;
  std::vector<VesselPiece> vessels_;
  std::vector<Light> tints_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
  std::vector<std::uint32_t> owners_;
  std::vector<std::uint32_t> seenBy_;  // triangle that a piece was last gathered for
  // Of the triangle at work: its plane and the pieces near it.
  Vec3 origin_m_;
  Vec3 right_;
  Vec3 up_;
  std::vector<FlatPiece> near_;
};

}  // namespace

TissueSkin paintSkin(const Scene& scene, const TissueLook& look) {
  TissueSkin skin;
  skin.charts = layFlat(scene.mesh, kPixel_m, kMaxPixels);
  for (std::size_t i = 0; i < scene.mesh.vertices_m.size(); ++i) {
    const Vec3& p = scene.mesh.vertices_m[i];
    constexpr float kMillimetres = 1000.0F;
    skin.rest_mm.push_back({kMillimetres * static_cast<float>(p.x), kMillimetres * static_cast<float>(p.z),
                            -kMillimetres * static_cast<float>(p.y)});
    skin.arc_mm.push_back(static_cast<float>(scene.lattice().vertexCoordinates()[i].arc_m * 1000.0));
  }
  Painter(scene, look, skin).paint();
  return skin;
}

}  // namespace torsio
