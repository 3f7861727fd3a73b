// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "sim/scene/scene.h"

namespace torsio::web {

/// The painted skin of an organ (sim/scene/skin) for a page: BinaryContainer, gzipped. Its map travels as two
/// pictures (JPEG): the colour, and at half the size the height of the relief. Half a second of a core.
[[nodiscard]] std::string skinPicture(const Scene& scene);

/// What all recordings of an organ have in common, for pages: its skin, and its body (organ_body.h). By a
/// name that the bytes give, so that a browser needs it once, whatever number of cases show it. Keeps what
/// was asked for lately. Any thread.
class OrganShelf {
 public:
  /// Returns the name of the organ's skin, which is painted when it is not there.
  [[nodiscard]] std::string putSkin(const Scene& scene);
  struct Body {
    std::string name{};
    std::shared_ptr<const std::string> bytes;  ///< whoever holds them can have them asked for
  };
  /// Returns what these bytes are found as while somebody holds them.
  [[nodiscard]] Body putBody(std::string bytes);
  /// Returns null for a name that is none, or none any more.
  [[nodiscard]] std::shared_ptr<const std::string> find(const std::string& name);

 private:
  struct Skin {
    std::string organ{};  ///< digest of what is painted
    std::string name{};
    std::shared_ptr<const std::string> bytes;
  };
  std::mutex painting_;
  std::mutex mutex_;
  std::list<Skin> skins_;                                           // newest first
  std::map<std::string, std::weak_ptr<const std::string>> bodies_;  // by name
};

}  // namespace torsio::web
