// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <span>
#include <string>

#include "app/services/review/blinded_case.h"
#include "app/web/binary_container.h"
#include "app/web/organ_shelf.h"
#include "sim/scene/blood_map.h"
#include "sim/scene/organ_state.h"

namespace torsio::web {

/// What a page needs to display a recording: gzipped BinaryContainers (docs/server.md describes the arrays).
struct CasePicture {
  std::string recording{};  ///< traces and instrument, 60 frames per second
  std::string organ{};      ///< movement of the organ; empty: the organ is not on this machine
  std::shared_ptr<const std::string>
      body{};                  ///< the body that `organ` refers to (organ_shelf.h); keeps it on the shelf
  std::int64_t length_us = 0;  ///< of the recording
  float farthest_mm = 0.0F;    ///< largest deviation of a vertex in the shapes kept
};

/// Maximum deviation of a drawn vertex from the window's display, mm.
inline constexpr float kWithin_mm = 0.15F;

/// Makes the picture of a recording, identical for all its raters: decodes it, rebuilds the scene and replays
/// it, in about a second of processor time, longer for long recordings. Consumes parts of `recording`.
/// Blinded: the bytes reveal nothing about the trainee. Puts the organ's skin and body on the shelf. Throws
/// like loadBlindedRecording.
[[nodiscard]] CasePicture casePicture(BlindedRecording recording, const std::filesystem::path& assets,
                                      OrganShelf& shelf);

/// Adds the colours of BloodMap::evaluate() in every frame as layers that a page mixes in the same order:
/// "fed", each vertex's share in the twisted vessels; "blood", their factor in each frame; meta "paints"
/// {factor, from, to} and "paint", one share per vertex each: bruises, tears and clips of frames from .. to -
/// 1. A bruise by the jaw lasts to the end. No effect for an organ without blood.
void addBloodPaint(BinaryContainer& container, const BloodMap& map, std::span<const OrganState> states,
                   std::span<const std::size_t> stateOfFrame);

/// Pictures of recently opened recordings, so that traces, organ, reopening and other raters share one
/// computation. One is made at a time, as it takes a core. Thread-safe.
class PictureCache {
 public:
  explicit PictureCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// Returns the picture of a recording (RecordingName::key), calling `make` if it is not cached. The caller
  /// must have checked the right to see it in the same call.
  [[nodiscard]] std::shared_ptr<const CasePicture> of(const std::string& recording,
                                                      const std::function<CasePicture()>& make);

 private:
  struct Kept {
    std::string recording{};
    std::shared_ptr<const CasePicture> picture;
  };
  [[nodiscard]] std::shared_ptr<const CasePicture> kept(const std::string& recording);

  std::size_t most_bytes_;
  std::mutex making_;
  std::mutex mutex_;
  std::size_t bytes_ = 0;
  std::list<Kept> kept_;  // newest first
};

}  // namespace torsio::web
