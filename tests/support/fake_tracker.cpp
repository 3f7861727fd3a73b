// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/fake_tracker.h"

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <igtlClientSocket.h>
#include <igtlServerSocket.h>
#include <igtlStatusMessage.h>
#include <igtlStringMessage.h>
#include <igtlTrackingDataMessage.h>
#include <igtlTransformMessage.h>
#include <thread>

namespace torsio::testing {

namespace {

constexpr int kTrackerPatience_ms = 20'000;

void setTime(igtl::MessageBase& message, std::int64_t sent_us) {
  const auto time = igtl::TimeStamp::New();
  time->SetTime(static_cast<igtlUint32>(sent_us / 1'000'000),
                static_cast<igtlUint32>(sent_us % 1'000'000 * 1'000));
  igtl::TimeStamp::Pointer pointer = time;
  message.SetTimeStamp(pointer);
}

void setPlace(igtl::Matrix4x4& matrix, const Vec3& place_mm) {
  igtl::IdentityMatrix(matrix);
  matrix[0][3] = static_cast<float>(place_mm.x);
  matrix[1][3] = static_cast<float>(place_mm.y);
  matrix[2][3] = static_cast<float>(place_mm.z);
}

}  // namespace

struct FakeTracker::Sockets {
  igtl::ServerSocket::Pointer server = igtl::ServerSocket::New();
  igtl::ClientSocket::Pointer client;

  bool send(igtl::MessageBase& message) {
    message.Pack();
    return client.IsNotNull() && client->Send(message.GetPackPointer(), message.GetPackSize()) == 1;
  }
};

FakeTracker::FakeTracker() : sockets_(std::make_unique<Sockets>()) {
  std::signal(SIGPIPE, SIG_IGN);
  sockets_->server->CreateServer(0);
}

FakeTracker::~FakeTracker() {
  hangUp();
  sockets_->server->CloseSocket();
}

std::uint16_t FakeTracker::port() const {
  return static_cast<std::uint16_t>(sockets_->server->GetServerPort());
}

bool FakeTracker::wait() {
  sockets_->client = sockets_->server->WaitForConnection(kTrackerPatience_ms);
  return sockets_->client.IsNotNull();
}

bool FakeTracker::call(std::uint16_t port) {
  for (int tries = 0; tries < kTrackerPatience_ms / 50; ++tries) {
    sockets_->client = igtl::ClientSocket::New();
    if (sockets_->client->ConnectToServer("127.0.0.1", port) == 0) {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return false;
}

void FakeTracker::hangUp() {
  if (sockets_->client.IsNotNull()) {
    sockets_->client->CloseSocket();
    sockets_->client = nullptr;
  }
}

bool FakeTracker::sendTransform(const std::string& device, const Vec3& place_mm, std::int64_t sent_us) {
  const auto message = igtl::TransformMessage::New();
  igtl::Matrix4x4 matrix;
  setPlace(matrix, place_mm);
  message->SetDeviceName(device.c_str());
  message->SetMatrix(matrix);
  setTime(*message, sent_us);
  return sockets_->send(*message);
}

bool FakeTracker::sendTransformWith(const std::string& device, float first, std::int64_t sent_us) {
  const auto message = igtl::TransformMessage::New();
  igtl::Matrix4x4 matrix;
  setPlace(matrix, {});
  matrix[0][0] = first;
  message->SetDeviceName(device.c_str());
  message->SetMatrix(matrix);
  setTime(*message, sent_us);
  return sockets_->send(*message);
}

bool FakeTracker::sendTracking(const std::string& instrument, const Vec3& place_mm, std::int64_t sent_us) {
  const auto element = igtl::TrackingDataElement::New();
  igtl::Matrix4x4 matrix;
  setPlace(matrix, place_mm);
  element->SetName(instrument.c_str());
  element->SetType(igtl::TrackingDataElement::TYPE_6D);
  element->SetMatrix(matrix);
  igtl::TrackingDataElement::Pointer pointer = element;
  const auto message = igtl::TrackingDataMessage::New();
  message->SetDeviceName("Tracker");
  message->AddTrackingDataElement(pointer);
  setTime(*message, sent_us);
  return sockets_->send(*message);
}

bool FakeTracker::sendStatus(int code, const std::string& words) {
  const auto message = igtl::StatusMessage::New();
  message->SetDeviceName("Tracker");
  message->SetCode(code);
  message->SetStatusString(words.c_str());
  return sockets_->send(*message);
}

bool FakeTracker::sendBytes(const std::string& bytes) {
  return sockets_->client.IsNotNull() &&
         sockets_->client->Send(bytes.data(), static_cast<int>(bytes.size())) == 1;
}

FakeTracker::Message FakeTracker::receive() {
  Message out;
  if (sockets_->client.IsNull()) {
    return out;
  }
  sockets_->client->SetReceiveTimeout(kTrackerPatience_ms);
  const auto head = igtl::MessageHeader::New();
  head->InitPack();
  if (sockets_->client->Receive(head->GetPackPointer(), head->GetPackSize()) != head->GetPackSize()) {
    return out;
  }
  head->Unpack();
  out.kind = head->GetDeviceType();
  out.device = head->GetDeviceName();
  const auto receiveBody = [&](igtl::MessageBase& message) {
    message.SetMessageHeader(head.GetPointer());
    message.AllocatePack();
    sockets_->client->Receive(message.GetPackBodyPointer(), message.GetPackBodySize());
    return (message.Unpack(1) & igtl::MessageHeader::UNPACK_BODY) != 0;
  };
  if (out.kind == "STRING") {
    const auto message = igtl::StringMessage::New();
    out.content = receiveBody(*message) ? message->GetString() : "damaged";
  } else if (out.kind == "TRANSFORM") {
    const auto message = igtl::TransformMessage::New();
    igtl::Matrix4x4 matrix;
    const bool sound = receiveBody(*message);
    message->GetMatrix(matrix);
    char text[64] = {};
    std::snprintf(text, sizeof text, "%.1f %.1f %.1f", matrix[0][3], matrix[1][3], matrix[2][3]);
    out.content = sound ? text : "damaged";
  } else {
    sockets_->client->Skip(head->GetBodySizeToRead());
  }
  return out;
}

}  // namespace torsio::testing
