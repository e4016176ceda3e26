// SPDX-License-Identifier: GPL-2.0-only
// fix wall/contactlaws/NAME: walls whose contacts follow any law of contactlaws.
//
//   fix ID GROUP wall/contactlaws/NAME SHAPE young E poisson nu [wall_young E] [wall_poisson nu] [NAME VALUE]... [MOTION]
//
// SHAPE: xplane, yplane or zplane LOW HIGH (NULL: no wall there); or zcylinder RADIUS, about the z axis. Without wall_young and
// wall_poisson the wall is of the grains' material. `wet GAP` wets, where the next run starts, contacts with a gap up to GAP.
//
// MOTION: `wiggle DIM AMPLITUDE PERIOD` or `shear DIM SPEED` as of wall/gran, or `velocity DIM SPEED`; see wall_motion.hpp. A plane
// shears along itself. A cylinder moves along z; it shears along z, or (DIM x or y) about z, clockwise as seen from above. Time runs
// from where the fix was made, and goes on in a restart.
//
// f_ID is the energy of springs and bridges, part of the energy after `fix_modify ID energy yes`; f_ID[1] to f_ID[3] the force
// on the wall; f_ID[4], f_ID[5] and f_ID[6] the heat of friction, of dashpots and of yielding since the start; f_ID[7] the liquid in
// bridges of a given volume and f_ID[8] what they returned at rupture, less what they took at touch. After `fix_modify ID
// virial yes` the pressure counts the way from the wall to the atom's centre times the force on it (xz: the way in x times the force
// in z, as between atoms). The wall is body 1, the atom body 2.
#pragma once

#include <array>

#include "pair_contactlaws.hpp"
#include "wall_motion.hpp"

namespace contactlaws {

template <class Parameters>
class FixWallContactLaws : public LAMMPS_NS::Fix {
  using Law = LawOf<Parameters>;
  static constexpr bool bridges = has_bridge<Law>;
  static constexpr bool yields = detail::yields<decltype(Law::normal)>;
  static constexpr bool liquid = holds_liquid<Law>;
  static constexpr int size = int(Law::state_size);

 public:
  FixWallContactLaws(LAMMPS_NS::LAMMPS* lammps, int count, char** words) : Fix(lammps, count, words) {
    if (atom->radius_flag == 0 || atom->rmass_flag == 0 || atom->omega_flag == 0 || atom->torque_flag == 0)
      fail("atoms need a radius, mass, spin and torque: atom_style sphere");
    const auto number = [&](int k) { return LAMMPS_NS::utils::numeric(FLERR, words[k], false, lmp); };
    const std::string shape = count > 4 ? words[3] : "";
    int next = 5;
    if (shape == "zcylinder") {
      sides_ = 1;
      cylinder_ = number(4);
    } else if (count > 5 && shape.size() == 6 && shape.substr(1) == "plane" && shape[0] >= 'x' && shape[0] <= 'z') {
      sides_ = 2;
      axis_ = shape[0] - 'x';
      for (int side = 0; side < 2; ++side)
        if (std::strcmp(words[4 + side], "NULL") != 0) plane_[side] = number(4 + side);
      next = 6;
    } else {
      fail("the shape is xplane, yplane or zplane LOW HIGH, or zcylinder RADIUS");
    }
    try {
      if (shape == "zcylinder") require_in(Range::positive(), cylinder_, "wall", "radius", "m");
      ElasticMaterial<double> grain = no_material(), wall = no_material();
      Parameters parameters;
      for (; next < count; next += 2) {
        const std::string name = words[next];
        if (const int numbers = WallMotion::numbers(name)) {
          if (next + 1 + numbers >= count) fail("a value is missing after " + name);
          motion_.set(name, words[next + 1], number(next + 2), numbers == 2 ? number(next + 3) : 0.0);
          next += numbers;
          continue;
        }
        if (next + 1 == count) fail("a value is missing after " + name);
        const double value = number(next + 1);
        if (name == "young" || name == "poisson") {
          set_parameter(grain, name, value);
        } else if (name == "wall_young" || name == "wall_poisson") {
          set_parameter(wall, name.substr(5), value);
        } else if (bridges && name == "wet") {
          require_in(Range::not_negative(), value, "wall", "wet", "m");
          wet_gap_ = value;
        } else {
          set_law_parameter(parameters, name, value,
                            std::string("young, poisson, wall_young, wall_poisson") + (bridges ? ", wet" : ""));
        }
      }
      if (sides_ == 2 && motion_.shears() && motion_.axis() == axis_) fail("a plane shears along itself");
      if (sides_ == 1 && !motion_.shears() && motion_.axis() != 2) fail("a cylinder moves along z");
      law_ = make_law(parameters);
      if (wall.young != wall.young) wall.young = grain.young;
      if (wall.poisson != wall.poisson) wall.poisson = grain.poisson;
      if (reads_moduli<Parameters>) moduli_ = given_moduli(grain, wall);
    } catch (const std::invalid_argument& complaint) {
      fail(complaint.what());
    }
    create_attribute = restart_peratom = scalar_flag = vector_flag = extscalar = extvector = global_freq = 1;
    energy_global_flag = virial_global_flag = virial_peratom_flag = restart_global = 1;
    size_vector = liquid ? 8 : 6;
    first_step_ = update->ntimestep;
    FixWallContactLaws::grow_arrays(atom->nmax);
    for (int i = 0; i < atom->nlocal; ++i) FixWallContactLaws::set_arrays(i);
    atom->add_callback(LAMMPS_NS::Atom::GROW);
    atom->add_callback(LAMMPS_NS::Atom::RESTART);
  }
  ~FixWallContactLaws() override {
    atom->delete_callback(id, LAMMPS_NS::Atom::GROW);
    atom->delete_callback(id, LAMMPS_NS::Atom::RESTART);
    memory->destroy(histories_);
  }

  int setmask() override { return LAMMPS_NS::FixConst::POST_FORCE; }
  void init() override {
    rigid_ = nullptr;
    for (int k = 0; k < modify->nfix; ++k)
      if (modify->fix[k]->rigid_flag != 0) rigid_ = modify->fix[k];
  }
  void setup(int flags) override { post_force(flags); }

  void post_force(int virial_flag) override {
    v_init(virial_flag);
    std::fill_n(totals_.begin(), 3, 0.0);
    for_each_contact(update->setupflag != 0 ? 0.0 : update->dt,
                     [this](int i, const SphereContact<double>& contact, const auto& pair, double* history) {
                       auto state = Law::load(history);
                       if constexpr (bridges)
                         if (wet_gap_ >= 0.0) Law::make_wet(state, contact.kinematics.overlap, wet_gap_);
                       auto step = law_.step(pair, contact.kinematics, state);
                       if constexpr (liquid) totals_[7] += take_returned(step.state);
                       Law::store(step.active ? step.state : typename Law::State{}, history);
                       const Torques<double> turning = torques<double>(contact, step.force, step.couple);
                       for (int d = 0; d < 3; ++d) {
                         atom->f[i][d] += step.force[d];
                         atom->torque[i][d] += turning.on2[d];
                         totals_[std::size_t(d)] -= step.force[d];
                       }
                       totals_[3] += step.friction_work;
                       totals_[4] += step.dashpot_work;
                       if (evflag != 0) tally(i, contact, step.force);
                     });
    wet_gap_ = -1.0;
  }

  double compute_scalar() override {
    double energy = 0.0;
    for_each_contact(0.0, [&](int, const SphereContact<double>& contact, const auto& pair, const double* history) {
      energy += law_.stored_energy(pair, contact.kinematics.overlap, Law::load(history));
    });
    return over_ranks(energy);
  }
  double compute_vector(int k) override {
    double value = totals_[std::size_t(k)];
    if constexpr (yields)
      if (k == 5)
        for_each_contact(0.0, [&](int, const SphereContact<double>&, const auto& pair, const double* history) {
          value += yielding(pair, history);
        });
    if constexpr (liquid)
      if (k == 6)
        for_each_contact(0.0, [&](int, const SphereContact<double>&, const auto&, const double* history) {
          value += Law::load(history).bridge_volume;
        });
    return over_ranks(value);
  }

  // The time at which the motion began.
  void write_restart(FILE* file) override {
    const int bytes = sizeof(first_step_);
    if (comm->me != 0) return;
    std::fwrite(&bytes, sizeof(int), 1, file);
    std::fwrite(&first_step_, sizeof(first_step_), 1, file);
  }
  void restart(char* values) override { std::memcpy(&first_step_, values, sizeof(first_step_)); }

  // The history travels with its atom, and into restart files.
  double memory_usage() override { return double(atom->nmax) * values() * sizeof(double); }
  void grow_arrays(int most) override {
    memory->grow(histories_, most, std::max(values(), 1), "wall/contactlaws:history");
  }
  void copy_arrays(int from, int to, int) override { std::copy_n(histories_[from], values(), histories_[to]); }
  void set_arrays(int i) override { std::fill_n(histories_[i], values(), 0.0); }
  int pack_exchange(int i, double* buffer) override {
    std::copy_n(histories_[i], values(), buffer);
    return values();
  }
  int unpack_exchange(int i, double* buffer) override {
    std::copy_n(buffer, values(), histories_[i]);
    return values();
  }
  int size_restart(int) override { return 1 + values(); }
  int maxsize_restart() override { return 1 + values(); }
  int pack_restart(int i, double* buffer) override {
    buffer[0] = 1 + values();
    return 1 + pack_exchange(i, buffer + 1);
  }
  void unpack_restart(int i, int which) override {
    double* block = atom->extra[i];
    for (int k = 0; k < which; ++k) block += int(*block);
    unpack_exchange(i, block + 1);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    error->all(FLERR, std::string("Fix ") + style + ": " + message);
    std::abort();
  }
  int values() const { return sides_ * size; }

  double yielding(const PairProperties<double>& pair, const double* history) const {
    return law_.normal.plastic_dissipation(Law::load(history), pair);
  }
  /// Adds to the virial the force on an atom times the way from the wall to its centre (xz: that in x times the force in z, as
  /// between atoms).
  void tally(int i, const SphereContact<double>& contact, const Vec3<double>& force) {
    const Vec3<double> way = contact.kinematics.normal * contact.distance;
    double virial[6] = {way[0] * force[0], way[1] * force[1], way[2] * force[2],
                        way[0] * force[1], way[0] * force[2], way[1] * force[2]};
    v_tally(i, virial);
  }
  double over_ranks(double mine) const {
    double all = 0.0;
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
    return all;
  }

  /// visit(atom, contact, pair, history) for the atoms of the group near the wall; the histories of the others are reset.
  template <class Visit>
  void for_each_contact(double dt, const Visit& visit) {
    int dimension = 0;
    const int* body = rigid_ == nullptr ? nullptr : static_cast<const int*>(rigid_->extract("body", dimension));
    const double* of_bodies =
        rigid_ == nullptr ? nullptr : static_cast<const double*>(rigid_->extract("masstotal", dimension));
    const double no_spin[3] = {0.0, 0.0, 0.0};
    const double time = double(update->ntimestep - first_step_) * update->dt;
    const double moved = motion_.displacement(time), speed = motion_.velocity(time);
    for (int i = 0; i < atom->nlocal; ++i) {
      if ((atom->mask[i] & groupbit) == 0) continue;
      const double *x = atom->x[i], radius = atom->radius[i];
      const double mass = body != nullptr && body[i] >= 0 ? of_bodies[body[i]] : atom->rmass[i];
      for (int side = 0; side < sides_; ++side) {
        double wall[3] = {x[0], x[1], x[2]};  // its point nearest to the centre
        double velocity[3] = {0.0, 0.0, 0.0};
        velocity[motion_.axis()] = speed;
        PairProperties<double> pair = plane_sphere_pair<double>(moduli_, radius, mass);
        double distance;
        if (sides_ == 1) {
          const double from_axis = std::hypot(x[0], x[1]);
          for (int d = 0; d < 2; ++d) wall[d] *= cylinder_ / from_axis;
          distance = std::abs(cylinder_ - from_axis);
          if (motion_.axis() != 2) {  // about z
            velocity[0] = speed * x[1] / from_axis;
            velocity[1] = -speed * x[0] / from_axis;
          }
          // Curved in one direction, by half of its curvature in the mean.
          pair.effective_radius = 1.0 / (1.0 / radius + (from_axis < cylinder_ ? -0.5 : 0.5) / cylinder_);
        } else {
          wall[axis_] = plane_[side] + (motion_.axis() == axis_ ? moved : 0.0);
          distance = std::abs(x[axis_] - wall[axis_]);
        }
        double* const history = histories_[i] + side * size;
        if (distance > 0.0 && distance < radius + law_.interaction_range(pair)) {
          visit(i, sphere_contact<double>(wall, velocity, no_spin, 0.0, x, atom->v[i], atom->omega[i], radius, dt),
                pair, history);
        } else {
          if constexpr (yields)
            if (std::any_of(history, history + size, [](double value) { return value != 0.0; }))
              totals_[5] += yielding(pair, history);
          if constexpr (liquid) totals_[7] += Law::load(history).bridge_volume;
          std::fill_n(history, size, 0.0);
        }
      }
    }
  }

  static constexpr double nowhere = 1e300;
  int sides_ = 0, axis_ = 0;
  double plane_[2] = {-nowhere, nowhere}, cylinder_ = 0.0;
  Law law_;
  EffectiveModuli<double> moduli_{1.0, 1.0};
  WallMotion motion_;
  LAMMPS_NS::bigint first_step_ = 0;  ///< in which the motion began
  double wet_gap_ = -1.0;
  double** histories_ = nullptr;  ///< of each atom: side by side
  /// Of this rank: force on the wall; heat of friction, of dashpots, and of yielding at contacts that have opened; the eighth, liquid
  /// returned.
  std::array<double, 8> totals_{};
  LAMMPS_NS::Fix* rigid_ = nullptr;
};

}  // namespace contactlaws
