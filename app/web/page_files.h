// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "app/web/http_server.h"

namespace torsio::web {

/// The pages of assets/web and the tissue shader shared with the window, in memory: a browser's request never
/// reaches the disk.
class PageFiles {
 public:
  /// Reads the files from the assets folder. Throws Error{kFileMissing, kFileUnreadable}.
  explicit PageFiles(const std::filesystem::path& assets);
  /// Returns the answer to a page request; empty for an unknown address. "/" and "/join" are the main page.
  [[nodiscard]] std::optional<HttpResponse> answer(const HttpRequest& request) const;
  /// The English sentences of the pages: the literals of t() in their scripts.
  [[nodiscard]] const std::set<std::string>& sentences() const noexcept { return sentences_; }

 private:
  struct File {
    std::string type{};
    std::string bytes{};
    std::string packed{};  // gzip
    std::string tag{};     // changes with the content
  };
  void add(const std::filesystem::path& path, const std::string& address);

  std::map<std::string, File> files_;  // by address
  std::set<std::string> sentences_;
};

/// Puts the bytes into the response, plain or gzipped, as the browser accepts.
void putPacked(HttpResponse& response, const HttpRequest& request, const std::string& packed,
               const std::string* plain);

}  // namespace torsio::web
