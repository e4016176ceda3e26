// Item 13: one line a law of what must be the same bits from any compiler at any optimisation, contraction off: a hash of the
// forces and states along random paths, one contact at a time and, of some laws, as a batch. Laws that call pow, exp, sin
// or cos are left out, so nothing spins and all is dry.
#include <cstring>

#include "contactlaws/batch.hpp"
#include "contactlaws/scalars/xsimd.hpp"
#include "make_laws.hpp"
#include "properties/law_list.hpp"
#include "properties/paths.hpp"
#include "row.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

namespace {

constexpr std::size_t contacts = 251;  // no multiple of a pack
constexpr std::size_t length = 50;

/// FNV-1a over the bytes of numbers.
class Hash {
 public:
  template <class T>
  void add(T x) {
    if (x == T(0)) x = T(0);  // the sign of a zero may differ
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &x, sizeof(T));
    for (const unsigned char byte : bytes) value_ = (value_ ^ byte) * 1099511628211u;
  }
  std::string text() const {
    std::ostringstream text;
    text << std::hex << value_;
    return text.str();
  }

 private:
  std::uint64_t value_ = 14695981039346656037u;
};

/// Numbers drawn one a statement, since compilers differ in the order of arguments, and without exp and log, which some
/// compute at compile time.
Vec3<double> direction(Random& random) {
  for (;;) {
    const double x = random.uniform(-1.0, 1.0);
    const double y = random.uniform(-1.0, 1.0);
    const double z = random.uniform(-1.0, 1.0);
    const double square = x * x + y * y + z * z;
    const double root = std::sqrt(square);
    if (square > 0.01 && square < 1.0) return {x / root, y / root, z / root};
  }
}

/// Like random_path: stick and slip, turn, now and then part.
Path dry_path(Random& random) {
  const double radius1 = random.binary<double>(-20, 0);
  const double radius2 = random.binary<double>(-20, 0);
  const ElasticMaterial<double> material{random.uniform(1e9, 1e11), random.uniform(0.0, 0.5), 2650.0};
  Path path{pair_properties(sphere(material, radius1), sphere(material, radius2)), {}, false};
  const double deep = path.pair.effective_radius * random.binary<double>(-14, -8);
  const double slowness = random.uniform(0.01, 1.0);
  const double dt = slowness * std::sqrt(path.pair.effective_mass /
                                         (path.pair.effective_young * std::sqrt(path.pair.effective_radius * deep)));
  Vec3<double> normal = direction(random);
  for (std::size_t i = 0; i < length; ++i) {
    const double turn = random.uniform(0.0, 0.1);
    const Vec3<double> aside = normal + turn * direction(random);
    normal = aside / norm<double>(aside);
    const bool open = random.chance(0.1);
    const double overlap = deep * (open ? random.uniform(-1.0, 0.0) : random.uniform(0.2, 1.0));
    const double speed = deep / dt * random.binary<double>(-10, -2);
    const Vec3<double> velocity = speed * direction(random);
    path.steps.push_back({normal, overlap, velocity, dt});
  }
  return path;
}

std::vector<Path> dry_paths() {
  Random random;
  std::vector<Path> paths;
  for (std::size_t c = 0; c < contacts; ++c) paths.push_back(dry_path(random));
  return paths;
}

std::string hash_of_inputs(const std::vector<Path>& paths) {
  Hash hash;
  for (const Path& path : paths) {
    for (const double x :
         {path.pair.effective_radius, path.pair.effective_young, path.pair.effective_shear, path.pair.effective_mass})
      hash.add(x);
    for (const auto& k : path.steps) {
      for (int i = 0; i < 3; ++i) hash.add(k.normal[i]), hash.add(k.velocity[i]);
      hash.add(k.overlap), hash.add(k.dt);
    }
  }
  return hash.text();
}

/// Forces and states, contact by contact at each step.
template <class T>
std::string hash_of_steps(const ErasedLaw<T>& law, const std::vector<Path>& paths) {
  std::vector<typename ErasedLaw<T>::State> states(paths.size(), law.virgin());
  Hash hash;
  for (std::size_t i = 0; i < length; ++i) {
    for (std::size_t c = 0; c < paths.size(); ++c) {
      const auto step = law.step(paths[c].pair.template cast<T>(), paths[c].steps[i].template cast<T>(), states[c]);
      states[c] = step.state;
      for (int axis = 0; axis < 3; ++axis) hash.add(step.force[axis]);
      for (std::size_t v = 0; v < law.state_size(); ++v) hash.add(step.state[v]);
    }
  }
  return hash.text();
}

/// The same contacts as arrays.
template <class Law>
class Contacts {
 public:
  using T = typename Law::Scalar;

  explicit Contacts(const std::vector<Path>& paths) : paths_(paths) {
    for (auto& column : columns_) column.resize(contacts);
    for (auto& column : state_) column.assign(contacts, T(0));
  }

  std::string hash_of_steps(const Law& law) {
    Hash hash;
    for (std::size_t i = 0; i < length; ++i) {
      fill(i);
      evaluate(law, batch());
      for (std::size_t c = 0; c < contacts; ++c) {
        for (std::size_t axis = 0; axis < 3; ++axis) hash.add(columns_[force_at + axis][c]);
        for (const auto& column : state_) hash.add(column[c]);
      }
    }
    return hash.text();
  }

 private:
  static constexpr std::size_t force_at = 14;

  void fill(std::size_t step) {
    for (std::size_t c = 0; c < contacts; ++c) {
      const PairProperties<T> p = paths_[c].pair.template cast<T>();
      const ContactKinematics<T> k = paths_[c].steps[step].template cast<T>();
      const T values[] = {p.effective_radius, p.effective_young,
                          p.effective_shear,  p.effective_mass,
                          p.min_radius,       p.length,
                          k.normal.x(),       k.normal.y(),
                          k.normal.z(),       k.overlap,
                          k.velocity.x(),     k.velocity.y(),
                          k.velocity.z(),     k.dt};
      for (std::size_t i = 0; i < force_at; ++i) columns_[i][c] = values[i];
    }
  }
  ContactBatch<Law> batch() {
    const auto at = [this](std::size_t i) { return columns_[i].data(); };
    ContactBatch<Law> b;
    b.count = contacts;
    b.pair = {at(0), at(1), at(2), at(3), at(4), at(5)};
    b.normal = {at(6), at(7), at(8)};
    b.overlap = at(9);
    b.velocity = {at(10), at(11), at(12)};
    b.dt = at(13);
    b.force = {at(force_at), at(force_at + 1), at(force_at + 2)};
    for (std::size_t i = 0; i < state_.size(); ++i) b.state[i] = b.next[i] = state_[i].data();
    return b;
  }

  const std::vector<Path>& paths_;
  std::array<std::vector<T>, force_at + 3> columns_;
  std::array<std::vector<T>, Law::state_size> state_;
};

void print(const std::string& name, const char* way, const std::string& hash) {
  std::cout << nlohmann::ordered_json{{"law", name}, {"way", way}, {"hash", hash}}.dump() << '\n';
}

template <class T>
std::string named(const char* law) {
  return law + std::string(sizeof(T) == sizeof(float) ? " (float)" : " (double)");
}

template <class T>
void print_steps(const std::vector<Path>& paths) {
  for (const auto& law : all_laws<T>())
    if (law->name.find("Rough") == std::string::npos)
      print(named<T>(law->name.c_str()), "scalar", hash_of_steps(*law, paths));
}

template <class T, class DoubleLaw>
void print_batch(const char* name, const DoubleLaw& double_law, const std::vector<Path>& paths) {
  const auto law = double_law.template cast<T>();
  print(named<T>(name), "scalar", hash_of_steps<T>(Erased<std::decay_t<decltype(law)>>(name, law), paths));
  print(named<T>(name), "batch", Contacts<std::decay_t<decltype(law)>>(paths).hash_of_steps(law));
}

}  // namespace

int main() {
  const std::vector<Path> paths = dry_paths();
  print("inputs", "", hash_of_inputs(paths));
  print_steps<double>(paths);
  print_steps<float>(paths);
  // Every kernel of a batch is inlined in one loop, which takes long to compile: two laws are enough.
  const auto print_batches = [&paths](const char* name, const auto& law) {
    print_batch<double>(name, law, paths);
    print_batch<float>(name, law, paths);
  };
  using D = double;
  print_batches("Hill in batches", test::hill<D>(0.4, 2e5, 0.07));
  print_batches("DisplacementRescaled Rotate in batches",
                compose(Hertz<D>{}, Dashpots<D, Tension::clipped>{0.6},
                        ShearDisplacementRescaled<D, Mindlin<D>, rotation::Rotate<D>>{{}, 0.5}, Dry<D>{}));
}
