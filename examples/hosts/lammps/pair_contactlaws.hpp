// SPDX-License-Identifier: GPL-2.0-only
// pair_style contactlaws/NAME: any contact law of contactlaws as a pair style of LAMMPS.
//
//   pair_style contactlaws/NAME [packs|scalar]
//   pair_coeff I J [young E] [poisson nu] [NAME VALUE]...
//
// young and poisson are those of a type: give them where I and J are the same. Every pair of types has parameters of its own;
// commands add up, and are checked where a run starts. `restitution e` sets the damping constant. `wet GAP` wets, where the
// next run starts, every contact of these types with a gap up to GAP.
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

#include "../laws.hpp"
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

// Functions that LAMMPS renamed in 2022; a header that came with the same releases tells them apart.
#if __has_include("label_map.h")
#define CONTACTLAWS_LAMMPS_2023 1
#else
#define CONTACTLAWS_LAMMPS_2023 0
#endif

namespace contactlaws {

template <class Parameters>
class PairContactLaws : public LAMMPS_NS::Pair {
  using Law = LawOf<Parameters>;
  using Pack = typename PackOf<double>::type;
  static constexpr bool bridges = decltype(Law::bridge)::acts;
  static constexpr bool yields = detail::yields<decltype(Law::normal)>;
  static_assert(Law::state_size > 0, "a law without history needs no fix NEIGH_HISTORY");
  static_assert(!Law::outlives_separation, "LAMMPS forgets pairs that have separated");

  using Row = double[3];
  /// LAMMPS's arrays by atom, each in one piece: row j without the pointer that LAMMPS keeps to it.
  struct Atoms {
    const Row *x, *v, *spin;
    Row *force, *torque;
    const double *radius, *mass;
    int owned, newton;
  };
  /// A copy of atom i of the neighbour list, which stays in registers: no store of a force can change it.
  struct Centre {
    Centre(const Atoms& atoms, int i)
        : x{atoms.x[i][0], atoms.x[i][1], atoms.x[i][2]},
          v{atoms.v[i][0], atoms.v[i][1], atoms.v[i][2]},
          spin{atoms.spin[i][0], atoms.spin[i][1], atoms.spin[i][2]},
          radius(atoms.radius[i]),
          mass(atoms.mass[i]) {}
    double x[3], v[3], spin[3], radius, mass;
  };
  /// Force and torque of atom i, in registers while its contacts follow each other.
  struct Sum {
    Sum(const Atoms& atoms, int i)
        : i(i),
          force{atoms.force[i][0], atoms.force[i][1], atoms.force[i][2]},
          torque{atoms.torque[i][0], atoms.torque[i][1], atoms.torque[i][2]} {}
    void store(const Atoms& atoms) const {
      for (int d = 0; d < 3; ++d) atoms.force[i][d] = force[d];
      for (int d = 0; d < 3; ++d) atoms.torque[i][d] = torque[d];
    }
    int i;
    double force[3], torque[3];
  };
  struct Heat {
    double friction, dashpots, yielding;  ///< [J]
  };
  struct Contact {
    int i, j;         ///< atoms: bodies 1 and 2
    int* touch;       ///< 1: it has a history
    double* history;  ///< Law::state_size values
  };
  struct TypePair {
    Parameters parameters;
    Law law;
    EffectiveModuli<double> moduli{1.0, 1.0};  ///< not read by laws of linear springs
    double wet_gap = -1.0;                     ///< < 0: wets nothing [m]
    ContactBlock<Law> block;
    std::array<Contact, ContactBlock<Law>::capacity> contacts;  ///< those in the block
  };

 public:
  explicit PairContactLaws(LAMMPS_NS::LAMMPS* lammps) : Pair(lammps) {
    restartinfo = 1;
    single_enable = 1;
    single_extra = 6;
    svector = new double[6]();
    nextra = 3;
    pvector = new double[3]();
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
          or_fail(
              [&] {
                if (name == "young" || name == "poisson") {
                  if (i_low != j_low || i_high != j_high)
                    reject(name + " is that of a type: give it where I and J are the same");
                  set_parameter(materials_[std::size_t(i)], name, value);
                } else {
                  set(of_types(i, j), name, value);
                }
              },
              i, j);
        }
        setflag[i][j] = 1;
        any = true;
      }
    }
    if (!any) fail("pair_coeff names no pair of types: give I <= J");
  }

  void init_style() override {
    if (atom->radius_flag == 0 || atom->rmass_flag == 0 || atom->omega_flag == 0 || atom->torque_flag == 0)
      fail("atoms need a radius, mass, spin and torque: atom_style sphere");
    if (comm->ghost_velocity == 0) fail("ghost atoms need velocities: comm_modify vel yes");

    for (int i = 1; i <= atom->ntypes; ++i)
      for (int j = i; j <= atom->ntypes; ++j)
        if (setflag[i][j] != 0) or_fail([&] { of_types(i, j).law = make_law(of_types(i, j).parameters); }, i, j);

    // A list of touching spheres, or one that reaches as far as a bridge does.
    bool reaches = false;
    if constexpr (bridges)
      for (const TypePair& pair : pairs_) reaches = reaches || pair.law.bridge.suction > 0.0;
    request_list(!reaches);
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
    if (spring_of<Parameters> == Spring::hertz)
      or_fail([&] { pair.moduli = given_moduli(materials_[std::size_t(i)], materials_[std::size_t(j)]); }, i, j);
    const double r1 = largest_radii_[std::size_t(i)], r2 = largest_radii_[std::size_t(j)];
    if (r1 == 0.0 || r2 == 0.0) return r1 + r2;
    return r1 + r2 + pair.law.interaction_range(sphere_sphere_pair<double>(pair.moduli, r1, r2, 1.0));
  }

  void compute(int energy_flag, int virial_flag) override {
    ev_init(energy_flag, virial_flag);
    if (rigid_ != nullptr && neighbor->ago == 0) find_body_masses();
    if (packs_ != 0) {
      step_all<Pack>();
    } else {
      step_all<double>();
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
    const PairProperties<double> pair = properties_of(types, masses(), i, j);
    const auto step = types.law.step(pair, contact.kinematics, Law::load(values));
    for (int k = 0; k < 3; ++k) svector[k] = -step.shear_force[k];
    svector[3] = norm<double>(step.shear_force);
    svector[4] = step.normal_force;
    svector[5] = step.bridge_force;
    force_over_distance = (step.normal_force - step.bridge_force) / contact.distance;
    return types.law.stored_energy(pair, contact.kinematics.overlap, step.state);
  }

  // Both forms of LAMMPS's virtual function, hence without `override`.
  virtual void transfer_history(double* source, double* target) {
    std::copy_n(source, Law::state_size, target);
    Law::exchange_bodies(target);
  }
  virtual void transfer_history(double* source, double* target, int, int) { transfer_history(source, target); }

  void write_restart(FILE* file) override {
    std::fwrite(&packs_, sizeof(packs_), 1, file);
    std::fwrite(materials_.data(), sizeof(materials_[0]), materials_.size(), file);
    for (int i = 1; i <= atom->ntypes; ++i)
      for (int j = i; j <= atom->ntypes; ++j) {
        std::fwrite(&setflag[i][j], sizeof(int), 1, file);
        std::fwrite(&of_types(i, j).parameters, sizeof(Parameters), 1, file);
        std::fwrite(&of_types(i, j).wet_gap, sizeof(double), 1, file);
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
        read(file, &pair.wet_gap, sizeof(double));
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
  /// Asks for a list of touching spheres with history, or for one that reaches as far as the cutoff.
  void request_list(bool touching) {
#if CONTACTLAWS_LAMMPS_2023
    using namespace LAMMPS_NS::NeighConst;
    neighbor->add_request(this, touching ? REQ_SIZE | REQ_HISTORY : REQ_DEFAULT);
#else
    const int request = neighbor->request(this, instance_me);
    neighbor->requests[request]->size = touching;
    neighbor->requests[request]->history = touching;
#endif
  }

  /// The library's complaint about a pair of types becomes LAMMPS's error.
  template <class Action>
  void or_fail(const Action& action, int i, int j) const {
    try {
      action();
    } catch (const std::invalid_argument& complaint) {
      fail("types " + std::to_string(i) + " " + std::to_string(j) + ": " + complaint.what());
    }
  }

  void allocate() {
    allocated = 1;
    const int n = atom->ntypes + 1;
    memory->create(setflag, n, n, "pair:setflag");
    memory->create(cutsq, n, n, "pair:cutsq");
    for (int i = 1; i < n; ++i)
      for (int j = i; j < n; ++j) setflag[i][j] = 0;
    materials_.assign(std::size_t(n), no_material());
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
    } else {
      set_law_parameter(pair.parameters, name, value);
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
#if CONTACTLAWS_LAMMPS_2023
    comm->forward_comm(this);
#else
    comm->forward_comm_pair(this);
#endif
  }

  /// Masses of a contact's bodies. Beside a frozen atom both count as twice the other's, so that m* is the other's mass.
  struct Masses {
    double m1, m2;
  };
  Masses masses_of(double m1, double m2, const Contact& contact) const {
    if (frozen_ != 0) {
      if ((atom->mask[contact.i] & frozen_) != 0) return {2.0 * m2, 2.0 * m2};
      if ((atom->mask[contact.j] & frozen_) != 0) return {2.0 * m1, 2.0 * m1};
    }
    return {m1, m2};
  }
  PairProperties<double> properties_of(const TypePair& pair, const double* mass, int i, int j) const {
    const Masses masses = masses_of(mass[i], mass[j], {i, j, nullptr, nullptr});
    return sphere_sphere_pair<double>(pair.moduli, atom->radius[i], atom->radius[j],
                                      effective_mass<double>(masses.m1, masses.m2));
  }
  const double* masses() const { return rigid_ == nullptr ? atom->rmass : body_masses_.data(); }

  /// History of atom j in the list of atom i, or null.
  const double* find_history(int i, int j) const {
    if (i >= atom->nlocal || list == nullptr) return nullptr;
    for (int k = 0; k < list->numneigh[i]; ++k)
      if ((list->firstneigh[i][k] & NEIGHMASK) == j) return &history_->firstvalue[i][k * int(Law::state_size)];
    return nullptr;
  }

  /// Steps the contacts of the neighbour list: one by one, or collected in blocks.
  template <class Number>
  void step_all() {
    const double dt = update->setupflag != 0 ? 0.0 : update->dt;
    const auto rows = [](double** array) { return array == nullptr ? nullptr : reinterpret_cast<Row*>(array[0]); };
    const Atoms atoms{rows(atom->x), rows(atom->v), rows(atom->omega), rows(atom->f),     rows(atom->torque),
                      atom->radius,  masses(),      atom->nlocal,      force->newton_pair};
    const int* const type = atom->type;
    Heat heat{0.0, 0.0, 0.0};
    yielding_of_closed_ = 0.0;
    for (int n = 0; n < list->inum; ++n) {
      const int i = list->ilist[n], neighbours = list->numneigh[i];
      const int* const neighbour = list->firstneigh[i];
      int* const touches = history_->firstflag[i];
      double* const histories = history_->firstvalue[i];
      TypePair* const* const pair_of = &pair_of_types_[std::size_t(type[i] * (atom->ntypes + 1))];
      const Centre centre(atoms, i);
      [[maybe_unused]] Sum sum(atoms, i);
      for (int k = 0; k < neighbours; ++k) {
        const int j = neighbour[k] & NEIGHMASK;
        const double* const xj = atoms.x[j];
        const double dx = xj[0] - centre.x[0], dy = xj[1] - centre.x[1], dz = xj[2] - centre.x[2];
        const double square = dx * dx + dy * dy + dz * dz, reach = centre.radius + atoms.radius[j];
        TypePair& pair = *pair_of[type[j]];
        const Contact contact{i, j, touches + k, histories + k * int(Law::state_size)};
        if constexpr (bridges)
          if (pair.wet_gap >= 0.0) wet(pair, contact, reach - std::sqrt(square));
        if (square >= reach * reach && *contact.touch == 0) continue;
        if constexpr (std::is_same_v<Number, double>) {
          step(atoms, pair, contact, centre, dt, sum, heat);
        } else {
          collect(atoms, pair, contact, centre);
          if (pair.block.count == pair.block.capacity) step_block<Number>(atoms, pair, dt, heat);
        }
      }
      if constexpr (std::is_same_v<Number, double>) sum.store(atoms);
    }
    for (TypePair& pair : pairs_) {
      if (pair.block.count > 0) step_block<Number>(atoms, pair, dt, heat);
      pair.wet_gap = -1.0;
    }
    pvector[0] += heat.friction;
    pvector[1] += heat.dashpots;
    yielding_of_opened_ += heat.yielding;
    if (eflag_either != 0) pvector[2] = yielding_of_opened_ + yielding_of_closed_;
  }

  void wet(const TypePair& pair, const Contact& contact, double overlap) const {
    if (-overlap > pair.wet_gap) return;
    typename Law::State state = Law::load(contact.history);
    Law::make_wet(state, overlap, pair.wet_gap);
    Law::store(state, contact.history);
    *contact.touch = 1;  // it has a history
  }

  CONTACTLAWS_INLINE void step(const Atoms& atoms, const TypePair& pair, const Contact& contact, const Centre& one,
                               double dt, Sum& sum, Heat& heat) {
    const int j = contact.j;
    const double rj = atoms.radius[j];
    const SphereContact<double> spheres =
        sphere_contact<double>(one.x, one.v, one.spin, one.radius, atoms.x[j], atoms.v[j], atoms.spin[j], rj, dt);
    const Masses masses = masses_of(one.mass, atoms.mass[j], contact);
    const auto properties =
        sphere_sphere_pair<double>(pair.moduli, one.radius, rj, effective_mass<double>(masses.m1, masses.m2));
    const auto step = pair.law.step(properties, spheres.kinematics, Law::load(contact.history));
    if constexpr (yields)
      if (!step.active) heat.yielding += share_of(contact) * yielding(pair, properties, contact);
    store(contact, step.active, step.state);
    const Torques<double> turning = torques<double>(spheres, step.force, step.couple);
    add(atoms, contact, step.force, turning.on1, turning.on2, step.friction_work, step.dashpot_work, sum, heat);
    if (evflag != 0) tally(pair, contact, step.force);
  }

  CONTACTLAWS_INLINE void collect(const Atoms& atoms, TypePair& pair, const Contact& contact, const Centre& one) {
    ContactBlock<Law>& block = pair.block;
    const std::size_t c = block.count++;
    pair.contacts[c] = contact;
    const int j = contact.j;
    const Masses masses = masses_of(one.mass, atoms.mass[j], contact);
    block.mass1[c] = masses.m1;
    block.mass2[c] = masses.m2;
    block.radius1[c] = one.radius;
    block.radius2[c] = atoms.radius[j];
    const double *xj = atoms.x[j], *vj = atoms.v[j], *wj = atoms.spin[j];
    for (std::size_t d = 0; d < 3; ++d) {
      block.branch[d][c] = xj[d] - one.x[d];
      block.velocity[d][c] = vj[d] - one.v[d];
      block.spin1[d][c] = one.spin[d];
      block.spin2[d][c] = wj[d];
    }
    for (std::size_t s = 0; s < Law::state_size; ++s) block.state[s][c] = contact.history[s];
  }

  template <class Number>
  void step_block(const Atoms& atoms, TypePair& pair, double dt, Heat& total) {
    ContactBlock<Law>& block = pair.block;
    block.template step<Number>(pair.law, pair.moduli, dt);
    const std::size_t count = block.count;
    Heat heat = total;
    for (std::size_t c = 0; c < count;) {
      const int i = pair.contacts[c].i;
      Sum sum(atoms, i);
      for (; c < count && pair.contacts[c].i == i; ++c) {
        const Contact& contact = pair.contacts[c];
        const bool active = block.active[c] != 0.0;
        if constexpr (yields)
          if (!active)
            heat.yielding +=
                share_of(contact) * yielding(pair, properties_of(pair, atoms.mass, contact.i, contact.j), contact);
        store(contact, active, block.state_of(c));
        const double on_j[3] = {block.force[0][c], block.force[1][c], block.force[2][c]};
        const double turns_i[3] = {block.torque1[0][c], block.torque1[1][c], block.torque1[2][c]};
        const double turns_j[3] = {block.torque2[0][c], block.torque2[1][c], block.torque2[2][c]};
        add(atoms, contact, on_j, turns_i, turns_j, block.friction_work[c], block.dashpot_work[c], sum, heat);
        if (evflag != 0) tally(pair, contact, on_j);
      }
      sum.store(atoms);
    }
    block.count = 0;
    total = heat;
  }

  /// Heat of yielding since the contact was new, as its stored history has it [J].
  static double yielding(const TypePair& pair, const PairProperties<double>& properties, const Contact& contact) {
    return pair.law.normal.plastic_dissipation(Law::load(contact.history), properties);
  }
  /// What this rank counts of a contact's energies: half, where the owner of atom j counts the other half.
  double share_of(const Contact& contact) const {
    return force->newton_pair != 0 || contact.j < atom->nlocal ? 1.0 : 0.5;
  }

  /// The history of a contact after its step; LAMMPS forgets that of one which is not active.
  CONTACTLAWS_INLINE static void store(const Contact& contact, bool active, const typename Law::State& state) {
    *contact.touch = active;
    Law::store(state, contact.history);
    if (!active) std::fill_n(contact.history, Law::state_size, 0.0);
  }

  /// Adds a contact's force and torques to those of its atoms, and its heat to the sums.
  template <class Vector>
  CONTACTLAWS_INLINE void add(const Atoms& atoms, const Contact& contact, const Vector& on_j, const Vector& turns_i,
                              const Vector& turns_j, double friction, double dashpots, Sum& on_i, Heat& heat) {
    const bool both = atoms.newton != 0 || contact.j < atoms.owned;
    for (int d = 0; d < 3; ++d) on_i.force[d] -= on_j[d];
    for (int d = 0; d < 3; ++d) on_i.torque[d] += turns_i[d];
    if (both) {
      double *const fj = atoms.force[contact.j], *const tj = atoms.torque[contact.j];
      for (int d = 0; d < 3; ++d) fj[d] += on_j[d];
      for (int d = 0; d < 3; ++d) tj[d] += turns_j[d];
    }
    const double share = both ? 1.0 : 0.5;  // the owner of atom j counts the other half
    heat.friction += share * friction;
    heat.dashpots += share * dashpots;
  }

  /// Adds energy and virial; after the history is stored.
  template <class Vector>
  void tally(const TypePair& pair, const Contact& contact, const Vector& on_j) {
    const int i = contact.i, j = contact.j;
    const double *xi = atom->x[i], *xj = atom->x[j], ri = atom->radius[i], rj = atom->radius[j];
    const Vec3<double> branch(xj[0] - xi[0], xj[1] - xi[1], xj[2] - xi[2]);
    double energy = 0.0;
    if (eflag_either != 0) {
      const PairProperties<double> properties = properties_of(pair, masses(), i, j);
      energy = pair.law.stored_energy(properties, ri + rj - norm<double>(branch), Law::load(contact.history));
      if constexpr (yields) yielding_of_closed_ += share_of(contact) * yielding(pair, properties, contact);
    }
    ev_tally_xyz(i, j, atom->nlocal, force->newton_pair, energy, 0.0, on_j[0], on_j[1], on_j[2], branch[0], branch[1],
                 branch[2]);
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
  // Heat of yielding [J]: of contacts that have opened, and of those that touch, in a step that counts energies.
  double yielding_of_opened_ = 0.0, yielding_of_closed_ = 0.0;
};

}  // namespace contactlaws
