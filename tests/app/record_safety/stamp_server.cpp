// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/record_safety/stamp_server.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "sim/core/file_io.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

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

StampServer::StampServer(const fs::path& folder)
    : folder_(folder / "authority"), server_([this](testing::RawServer::Guest& guest) { talk(guest); }) {
  makeAuthority(folder_ / "good");
  makeAuthority(folder_ / "other");
}

void StampServer::talk(testing::RawServer::Guest& guest) {
  const std::string heard = guest.hear("\r\n\r\n");
  const std::size_t length = heard.find("Content-Length: ");
  if (length == std::string::npos) {
    return;
  }
  const std::string query = guest.hear(static_cast<std::size_t>(std::atol(heard.c_str() + length + 16)));
  const Fault fault = fault_;
  const auto head = [](const std::string& status, std::size_t size, const std::string& more = "") {
    return "HTTP/1.1 " + status + "\r\nContent-Type: application/timestamp-reply\r\n" + more +
           "Content-Length: " + std::to_string(size) + "\r\nConnection: close\r\n\r\n";
  };
  if (heard.find("Content-Type: application/timestamp-query\r\n") == std::string::npos) {
    guest.say(head("415 Unsupported Media Type", 0));
    return;
  }
  switch (fault) {
    case Fault::kBroken:
      guest.say(head("500 Internal Server Error", 4) + "no\x1b[");
      return;
    case Fault::kRedirects:
      guest.say(head("302 Found", 0, "Location: http://127.0.0.2/elsewhere\r\n"));
      return;
    case Fault::kPage:
      guest.say(head("200 OK", 28) + "<html>please sign in\x1b[2J</");
      guest.say("ab");
      return;
    case Fault::kEmpty:
      guest.say(head("200 OK", 0));
      return;
    case Fault::kHangsUp:
      return;
    case Fault::kEndless:
      if (guest.say("HTTP/1.1 200 OK\r\nContent-Type: application/timestamp-reply\r\n\r\n")) {
        while (guest.say(std::string(kMegabyte, '\0'))) {
        }
      }
      return;
    case Fault::kEndlessHead:
      if (guest.say("HTTP/1.1 200 OK\r\nX: ")) {
        while (guest.say(std::string(kMegabyte, 'x'))) {
        }
      }
      return;
    default:
      break;
  }
  const std::string reply = replyTo(query, fault);
  const std::string answer = head("200 OK", reply.size()) + reply;
  if (fault == Fault::kHalf) {
    guest.say(answer.substr(0, answer.size() - reply.size() / 2));
  } else if (fault == Fault::kSlow) {
    guest.trickle(answer, std::chrono::milliseconds(100));
  } else {
    guest.say(answer);
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
