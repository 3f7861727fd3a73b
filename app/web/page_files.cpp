// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/page_files.h"

#include "app/web/binary_container.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

namespace torsio::web {

namespace {

constexpr const char* kIndex = "/index.html";
constexpr std::size_t kTagDigits = 16;
constexpr const char* kTissueShader = "quick_tissue.frag";  // shared with the window

/// Returns the content type; empty for other files of the folder (notes, tests), which are not served.
std::string typeOf(const std::filesystem::path& file) {
  static const std::map<std::string, std::string> kTypes = {{".html", "text/html; charset=utf-8"},
                                                            {".css", "text/css; charset=utf-8"},
                                                            {".js", "text/javascript; charset=utf-8"},
                                                            {".svg", "image/svg+xml"},
                                                            {".frag", "text/plain; charset=utf-8"}};
  const auto found = kTypes.find(file.extension().string());
  return found == kTypes.end() ? std::string() : found->second;
}

}  // namespace

PageFiles::PageFiles(const std::filesystem::path& assets) {
  const std::filesystem::path folder = assets / "web";
  if (!std::filesystem::is_directory(folder)) {
    throw Error(ErrorCode::kFileMissing, Text::verbatim("the pages of the review desk are not installed"),
                folder.string(), Text::verbatim("Install Torsio with its assets"));
  }
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      add(entry.path(), "/" + std::filesystem::relative(entry.path(), folder).generic_string());
    }
  }
  add(assets / "shaders" / kTissueShader, std::string("/") + kTissueShader);
}

void PageFiles::add(const std::filesystem::path& path, const std::string& address) {
  const std::string type = typeOf(path);
  if (type.empty()) {
    return;
  }
  File file{type, readFile(path), {}, {}};
  file.packed = gzipped(file.bytes);
  Digest digest;
  digest.update(std::string_view(file.bytes));
  file.tag = '"' + digest.hex().substr(0, kTagDigits) + '"';
  files_.emplace(address, std::move(file));
}

std::optional<HttpResponse> PageFiles::answer(const HttpRequest& request) const {
  const bool page = request.path == "/" || request.path == "/join";
  const auto found = files_.find(page ? kIndex : request.path);
  if (found == files_.end()) {
    return std::nullopt;
  }
  const File& file = found->second;
  HttpResponse response;
  response.type = file.type;
  response.headers = {{"ETag", file.tag}, {"Cache-Control", "no-cache"}};
  if (request.header("if-none-match") == file.tag) {
    response.status = 304;
    return response;
  }
  putPacked(response, request, file.packed, &file.bytes);
  return response;
}

void putPacked(HttpResponse& response, const HttpRequest& request, const std::string& packed,
               const std::string* plain) {
  response.headers.emplace_back("Vary", "Accept-Encoding");
  if (plain != nullptr && request.header("accept-encoding").find("gzip") == std::string::npos) {
    response.body = *plain;
    return;
  }
  response.headers.emplace_back("Content-Encoding", "gzip");
  response.body = packed;
}

}  // namespace torsio::web
