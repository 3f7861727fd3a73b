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
  bool isTooLong = false;
  const std::atomic<bool>* stop = nullptr;

  /// Returns what libcurl takes for an error where there is no room.
  std::size_t take(const char* bytes, std::size_t count, bool isBody) {
    if (count > left_bytes) {
      isTooLong = true;
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

/// Not zero: libcurl stops.
int isStopped(void* arriving, curl_off_t /*toCome*/, curl_off_t /*came*/, curl_off_t /*toGo*/,
              curl_off_t /*went*/) {
  const std::atomic<bool>* stop = static_cast<Arriving*>(arriving)->stop;
  return stop != nullptr && stop->load() ? 1 : 0;
}

using Headers = std::unique_ptr<curl_slist, decltype(&curl_slist_free_all)>;

Headers headersOf(const WebRequest& request) {
  Headers headers(nullptr, &curl_slist_free_all);
  for (const std::string& header : request.headers) {
    TORSIO_EXPECTS(header.find_first_of("\r\n") == std::string::npos);
    curl_slist* longer = curl_slist_append(headers.get(), header.c_str());
    TORSIO_EXPECTS(longer != nullptr);
    (void)headers.release();
    headers.reset(longer);
  }
  return headers;
}

}  // namespace

WebAnswer askWeb(const WebRequest& request) {
  static const CURLcode ready = curl_global_init(CURL_GLOBAL_DEFAULT);
  TORSIO_EXPECTS(ready == CURLE_OK);
  const std::unique_ptr<CURL, decltype(&curl_easy_cleanup)> curl(curl_easy_init(), &curl_easy_cleanup);
  TORSIO_EXPECTS(curl != nullptr);
  const Headers headers = headersOf(request);
  Arriving arriving{.left_bytes = request.most_bytes, .stop = request.stop};
  const auto set = [&curl](CURLoption option, auto value) { curl_easy_setopt(curl.get(), option, value); };
  set(CURLOPT_URL, request.address.c_str());
  set(CURLOPT_PROTOCOLS_STR, "http,https");
  set(CURLOPT_NOPROXY, "localhost,127.0.0.0/8,::1");
  set(CURLOPT_NOSIGNAL, 1L);
  set(CURLOPT_TIMEOUT_MS, static_cast<long>(request.patience.count()));
  set(CURLOPT_HTTPHEADER, headers.get());
  if (request.body) {
    set(CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(request.body->size()));
    set(CURLOPT_POSTFIELDS, request.body->data());
  }
  set(CURLOPT_HEADERFUNCTION, &takeHeader);
  set(CURLOPT_HEADERDATA, &arriving);
  set(CURLOPT_WRITEFUNCTION, &takeBody);
  set(CURLOPT_WRITEDATA, &arriving);
  set(CURLOPT_NOPROGRESS, 0L);
  set(CURLOPT_XFERINFOFUNCTION, &isStopped);
  set(CURLOPT_XFERINFODATA, &arriving);
  const CURLcode code = curl_easy_perform(curl.get());
  if (arriving.isTooLong || code == CURLE_OUT_OF_MEMORY) {  // the latter: a header longer than libcurl takes
    return {0, "it is too long"};
  }
  if (code != CURLE_OK) {
    return {0, curl_easy_strerror(code)};
  }
  long status = 0;
  curl_easy_getinfo(curl.get(), CURLINFO_RESPONSE_CODE, &status);
  curl_header* wait = nullptr;
  const bool waits = curl_easy_header(curl.get(), "Retry-After", 0, CURLH_HEADER, -1, &wait) == CURLHE_OK;
  return {static_cast<int>(status), std::move(arriving.body), waits ? wait->value : ""};
}

}  // namespace torsio
