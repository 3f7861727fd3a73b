// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/web/web_client.h"

#include <algorithm>
#include <arpa/inet.h>
#include <cctype>
#include <cstddef>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>
#include <zlib.h>

namespace torsio {

std::string unpackedGzip(const std::string& bytes) {
  constexpr std::size_t kPiece = 65'536;
  z_stream stream{};
  inflateInit2(&stream, 15 + 16);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string out;
  std::string piece(kPiece, '\0');
  int result = Z_OK;
  while (result == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    result = inflate(&stream, Z_NO_FLUSH);
    out.append(piece, 0, piece.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  return out;
}

namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

DeskAnswer parsed(const std::string& bytes) {
  DeskAnswer answer;
  const std::size_t end = bytes.find("\r\n\r\n");
  if (end == std::string::npos || bytes.rfind("HTTP/1.1 ", 0) != 0) {
    return answer;
  }
  answer.status = std::stoi(bytes.substr(9, 3));
  std::size_t at = bytes.find("\r\n") + 2;
  while (at < end) {
    const std::size_t next = bytes.find("\r\n", at);
    const std::string line = bytes.substr(at, next - at);
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) {
      const std::string name = lower(line.substr(0, colon));
      answer.headers.emplace(name, line.substr(colon + 2));
      if (name == "set-cookie") {
        answer.cookies.push_back(line.substr(colon + 2, line.find(';', colon) - colon - 2));
      }
    }
    at = next + 2;
  }
  answer.body = bytes.substr(end + 4);
  if (answer.headers.count("content-encoding") != 0) {
    answer.body = unpackedGzip(answer.body);
  }
  return answer;
}

}  // namespace

DeskAnswer WebClient::raw(const std::string& bytes) const {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(port_);
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const timeval patience{patience_ms / 1000, (patience_ms % 1000) * 1000};
  ::setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  std::string received;
  if (::connect(socket, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0) {
    std::size_t sent = 0;
    while (sent < bytes.size()) {
      const ssize_t some = ::send(socket, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (some <= 0) {
        break;
      }
      sent += static_cast<std::size_t>(some);
    }
    char piece[16'384];
    for (ssize_t some = 0; (some = ::recv(socket, piece, sizeof piece, 0)) > 0;) {
      received.append(piece, static_cast<std::size_t>(some));
    }
  }
  ::close(socket);
  return parsed(received);
}

DeskAnswer WebClient::exchange(const std::string& head, const std::string& body) {
  std::string bytes = head + "Host: 127.0.0.1:" + std::to_string(port_) +
                      "\r\nConnection: close\r\nAccept-Encoding: gzip\r\n";
  if (!cookie.empty()) {
    bytes += "Cookie: " + cookie + "\r\n";
  }
  for (const auto& [name, value] : headers) {
    bytes.append(name).append(": ").append(value).append("\r\n");
  }
  DeskAnswer answer = raw(bytes + "\r\n" + body);
  for (const std::string& one : answer.cookies) {
    const std::string name = one.substr(0, one.find('=') + 1);
    const std::size_t old = cookie.find(name);
    if (old != std::string::npos) {
      cookie.erase(old, cookie.find("; ", old) == std::string::npos ? std::string::npos
                                                                    : cookie.find("; ", old) + 2 - old);
    }
    cookie += (cookie.empty() || cookie.ends_with("; ") ? "" : "; ") + one;
  }
  return answer;
}

DeskAnswer WebClient::get(const std::string& path) {
  return exchange("GET " + path + " HTTP/1.1\r\n", "");
}

DeskAnswer WebClient::send(const std::string& method, const std::string& path, const nlohmann::json& body) {
  const std::string text = body.dump();
  return exchange(
      method + " " + path +
          " HTTP/1.1\r\nContent-Type: application/json\r\nOrigin: http://127.0.0.1:" + std::to_string(port_) +
          "\r\nX-Torsio-Token: " + token + "\r\nContent-Length: " + std::to_string(text.size()) + "\r\n",
      text);
}

bool WebClient::signIn(const std::string& login, const std::string& password) {
  const DeskAnswer answer = send("POST", "/api/sign-in", {{"login", login}, {"password", password}});
  if (answer.status != 200 || !answer.json().contains("token")) {
    return false;
  }
  token = answer.json()["token"].get<std::string>();
  return true;
}

}  // namespace torsio
