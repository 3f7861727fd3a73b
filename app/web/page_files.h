// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "app/web/http_message.h"

namespace torsio::web {

/// The pages of assets/web and the shader of the tissue that they share with the window, in memory: nothing
/// on the disk is reached by an address that a browser sends.
class PageFiles {
 public:
  /// Reads them out of the folder of the program's assets. Throws Error{kFileMissing, kFileUnreadable}.
  explicit PageFiles(const std::filesystem::path& assets);
  /// Returns the answer to a request for a page; nothing for an address that is none. "/" and "/join" are the
  /// page itself.
  [[nodiscard]] std::optional<HttpResponse> answer(const HttpRequest& request) const;

 private:
  struct File {
    std::string type{};
    std::string bytes{};
    std::string packed{};  // gzip
    std::string tag{};     // changes with the content
  };
  void add(const std::filesystem::path& path, const std::string& address);

  std::map<std::string, File> files_;  // by address
};

/// Gives the bytes as they are or packed, as the browser takes them.
void putPacked(HttpResponse& response, const HttpRequest& request, const std::string& packed,
               const std::string* plain);

}  // namespace torsio::web
