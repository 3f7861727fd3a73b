// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/foreign/parquet_thrift.h"

namespace torsio {

namespace {

constexpr int kDeepest = 16;
constexpr unsigned kSevenBits = 7;
constexpr unsigned kLongest = 64;  // bits of a number

}  // namespace

unsigned ThriftReader::byte() {
  if (left() == 0) {
    throw Damaged();
  }
  return static_cast<unsigned char>(bytes_[at_++]);
}

std::uint64_t ThriftReader::varint() {
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift < kLongest; shift += kSevenBits) {
    const unsigned next = byte();
    value |= static_cast<std::uint64_t>(next & 0x7FU) << shift;
    if ((next & 0x80U) == 0) {
      return value;
    }
  }
  throw Damaged();
}

std::int64_t ThriftReader::whole() {
  const std::uint64_t value = varint();  // zigzag
  return static_cast<std::int64_t>((value >> 1U) ^ (~(value & 1U) + 1U));
}

std::string_view ThriftReader::text() {
  const std::uint64_t size = varint();
  if (size > left()) {
    throw Damaged();
  }
  at_ += static_cast<std::size_t>(size);
  return bytes_.substr(at_ - static_cast<std::size_t>(size), static_cast<std::size_t>(size));
}

ThriftReader::List ThriftReader::list() {
  constexpr unsigned kLongForm = 15;
  const unsigned head = byte();
  const std::uint64_t size = head >> 4U == kLongForm ? varint() : head >> 4U;
  if (size > left()) {  // each element takes a byte at least
    throw Damaged();
  }
  return {static_cast<std::size_t>(size), head & 0xFU};
}

bool ThriftReader::nextField(int& number, unsigned& kind) {
  const unsigned head = byte();
  kind = head & 0xFU;
  if (kind == 0) {
    return false;
  }
  constexpr std::int64_t kLargestNumber = 32'767;
  const std::int64_t next = head >> 4U == 0 ? whole() : number + static_cast<std::int64_t>(head >> 4U);
  if (next < 0 || next > kLargestNumber) {
    throw Damaged();
  }
  number = static_cast<int>(next);
  return true;
}

void ThriftReader::skip(unsigned kind, int depth) {
  if (depth > kDeepest) {
    throw Damaged();
  }
  switch (kind) {
    case kTrue:
    case kFalse:
      return;  // of a field: the kind is the value
    case kByte:
      (void)byte();
      return;
    case kI16:
    case kI32:
    case kI64:
      (void)varint();
      return;
    case kDouble:
      if (left() < sizeof(double)) {
        throw Damaged();
      }
      at_ += sizeof(double);
      return;
    case kBinary:
      (void)text();
      return;
    case kList:
    case kSet: {
      const List all = list();
      for (std::size_t i = 0; i < all.size; ++i) {
        skip(all.kind == kTrue || all.kind == kFalse ? kByte : all.kind, depth + 1);
      }
      return;
    }
    case kMap: {
      const std::uint64_t size = varint();
      const unsigned kinds = size == 0 ? 0 : byte();
      if (size > left()) {
        throw Damaged();
      }
      for (std::uint64_t i = 0; i < size; ++i) {
        for (const unsigned one : {kinds >> 4U, kinds & 0xFU}) {
          skip(one == kTrue || one == kFalse ? kByte : one, depth + 1);
        }
      }
      return;
    }
    case kStruct: {
      int number = 0;
      for (unsigned inner = 0; nextField(number, inner);) {
        skip(inner, depth + 1);
      }
      return;
    }
    default:
      throw Damaged();
  }
}

}  // namespace torsio
