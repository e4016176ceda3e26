// A batch on a GPU gives what it gives on the CPU, where nothing is contracted to fused multiply-adds:
//
//   nvcc -fmad=false    bit for bit, where the law calls no pow or exp
//   otherwise           within a bound: as far as the CPU's result moves when each input and each value of the history
//                       changes by up to 4 eps (the largest change of four draws, times 4), and 8 eps of the result
//
//   test_gpu               77: skipped, there is no GPU
//   test_gpu --small       fewer contacts, for compute-sanitizer
//   test_gpu --stand-in    the CPU in place of the GPU: whether the comparison finds the planted faults
//
// Built with -DCONTACTLAWS_TEST_CONTRACTS unless with -fmad=false.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "bench/gpu/device_arrays.hpp"
#include "contactlaws/contactlaws.hpp"
#include "contactlaws/scalars/cuda.hpp"

namespace {

using namespace contactlaws;

#if defined(CONTACTLAWS_TEST_CONTRACTS)
constexpr bool contracts = true;
#else
constexpr bool contracts = false;
#endif

bool stand_in = false;
int failures = 0;

void expect(bool holds, const std::string& what) {
  if (holds) return;
  std::printf("FAILED: %s\n", what.c_str());
  ++failures;
}

struct Random {
  std::mt19937_64 engine{20190501};
  double uniform(double low, double high) { return low + (high - low) * std::ldexp(double(engine() >> 11), -53); }
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
};

/// Contacts as a host keeps them: one array a quantity.
template <class Law>
struct Contacts {
  using T = typename Law::Scalar;
  enum : std::size_t {
    radius,
    young,
    shear,
    mass,
    min_radius,
    length,
    overlap,
    normal,
    velocity = normal + 3,
    dt = velocity + 3,
    normal_spin,
    relative_spin,
    inputs = relative_spin + 3,
    force = inputs,
    couple = force + 3,
    state = couple + 3,
    next = state + Law::state_size,
    columns = next + Law::state_size
  };
  std::vector<std::vector<T>> column{columns};

  explicit Contacts(std::size_t count) {
    for (auto& values : column) values.assign(count, T(0));
    for (std::size_t i = force; i < state; ++i) column[i].assign(count, T(-1));
  }

  /// Pairs of grains, and motions in which contacts open, close, stick and slide. Later draws move the same contacts.
  void draw(Random& random) {
    const bool first = column[radius].empty() || column[radius][0] == T(0);
    for (std::size_t i = 0; i < column[radius].size(); ++i) {
      const auto put = [this, i](std::size_t c, double value) { column[c][i] = T(value); };
      const auto put_vector = [&](std::size_t c, double size) {
        double v[3], square = 0.0;
        for (double& x : v) {
          x = random.uniform(-1.0, 1.0);
          square += x * x;
        }
        for (std::size_t axis = 0; axis < 3; ++axis) put(c + axis, v[axis] * size / std::sqrt(square));
      };
      if (first) {
        const double r = random.log_uniform(1e-3, 1e-2);
        put(radius, r);
        put(young, random.log_uniform(1e9, 1e11));
        put(shear, random.log_uniform(1e9, 1e11));
        put(mass, 1e4 * r * r * r);
        put(min_radius, r * random.uniform(1.0, 1.9));
        put(length, r * random.uniform(4.0, 5.0));
        put(dt, random.log_uniform(1e-7, 1e-5));
        put_vector(normal, 1.0);
        put(overlap, r * random.log_uniform(1e-5, 1e-2));
      }
      const double r = double(column[radius][i]);
      const double before = double(column[overlap][i]);
      const bool opens = random.chance(0.2);
      const double gap = r * random.log_uniform(1e-6, 4.0);
      const double closed = before > 0.0 ? before * random.uniform(0.5, 1.6) : r * random.log_uniform(1e-5, 1e-2);
      put(overlap, opens ? -gap : closed);
      double n[3], square = 0.0;  // turned a little
      for (std::size_t axis = 0; axis < 3; ++axis) {
        n[axis] = double(column[normal + axis][i]) + random.uniform(-1e-3, 1e-3);
        square += n[axis] * n[axis];
      }
      for (std::size_t axis = 0; axis < 3; ++axis) put(normal + axis, n[axis] / std::sqrt(square));
      put_vector(velocity, random.log_uniform(1e-6, 1e1));
      put_vector(relative_spin, random.log_uniform(1e-3, 1e3));
    }
  }

  ContactBatch<Law> batch(bool in_place = true, bool uniform = false) {
    const auto array = [this](std::size_t c) { return column[c].data(); };
    ContactBatch<Law> b;
    b.count = column[radius].size();
    b.pair = {array(radius), array(young), array(shear), array(mass), array(min_radius), array(length)};
    b.overlap = array(overlap);
    b.dt = array(dt);
    b.normal_spin = array(normal_spin);
    if (uniform) {
      b.pair.effective_young = T(3e10);
      b.pair.effective_shear = T(2e10);
      b.dt = T(1e-6);
      b.normal_spin = 0;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      b.normal[axis] = array(normal + axis);
      b.velocity[axis] = array(velocity + axis);
      b.relative_spin[axis] = array(relative_spin + axis);
      b.force[axis] = array(force + axis);
      b.couple[axis] = array(couple + axis);
    }
    for (std::size_t i = 0; i < Law::state_size; ++i) {
      b.state[i] = array(state + i);
      b.next[i] = array((in_place ? state : next) + i);
    }
    return b;
  }

  /// Each input and each value of the history changed by up to 4 eps.
  void perturb(Random& random) {
    for (std::size_t c = 0; c < columns; ++c)
      if (c < inputs || c >= state)
        for (T& x : column[c]) x *= T(1) + T(random.uniform(-4.0, 4.0)) * std::numeric_limits<T>::epsilon();
  }
};

/// Steps the batch a few times in a row on the GPU, on a stream of its own; the host's arrays get the results.
template <class Law, class T = typename Law::Scalar>
void step_on_gpu(const Law& law, Contacts<Law>& contacts, const ContactBatch<Law>& batch, int times,
                 bench::DeviceArrays<T>& device) {
  if (stand_in) {
    for (int i = 0; i < times; ++i) evaluate<Law, T>(law, batch);
    return;
  }
  cudaStream_t stream;
  CONTACTLAWS_CUDA(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking));
  ContactBatch<Law> on_device = device.of(batch);
  for (const auto& values : contacts.column) {
    device.of(values.data());
    device.upload(values.data());
  }
  on_device.count = batch.count;
  for (int i = 0; i < times; ++i) CONTACTLAWS_CUDA(evaluate(law, on_device, stream));
  CONTACTLAWS_CUDA(cudaStreamSynchronize(stream));
  CONTACTLAWS_CUDA(cudaStreamDestroy(stream));
  for (auto& values : contacts.column) device.download(values.data());
}

template <class T>
bool same(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0 || (a != a && b != b);
}

struct Difference {
  std::size_t different = 0;    ///< numbers whose bits differ
  std::size_t beyond = 0;       ///< results beyond the bound
  double largest = 0.0;         ///< largest difference, of the bound
  double largest_in_eps = 0.0;  ///< of a force, in eps of its length
};

/// What the GPU has computed beside the CPU. `changed`: the CPU with changed inputs; none: bits are compared.
template <class Law>
Difference compare(const Contacts<Law>& cpu, const Contacts<Law>& gpu, const std::vector<Contacts<Law>>& changed) {
  using T = typename Law::Scalar;
  using C = Contacts<Law>;
  const double eps = double(std::numeric_limits<T>::epsilon());
  Difference found;
  const std::size_t size = cpu.column[0].size();
  for (std::size_t c = 0; c < C::columns; ++c)
    for (std::size_t i = 0; i < size; ++i) found.different += !same(cpu.column[c][i], gpu.column[c][i]);
  if (changed.empty()) {
    found.beyond = found.different;
    return found;
  }
  const auto distance = [](const C& a, const C& b, std::size_t c, std::size_t width, std::size_t i) {
    double square = 0.0;
    for (std::size_t k = c; k < c + width; ++k) {
      const double d = double(a.column[k][i]) - double(b.column[k][i]);
      square += d * d;
    }
    return std::sqrt(square);
  };
  const C zero = [size] {
    C all(size);
    for (auto& values : all.column) values.assign(size, T(0));
    return all;
  }();
  const auto compare_columns = [&](std::size_t c, std::size_t width) {
    for (std::size_t i = 0; i < size; ++i) {
      double moved = 0.0;
      for (const C& other : changed) moved = std::max(moved, distance(cpu, other, c, width, i));
      const double value = distance(cpu, zero, c, width, i), off = distance(cpu, gpu, c, width, i);
      const double bound = 4.0 * moved + 8.0 * eps * value;
      if (!(off <= bound)) ++found.beyond;
      if (off > 0.0) found.largest = std::max(found.largest, off / bound);
      if (off > 0.0 && c == C::force) found.largest_in_eps = std::max(found.largest_in_eps, off / (eps * value));
    }
  };
  compare_columns(C::force, 3);
  compare_columns(C::couple, 3);
  for (std::size_t i = 0; i < Law::state_size;) {
    const std::size_t width = Law::state_values()[i].kind == ValueKind::vector ? 3 : 1;
    compare_columns(C::state + i, width);
    compare_columns(C::next + i, width);
    i += width;
  }
  return found;
}

/// Damages what the GPU is told, to see whether the comparison finds it.
template <class Law>
using Fault = void (*)(Law&, ContactBatch<Law>&);

/// Some contacts with a history, virgin and wet ones among them, over a few steps.
template <class Law>
Difference run(Law law, std::size_t size, std::size_t count, bool bits, bool in_place = true, bool uniform = false,
               Fault<Law> fault = nullptr) {
  using T = typename Law::Scalar;
  Random random;
  Contacts<Law> cpu(size);
  for (int i = 0; i < 2; ++i) {
    cpu.draw(random);
    evaluate<Law, T>(law, cpu.batch());
  }
  for (std::size_t i = 0; i < size; ++i) {
    const bool is_virgin = random.chance(0.4), is_wet = random.chance(0.6);
    for (std::size_t s = 0; s < Law::state_size; ++s) {
      if (is_virgin) cpu.column[cpu.state + s][i] = T(0);
      if (std::strcmp(Law::state_values()[s].name, "moisture") == 0) cpu.column[cpu.state + s][i] = T(is_wet ? 2 : 0);
    }
  }
  Contacts<Law> gpu = cpu;
  std::vector<Contacts<Law>> changed(bits ? 0 : 4, cpu);
  bench::DeviceArrays<T> device(size, size);
  for (int round = 0; round < 3; ++round) {
    cpu.draw(random);
    const auto take_inputs = [&cpu](Contacts<Law>& other) {
      std::copy_n(cpu.column.begin(), std::size_t(Contacts<Law>::inputs), other.column.begin());
    };
    take_inputs(gpu);
    const int times = in_place ? 3 : 1;
    const auto cpu_batch = [&](Contacts<Law>& contacts) {
      ContactBatch<Law> batch = contacts.batch(in_place, uniform);
      batch.count = count;
      return batch;
    };
    ContactBatch<Law> damaged = cpu_batch(gpu);
    Law damaged_law = law;
    if (fault != nullptr) fault(damaged_law, damaged);
    step_on_gpu(damaged_law, gpu, damaged, times, device);
    for (int i = 0; i < times; ++i) evaluate<Law, T>(law, cpu_batch(cpu));
    for (Contacts<Law>& other : changed) {
      take_inputs(other);
      other.perturb(random);
      for (int i = 0; i < times; ++i) evaluate<Law, T>(law, cpu_batch(other));
    }
  }
  return compare(cpu, gpu, changed);
}

std::size_t many = 100007;

/// `exact`: the law calls no pow or exp.
template <class Law>
void test_on(const std::string& name, const Law& law, bool exact) {
  using T = typename Law::Scalar;
  const bool bits = exact && !contracts;
  const std::string full = name + (sizeof(T) == 8 ? " double" : " float");
  const Difference found = run(law, many, many, bits);
  std::printf("%-34s %-6s %8zu numbers differ, force by %.3g eps, %.3g of the bound\n", full.c_str(),
              bits ? "bits" : "bound", found.different, found.largest_in_eps, found.largest);
  expect(found.beyond == 0, full + ": " + std::to_string(found.beyond) + " results beyond the bound");
  // Beyond the count nothing is written.
  for (const std::size_t count : {0, 1, 31})
    expect(run(law, 40, count, bits).beyond == 0, full + ", count " + std::to_string(count));
  expect(run(law, 1000, 1000, bits, false).beyond == 0, full + ": state and next in arrays of their own");
  expect(run(law, 1000, 1000, bits, true, true).beyond == 0, full + ": one number for all contacts");
}

template <class Law>
void test(const std::string& name, const Law& law, bool exact = true) {
  test_on(name, law, exact);
  test_on(name, law.template cast<float>(), exact);
}

template <class Normal, class Damping, class Shear, class Bridge = Dry<double>, class Rolling = NoRolling<double>>
auto compose(const Normal& normal, const Damping& damping, const Shear& shear, const Bridge& bridge = {},
             const Rolling& rolling = {}) {
  return ContactLaw<Normal, Damping, Shear, Bridge, Rolling>{normal, damping, shear, bridge, rolling};
}

void test_laws() {
  using T = double;
  const Hertz<T> hertz;
  const Dashpots<T> damped{0.3};
  const Mindlin<T> mindlin;
  const ConstantRatio<T> ratio{0.6};
  test("SmoothHertz", SmoothHertz<T>{});
  test("LinearFriction", LinearFriction<T>{LinearModulus<T>{5e8}, {}, {ratio, 0.4}});
  test("LinearSpringDashpot", LinearSpringDashpot<T>{LinearSpring<T>{1e6}, damped, {ratio, 0.4}});
  test("DryHill", DryHill<T>{hertz, damped, {mindlin, 0.4}});
  test("DryHill clipped", DryHill<T, Tension::clipped>{hertz, {0.6}, {mindlin, 0.4}});
  test("DryHill, displacement", compose(hertz, damped, ShearDisplacement<T>{mindlin, 0.4}));
  test("DryHill, force rescaled", compose(hertz, damped, ShearForceRescaled<T>{mindlin, 0.4}));
  test("DryHill, displacement rescaled", compose(hertz, damped, ShearDisplacementRescaled<T>{mindlin, 0.4}));
  test("DryHill, turned exactly", compose(hertz, damped, ShearForce<T, Mindlin<T>, rotation::Rotate<T>>{mindlin, 0.4}));
  test("DryHill, rolling", compose(hertz, damped, ShearForce<T>{mindlin, 0.4}, Dry<T>{}, RollingSpring<T>{0.2}));
  test("Hill, suction zero", Hill<T>{hertz, damped, {mindlin, 0.4}, {0.0, 2.0, 2.0}});
  test("Hill", Hill<T>{hertz, damped, {mindlin, 0.4}, {2e5, 2.0, 2.0}}, false);
  test("RoughBallast", RoughBallast<T>{PohrtPopovElastoPlastic<T>::of({2.13, 26.1e-6}), {}, {ratio, 0.7}}, false);
}

/// Faults of a host or of a kernel, each of which the comparison must find.
template <class Law>
void test_faults(const char* name, const Law& law, bool exact) {
  using T = typename Law::Scalar;
  struct Planted {
    const char* name;
    Fault<Law> fault;
  };
  const Planted planted[] = {
      {"two columns exchanged", [](Law&, ContactBatch<Law>& b) { std::swap(b.velocity[0], b.velocity[2]); }},
      {"the last contact left out", [](Law&, ContactBatch<Law>& b) { --b.count; }},
      {"state of another column", [](Law&, ContactBatch<Law>& b) { std::swap(b.state[0], b.state[1]); }},
      {"history not stored", [](Law&, ContactBatch<Law>& b) { b.next[1] = b.couple[1]; }},
      {"a force not stored", [](Law&, ContactBatch<Law>& b) { b.force[2] = b.couple[2]; }},
      {"a parameter off by 300 eps",
       [](Law& l, ContactBatch<Law>&) { l.shear.friction *= T(1) + T(300) * std::numeric_limits<T>::epsilon(); }},
      {"one number in place of a column", [](Law&, ContactBatch<Law>& b) { b.pair.effective_mass = T(1e-3); }},
  };
  for (const Planted& p : planted)
    expect(run(law, 1000, 1000, exact && !contracts, true, false, p.fault).beyond > 0,
           std::string(name) + ": not found: " + p.name);
}

/// A launch that cannot be made returns its error, and harms nothing.
void test_errors() {
  using Law = DryHill<double>;
  ContactBatch<Law> none;
  expect(evaluate(Law{}, none, nullptr) == cudaSuccess, "no contacts are no error");
  none.count = std::size_t(1) << 40;
  expect(evaluate(Law{}, none, nullptr) == cudaErrorInvalidConfiguration, "too many contacts are an error");
  cudaGetLastError();
  expect(cudaDeviceSynchronize() == cudaSuccess, "after such an error the device works");
}

/// Friction in an array gives what as many laws give.
void test_parameter_columns() {
  using Law = DryHill<double>;
  const Law law{{}, {0.3}, {{}, 0.4}};
  const std::size_t size = many;
  Random random;
  std::vector<double> friction(size);
  for (double& mu : friction) mu = random.uniform(0.1, 0.9);
  Contacts<Law> cpu(size);
  cpu.draw(random);
  Contacts<Law> gpu = cpu;
  auto columns = law.cast<Column<double>>();
  columns.shear.friction = static_cast<const double*>(friction.data());
  evaluate<Law, double>(columns, cpu.batch());
  bench::DeviceArrays<double> device(size, size);
  columns.shear.friction = device.of(columns.shear.friction);
  CONTACTLAWS_CUDA(evaluate<Law>(columns, device.of(gpu.batch()), nullptr));
  for (auto& values : gpu.column) {
    device.of(values.data());
    device.download(values.data());
  }
  std::vector<Contacts<Law>> changed(contracts ? 4 : 0, cpu);
  for (auto& other : changed) {
    other = gpu;  // its inputs are the CPU's
    for (std::size_t i = 0; i < Law::state_size; ++i) other.column[other.state + i].assign(size, 0.0);
    other.perturb(random);
    columns.shear.friction = static_cast<const double*>(friction.data());
    evaluate<Law, double>(columns, other.batch());
  }
  expect(compare(cpu, gpu, changed).beyond == 0, "friction in an array");
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--stand-in") == 0) stand_in = true;
    if (std::strcmp(argv[i], "--small") == 0) many = 1007;
  }
  int devices = 0;
  if (!stand_in && (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0)) {
    std::puts("skipped: no GPU");
    return 77;
  }
  std::printf("%s, %zu contacts\n", contracts ? "contracted to fused multiply-adds" : "not contracted", many);
  test_laws();
  test_faults("DryHill", DryHill<double>{{}, {0.3}, {{}, 0.4}}, true);
  test_faults("DryHill float", DryHill<float>{{}, {0.3F}, {{}, 0.4F}}, true);
  test_faults("Hill", Hill<double>{{}, {0.3}, {{}, 0.4}, {2e5, 2.0, 2.0}}, false);
  if (!stand_in) {
    test_errors();
    test_parameter_columns();
  }
  std::printf("%d failures\n", failures);
  return failures == 0 ? 0 : 1;
}
