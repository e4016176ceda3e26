// Numbers drawn from a fuzzer's bytes. Bytes decide what happens and at which magnitude; digits, and all that comes after the
// last byte, are random numbers that the bytes seed. So any input is a whole path, the same on every machine: draw one
// number a statement, since compilers evaluate the arguments of a call in different orders.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace fuzz {

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {
    for (const std::uint8_t* byte = data; byte != end_; ++byte) seed_ = (seed_ ^ *byte) * 0x100000001b3U;  // FNV-1a
  }

  unsigned byte() { return next_ != end_ ? *next_++ : static_cast<unsigned>(random() >> 56U); }
  /// One in `n`.
  bool one_in(unsigned n) { return byte() % n == 0; }
  /// An integer of [low, high].
  int between(int low, int high) {
    const unsigned range = static_cast<unsigned>(high - low) + 1;
    const unsigned high_byte = range > 256 ? byte() : 0;
    return low + static_cast<int>((high_byte * 256U + byte()) % range);
  }
  /// A number of [0, 1).
  double fraction() { return static_cast<double>(random() >> 11U) * 0x1p-53; }
  double sign() { return byte() % 2 == 0 ? 1.0 : -1.0; }
  /// A number of [2^low, 2^(high+1)), denormal where the exponent says so; a power of two now and then.
  double magnitude(int low, int high) {
    const int exponent = between(low, high);
    return std::ldexp(one_in(8) ? 1.0 : 1.0 + fraction(), exponent);
  }
  /// The same, of either sign, or zero of either sign.
  double number(int low, int high) {
    const double side = sign();
    return side * (one_in(8) ? 0.0 : magnitude(low, high));
  }

 private:
  std::uint64_t random() {  // splitmix64
    std::uint64_t z = (seed_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

  const std::uint8_t* next_;
  const std::uint8_t* end_;
  std::uint64_t seed_ = 0xcbf29ce484222325U;
};

}  // namespace fuzz
