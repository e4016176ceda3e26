// SPDX-License-Identifier: GPL-2.0-only
// pair_style contactlaws/NAME: any contact law of contactlaws as a pair style of LAMMPS.
//
//   pair_style contactlaws/NAME [packs|scalar]
//   pair_coeff I J [young E] [poisson nu] [NAME VALUE]...
//
// young and poisson are those of a type: give them where I and J are the same. Every pair of types has parameters of its own;
// commands add up. `restitution e` sets the damping constant of a Hertz contact. `wet GAP` wets, where the next run starts,
// every contact of these types with a gap up to GAP.
//
// Body 1 is LAMMPS's atom i, body 2 atom j. History lives in fix NEIGH_HISTORY; a pair that changes its owner is transferred
// with bodies swapped. A set-up pass has dt = 0, so that it returns the last step's force and leaves the history as it is.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "contact_block.hpp"
#include "error.h"
#include "fix.h"
#include "fix_neigh_history.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neigh_request.h"
#include "neighbor.h"
#include "pair.h"
#include "update.h"
#include "utils.h"

namespace contactlaws {

/// The law of checked parameters: those of a maker, or of the law itself.
inline RoughBallast<double> make_law(const RoughBallastProperties<double>& properties) {
  return rough_ballast(properties);
}
template <class... Slots>
ContactLaw<Slots...> make_law(const ContactLaw<Slots...>& law) {
  return checked(law);
}

template <class Parameters>
class PairContactLaws : public LAMMPS_NS::Pair {
  using Law = decltype(make_law(Parameters()));
  using Pack = typename PackOf<double>::type;
  static constexpr bool bridges = decltype(Law::bridge)::acts;
  static_assert(Law::state_size > 0, "a law without history needs no fix NEIGH_HISTORY");
  static_assert(!Law::outlives_separation, "LAMMPS forgets pairs that have separated");

  struct TypePair {
    Parameters parameters;
    Law law;
    EffectiveModuli<double> moduli;
    double wet_gap = -1.0;  ///< < 0: wets nothing [m]
    ContactBlock<Law> block;
    // of each contact in the block
    std::array<int, ContactBlock<Law>::capacity> i, j;
    std::array<int*, ContactBlock<Law>::capacity> touch;
    std::array<double*, ContactBlock<Law>::capacity> history;
  };

 public:
  explicit PairContactLaws(LAMMPS_NS::LAMMPS* lammps) : Pair(lammps) {
    restartinfo = 1;
    single_enable = 1;
    single_extra = 6;
    svector = new double[6]();
    nextra = 2;
    pvector = new double[2]();
    finitecutflag = 1;
    no_virial_fdotr_compute = 1;
    centroidstressflag = LAMMPS_NS::CENTROID_NOTAVAIL;
    nondefault_history_transfer = 1;
    beyond_contact = bridges;
    comm_forward = 1;
    // The fix must stand before those that move atoms, such as fix pour: a placeholder keeps its place until init_style().
    modify->add_fix(placeholder_id() + " all DUMMY");
  }
  ~PairContactLaws() override {
    delete[] svector;
    delete[] pvector;
    modify->delete_fix(history_ == nullptr ? placeholder_id() : history_id());
    if (allocated == 0) return;
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }

  void settings(int count, char** words) override {
    packs_ = 1;
    if (count == 0) return;
    const std::string word = words[0];
    if (count > 1 || (word != "packs" && word != "scalar"))
      fail("the style takes one word, packs or scalar, not '" + word + "'");
    packs_ = word == "packs";
  }

  void coeff(int count, char** words) override {
    if (count < 4 || count % 2 != 0) fail("pair_coeff takes I J and pairs of a name and a value");
    if (allocated == 0) allocate();
    int i_low, i_high, j_low, j_high;
    LAMMPS_NS::utils::bounds(FLERR, words[0], 1, atom->ntypes, i_low, i_high, error);
    LAMMPS_NS::utils::bounds(FLERR, words[1], 1, atom->ntypes, j_low, j_high, error);
    bool any = false;
    for (int i = i_low; i <= i_high; ++i) {
      for (int j = std::max(j_low, i); j <= j_high; ++j) {
        for (int k = 2; k < count; k += 2) {
          const std::string name = words[k];
          const double value = LAMMPS_NS::utils::numeric(FLERR, words[k + 1], false, lmp);
          or_fail([&] {
            if (name == "young" || name == "poisson") {
              if (i_low != j_low || i_high != j_high) reject(name + " is that of a type: give it where I and J are the same");
              set_parameter(materials_[std::size_t(i)], name, value);
            } else {
              set(of_types(i, j), name, value);
            }
          });
        }
        or_fail([&] { of_types(i, j).law = make_law(of_types(i, j).parameters); });
        setflag[i][j] = 1;
        any = true;
      }
      or_fail([&] {
        if (materials_[std::size_t(i)].young != 0.0) checked(materials_[std::size_t(i)]);
      });
    }
    if (!any) fail("pair_coeff names no pair of types: give I <= J");
  }

  void init_style() override {
    if (atom->radius_flag == 0 || atom->rmass_flag == 0 || atom->omega_flag == 0 || atom->torque_flag == 0)
      fail("atoms need a radius, mass, spin and torque: atom_style sphere");
    if (comm->ghost_velocity == 0) fail("ghost atoms need velocities: comm_modify vel yes");

    // A list of touching spheres, or one that reaches as far as a bridge does.
    bool reaches = false;
    if constexpr (bridges)
      for (const TypePair& pair : pairs_) reaches = reaches || pair.law.bridge.suction > 0.0;
    const int request = neighbor->request(this, instance_me);
    neighbor->requests[request]->size = !reaches;
    neighbor->requests[request]->history = !reaches;
    if (history_ == nullptr) {
      history_ = static_cast<LAMMPS_NS::FixNeighHistory*>(modify->replace_fix(
          placeholder_id().c_str(), history_id() + " all NEIGH_HISTORY " + std::to_string(Law::state_size), 1));
      history_->pair = this;
    }
    history_->use_bit_flag = !reaches;

    frozen_ = 0;
    rigid_ = nullptr;
    for (int k = 0; k < modify->nfix; ++k) {
      LAMMPS_NS::Fix* fix = modify->fix[k];
      if (std::strcmp(fix->style, "freeze") == 0) frozen_ = fix->groupbit;
      if (fix->rigid_flag != 0) rigid_ = fix;
    }
    find_largest_radii();
  }

  double init_one(int i, int j) override {
    if (setflag[i][j] == 0) fail("no pair_coeff of types " + std::to_string(i) + " " + std::to_string(j));
    TypePair& pair = of_types(i, j);
    or_fail([&] { pair.moduli = effective_moduli(materials_[std::size_t(i)], materials_[std::size_t(j)]); });
    const double r1 = largest_radii_[std::size_t(i)], r2 = largest_radii_[std::size_t(j)];
    if (r1 == 0.0 || r2 == 0.0) return r1 + r2;
    return r1 + r2 + pair.law.interaction_range(sphere_sphere_pair<double>(pair.moduli, r1, r2, 1.0));
  }

  void compute(int energy_flag, int virial_flag) override {
    ev_init(energy_flag, virial_flag);
    if (rigid_ != nullptr && neighbor->ago == 0) find_body_masses();
    if (packs_ != 0) {
      collect<Pack>();
    } else {
      collect<double>();
    }
  }

  /// As fforce: normal force over distance. Extra: shear force on atom i, its magnitude, normal force, pull of the bridge [N].
  double single(int i, int j, int, int, double, double, double, double& force_over_distance) override {
    const TypePair& types = of_types(atom->type[i], atom->type[j]);
    double values[Law::state_size] = {};
    if (const double* found = find_history(i, j)) {
      std::copy_n(found, Law::state_size, values);
    } else if (const double* other = j < atom->nlocal ? find_history(j, i) : nullptr) {
      std::copy_n(other, Law::state_size, values);
      Law::exchange_bodies(values);
    }
    const SphereContact<double> contact =
        sphere_contact<double>(atom->x[i], atom->v[i], atom->omega[i], atom->radius[i], atom->x[j], atom->v[j],
                               atom->omega[j], atom->radius[j], 0.0);
    const PairProperties<double> pair =
        sphere_sphere_pair<double>(types.moduli, atom->radius[i], atom->radius[j], mass_of(i, j));
    const auto step = types.law.step(pair, contact.kinematics, Law::load(values));
    for (int k = 0; k < 3; ++k) svector[k] = -step.shear_force[k];
    svector[3] = norm<double>(step.shear_force);
    svector[4] = step.normal_force;
    svector[5] = step.bridge_force;
    force_over_distance = (step.normal_force - step.bridge_force) / contact.distance;
    return types.law.stored_energy(pair, contact.kinematics.overlap, step.state);
  }

  void transfer_history(double* source, double* target) override {
    std::copy_n(source, Law::state_size, target);
    Law::exchange_bodies(target);
  }

  void write_restart(FILE* file) override {
    std::fwrite(&packs_, sizeof(packs_), 1, file);
    std::fwrite(materials_.data(), sizeof(materials_[0]), materials_.size(), file);
    for (int i = 1; i <= atom->ntypes; ++i)
      for (int j = i; j <= atom->ntypes; ++j) {
        std::fwrite(&setflag[i][j], sizeof(int), 1, file);
        std::fwrite(&of_types(i, j).parameters, sizeof(Parameters), 1, file);
      }
  }
  void read_restart(FILE* file) override {
    static_assert(std::is_trivially_copyable_v<Parameters>);
    allocate();
    read(file, &packs_, sizeof(packs_));
    read(file, materials_.data(), sizeof(materials_[0]) * materials_.size());
    for (int i = 1; i <= atom->ntypes; ++i)
      for (int j = i; j <= atom->ntypes; ++j) {
        TypePair& pair = of_types(i, j);
        read(file, &setflag[i][j], sizeof(int));
        read(file, static_cast<void*>(&pair.parameters), sizeof(Parameters));
        if (setflag[i][j] != 0) or_fail([&] { pair.law = make_law(pair.parameters); });
      }
  }

  int pack_forward_comm(int count, int* atoms, double* buffer, int, int*) override {
    for (int k = 0; k < count; ++k) buffer[k] = body_masses_[std::size_t(atoms[k])];
    return count;
  }
  void unpack_forward_comm(int count, int first, double* buffer) override {
    std::copy_n(buffer, count, body_masses_.begin() + first);
  }

 private:
  std::string placeholder_id() const { return "CONTACTLAWS_PLACE_" + std::to_string(instance_me); }
  std::string history_id() const { return "CONTACTLAWS_HISTORY_" + std::to_string(instance_me); }

  [[noreturn]] void fail(const std::string& message) const {
    error->all(FLERR, std::string("Pair style contactlaws: ") + message);
    std::abort();
  }
  /// The library's complaint becomes LAMMPS's error.
  template <class Action>
  void or_fail(const Action& action) const {
    try {
      action();
    } catch (const std::invalid_argument& complaint) {
      fail(complaint.what());
    }
  }

  void allocate() {
    allocated = 1;
    const int n = atom->ntypes + 1;
    memory->create(setflag, n, n, "pair:setflag");
    memory->create(cutsq, n, n, "pair:cutsq");
    for (int i = 1; i < n; ++i)
      for (int j = i; j < n; ++j) setflag[i][j] = 0;
    materials_.assign(std::size_t(n), {0.0, 0.0, 1.0});
    pairs_.resize(std::size_t(n * (n - 1) / 2));
    pair_of_types_.assign(std::size_t(n * n), nullptr);
    std::size_t next = 0;
    for (int i = 1; i < n; ++i)
      for (int j = i; j < n; ++j)
        pair_of_types_[std::size_t(i * n + j)] = pair_of_types_[std::size_t(j * n + i)] = &pairs_[next++];
  }
  TypePair& of_types(int i, int j) { return *pair_of_types_[std::size_t(i * (atom->ntypes + 1) + j)]; }

  void set(TypePair& pair, const std::string& name, double value) {
    if (bridges && name == "wet") {
      require_in(Range::not_negative(), value, "pair_coeff", "wet", "m");
      pair.wet_gap = value;
    } else if (name == "restitution") {
      set_parameter(pair.parameters, "damping_constant", damping_constant(value, Spring::hertz, Tension::allowed));
    } else {
      set_parameter(pair.parameters, name, value);
    }
  }

  void read(FILE* file, void* values, std::size_t bytes) {
    if (comm->me == 0) LAMMPS_NS::utils::sfread(FLERR, values, 1, bytes, file, nullptr, error);
    MPI_Bcast(values, int(bytes), MPI_BYTE, 0, world);
  }

  /// Largest radius of each type, those included that fixes will insert.
  void find_largest_radii() {
    std::vector<double> largest(std::size_t(atom->ntypes + 1), 0.0);
    for (int i = 0; i < atom->nlocal; ++i) {
      double& r = largest[std::size_t(atom->type[i])];
      r = std::max(r, atom->radius[i]);
    }
    for (int k = 0; k < modify->nfix; ++k) {
      LAMMPS_NS::Fix* fix = modify->fix[k];
      if (std::strncmp(fix->style, "pour", 4) != 0 && std::strncmp(fix->style, "deposit", 7) != 0) continue;
      for (int type = 1; type <= atom->ntypes; ++type) {
        int changed_by_extract = type;
        const void* radius = fix->extract("radius", changed_by_extract);
        double& r = largest[std::size_t(type)];
        if (radius != nullptr) r = std::max(r, *static_cast<const double*>(radius));
      }
    }
    largest_radii_.resize(largest.size());
    MPI_Allreduce(largest.data(), largest_radii_.data(), int(largest.size()), MPI_DOUBLE, MPI_MAX, world);
  }

  /// Mass of each atom, or of the rigid body that it belongs to; ghosts too.
  void find_body_masses() {
    int dimension = 0;
    const int* body = static_cast<const int*>(rigid_->extract("body", dimension));
    const double* mass = static_cast<const double*>(rigid_->extract("masstotal", dimension));
    body_masses_.resize(std::size_t(atom->nmax));
    for (int i = 0; i < atom->nlocal; ++i)
      body_masses_[std::size_t(i)] = body != nullptr && body[i] >= 0 ? mass[body[i]] : atom->rmass[i];
    comm->forward_comm_pair(this);
  }

  /// Effective mass; a frozen atom counts as held in space.
  double mass_of(int i, int j) const {
    const double* mass = rigid_ == nullptr ? atom->rmass : body_masses_.data();
    if ((atom->mask[i] & frozen_) != 0) return mass[j];
    if ((atom->mask[j] & frozen_) != 0) return mass[i];
    return effective_mass<double>(mass[i], mass[j]);
  }

  /// History of atom j in the list of atom i, or null.
  const double* find_history(int i, int j) const {
    if (i >= atom->nlocal || list == nullptr) return nullptr;
    for (int k = 0; k < list->numneigh[i]; ++k)
      if ((list->firstneigh[i][k] & NEIGHMASK) == j) return &history_->firstvalue[i][k * int(Law::state_size)];
    return nullptr;
  }

  /// Collects the contacts of the neighbour list and steps them block by block.
  template <class Number>
  void collect() {
    const double dt = update->setupflag != 0 ? 0.0 : update->dt;
    double** const x = atom->x;
    double** const v = atom->v;
    double** const w = atom->omega;
    const double* const radius = atom->radius;
    for (int n = 0; n < list->inum; ++n) {
      const int i = list->ilist[n];
      int* const touches = history_->firstflag[i];
      double* const histories = history_->firstvalue[i];
      TypePair* const* const pair_of = &pair_of_types_[std::size_t(atom->type[i] * (atom->ntypes + 1))];
      const double xi[3] = {x[i][0], x[i][1], x[i][2]}, vi[3] = {v[i][0], v[i][1], v[i][2]};
      const double wi[3] = {w[i][0], w[i][1], w[i][2]}, ri = radius[i];
      for (int k = 0; k < list->numneigh[i]; ++k) {
        const int j = list->firstneigh[i][k] & NEIGHMASK;
        const double branch[3] = {x[j][0] - xi[0], x[j][1] - xi[1], x[j][2] - xi[2]};
        const double square = branch[0] * branch[0] + branch[1] * branch[1] + branch[2] * branch[2];
        const double reach = ri + radius[j];
        double* const history = histories + k * int(Law::state_size);
        TypePair& pair = *pair_of[atom->type[j]];
        if constexpr (bridges)
          if (pair.wet_gap >= 0.0 && square <= (reach + pair.wet_gap) * (reach + pair.wet_gap))
            touches[k] = wet(history, reach - std::sqrt(square), pair.wet_gap);
        if (square >= reach * reach && touches[k] == 0) continue;

        ContactBlock<Law>& block = pair.block;
        const std::size_t c = block.count++;
        pair.i[c] = i;
        pair.j[c] = j;
        pair.touch[c] = touches + k;
        pair.history[c] = history;
        for (std::size_t d = 0; d < 3; ++d) {
          block.branch[d][c] = branch[d];
          block.velocity[d][c] = v[j][d] - vi[d];
          block.spin1[d][c] = wi[d];
          block.spin2[d][c] = w[j][d];
        }
        block.radius1[c] = ri;
        block.radius2[c] = radius[j];
        block.mass[c] = mass_of(i, j);
        for (std::size_t s = 0; s < Law::state_size; ++s) block.state[s][c] = history[s];
        if (block.count == block.capacity) step<Number>(pair, dt);
      }
    }
    for (TypePair& pair : pairs_) {
      if (pair.block.count > 0) step<Number>(pair, dt);
      pair.wet_gap = -1.0;
    }
  }

  /// Wets a new contact, or one that is there; returns 1, "has a history".
  static int wet(double* history, double overlap, double gap) {
    typename Law::State state = Law::load(history);
    Law::make_wet(state, overlap, gap);
    Law::store(state, history);
    return 1;
  }

  /// Steps the contacts collected of a pair of types, and adds their forces.
  template <class Number>
  void step(TypePair& pair, double dt) {
    ContactBlock<Law>& block = pair.block;
    block.template step<Number>(pair.law, pair.moduli, dt);
    double** const f = atom->f;
    double** const torque = atom->torque;
    const int nlocal = atom->nlocal, newton = force->newton_pair;
    for (std::size_t c = 0; c < block.count; ++c) {
      const int i = pair.i[c], j = pair.j[c];
      const bool active = block.active[c] != 0.0, owned = newton != 0 || j < nlocal;
      *pair.touch[c] = active;
      for (std::size_t s = 0; s < Law::state_size; ++s) pair.history[c][s] = active ? block.state[s][c] : 0.0;
      for (std::size_t d = 0; d < 3; ++d) {
        f[i][d] -= block.force[d][c];
        torque[i][d] += block.torque1[d][c];
      }
      if (owned) {
        for (std::size_t d = 0; d < 3; ++d) {
          f[j][d] += block.force[d][c];
          torque[j][d] += block.torque2[d][c];
        }
      }
      const double share = owned ? 1.0 : 0.5;  // the other half is counted where j is owned
      pvector[0] += share * block.friction_work[c];
      pvector[1] += share * block.dashpot_work[c];
      if (evflag != 0) tally(pair, c);
    }
    block.count = 0;
  }

  void tally(const TypePair& pair, std::size_t c) {
    const ContactBlock<Law>& block = pair.block;
    const double x = block.branch[0][c], y = block.branch[1][c], z = block.branch[2][c];
    double energy = 0.0;
    if (eflag_either != 0)
      energy = pair.law.stored_energy(
          sphere_sphere_pair<double>(pair.moduli, block.radius1[c], block.radius2[c], block.mass[c]),
          block.radius1[c] + block.radius2[c] - std::sqrt(x * x + y * y + z * z), block.state_of(c));
    ev_tally_xyz(pair.i[c], pair.j[c], atom->nlocal, force->newton_pair, energy, 0.0, block.force[0][c],
                 block.force[1][c], block.force[2][c], x, y, z);
  }

  int packs_ = 1;
  std::vector<ElasticMaterial<double>> materials_;  ///< of each type, from 1 on
  std::vector<TypePair> pairs_;
  std::vector<TypePair*> pair_of_types_;
  std::vector<double> largest_radii_;  ///< of each type [m]
  std::vector<double> body_masses_;    ///< of each atom, where there are rigid bodies [kg]
  LAMMPS_NS::FixNeighHistory* history_ = nullptr;
  LAMMPS_NS::Fix* rigid_ = nullptr;
  int frozen_ = 0;  ///< group bit of fix freeze
};

}  // namespace contactlaws
