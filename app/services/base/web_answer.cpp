// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/base/web_answer.h"

#include <curl/curl.h>
#include <memory>
#include <utility>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

/// An answer as it arrives: headers and body count together.
struct Arriving {
  std::string body{};
  std::size_t left_bytes = 0;

  /// Returns what libcurl takes for an error where there is no room.
  std::size_t take(const char* bytes, std::size_t count, bool isBody) {
    if (count > left_bytes) {
      return 0;
    }
    left_bytes -= count;
    if (isBody) {
      body.append(bytes, count);
    }
    return count;
  }
};

std::size_t takeHeader(const char* bytes, std::size_t size, std::size_t count, void* arriving) {
  return static_cast<Arriving*>(arriving)->take(bytes, size * count, false);
}

std::size_t takeBody(const char* bytes, std::size_t size, std::size_t count, void* arriving) {
  return static_cast<Arriving*>(arriving)->take(bytes, size * count, true);
}

}  // namespace

WebAnswer postedTo(const std::string& address, const std::string& contentType, const std::string& body,
                   std::chrono::milliseconds patience, std::size_t most_bytes) {
  static const CURLcode ready = curl_global_init(CURL_GLOBAL_DEFAULT);
  TORSIO_EXPECTS(ready == CURLE_OK);
  const std::unique_ptr<CURL, decltype(&curl_easy_cleanup)> curl(curl_easy_init(), &curl_easy_cleanup);
  TORSIO_EXPECTS(curl != nullptr);
  const std::unique_ptr<curl_slist, decltype(&curl_slist_free_all)> headers(
      curl_slist_append(nullptr, ("Content-Type: " + contentType).c_str()), &curl_slist_free_all);
  Arriving arriving{.left_bytes = most_bytes};
  const auto set = [&curl](CURLoption option, auto value) { curl_easy_setopt(curl.get(), option, value); };
  set(CURLOPT_URL, address.c_str());
  set(CURLOPT_PROTOCOLS_STR, "http,https");
  set(CURLOPT_NOSIGNAL, 1L);
  set(CURLOPT_TIMEOUT_MS, static_cast<long>(patience.count()));
  set(CURLOPT_HTTPHEADER, headers.get());
  set(CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(body.size()));
  set(CURLOPT_POSTFIELDS, body.data());
  set(CURLOPT_HEADERFUNCTION, &takeHeader);
  set(CURLOPT_HEADERDATA, &arriving);
  set(CURLOPT_WRITEFUNCTION, &takeBody);
  set(CURLOPT_WRITEDATA, &arriving);
  const CURLcode code = curl_easy_perform(curl.get());
  if (code == CURLE_WRITE_ERROR) {
    return {0, "it is too long"};
  }
  if (code != CURLE_OK) {
    return {0, curl_easy_strerror(code)};
  }
  long status = 0;
  curl_easy_getinfo(curl.get(), CURLINFO_RESPONSE_CODE, &status);
  return {static_cast<int>(status), std::move(arriving.body)};
}

}  // namespace torsio
