// SPDX-License-Identifier: MIT
// How far each law is from what this core can do: as CSV, built once per instruction set. docs/speed.md says what is assumed.
//
//   limits        rows of one operation: its time, of a stream of independent ones whose numbers stay in registers or the first cache
//                 rows of a law: what it computes per contact, the least time that takes [ns], the time it takes, their ratio
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "counted.hpp"
#include "passes.hpp"
#include "runs_here.hpp"
#include "triad.hpp"

namespace {

using namespace bench;

constexpr std::size_t in_cache = 1024;
constexpr std::size_t in_memory = 1'000'000;

/// ns of one call: median of eleven turns of about a millisecond.
template <class Call>
double median_ns(Call&& call) {
  using Clock = std::chrono::steady_clock;
  const auto ns_of = [&call](std::size_t calls) {
    const auto start = Clock::now();
    for (std::size_t i = 0; i < calls; ++i) {
      call();
      asm volatile("" ::: "memory");
    }
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / double(calls);
  };
  ns_of(2);
  const std::size_t calls = 1 + std::size_t(1e6 / ns_of(2));
  std::vector<double> turns(11);
  for (double& turn : turns) turn = ns_of(calls);
  std::nth_element(turns.begin(), turns.begin() + 5, turns.end());
  return turns[5];
}

/// A value in a register that the compiler must compute, and does not know afterwards.
template <class Pack>
void change(Pack& x) {
  if constexpr (std::is_floating_point_v<Pack>) {
    asm volatile("" : "+x"(x)::"memory");
  } else {
    asm volatile("" : "+x"(x.data)::"memory");
  }
}

/// ns of one operation among many.
template <class Pack, class Compute>
double ns_of(const Compute& compute) {
  constexpr std::size_t operations = 64, lanes = ScalarTraits<Pack>::lanes;
  alignas(64) static typename ScalarTraits<Pack>::Lane cached[operations * lanes];
  const double all = median_ns([&compute] {
    Pack a(1.25F), b(0.75F), c(1.5F);
#pragma GCC unroll 16
    for (std::size_t i = 0; i < operations; ++i) {
      change(a);
      Pack result = compute(a, b, c, cached + i * lanes);
      change(result);
    }
  });
  return all / double(operations);
}

/// What one operation on a pack takes [ns].
template <class Pack>
struct Core {
  using Traits = ScalarTraits<Pack>;

  double root = ns_of<Pack>([](const Pack& a, const Pack&, const Pack&, auto*) {
    using std::sqrt;
    return Pack(sqrt(a));
  });
  double division = ns_of<Pack>([](const Pack& a, const Pack& b, const Pack&, auto*) { return Pack(b / a); });
  double multiplication = ns_of<Pack>([](const Pack& a, const Pack& b, const Pack&, auto*) { return Pack(a * b); });
  double multiply_add = ns_of<Pack>([](const Pack& a, const Pack& b, const Pack& c, auto*) { return Pack(a * b + c); });
  double multiply_add_and_addition = ns_of<Pack>([](const Pack& a, const Pack& b, const Pack& c, auto*) {
    Pack sum = a + c;
    change(sum);
    return Pack(a * b + c);
  });
  double load = ns_of<Pack>([](const Pack&, const Pack&, const Pack&, auto* cached) { return Traits::load(cached); });
  double store = ns_of<Pack>([](const Pack& a, const Pack&, const Pack&, auto* cached) {
    Traits::store(cached, a);
    return a;
  });
  /// Of a multiplication or an addition, in the mix of both that is the fastest.
  double flop = std::min(multiply_add / 2, multiply_add_and_addition / 3);

  /// The least time for these operations: root and quotient share a unit, loads, stores and the rest go beside them.
  std::pair<double, const char*> least(const Counts& counts) const {
    const auto number = [&counts](Operation operation) { return double(counts[std::size_t(operation)]); };
    const double multiplications = number(Operation::multiplication);
    const std::pair<double, const char*> units[] = {
        {number(Operation::root) * root + number(Operation::division) * division, "roots and divisions"},
        {std::max(multiplications * multiplication, (multiplications + number(Operation::addition)) * flop),
         "multiplications and additions"},
        {number(Operation::load) * load, "loads"},
        {number(Operation::store) * store, "stores"}};
    return *std::max_element(std::begin(units), std::end(units));
  }
};

template <class T>
constexpr const char* number = std::is_same_v<T, double> ? "double" : "float";

void print_operation(const char* type, const char* path, const char* operation, double ns) {
  std::printf("%s,%s,%s,%s,,,,,,,,,,%.4g,\n", CONTACTLAWS_BENCH_ARCH, type, path, operation, ns);
}
template <class Pack>
void print_operations(const char* path, const Core<Pack>& core) {
  const char* type = number<typename ScalarTraits<Pack>::Lane>;
  const double lanes = double(ScalarTraits<Pack>::lanes);
  print_operation(type, path, "root", core.root / lanes);
  print_operation(type, path, "division", core.division / lanes);
  print_operation(type, path, "multiplication", core.multiplication / lanes);
  print_operation(type, path, "multiplication or addition", core.flop / lanes);
  print_operation(type, path, "load", core.load / lanes);
  print_operation(type, path, "store", core.store / lanes);
}

/// What the kernel computes in two passes over a cached batch, per pass.
template <class Pack, class Law>
Counts counts_of(const Law& law, const std::vector<Contact>& contacts) {
  Batched<Law> batch(contacts);
  const auto both_passes = [&] {
    for (int i = 0; i < 2; ++i) batch.template step<Counted<Pack>>(law);
    return Tape::read();
  };
  both_passes();  // until the state repeats
  Counts counts = both_passes();
  for (std::size_t& of_kind : counts) of_kind /= 2;
  return counts;
}

struct MixOf {
  const char* name;
  std::vector<Contact> cached, stored;
};

template <class Pack, class Pass, class Law>
void print_law(const char* path, const Core<Pack>& core, const char* name, const Law& law, const MixOf& mix) {
  const Counts counts = counts_of<Pack>(law, mix.cached);
  const auto [least, unit] = core.least(counts);
  const double contacts = double(mix.cached.size());
  Pass pass(mix.cached);
  const double measured = median_ns([&] { pass(law); });
  std::printf("%s,%s,%s,%s,%s", CONTACTLAWS_BENCH_ARCH, number<typename Law::Scalar>, path, name, mix.name);
  for (std::size_t i = std::size_t(Operation::root); i < counts.size(); ++i)
    std::printf(",%.3g", double(counts[i] * ScalarTraits<Pack>::lanes) / contacts);
  std::printf(",%.3g,%s,%.3g,%.2f\n", least / contacts, unit, measured / contacts, measured / least);
}

/// A batch of contacts that no cache holds, against the triad.
template <class Law>
void print_from_memory(double ns_per_byte, const char* name, const Law& law, const MixOf& mix) {
  Batched<Law> pass(mix.stored);
  const double least = double(bytes_per_contact<Law>()) * ns_per_byte;
  const double measured = median_ns([&] { pass(law); }) / double(mix.stored.size());
  std::printf("%s,%s,memory,%s,%s,,,,,,,%.3g,triad,%.3g,%.2f\n", CONTACTLAWS_BENCH_ARCH, number<typename Law::Scalar>,
              name, mix.name, least, measured, measured / least);
}

/// The laws of one number.
template <class T>
void print_all(const std::vector<MixOf>& mixes, double ns_per_byte) {
  using Pack = typename PackOf<T>::type;
  const Core<T> one;
  const Core<Pack> packs;
  print_operations("scalar", one);
  print_operations("batch", packs);
  const auto print = [&](const char* name, const auto& in_double) {
    const auto law = in_double.template cast<T>();
    using Law = std::decay_t<decltype(law)>;
    for (const MixOf& mix : mixes) {
      print_law<T, OneByOne<Law>>("scalar", one, name, law, mix);
      print_law<Pack, Batched<Law>>("batch", packs, name, law, mix);
      print_from_memory(ns_per_byte, name, law, mix);
    }
  };
  print("SmoothHertz", granite<SmoothHertz<double>>());
  print("LinearFriction", granite<LinearFriction<double>>());
  print("LinearSpringDashpot", granite<LinearSpringDashpot<double>>());
  print("DryHill", granite<DryHill<double>>());
  print("DryHill/in_ratio", granite<DryHillInRatio>());
  print("Hill", granite<Hill<double>>());
  print("RoughBallast", granite<RoughBallast<double>>());
}

}  // namespace

int main() {
  if (!runs_here()) {
    std::fputs(CONTACTLAWS_BENCH_ARCH ": this machine lacks the instructions, skipped\n", stderr);
    return 0;
  }
  const auto mix_of = [](const char* name, const Mix& mix) {
    return MixOf{name, make_contacts(in_cache, mix), make_contacts(in_memory, mix)};
  };
  const std::vector<MixOf> mixes{mix_of("resting", {0.0, 0.0, 1.0}), mix_of("mix", {0.05, 0.05, 1.0})};
  std::puts(
      "instructions,number,path,law,contacts,roots,divisions,multiplications,additions,loads,stores,least_ns,set_by,"
      "measured_ns,ratio");
  Triad triad;
  const double ns_per_byte = median_ns(triad) / double(Triad::bytes * Triad::count);
  print_operation("double", "memory", "byte of the triad", ns_per_byte);
  print_all<double>(mixes, ns_per_byte);
  print_all<float>(mixes, ns_per_byte);
}
