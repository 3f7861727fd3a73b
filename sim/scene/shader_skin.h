// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/pose.h"
#include "sim/scene/scene.h"
#include "sim/tissue/rod/rod_skin.h"

namespace torsio {

/// The skin of an organ as a vertex shader deforms it (assets/shaders/organ_place.glsl): constant numbers of
/// each vertex, and in each frame a table of how the organ's sections lie, between whose rows the shader
/// interpolates. One program for straight organs, rods and wrung walls. Within 0.2 mm of Scene::deform; for
/// views only. One thread at a time; shares ownership of the scene.
class ShaderSkin {
 public:
  static constexpr std::size_t kVertexTexels = 5;  ///< of four numbers, of each vertex
  static constexpr std::size_t kRowTexels = 4;     ///< of each row
  using Texel = std::array<float, 4>;

  /// Returns it; empty if the organ is deformed by other rules (the paper's formulation, options of an
  /// engineer), or its surface is not closed. `fed`: BloodMap::fed(), or empty.
  [[nodiscard]] static std::optional<ShaderSkin> of(std::shared_ptr<const Scene> scene,
                                                    std::span<const float> fed);

  /// Returns the numbers of all vertices: place in its section, m, and row; what the map of a bend leaves, m,
  /// length of the fibre at rest, warping, m^2; across the section of a wound limb, m, and its angle; across
  /// that, m, and how far its blood comes through the twist; its neighbours (first, count), whether its limb
  /// is wound.
  [[nodiscard]] std::span<const Texel> vertices() const noexcept { return vertices_; }
  /// Returns the neighbours of all vertices, those of one after the other, counter-clockwise seen from
  /// outside.
  [[nodiscard]] std::span<const float> neighbours() const noexcept { return neighbours_; }

  /// Computes the rows of a frame: place, m, and width; turn (x, y, z, w); bend, 1/m, stretch, warping rate,
  /// rad/m; folds (even, odd, waves). Allocates nothing after the first.
  void update(const OrganState& state);
  /// Returns the rows of the last frame.
  [[nodiscard]] std::span<const Texel> rows() const noexcept { return rows_; }
  /// Returns where the shader puts a vertex in the last frame, world frame, m.
  [[nodiscard]] Vec3 place_m(std::uint32_t vertex) const noexcept;
  /// Returns the sum of the normals of the triangles round a vertex there, as long as twice their area.
  [[nodiscard]] Vec3 normal_m2(std::uint32_t vertex) const noexcept;

 private:
  /// How a section lies.
  struct Row {
    Vec3 place_m;
    Quat turn;
    double width = 1.0;
    std::array<double, 2> inwards_per_m{};
    double stretch = 1.0;
    double warpingRate_per_m = 0.0;
    double even = 0.0;
    double odd = 0.0;
    int waves = 0;
  };
  explicit ShaderSkin(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {}
  [[nodiscard]] bool findNeighbours();
  void layVertices(std::span<const float> fed);
  void layRodVertices(const RodSkin& skin);
  void layVertex(std::size_t vertex, double row);
  void layWound(std::size_t vertex);
  void computeRows(const OrganState& state);
  void straightRows(const OrganState& state);
  void rodRows(const RodSkin& skin, const RodCurve& curve);
  void hollowRows(const OrganState& state);
  void spanRows(int span, const OrganState& state);
  [[nodiscard]] const RodSkin* rodSkin() const noexcept;
  [[nodiscard]] double hollowRowOf(std::size_t vertex) const;
  void put(const Row& row);

  std::shared_ptr<const Scene> scene_;
  std::vector<Texel> vertices_;
  std::vector<float> neighbours_;
  std::vector<Texel> rows_;
};

}  // namespace torsio
