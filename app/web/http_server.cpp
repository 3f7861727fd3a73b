// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/http_server.h"

#include <algorithm>
#include <arpa/inet.h>
#include <atomic>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstring>
#include <map>
#include <microhttpd.h>
#include <mutex>
#include <netinet/in.h>
#include <optional>
#include <set>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include "sim/core/error.h"

namespace torsio::web {

/// A pending reply, which may come after its connection has closed.
struct Pending {
  std::mutex mutex;
  MHD_Connection* connection = nullptr;  // null: not suspended
  bool gone = false;
  std::optional<HttpResponse> response;

  /// Only the first reply counts.
  void answer(HttpResponse given) {
    const std::lock_guard lock(mutex);
    if (response || gone) {
      return;
    }
    response = std::move(given);
    if (connection != nullptr) {
      MHD_resume_connection(connection);
    }
  }
  /// Marks the connection as waiting.
  void suspended(MHD_Connection* waiting) {
    const std::lock_guard lock(mutex);
    connection = waiting;
    if (response) {
      MHD_resume_connection(connection);
    }
  }
};

/// A request while it is received and answered.
struct Exchange {
  HttpRequest request;
  int refusal = 0;  // HTTP status; 0: not refused
  bool handed = false;
  std::shared_ptr<Pending> pending = std::make_shared<Pending>();
};

namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr unsigned kNetworkThreads = 2;
constexpr unsigned kBacklog = 512;
constexpr const char* kTlsPriorities = "NORMAL:-VERS-TLS1.0:-VERS-TLS1.1";

std::string lowered(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
  return lower;
}

/// Returns the socket address of a numeric `address`; empty otherwise.
std::optional<sockaddr_storage> socketAddressOf(const HttpAddress& address) {
  sockaddr_storage storage{};
  auto* v4 = reinterpret_cast<sockaddr_in*>(&storage);
  auto* v6 = reinterpret_cast<sockaddr_in6*>(&storage);
  if (inet_pton(AF_INET, address.host.c_str(), &v4->sin_addr) == 1) {
    v4->sin_family = AF_INET;
    v4->sin_port = htons(address.port);
    return storage;
  }
  storage = {};
  if (inet_pton(AF_INET6, address.host.c_str(), &v6->sin6_addr) == 1) {
    v6->sin6_family = AF_INET6;
    v6->sin6_port = htons(address.port);
    return storage;
  }
  return std::nullopt;
}

std::string peerOf(const sockaddr* peer) {
  char text[INET6_ADDRSTRLEN] = {};
  if (peer == nullptr) {
    return {};
  }
  const void* where = peer->sa_family == AF_INET6
                          ? static_cast<const void*>(&reinterpret_cast<const sockaddr_in6*>(peer)->sin6_addr)
                          : static_cast<const void*>(&reinterpret_cast<const sockaddr_in*>(peer)->sin_addr);
  return inet_ntop(peer->sa_family, where, text, sizeof text) != nullptr ? text : std::string();
}

struct HeaderCount {
  std::map<std::string, std::string>& headers;
  int lengths = 0;
  int encodings = 0;
  int hosts = 0;
};

MHD_Result takeHeader(void* into, MHD_ValueKind /*kind*/, const char* name, const char* value) {
  auto& count = *static_cast<HeaderCount*>(into);
  const std::string key = lowered(name);
  count.lengths += key == "content-length" ? 1 : 0;
  count.encodings += key == "transfer-encoding" ? 1 : 0;
  count.hosts += key == "host" ? 1 : 0;
  count.headers[key] = value != nullptr ? value : "";
  return MHD_YES;
}

/// True for conflicting body lengths, with which requests are smuggled past a proxy.
bool contradicts(const HeaderCount& count) {
  return count.lengths > 1 || count.encodings > 1 || (count.lengths > 0 && count.encodings > 0) ||
         count.hosts > 1;
}

MHD_Result queue(MHD_Connection* connection, const HttpResponse& answer) {
  MHD_Response* response = MHD_create_response_from_buffer(
      answer.body.size(), const_cast<char*>(answer.body.data()), MHD_RESPMEM_MUST_COPY);
  if (response == nullptr) {
    return MHD_NO;
  }
  MHD_add_response_header(response, "Content-Type", answer.type.c_str());
  for (const auto& [name, value] : answer.headers) {
    MHD_add_response_header(response, name.c_str(), value.c_str());
  }
  const MHD_Result queued = MHD_queue_response(connection, static_cast<unsigned>(answer.status), response);
  MHD_destroy_response(response);
  return queued;
}

}  // namespace

std::string HttpRequest::header(const std::string& name) const {
  const auto found = headers.find(name);
  return found == headers.end() ? std::string() : found->second;
}

std::string HttpRequest::cookie(const std::string& name) const {
  std::string_view rest = headers.count("cookie") != 0 ? std::string_view(headers.at("cookie")) : "";
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(';'), rest.size());
    std::string_view one = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    while (!one.empty() && one.front() == ' ') {
      one.remove_prefix(1);
    }
    if (one.size() > name.size() && one.substr(0, name.size()) == name && one[name.size()] == '=') {
      return std::string(one.substr(name.size() + 1));
    }
  }
  return {};
}

bool HttpAddress::isLoopback() const {
  return host == "::1" || host.rfind("127.", 0) == 0;
}

HttpAddress addressOf(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  HttpAddress address;
  unsigned port = 0;
  bool good = colon != std::string::npos && colon + 1 < text.size();
  if (good) {
    const auto [end, fault] = std::from_chars(text.data() + colon + 1, text.data() + text.size(), port);
    good = fault == std::errc{} && end == text.data() + text.size() && port <= 65'535;
    address.host = text.substr(0, colon);
    if (address.host.size() > 2 && address.host.front() == '[' && address.host.back() == ']') {
      address.host = address.host.substr(1, address.host.size() - 2);
    }
    address.port = static_cast<std::uint16_t>(port);
  }
  if (!good || !socketAddressOf(address)) {
    throw Error(ErrorCode::kUsage, Text::verbatim("this is not an address to listen at"), text,
                Text::verbatim("Give an address and a port, for example 127.0.0.1:8443 or [::1]:8443"));
  }
  return address;
}

/// The libmicrohttpd daemon and its connections.
struct HttpServer::Daemon {
  HttpLimits limits;
  Handler handler;
  bool encrypted = false;
  MHD_Daemon* daemon = nullptr;
  std::uint16_t port = 0;

  /// When a connection began to wait for a complete request; empty while one is answered.
  struct Waiting {
    MHD_socket socket{};
    std::optional<SteadyClock::time_point> since;
  };
  std::mutex mutex;
  std::map<MHD_Connection*, Waiting> connected;
  std::set<std::shared_ptr<Pending>> unanswered;
  std::condition_variable ending;
  bool ended = false;
  std::thread reaper;

  MHD_Result access(MHD_Connection* connection, const char* url, const char* method, const char* data,
                    std::size_t* size, void** context);
  void begin(MHD_Connection* connection, const char* url, const char* method, Exchange& exchange);
  MHD_Result hand(MHD_Connection* connection, Exchange& exchange);
  void mark(MHD_Connection* connection, bool waits);
  void complete(MHD_Connection* connection, const Exchange* exchange);
  void drain();
  void cancelWaiting();
  void notice(MHD_Connection* connection, bool opened);
  void reap();
};

void HttpServer::Daemon::begin(MHD_Connection* connection, const char* url, const char* method,
                               Exchange& exchange) {
  exchange.request.method = method;
  exchange.request.path = url;
  exchange.request.encrypted = encrypted;
  const MHD_ConnectionInfo* info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CLIENT_ADDRESS);
  exchange.request.address = info != nullptr ? peerOf(info->client_addr) : std::string();
  HeaderCount count{exchange.request.headers};
  MHD_get_connection_values(connection, MHD_HEADER_KIND, &takeHeader, &count);
  if (contradicts(count)) {
    exchange.refusal = 400;
    return;
  }
  const std::string length = exchange.request.header("content-length");
  std::size_t bytes = 0;
  const auto [end, fault] = std::from_chars(length.data(), length.data() + length.size(), bytes);
  if (!length.empty() && (fault != std::errc{} || end != length.data() + length.size())) {
    exchange.refusal = 400;
  } else if (bytes > limits.body_bytes) {
    exchange.refusal = 413;
  }
}

MHD_Result HttpServer::Daemon::hand(MHD_Connection* connection, Exchange& exchange) {
  exchange.handed = true;
  mark(connection, false);
  const std::shared_ptr<Pending> pending = exchange.pending;
  {
    const std::lock_guard lock(mutex);
    if (ended) {
      return queue(connection, {.status = 503, .headers = {{"Connection", "close"}, {"Retry-After", "2"}}});
    }
    unanswered.insert(pending);
  }
  MHD_suspend_connection(connection);
  pending->suspended(connection);
  handler(std::move(exchange.request),
          [pending](HttpResponse response) { pending->answer(std::move(response)); });
  return MHD_YES;
}

MHD_Result HttpServer::Daemon::access(MHD_Connection* connection, const char* url, const char* method,
                                      const char* data, std::size_t* size, void** context) {
  if (*context == nullptr) {
    auto exchange = std::make_unique<Exchange>();
    begin(connection, url, method, *exchange);
    const int refusal = exchange->refusal;
    *context = exchange.release();
    return refusal == 0 ? MHD_YES
                        : queue(connection, {.status = refusal, .headers = {{"Connection", "close"}}});
  }
  Exchange& exchange = *static_cast<Exchange*>(*context);
  if (*size != 0) {
    if (exchange.request.body.size() + *size > limits.body_bytes) {
      return MHD_NO;  // a peer that keeps sending ignores the refusal
    }
    exchange.request.body.append(data, *size);
    *size = 0;
    return MHD_YES;
  }
  if (!exchange.handed) {
    return hand(connection, exchange);
  }
  const std::lock_guard lock(exchange.pending->mutex);
  return exchange.pending->response ? queue(connection, *exchange.pending->response) : MHD_YES;
}

void HttpServer::Daemon::mark(MHD_Connection* connection, bool waits) {
  const std::lock_guard lock(mutex);
  const auto found = connected.find(connection);
  if (found != connected.end()) {
    found->second.since = waits ? std::optional(SteadyClock::now()) : std::nullopt;
  }
}

void HttpServer::Daemon::complete(MHD_Connection* connection, const Exchange* exchange) {
  if (exchange != nullptr) {
    {
      const std::lock_guard lock(exchange->pending->mutex);
      exchange->pending->connection = nullptr;
      exchange->pending->gone = true;
    }
    const std::lock_guard lock(mutex);
    unanswered.erase(exchange->pending);
    ending.notify_all();
  }
  mark(connection, true);
}

/// Waits until what was received is answered.
void HttpServer::Daemon::drain() {
  std::unique_lock lock(mutex);
  ending.wait_for(lock, std::chrono::seconds(limits.drain_s), [this] { return unanswered.empty(); });
}

/// Replies to suspended connections: the library cannot stop while there are any.
void HttpServer::Daemon::cancelWaiting() {
  std::set<std::shared_ptr<Pending>> left;
  {
    const std::lock_guard lock(mutex);
    left = unanswered;
  }
  for (const std::shared_ptr<Pending>& pending : left) {
    pending->answer({.status = 503});
  }
}

void HttpServer::Daemon::notice(MHD_Connection* connection, bool opened) {
  const std::lock_guard lock(mutex);
  if (!opened) {
    connected.erase(connection);
    return;
  }
  const MHD_ConnectionInfo* info = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD);
  if (info != nullptr) {
    connected[connection] = {info->connect_fd, SteadyClock::now()};
  }
}

/// The library's idle timeout resets on every byte, so we also enforce a deadline for the whole request
/// (slowloris).
void HttpServer::Daemon::reap() {
  std::unique_lock lock(mutex);
  const auto longest = std::chrono::seconds(limits.request_s);
  while (!ending.wait_for(lock, std::chrono::seconds(1), [this] { return ended; })) {
    for (const auto& [connection, waiting] : connected) {
      if (waiting.since && SteadyClock::now() - *waiting.since > longest) {
        ::shutdown(waiting.socket, SHUT_RDWR);
      }
    }
  }
}

HttpServer::HttpServer(const HttpAddress& address, const TlsMaterial& tls, const HttpLimits& limits,
                       Handler handler)
    : daemon_(std::make_unique<Daemon>()) {
  daemon_->limits = limits;
  daemon_->handler = std::move(handler);
  daemon_->encrypted = !tls.certificate.empty();
  const auto socketAddress = socketAddressOf(address);
  unsigned flags = MHD_USE_EPOLL_INTERNAL_THREAD | MHD_ALLOW_SUSPEND_RESUME | MHD_USE_ITC;
  if (address.host.find(':') != std::string::npos) {
    flags |= MHD_USE_IPv6;
  }
  if (daemon_->encrypted) {
    flags |= MHD_USE_TLS;
  }
  std::vector<MHD_OptionItem> options;
  if (daemon_->encrypted) {
    options.push_back({MHD_OPTION_HTTPS_MEM_KEY, 0, const_cast<char*>(tls.key.c_str())});
    options.push_back({MHD_OPTION_HTTPS_MEM_CERT, 0, const_cast<char*>(tls.certificate.c_str())});
    options.push_back({MHD_OPTION_HTTPS_PRIORITIES, 0, const_cast<char*>(kTlsPriorities)});
  }
  // An encoded NUL would truncate the address: replace it by a character that no address contains.
  const auto unescaped = [](void* /*self*/, MHD_Connection* /*connection*/, char* text) {
    for (char* at = std::strstr(text, "%00"); at != nullptr; at = std::strstr(at, "%00")) {
      at[2] = '1';
    }
    return MHD_http_unescape(text);
  };
  using Unescape = std::size_t (*)(void*, MHD_Connection*, char*);
  options.push_back({MHD_OPTION_UNESCAPE_CALLBACK,
                     reinterpret_cast<std::intptr_t>(static_cast<Unescape>(unescaped)), nullptr});
  options.push_back({MHD_OPTION_END, 0, nullptr});
  const auto access = [](void* self, MHD_Connection* connection, const char* url, const char* method,
                         const char* /*version*/, const char* data, std::size_t* size, void** context) {
    return static_cast<Daemon*>(self)->access(connection, url, method, data, size, context);
  };
  const auto completed = [](void* self, MHD_Connection* connection, void** context,
                            MHD_RequestTerminationCode /*how*/) {
    const std::unique_ptr<Exchange> exchange(static_cast<Exchange*>(*context));
    *context = nullptr;
    static_cast<Daemon*>(self)->complete(connection, exchange.get());
  };
  const auto noticed = [](void* self, MHD_Connection* connection, void** /*socket*/,
                          MHD_ConnectionNotificationCode how) {
    static_cast<Daemon*>(self)->notice(connection, how == MHD_CONNECTION_NOTIFY_STARTED);
  };
  if (socketAddress) {
    daemon_->daemon = MHD_start_daemon(
        flags, address.port, nullptr, nullptr, static_cast<MHD_AccessHandlerCallback>(access), daemon_.get(),
        MHD_OPTION_SOCK_ADDR, &*socketAddress, MHD_OPTION_THREAD_POOL_SIZE, kNetworkThreads,
        MHD_OPTION_CONNECTION_LIMIT, limits.connections, MHD_OPTION_PER_IP_CONNECTION_LIMIT,
        limits.connectionsAnAddress, MHD_OPTION_CONNECTION_TIMEOUT, limits.silent_s,
        MHD_OPTION_CONNECTION_MEMORY_LIMIT, limits.headers_bytes, MHD_OPTION_LISTEN_BACKLOG_SIZE, kBacklog,
        MHD_OPTION_STRICT_FOR_CLIENT, 1, MHD_OPTION_NOTIFY_COMPLETED,
        static_cast<MHD_RequestCompletedCallback>(completed), daemon_.get(), MHD_OPTION_NOTIFY_CONNECTION,
        static_cast<MHD_NotifyConnectionCallback>(noticed), daemon_.get(), MHD_OPTION_ARRAY, options.data(),
        MHD_OPTION_END);
  }
  if (daemon_->daemon == nullptr) {
    const std::string where = address.host + ":" + std::to_string(address.port);
    throw daemon_->encrypted
        ? Error(ErrorCode::kBadParameter,
                Text::verbatim("the server does not start: address, certificate or key cannot be used"),
                where,
                Text::verbatim("Look whether another program listens there, and whether key and certificate "
                               "belong together"))
        : Error(ErrorCode::kUsage, Text::verbatim("nothing can listen at this address"), where,
                Text::verbatim("Choose another port, or end the program that listens there"));
  }
  const MHD_DaemonInfo* info = MHD_get_daemon_info(daemon_->daemon, MHD_DAEMON_INFO_BIND_PORT);
  daemon_->port = info != nullptr ? info->port : address.port;
  daemon_->reaper = std::thread([daemon = daemon_.get()] { daemon->reap(); });
}

HttpServer::~HttpServer() {
  {
    const std::lock_guard lock(daemon_->mutex);
    daemon_->ended = true;
  }
  daemon_->ending.notify_all();
  daemon_->reaper.join();
  const MHD_socket listening = MHD_quiesce_daemon(daemon_->daemon);
  daemon_->drain();
  daemon_->cancelWaiting();
  MHD_stop_daemon(daemon_->daemon);
  if (listening != MHD_INVALID_SOCKET) {
    ::close(listening);
  }
}

std::uint16_t HttpServer::port() const noexcept {
  return daemon_->port;
}

}  // namespace torsio::web
