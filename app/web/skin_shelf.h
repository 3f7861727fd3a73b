// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "sim/scene/scene.h"

namespace torsio::web {

/// The painted skin of an organ (sim/scene/skin) for a page: BinaryContainer, gzipped. Its map travels as two
/// pictures (JPEG): the colour, and at half the size the height of the relief. Half a second of a core.
[[nodiscard]] std::string skinPicture(const Scene& scene);

/// Skins of organs that were shown lately, by a name that their bytes give: the same organ has the same one
/// in every case, so that a browser needs it once. Any thread.
class SkinShelf {
 public:
  /// Returns the name of the organ's skin, which is painted when it is not there.
  [[nodiscard]] std::string put(const Scene& scene);
  /// Returns null for a name that is none, or none any more.
  [[nodiscard]] std::shared_ptr<const std::string> find(const std::string& name);

 private:
  struct Kept {
    std::string organ{};  ///< digest of what is painted
    std::string name{};
    std::shared_ptr<const std::string> bytes;
  };
  std::mutex painting_;
  std::mutex mutex_;
  std::list<Kept> kept_;  // newest first
};

}  // namespace torsio::web
