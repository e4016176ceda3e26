// SPDX-License-Identifier: MIT
// A number, or a pack, that counts the operations its stored results need: the library's own kernels, run on it, tell what they
// compute. What no stored result needs, a compiler leaves out; what depends on no contact, it computes once: neither counts.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "contactlaws/core/power.hpp"
#include "contactlaws/core/scalar.hpp"
#include "contactlaws/core/sixth_root.hpp"

namespace bench {

/// Of a kind that an arithmetic unit is slow at or busy with; `free`: selections, signs, digits.
enum class Operation : unsigned { free, root, division, multiplication, addition, load, store, count };
using Counts = std::array<std::size_t, std::size_t(Operation::count)>;

/// Every operation since the last reading, with the operations whose results it takes.
class Tape {
 public:
  static constexpr unsigned constant = 0;  ///< the node of what depends on no contact

  [[gnu::noinline]] static unsigned add(Operation operation, unsigned a, unsigned b = constant) {
    if (a == constant && b == constant) return constant;
    return input(operation, a, b);
  }
  [[gnu::noinline]] static unsigned input(Operation operation, unsigned a = constant, unsigned b = constant) {
    nodes.push_back({operation, a, b, false});
    return unsigned(nodes.size() - 1);
  }
  /// A result that leaves the kernel, or that decides its course.
  [[gnu::noinline]] static void need(unsigned node) { nodes[node].needed = true; }
  [[gnu::noinline]] static void store(unsigned node) { need(input(Operation::store, node)); }

  /// How many operations of each kind were needed; forgets them all.
  static Counts read() {
    Counts counts{};
    for (std::size_t i = nodes.size() - 1; i > 0; --i) {
      if (!nodes[i].needed) continue;
      ++counts[std::size_t(nodes[i].operation)];
      need(nodes[i].a);
      need(nodes[i].b);
    }
    nodes.resize(1);
    return counts;
  }

 private:
  struct Node {
    Operation operation;
    unsigned a, b;
    bool needed;
  };
  static inline std::vector<Node> nodes{{Operation::free, constant, constant, false}};
};

template <class Pack>
class Counted {
 public:
  using Traits = contactlaws::ScalarTraits<Pack>;
  using Mask = typename Traits::Mask;

  Counted() = default;
  Counted(const Pack& result, unsigned from) : value(result), node(from) {}
  template <class Number, std::enable_if_t<std::is_arithmetic_v<Number>, int> = 0>
  Counted(Number number) : value(typename Traits::Lane(number)) {}  // NOLINT: implicit

  [[gnu::noinline]] friend Counted operator+(const Counted& a, const Counted& b) {
    return {a.value + b.value, both(Operation::addition, a, b)};
  }
  [[gnu::noinline]] friend Counted operator-(const Counted& a, const Counted& b) {
    return {a.value - b.value, both(Operation::addition, a, b)};
  }
  [[gnu::noinline]] friend Counted operator*(const Counted& a, const Counted& b) {
    return {a.value * b.value, both(Operation::multiplication, a, b)};
  }
  [[gnu::noinline]] friend Counted operator/(const Counted& a, const Counted& b) {
    return {a.value / b.value, both(Operation::division, a, b)};
  }
  [[gnu::noinline]] Counted operator-() const { return {-value, Tape::add(Operation::free, node)}; }
  [[gnu::noinline]] friend Counted sqrt(const Counted& x) {
    using std::sqrt;
    return {sqrt(x.value), Tape::add(Operation::root, x.node)};
  }
  [[gnu::noinline]] friend Counted abs(const Counted& x) {
    using std::abs;
    return {abs(x.value), Tape::add(Operation::free, x.node)};
  }
  // A library's function: what it computes is not counted.
  [[gnu::noinline]] friend Counted exp(const Counted& x) {
    using std::exp;
    return {exp(x.value), Tape::add(Operation::free, x.node)};
  }
  [[gnu::noinline]] friend Counted pow(const Counted& x, const Counted& y) {
    using std::pow;
    return {pow(x.value, y.value), both(Operation::free, x, y)};
  }
  // Comparisons decide what is computed.
  [[gnu::noinline]] friend Mask operator<(const Counted& a, const Counted& b) {
    return needed(a, b), a.value < b.value;
  }
  [[gnu::noinline]] friend Mask operator<=(const Counted& a, const Counted& b) {
    return needed(a, b), a.value <= b.value;
  }
  friend Mask operator>(const Counted& a, const Counted& b) { return b < a; }
  friend Mask operator>=(const Counted& a, const Counted& b) { return b <= a; }

  Pack value{};
  unsigned node = Tape::constant;

 private:
  static unsigned both(Operation operation, const Counted& a, const Counted& b) {
    return Tape::add(operation, a.node, b.node);
  }
  static void needed(const Counted& a, const Counted& b) { Tape::need(a.node), Tape::need(b.node); }
};

/// The digits of a number or a pack.
template <class Pack>
using DigitsOf = std::conditional_t<std::is_floating_point_v<Pack>, contactlaws::detail::NumberDigits<Pack>,
                                    contactlaws::BinaryDigits<Pack>>;
template <class Pack>
struct CountedDigits {
  using Bits = typename DigitsOf<Pack>::Bits;
  static constexpr bool known = !std::is_floating_point_v<Pack>;

  static Bits bits(const Counted<Pack>& x) { return Tape::need(x.node), DigitsOf<Pack>::bits(x.value); }
  static Counted<Pack> number(const Bits& bits) { return {DigitsOf<Pack>::number(bits), Tape::input(Operation::free)}; }
  static Counted<Pack> nearest(const Counted<Pack>& x) {
    return {DigitsOf<Pack>::nearest(x.value), Tape::add(Operation::free, x.node)};
  }
};

}  // namespace bench

namespace contactlaws {

template <class Pack>
struct VectorOf<bench::Counted<Pack>> {
  using type = PlainVec3<bench::Counted<Pack>>;
};

template <class Pack>
struct ScalarTraits<bench::Counted<Pack>> {
  using T = bench::Counted<Pack>;
  using Traits = ScalarTraits<Pack>;
  using Mask = typename Traits::Mask;
  using Lane = typename Traits::Lane;
  static constexpr std::size_t lanes = Traits::lanes;

  static T select(const Mask& condition, const T& yes, const T& no) {
    return {Traits::select(condition, yes.value, no.value),
            bench::Tape::add(bench::Operation::free, yes.node, no.node)};
  }
  static bool any(const Mask& condition) { return Traits::any(condition); }
  static bool all(const Mask& condition) { return Traits::all(condition); }
  static Mask negate(const Mask& condition) { return Traits::negate(condition); }
  static T load(const Lane* values) { return {Traits::load(values), bench::Tape::input(bench::Operation::load)}; }
  static void store(Lane* values, const T& x) {
    bench::Tape::store(x.node);
    Traits::store(values, x.value);
  }
};

template <class Pack>
struct BinaryDigits<bench::Counted<Pack>> : bench::CountedDigits<Pack> {};
template <class Pack>
struct SixthRootOf<bench::Counted<Pack>> {
  static SixthRoot<bench::Counted<Pack>> of(const bench::Counted<Pack>& x) {
    return detail::sixth_root_of_bits<bench::Counted<Pack>, bench::CountedDigits<Pack>>(x);
  }
};

/// Of one number too, two roots are computed by one instruction.
template <>
inline std::array<bench::Counted<double>, 2> sqrt_pair(const bench::Counted<double>& a,
                                                       const bench::Counted<double>& b) noexcept {
  return {sqrt(a), bench::Counted<double>(std::sqrt(b.value), bench::Tape::add(bench::Operation::free, b.node))};
}
template <>
inline std::array<bench::Counted<float>, 2> sqrt_pair(const bench::Counted<float>& a,
                                                      const bench::Counted<float>& b) noexcept {
  return {sqrt(a), bench::Counted<float>(std::sqrt(b.value), bench::Tape::add(bench::Operation::free, b.node))};
}

}  // namespace contactlaws
