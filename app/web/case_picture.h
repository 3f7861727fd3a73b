// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/services/review/blinded_case.h"
#include "app/web/organ_shelf.h"

namespace torsio::web {

/// What a page needs to show a recording, as BinaryContainer (docs/server.md describes the arrays), gzipped.
struct CasePicture {
  std::string recording{};                    ///< traces and instrument, 60 a second
  std::string organ{};                        ///< how the organ lay; empty: it is not on this machine
  std::shared_ptr<const std::string> body{};  ///< what they stand on (organ_body.h), on the shelf meanwhile
  float farthest_mm = 0.0F;                   ///< by which a vertex lies off in any shape that was kept
};

/// Largest distance of a drawn vertex from where the window would draw it, mm.
inline constexpr float kWithin_mm = 0.15F;

/// The same for every rater of a recording. Decodes, rebuilds the scene and follows it through the recording:
/// a second of processor time, some more for long ones. Takes what it needs out of `recording`. No byte of it
/// tells whose recording it is. Its organ's skin and body are put on the shelf. Throws as
/// loadBlindedRecording.
[[nodiscard]] CasePicture casePicture(BlindedRecording recording, const std::filesystem::path& assets,
                                      OrganShelf& shelf);

}  // namespace torsio::web
