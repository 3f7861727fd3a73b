// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/services/review/blinded_case.h"
#include "app/web/organ_shelf.h"

namespace torsio::web {

/// What a page needs to display a recording: gzipped BinaryContainers (docs/server.md describes the arrays).
struct CasePicture {
  std::string recording{};  ///< traces and instrument, 60 frames per second
  std::string organ{};      ///< movement of the organ; empty: the organ is not on this machine
  std::shared_ptr<const std::string>
      body{};                ///< the body that `organ` refers to (organ_body.h); keeps it on the shelf
  float farthest_mm = 0.0F;  ///< largest deviation of a vertex in the shapes kept
};

/// Maximum deviation of a drawn vertex from the window's display, mm.
inline constexpr float kWithin_mm = 0.15F;

/// Makes the picture of a recording, identical for all its raters: decodes it, rebuilds the scene and replays
/// it, in about a second of processor time, longer for long recordings. Consumes parts of `recording`.
/// Blinded: the bytes reveal nothing about the trainee. Puts the organ's skin and body on the shelf. Throws
/// like loadBlindedRecording.
[[nodiscard]] CasePicture casePicture(BlindedRecording recording, const std::filesystem::path& assets,
                                      OrganShelf& shelf);

}  // namespace torsio::web
