// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/review/blinded_case.h"
#include "app/web/skin_shelf.h"

namespace torsio::web {

/// What a page needs to show a recording, as BinaryContainer (docs/server.md describes the arrays), gzipped.
struct CasePicture {
  std::string recording{};   ///< traces and instrument, 60 a second
  std::string organ{};       ///< shapes of the organ, 30 a second; empty: it is not on this machine
  float farthest_mm = 0.0F;  ///< by which a vertex lies off in any shape that was kept
};

/// Largest distance of a drawn vertex from where the window would draw it, mm.
inline constexpr float kWithin_mm = 0.15F;

/// The same for every rater of a recording. Decodes, rebuilds the scene and follows it through the recording:
/// a second of processor time, some more for long ones. Takes what it needs out of `recording`. No byte of it
/// tells whose recording it is. Its organ's skin is put on the shelf. Throws as loadBlindedRecording.
[[nodiscard]] CasePicture casePicture(BlindedRecording recording, const std::filesystem::path& assets,
                                      SkinShelf& skins);

}  // namespace torsio::web
