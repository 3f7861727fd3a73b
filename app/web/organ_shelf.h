// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "app/web/shapes/shape_basis.h"
#include "sim/scene/scene.h"

namespace torsio::web {

/// Makes the painted skin of an organ (sim/scene/skin) for a page: a gzipped BinaryContainer with two JPEGs,
/// the colour and, at half size, the height of the relief. Half a second of one core.
[[nodiscard]] std::string skinPicture(const Scene& scene);

/// Cache of what all recordings of an organ share: its skin, and its body. Names are content
/// hashes, so that browsers load each once for any number of cases. Evicts old entries. Thread-safe.
class OrganShelf {
 public:
  /// Returns the name of the organ's skin, painting it if needed.
  [[nodiscard]] std::string putSkin(const Scene& scene);
  struct Body {
    std::string name{};
    std::shared_ptr<const std::string> bytes;  ///< keeps the body available while held
  };
  /// Returns the name of these bytes, valid while the body is held.
  [[nodiscard]] Body putBody(std::string bytes);
  /// Returns null for an unknown or expired name.
  [[nodiscard]] std::shared_ptr<const std::string> find(const std::string& name);

 private:
  struct Skin {
    std::string organ{};  ///< digest of the painted scene
    std::string name{};
    std::shared_ptr<const std::string> bytes;
  };
  std::mutex painting_;
  std::mutex mutex_;
  std::list<Skin> skins_;                                           // newest first
  std::map<std::string, std::weak_ptr<const std::string>> bodies_;  // by name
};

/// Makes what pages draw an organ and the instrument from, independent of the recording: a gzipped
/// BinaryContainer (docs/server.md describes the arrays) with surface, colour, and the shapes of `basis`,
/// those of the scene's pattern. Reproducible. Throws Error{kFileMissing}, {kBadMesh} for the instrument's
/// files.
[[nodiscard]] std::string organBody(const Scene& scene, const ShapeBasis& basis,
                                    const std::filesystem::path& assets);

}  // namespace torsio::web
