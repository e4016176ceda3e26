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
// Body 1 is LAMMPS's atom i, body 2 atom j. History and sums live in a fix NEIGH_HISTORY; a pair that changes its owner is transferred
// with bodies swapped. A set-up pass has dt = 0, so that it returns the last step's force and leaves the history as it is.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "contact_block.hpp"
#include "pair_of_spheres.hpp"
#include "type_pairs.hpp"

namespace contactlaws {

template <class Parameters>
class PairContactLaws : public PairOfSpheres {
  using Law = LawOf<Parameters>;
  using Pack = typename PackOf<double>::type;
  static constexpr bool bridges = has_bridge<Law>;
  static constexpr bool yields = detail::yields<decltype(Law::normal)>;
  static constexpr bool liquid = holds_liquid<Law>;
  static_assert(Law::state_size > 0, "a law without history needs no fix NEIGH_HISTORY");
  static_assert(!Law::outlives_separation, "LAMMPS forgets pairs that have separated");

  struct Types : TypePair<Parameters> {
    ContactBlock<Law> block;
    std::array<Contact, ContactBlock<Law>::capacity> contacts;  ///< those in the block
  };

 public:
  explicit PairContactLaws(LAMMPS_NS::LAMMPS* lammps) : PairOfSpheres(lammps, Law::state_size) {
    single_extra = 6;
    svector = new double[6]();
    nextra = liquid ? 5 : 3;
    pvector = new double[5]();
    beyond_contact = bridges || Law::adheres;
  }

  void settings(int count, char** words) override {
    packs_ = 1;
    if (count == 0) return;
    const std::string word = words[0];
    if (count > 1 || (word != "packs" && word != "scalar"))
      fail("the style takes one word, packs or scalar, not '" + word + "'");
    packs_ = word == "packs";
  }

  void init_style() override {
    check_atoms();
    largest_radii_ = largest_radii();
    find_frozen_and_rigid();
    double range = 0.0;
    for (int i = 1; i <= atom->ntypes; ++i)
      for (int j = i; j <= atom->ntypes; ++j)
        if (setflag[i][j] != 0) {
          or_fail([&] { types_.prepare(i, j); }, i, j);
          range = std::max(range, range_of(i, j));
        }
    // The list of spheres that touch reaches beyond touch by the skin. Twice the range of the largest spheres: bridges between smaller
    // ones reached up to 1.1 times as far (4000 random liquids).
    request_list(2.0 * range <= neighbor->skin);
  }

  double init_one(int i, int j) override {
    if (setflag[i][j] == 0) fail("no pair_coeff of types " + std::to_string(i) + " " + std::to_string(j));
    return largest_radii_[std::size_t(i)] + largest_radii_[std::size_t(j)] + range_of(i, j);
  }

  void compute(int energy_flag, int virial_flag) override {
    ev_init(energy_flag, virial_flag);
    find_body_masses();
    if (packs_ != 0) {
      step_all<Pack>();
    } else {
      step_all<double>();
    }
  }

  /// As fforce: normal force over distance. Extra: shear force on atom i, its magnitude, normal force, pull of the bridge [N].
  double single(int i, int j, int, int, double, double, double, double& force_over_distance) override {
    const Types& types = types_(atom->type[i], atom->type[j]);
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
    transfer_settings([file](void* values, std::size_t bytes) { std::fwrite(values, 1, bytes, file); });
  }
  void read_restart(FILE* file) override {
    allocate();
    transfer_settings([this, file](void* values, std::size_t bytes) { read(file, values, bytes); });
  }

 private:
  void allocate() override {
    PairOfSpheres::allocate();
    types_.resize(atom->ntypes);
  }
  void set(int i, int j, const std::string& name, double value) override { types_.set(i, j, name, value); }
  template <class Transfer>
  void transfer_settings(const Transfer& transfer) {
    transfer(&packs_, sizeof(packs_));
    for (int i = 1; i <= atom->ntypes; ++i)
      for (int j = i; j <= atom->ntypes; ++j) transfer(&setflag[i][j], sizeof(int));
    types_.transfer(transfer);
  }

  /// How far contacts of these types reach beyond touch [m]. Between the largest spheres: a bridge of a given volume between smaller ones
  /// may reach farther, but by less than their radii are smaller.
  double range_of(int i, int j) const {
    const double r1 = largest_radii_[std::size_t(i)], r2 = largest_radii_[std::size_t(j)];
    if (r1 == 0.0 || r2 == 0.0) return 0.0;
    const Types& types = types_(i, j);
    return types.law.interaction_range(sphere_sphere_pair<double>(types.moduli, r1, r2, 1.0));
  }
  PairProperties<double> properties_of(const Types& types, const double* mass, int i, int j) const {
    const Masses masses = masses_of(mass[i], mass[j], i, j);
    return sphere_sphere_pair<double>(types.moduli, atom->radius[i], atom->radius[j],
                                      effective_mass<double>(masses.m1, masses.m2));
  }

  /// Steps the contacts of the neighbour list: one by one, or collected in blocks.
  template <class Number>
  void step_all() {
    const double dt = update->setupflag != 0 ? 0.0 : update->dt;
    const Atoms atoms = this->atoms();
    const int* const type = atom->type;
    ContactSums gains;
    yielding_of_closed_ = liquid_in_bridges_ = 0.0;
    for (int n = 0; n < list->inum; ++n) {
      const int i = list->ilist[n], neighbours = list->numneigh[i];
      const int* const neighbour = list->firstneigh[i];
      int* const touches = history_->firstflag[i];
      double* const histories = history_->firstvalue[i];
      Types* const* const types_of = types_.of(type[i]);
      const Centre centre(atoms, i);
      [[maybe_unused]] Sum sum(atoms, i);
      for (int k = 0; k < neighbours; ++k) {
        const int j = neighbour[k] & NEIGHMASK;
        const double* const xj = atoms.x[j];
        const double dx = xj[0] - centre.x[0], dy = xj[1] - centre.x[1], dz = xj[2] - centre.x[2];
        const double square = dx * dx + dy * dy + dz * dz, reach = centre.radius + atoms.radius[j];
        Types& types = *types_of[type[j]];
        const Contact contact{i, j, touches + k, histories + k * int(Law::state_size)};
        if constexpr (bridges)
          if (types.wet_gap >= 0.0) wet(types, contact, reach - std::sqrt(square));
        if (square >= reach * reach && *contact.touch == 0) continue;
        if constexpr (std::is_same_v<Number, double>) {
          step(atoms, types, contact, centre, dt, sum, gains);
        } else {
          collect(atoms, types, contact, centre);
          if (types.block.count == types.block.capacity) step_block<Number>(atoms, types, dt, gains);
        }
      }
      if constexpr (std::is_same_v<Number, double>) sum.store(atoms);
    }
    for (Types& types : types_) {
      if constexpr (!std::is_same_v<Number, double>)
        if (types.block.count > 0) step_block<Number>(atoms, types, dt, gains);
      types.wet_gap = -1.0;
    }
    ContactSums& sums = history_->sums;
    pvector[0] = sums.friction += gains.friction;
    pvector[1] = sums.dashpots += gains.dashpots;
    sums.yielding += gains.yielding;
    pvector[4] = sums.returned += gains.returned;
    if (eflag_either == 0) return;
    pvector[2] = sums.yielding + yielding_of_closed_;
    pvector[3] = liquid_in_bridges_;
  }

  void wet(const Types& types, const Contact& contact, double overlap) const {
    if (-overlap > types.wet_gap) return;
    typename Law::State state = Law::load(contact.history);
    Law::make_wet(state, overlap, types.wet_gap);
    Law::store(state, contact.history);
    *contact.touch = 1;  // it has a history
  }

  CONTACTLAWS_INLINE void step(const Atoms& atoms, const Types& types, const Contact& contact, const Centre& one,
                               double dt, Sum& sum, ContactSums& gains) {
    const int j = contact.j;
    const double rj = atoms.radius[j];
    const SphereContact<double> spheres =
        sphere_contact<double>(one.x, one.v, one.spin, one.radius, atoms.x[j], atoms.v[j], atoms.spin[j], rj, dt);
    const Masses masses = masses_of(one.mass, atoms.mass[j], contact.i, j);
    const auto properties =
        sphere_sphere_pair<double>(types.moduli, one.radius, rj, effective_mass<double>(masses.m1, masses.m2));
    const auto step = types.law.step(properties, spheres.kinematics, Law::load(contact.history));
    if constexpr (yields)
      if (!step.active) gains.yielding += share_of(contact) * yielding(types, properties, contact);
    store(contact, step.active, step.state, gains);
    const Torques<double> turning = torques<double>(spheres, step.force, step.couple);
    add(atoms, contact, step.force, turning.on1, turning.on2, step.friction_work, step.dashpot_work, sum, gains);
    if (evflag != 0) tally(types, contact, step.force);
  }

  CONTACTLAWS_INLINE void collect(const Atoms& atoms, Types& types, const Contact& contact, const Centre& one) {
    ContactBlock<Law>& block = types.block;
    const std::size_t c = block.count++;
    types.contacts[c] = contact;
    const int j = contact.j;
    const Masses masses = masses_of(one.mass, atoms.mass[j], contact.i, j);
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
  void step_block(const Atoms& atoms, Types& types, double dt, ContactSums& total) {
    ContactBlock<Law>& block = types.block;
    block.template step<Number>(types.law, types.moduli, dt);
    const std::size_t count = block.count;
    ContactSums gains = total;
    for (std::size_t c = 0; c < count;) {
      const int i = types.contacts[c].i;
      Sum sum(atoms, i);
      for (; c < count && types.contacts[c].i == i; ++c) {
        const Contact& contact = types.contacts[c];
        const bool active = block.active[c] != 0.0;
        if constexpr (yields)
          if (!active)
            gains.yielding +=
                share_of(contact) * yielding(types, properties_of(types, atoms.mass, contact.i, contact.j), contact);
        store(contact, active, block.state_of(c), gains);
        const double on_j[3] = {block.force[0][c], block.force[1][c], block.force[2][c]};
        const double turns_i[3] = {block.torque1[0][c], block.torque1[1][c], block.torque1[2][c]};
        const double turns_j[3] = {block.torque2[0][c], block.torque2[1][c], block.torque2[2][c]};
        add(atoms, contact, on_j, turns_i, turns_j, block.friction_work[c], block.dashpot_work[c], sum, gains);
        if (evflag != 0) tally(types, contact, on_j);
      }
      sum.store(atoms);
    }
    block.count = 0;
    total = gains;
  }

  /// Heat of yielding since the contact was new, as its stored history has it [J].
  static double yielding(const Types& types, const PairProperties<double>& properties, const Contact& contact) {
    return types.law.normal.plastic_dissipation(Law::load(contact.history), properties);
  }

  /// The history of a contact after its step; LAMMPS forgets that of one which is not active.
  CONTACTLAWS_INLINE void store(const Contact& contact, bool active, typename Law::State state,
                                ContactSums& gains) const {
    if constexpr (liquid) gains.returned += share_of(contact) * take_returned(state);
    *contact.touch = active;
    Law::store(state, contact.history);
    if (!active) std::fill_n(contact.history, Law::state_size, 0.0);
  }

  /// Adds a contact's force and torques to those of its atoms, and its heat to the sums.
  template <class Vector>
  CONTACTLAWS_INLINE void add(const Atoms& atoms, const Contact& contact, const Vector& on_j, const Vector& turns_i,
                              const Vector& turns_j, double friction, double dashpots, Sum& on_i, ContactSums& gains) {
    const bool both = atoms.newton != 0 || contact.j < atoms.owned;
    for (int d = 0; d < 3; ++d) on_i.force[d] -= on_j[d];
    for (int d = 0; d < 3; ++d) on_i.torque[d] += turns_i[d];
    if (both) {
      double *const fj = atoms.force[contact.j], *const tj = atoms.torque[contact.j];
      for (int d = 0; d < 3; ++d) fj[d] += on_j[d];
      for (int d = 0; d < 3; ++d) tj[d] += turns_j[d];
    }
    const double share = both ? 1.0 : 0.5;  // the owner of atom j counts the other half
    gains.friction += share * friction;
    gains.dashpots += share * dashpots;
  }

  /// Adds energy and virial; after the history is stored.
  template <class Vector>
  void tally(const Types& types, const Contact& contact, const Vector& on_j) {
    const int i = contact.i, j = contact.j;
    const double *xi = atom->x[i], *xj = atom->x[j], ri = atom->radius[i], rj = atom->radius[j];
    const Vec3<double> branch(xj[0] - xi[0], xj[1] - xi[1], xj[2] - xi[2]);
    double energy = 0.0;
    if (eflag_either != 0) {
      const PairProperties<double> properties = properties_of(types, masses(), i, j);
      energy = types.law.stored_energy(properties, ri + rj - norm<double>(branch), Law::load(contact.history));
      if constexpr (yields) yielding_of_closed_ += share_of(contact) * yielding(types, properties, contact);
      if constexpr (liquid) liquid_in_bridges_ += share_of(contact) * Law::load(contact.history).bridge_volume;
    }
    ev_tally_xyz(i, j, atom->nlocal, force->newton_pair, energy, 0.0, on_j[0], on_j[1], on_j[2], branch[0], branch[1],
                 branch[2]);
  }

  int packs_ = 1;
  TypePairs<Parameters, Types> types_;
  std::vector<double> largest_radii_;  ///< of each type [m]
  // In a step that counts energies:
  double yielding_of_closed_ = 0.0;  ///< heat of yielding of contacts that touch [J]
  double liquid_in_bridges_ = 0.0;   ///< [m^3]
};

}  // namespace contactlaws
