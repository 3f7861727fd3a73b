// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "sim/tissue/hollow/fold_field.h"
#include "sim/tissue/twist/twist_model_tables.h"
#include "sim/tissue/view/cpu_features.h"
#include "sim/tissue/view/twist_kernels_buffer.h"

namespace torsio {

/// A hollow organ as it is drawn (docs/model.md H.8): as HollowMap has it, with the folds of the wrung wall.
/// What is common to all vertices is computed on construction. For views; lives on the stack.
class HollowSkin {
 public:
  HollowSkin(const HollowOrgan& organ, const OrganState& state) noexcept;

  /// Returns where a vertex goes; `round_rad`: its ridge angle.
  [[nodiscard]] Vec3 vertex(const TwistVertex& vertex, double round_rad) const noexcept;

  static constexpr std::size_t kPlaces = HollowOrgan::kPlaces;  ///< of a span, at equal shares
  /// Tells whether no vertex moves.
  [[nodiscard]] bool rests() const noexcept;

 private:
  struct Limb {
    int waves = kMinDrawnWaves;
    HollowOrgan::Sections sections{};
    std::array<FoldPhase, kPlaces> folds{};
  };
  struct Place {
    HollowOrgan::Section section;
    FoldPhase fold;
  };
  void fill(int span, const OrganState& state, Limb& limb) const noexcept;
  [[nodiscard]] Place placeAt(const Limb& limb, double share) const noexcept;

  const HollowOrgan& organ_;
  double angle_rad_ = 0.0;
  std::array<Limb, 2> limbs_;  // of the spans
};

/// The mesh of a hollow scene for a view: HollowSkin in single precision by the widest instruction set of the
/// processor, good to 1e-6 m. Vertices are sorted by their place along the organ, so that a block reads one
/// place of the frame's table and gathers nothing; those that never move are written once. An organ that
/// swings as a rod is drawn by Scene::deform itself. Never feeds a recording: the last bit depends on the
/// processor. One thread at a time.
class HollowView {
 public:
  /// `scene` has a hollow organ.
  explicit HollowView(std::shared_ptr<const Scene> scene, Isa isa = bestIsa());

  /// Computes where each mesh vertex is drawn, m, as Scene::deform does; at rest the same bits. Allocates
  /// nothing.
  void deform(const OrganState& state, std::span<Vec3> out_m) noexcept;
  /// Computes the frame in the kernels' own layout, 3 x 16 a block, in the view's own order of vertices;
  /// false at rest, where there is nothing to compute. Not for an organ that swings.
  bool updateBlocks(const OrganState& state) noexcept;
  /// Returns how many bytes of vertices a frame reads and writes; padding is not counted.
  [[nodiscard]] std::size_t bytesAFrame() const noexcept { return bytes_; }

 private:
  /// A vertex in a block: of the mesh, and its place in rows of its span.
  struct Entry {
    std::size_t vertex = 0;
    double row = 0.0;
  };
  /// Blocks of one span, or of all limbs that are wound round each other.
  struct Span {
    KernelBuffer<float> in;
    std::vector<int> firstRows;
    std::vector<double> rounds_rad;  // ridge angle, one a lane
    int waves = 0;                   // for which `in` is written
    std::size_t firstBlock = 0;
    std::size_t wrung = 0;
  };
  /// How a span is wrung; limbs that are alike share one.
  struct Wrung {
    const WrungOrgan* tube = nullptr;  // none of a cord
    KernelBuffer<float> solved;        // of HollowMix, one after the other
    KernelBuffer<float> places;
    KernelBuffer<float> cells;
    int waves = kMinDrawnWaves;
  };
  void layStill(std::span<const std::size_t> vertices);
  void layMobile(std::span<const std::size_t> vertices);
  void laySpan(std::vector<Entry> entries, Span& span);
  void putSpanVertex(const Entry& entry, int firstRow, float* lane) const;
  void putWaves(Span& span, int waves) noexcept;
  void layWrung(int span);
  void mixPlaces(const OrganState& state, Wrung& wrung) const noexcept;
  void windPlaces(double angle_rad, Wrung& wrung) const noexcept;
  void moveSpan(Span& span) noexcept;
  void moveMobile(double angle_rad) noexcept;
  [[nodiscard]] std::size_t streams() const noexcept;

  std::shared_ptr<const Scene> scene_;
  Isa isa_;
  Vec3 first_;  // across the organ's line, with second_ a right-handed frame
  Vec3 second_;
  std::size_t blocks_ = 0;
  std::size_t bytes_ = 0;
  std::size_t stillBlocks_ = 0;
  KernelBuffer<float> mobile_;  // against the point of the organ's line
  int mobileBlocks_ = 0;
  std::vector<Span> spans_;
  std::vector<Wrung> wrung_;
  std::vector<std::uint32_t> slots_;  // of each mesh vertex: its x in out_
  KernelBuffer<float> out_;
};

}  // namespace torsio
