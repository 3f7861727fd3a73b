// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/record_safety/stamp_server.h"

#include <arpa/inet.h>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <netinet/in.h>
#include <poll.h>
#include <stdexcept>
#include <sys/socket.h>
#include <unistd.h>

#include "sim/core/file_io.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr int kLook_ms = 50;
constexpr std::size_t kMegabyte = 1'048'576;

void shell(const std::string& command) {
  if (std::system((command + " >/dev/null 2>&1").c_str()) != 0) {
    throw std::runtime_error("failed: " + command);
  }
}

void makeAuthority(const fs::path& folder) {
  fs::create_directories(folder);
  std::ofstream(folder / "tsa.ext") << "extendedKeyUsage = critical,timeStamping\n";
  std::ofstream(folder / "tsa.cnf")
      << "[tsa]\ndefault_tsa = one\n[one]\nserial = " << (folder / "serial").string()
      << "\nsigner_cert = " << (folder / "tsa.pem").string()
      << "\nsigner_key = " << (folder / "tsa.key").string() << "\ncerts = " << (folder / "ca.pem").string()
      << "\ndefault_policy = 1.2.3.4.1\ndigests = sha256\nsigner_digest = sha256\n"
         "accuracy = secs:1\nordering = no\ntsa_name = no\ness_cert_id_chain = no\n";
  std::ofstream(folder / "serial") << "01\n";
  const std::string go = "cd " + folder.string() + " && openssl ";
  shell(go + "req -x509 -newkey rsa:2048 -nodes -days 2 -subj '/CN=Stamps root' -keyout ca.key -out ca.pem");
  shell(go + "req -newkey rsa:2048 -nodes -subj '/CN=Stamps of the test' -keyout tsa.key -out tsa.csr");
  shell(
      go +
      "x509 -req -days 2 -in tsa.csr -CA ca.pem -CAkey ca.key -CAcreateserial -extfile tsa.ext -out tsa.pem");
}

}  // namespace

StampServer::StampServer(const fs::path& folder) : folder_(folder / "authority") {
  makeAuthority(folder_ / "good");
  makeAuthority(folder_ / "other");
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(place);
  if (::bind(listener_, reinterpret_cast<sockaddr*>(&place), size) != 0 || ::listen(listener_, 8) != 0 ||
      ::getsockname(listener_, reinterpret_cast<sockaddr*>(&place), &size) != 0) {
    throw std::runtime_error("no port for the time stamp authority");
  }
  port_ = ntohs(place.sin_port);
  thread_ = std::thread([this] { serve(); });
}

StampServer::~StampServer() {
  stop_ = true;
  thread_.join();
  ::close(listener_);
}

void StampServer::serve() {
  while (!stop_) {
    pollfd door{listener_, POLLIN, 0};
    if (::poll(&door, 1, kLook_ms) > 0) {
      const int socket = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
      talk(socket);
      ::close(socket);
    }
  }
}

bool StampServer::send(int socket, const std::string& bytes) {
  std::size_t done = 0;
  while (done < bytes.size() && !stop_) {
    pollfd line{socket, POLLOUT, 0};
    if (::poll(&line, 1, kLook_ms) <= 0) {
      continue;
    }
    const ssize_t count =
        ::send(socket, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count <= 0) {
      return false;
    }
    done += static_cast<std::size_t>(count);
    sent_ += count;
  }
  return !stop_;
}

void StampServer::talk(int socket) {
  std::string heard;
  std::size_t wanted = 0;
  while (!stop_ && (wanted == 0 || heard.size() < wanted)) {
    pollfd line{socket, POLLIN, 0};
    if (::poll(&line, 1, kLook_ms) <= 0) {
      continue;
    }
    char part[4096];
    const ssize_t count = ::recv(socket, part, sizeof(part), 0);
    if (count <= 0) {
      return;
    }
    heard.append(part, static_cast<std::size_t>(count));
    const std::size_t end = heard.find("\r\n\r\n");
    const std::size_t length = heard.find("Content-Length: ");
    if (end != std::string::npos && length != std::string::npos) {
      wanted = end + 4 + static_cast<std::size_t>(std::atol(heard.c_str() + length + 16));
    }
  }
  const Fault fault = fault_;
  const auto head = [](const std::string& status, std::size_t size, const std::string& more = "") {
    return "HTTP/1.1 " + status + "\r\nContent-Type: application/timestamp-reply\r\n" + more +
           "Content-Length: " + std::to_string(size) + "\r\nConnection: close\r\n\r\n";
  };
  if (heard.find("Content-Type: application/timestamp-query\r\n") == std::string::npos) {
    send(socket, head("415 Unsupported Media Type", 0));
    return;
  }
  const std::string query = heard.substr(heard.find("\r\n\r\n") + 4);
  switch (fault) {
    case Fault::kBroken:
      send(socket, head("500 Internal Server Error", 4) + "no\x1b[");
      return;
    case Fault::kRedirects:
      send(socket, head("302 Found", 0, "Location: http://127.0.0.2/elsewhere\r\n"));
      return;
    case Fault::kPage:
      send(socket, head("200 OK", 28) + "<html>please sign in\x1b[2J</");
      send(socket, "ab");
      return;
    case Fault::kEmpty:
      send(socket, head("200 OK", 0));
      return;
    case Fault::kHangsUp:
      return;
    case Fault::kEndless:
      if (send(socket, "HTTP/1.1 200 OK\r\nContent-Type: application/timestamp-reply\r\n\r\n")) {
        while (send(socket, std::string(kMegabyte, '\0'))) {
        }
      }
      return;
    case Fault::kEndlessHead:
      if (send(socket, "HTTP/1.1 200 OK\r\nX: ")) {
        while (send(socket, std::string(kMegabyte, 'x'))) {
        }
      }
      return;
    default:
      break;
  }
  const std::string reply = replyTo(query, fault);
  const std::string answer = head("200 OK", reply.size()) + reply;
  if (fault == Fault::kHalf) {
    send(socket, answer.substr(0, answer.size() - reply.size() / 2));
  } else if (fault == Fault::kSlow) {
    for (std::size_t i = 0; i < answer.size() && send(socket, answer.substr(i, 1)); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  } else {
    send(socket, answer);
  }
}

std::string StampServer::replyTo(const std::string& query, Fault fault) {
  if (fault == Fault::kOldAnswer && !first_.empty()) {
    return first_;
  }
  std::ofstream(folder_ / "query.tsq", std::ios::binary) << query;
  const std::string go = "cd " + folder_.string() + " && openssl ts ";
  if (fault == Fault::kOtherText) {
    shell("echo other > " + (folder_ / "other.txt").string());
    shell(go + "-query -data other.txt -sha256 -cert -no_nonce -out query.tsq");
  }
  if (fault == Fault::kRefuses) {  // a digest that it does not accept
    shell("echo other > " + (folder_ / "other.txt").string());
    shell(go + "-query -data other.txt -sha512 -cert -out query.tsq");
  }
  const char* name = fault == Fault::kOtherAuthority ? "other" : "good";
  shell(go + "-reply -config " + name + "/tsa.cnf -queryfile query.tsq -out reply.tsr");
  const std::string reply = readFile(folder_ / "reply.tsr");
  if (first_.empty()) {
    first_ = reply;
  }
  return reply;
}

}  // namespace torsio
