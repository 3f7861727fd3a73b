// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

namespace torsio {

/// Unique names in file order, found in constant time.
class NamePlaces {
 public:
  /// Returns the place of a name, adding it if new.
  std::size_t operator()(const std::string& name) {
    const auto [at, isNew] = places_.emplace(name, names_.size());
    if (isNew) {
      names_.push_back(name);
    }
    return at->second;
  }
  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }

 private:
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::size_t> places_;
};

}  // namespace torsio
