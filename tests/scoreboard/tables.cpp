// The reference tables tests/reference/*.csv: kernels at corners of their domains, by the same template at 200 bits. Inputs are
// doubles, printed so that they come back to the bit; results have 30 digits.
//
//   tables FOLDER           writes them
//   tables --check FOLDER   1 unless they are what this program writes, and the kernels in double are within their bounds
//
// oracle.py computes the same from the documents' formulas, in mpmath, and shares no code with this.
#include <fstream>
#include <vector>

#include "contactlaws/contactlaws.hpp"
#include "contactlaws/damping/restitution.hpp"
#include "oracle.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

namespace {

using Rows = std::vector<std::vector<double>>;

/// Every combination of the values listed for each input.
Rows combinations(const Rows& corners) {
  Rows rows = {{}};
  for (const auto& values : corners) {
    Rows longer;
    for (const auto& row : rows)
      for (const double value : values) {
        longer.push_back(row);
        longer.back().push_back(value);
      }
    rows = longer;
  }
  return rows;
}

class Tables {
 public:
  Tables(const std::string& folder, bool check) : folder_(folder), check_(check) {}

  /// `kernel` maps a vector of any scalar to one; `bound` is what it may be off in double [ULP];
  /// of the components of a vector, `together`, in eps of the largest.
  template <class Kernel>
  void add(const std::string& name, const std::string& columns, const Rows& rows, double bound, const Kernel& kernel,
           bool together = false) {
    std::ostringstream text;
    text << columns << '\n';
    double worst = 0.0;
    for (const auto& row : rows) {
      const std::vector<Binary200> exact = kernel(std::vector<Binary200>(row.begin(), row.end()));
      const std::vector<double> computed = kernel(row);
      for (const double x : row) text << to_string(x) << ',';
      Binary200 largest = 0;
      for (const Binary200& x : exact) largest = maximum<Binary200>(largest, abs(x));
      for (std::size_t i = 0; i < exact.size(); ++i) {
        text << exact[i].str(30, std::ios_base::scientific) << (i + 1 < exact.size() ? ',' : '\n');
        const double off =
            static_cast<double>(abs(Binary200(computed[i]) - exact[i]) / (together ? largest : Binary200(1)));
        const double error = together ? off / std::numeric_limits<double>::epsilon() : ulps(computed[i], exact[i]);
        if (!(error <= worst)) worst = error;  // a NaN is seen
      }
    }
    const std::string path = folder_ + "/" + name + ".csv";
    if (!check_) {
      if (!(std::ofstream(path) << text.str())) fail(path + " cannot be written");
      return;
    }
    std::ostringstream committed;
    committed << std::ifstream(path).rdbuf();
    if (committed.str() != text.str()) fail(path + " is not what tables.cpp writes");
    if (!(worst <= bound))
      fail(path + ": in double off by " + to_string(worst) + " ULP, must not exceed " + to_string(bound));
    std::cout << path << ": in double off by " << worst << " ULP at most\n";
  }
  bool failed() const { return failed_; }

 private:
  void fail(const std::string& message) {
    std::cerr << message << '\n';
    failed_ = true;
  }

  std::string folder_;
  bool check_, failed_ = false;
};

template <class T>
PairProperties<T> pair_of(const T& radius, const T& young, const T& shear) {
  return {radius, young, shear, T(1), radius, radius};
}

void write(Tables& tables) {
  const std::vector<double> radii = {1e-6, 3e-3, 1.0}, moduli = {1e5, 14.8e9, 4e11};

  tables.add(
      "pair", "young1,poisson1,density1,radius1,young2,poisson2,density2,radius2,radius,young,shear,mass",
      combinations(
          {{1e5, 29e9}, {-0.999, 0.15, 0.5}, {2650}, {1e-6, 5e-3}, {29e9, 4e11}, {0.0, 0.3}, {500, 2e4}, {5e-3, 1.0}}),
      6.0, [](const auto& x) {
        using T = typename std::decay_t<decltype(x)>::value_type;
        const PairProperties<T> pair = pair_properties(sphere(ElasticMaterial<T>{x[0], x[1], x[2]}, x[3]),
                                                       sphere(ElasticMaterial<T>{x[4], x[5], x[6]}, x[7]));
        return std::vector<T>{pair.effective_radius, pair.effective_young, pair.effective_shear, pair.effective_mass};
      });

  tables.add("hertz", "radius,young,shear,overlap,force,stiffness,contact_radius,energy,shear_stiffness",
             combinations({radii, moduli, {4e4, 3.4e9}, {5e-324, 1e-310, 1e-200, 1e-12, 1e-6, 1e-4}}), 5.0,
             [](const auto& x) {
               using T = typename std::decay_t<decltype(x)>::value_type;
               const PairProperties<T> pair = pair_of<T>(x[0], x[1], x[2]);
               const HertzResponse<T> response = hertz_response<T>(pair, x[3]);
               return std::vector<T>{response.force, response.stiffness, response.contact_radius,
                                     hertz_energy<T>(pair, x[3]), Mindlin<T>{}.stiffness(pair, response)};
             });

  tables.add("linear", "modulus,min_radius,length,overlap,stiffness,force",
             combinations({moduli, {1e-6, 5e-3}, {7e-3, 12.5e-3}, {5e-324, 1e-12, 1e-4}}), 5.0, [](const auto& x) {
               using T = typename std::decay_t<decltype(x)>::value_type;
               typename LinearModulus<T>::State none;
               const auto response = LinearModulus<T>{x[0]}.respond(none, {T(1), T(1), T(1), T(1), x[1], x[2]}, x[3]);
               return std::vector<T>{response.stiffness, response.force};
             });

  tables.add("dashpots", "damping_constant,mass,stiffness,coefficient,stiffening",
             combinations({{1e-6, 0.07, 1.0, 3.0}, {1e-18, 1e-3, 1e6}, {1e-9, 1e7}}), 4.0, [](const auto& x) {
               using T = typename std::decay_t<decltype(x)>::value_type;
               const Dashpots<T> law{x[0]};
               return std::vector<T>{law.coefficients(x[1], x[2], x[2]).normal, law.stiffness_factor()};
             });

  // z = ln e / ..., whose ULPs count for more the smaller e is: 4 - 2 ln e, and a product.
  tables.add("restitution",
             "restitution,hertz_tension_allowed,hertz_tension_clipped,linear_tension_allowed,linear_tension_clipped",
             combinations({{1e-6, 0.01, 0.1, 0.13533528323661270, 0.14, 0.5, 0.9, 0.999999, 1.0}}), 34.0,
             [](const auto& x) {
               using T = typename std::decay_t<decltype(x)>::value_type;
               return std::vector<T>{damping_constant<T>(x[0], Spring::hertz, Tension::allowed),
                                     damping_constant<T>(x[0], Spring::hertz, Tension::clipped),
                                     damping_constant<T>(x[0], Spring::linear, Tension::allowed),
                                     damping_constant<T>(x[0], Spring::linear, Tension::clipped)};
             });

  // Short of rupture; the energy is a difference of exponentials, whose roundings count e^(2/0.5) times at most.
  tables.add("bridge", "suction,decay_length,rupture_gap,min_radius,overlap,force,energy",
             combinations({{1.0, 2e5}, {0.5, 2.0}, {2.0}, {5e-3}, {1e-4, 0.0, -1e-300, -1e-12, -1e-3, -9e-3}}), 60.0,
             [](const auto& x) {
               using T = typename std::decay_t<decltype(x)>::value_type;
               const SuctionBridge<T> bridge{x[0], x[1], x[2]};
               const PairProperties<T> pair = pair_of<T>(x[3], T(1), T(1));
               typename SuctionBridge<T>::State wet{T(2)};
               return std::vector<T>{bridge.respond(wet, pair, x[4]).force, bridge.energy(wet, pair, x[4])};
             });

  // From D_f and h: an error of p counts 3/2 p |ln(o/o_c) - 1| times, which is 50 at the smallest overlap and D_f = 3.
  const auto rough = [](const auto& x) {
    using T = typename std::decay_t<decltype(x)>::value_type;
    const auto law = PohrtPopovElastoPlastic<T>::of({x[0], x[1]});
    typename PohrtPopovElastoPlastic<T>::State state{x[5]};
    const auto response = law.respond(state, pair_of<T>(x[2], x[3], T(1)), x[4]);
    return std::vector<T>{law.transition_overlap, response.force, response.stiffness};
  };
  const std::string columns =
      "fractal_dimension,roughness,radius,young,overlap,largest_overlap,transition_overlap,force,stiffness";
  tables.add(
      "pohrt_popov_virgin", columns,
      combinations({{2.0, 2.13, 3.0}, {1e-7, 26.1e-6}, {2.36e-3, 1.0}, {1e9, 32e9}, {1e-9, 1e-6, 1e-5, 1e-3}, {0.0}}),
      60.0, rough);
  // Unloading subtracts from d(o_m), which is as far off, and leaves a tenth of it or more, or nothing at all.
  Rows unloading;
  for (const double overlap : {1e-5, 1e-4, 1e-3})
    for (const double share : {1.0078125, 1.125, 2.0})
      for (const auto& row :
           combinations({{2.0, 2.13, 3.0}, {1e-7, 26.1e-6}, {2.36e-3}, {32e9}, {overlap}, {overlap * share}}))
        unloading.push_back(row);
  tables.add("pohrt_popov_unloading", columns, unloading, 60.0, rough);

  // The vectors are computed in 200 bits and rounded: the same doubles from every compiler.
  using Exact = Vec3<Binary200>;
  const auto shares = [](int x, int y, int z) { return Exact(Exact(x, y, z) / Binary200(25)); };
  Rows turns;
  for (const auto& [last, along] : {std::pair{shares(25, 0, 0), shares(0, 25, 0)},
                                    {shares(0, 15, 20), shares(0, 20, -15)},
                                    {shares(9, -12, 20), shares(20, 15, 0)}})
    for (const auto& x : combinations({{0.0, 1e-9, 0.3}, {-0.2, 0.0}, {0.5, -3.0}, {0.0, 1e-9, 0.5}})) {
      const Exact across = last.cross(along), shear = along + Binary200(x[2]) * across;
      const Exact turned = last + Binary200(x[0]) * along + Binary200(x[1]) * across;
      const Exact normal = turned / norm<Binary200>(turned);
      std::vector<double> row;
      for (const Exact& v : {last, normal, shear})
        for (int i = 0; i < 3; ++i) row.push_back(static_cast<double>(v[i]));
      row.push_back(x[3]);
      turns.push_back(row);
    }
  tables.add(
      "rotation_rotate",
      "last_x,last_y,last_z,normal_x,normal_y,normal_z,shear_x,shear_y,shear_z,twist,carried_x,carried_y,carried_z",
      turns, 6.0,
      [](const auto& x) {
        using T = typename std::decay_t<decltype(x)>::value_type;
        typename rotation::Rotate<T>::State state{{x[0], x[1], x[2]}};
        const Vec3<T> carried = rotation::Rotate<T>::apply(state, {x[6], x[7], x[8]}, {x[3], x[4], x[5]}, x[9]);
        return std::vector<T>{carried.x(), carried.y(), carried.z()};
      },
      true);
}

}  // namespace

int main(int argc, char** argv) {
  const bool check = argc == 3 && argv[1] == std::string("--check");
  if (argc != 2 && !check) {
    std::cerr << "tables [--check] FOLDER\n";
    return 2;
  }
  Tables tables(argv[argc - 1], check);
  write(tables);
  return tables.failed();
}
