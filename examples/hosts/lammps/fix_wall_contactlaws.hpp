// SPDX-License-Identifier: GPL-2.0-only
// fix wall/contactlaws/NAME: walls whose contacts follow any law of contactlaws.
//
//   fix ID GROUP wall/contactlaws/NAME SHAPE young E poisson nu [wall_young E] [wall_poisson nu] [NAME VALUE]...
//
// SHAPE: xplane, yplane or zplane LOW HIGH (NULL: no wall there); or zcylinder RADIUS, about the z axis. Without wall_young and
// wall_poisson the wall is of the grains' material. `wet GAP` wets, where the next run starts, contacts with a gap up to GAP.
//
// f_ID is the energy of springs and bridges, part of the energy after `fix_modify ID energy yes`; f_ID[1] to f_ID[3] the force
// on the wall; f_ID[4] and f_ID[5] the heat of friction and of dashpots since the start. The wall is body 1, the atom body 2.
#pragma once

#include <array>

#include "pair_contactlaws.hpp"

namespace contactlaws {

template <class Parameters>
class FixWallContactLaws : public LAMMPS_NS::Fix {
  using Law = LawOf<Parameters>;
  static constexpr bool bridges = decltype(Law::bridge)::acts;
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
          set_law_parameter(parameters, name, value);
        }
      }
      law_ = make_law(parameters);
      if (wall.young != wall.young) wall.young = grain.young;
      if (wall.poisson != wall.poisson) wall.poisson = grain.poisson;
      if (spring_of<Parameters> == Spring::hertz) moduli_ = given_moduli(grain, wall);
    } catch (const std::invalid_argument& complaint) {
      fail(complaint.what());
    }
    create_attribute = restart_peratom = scalar_flag = vector_flag = extscalar = extvector = global_freq = 1;
    energy_global_flag = 1;
    size_vector = 5;
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

  void post_force(int) override {
    std::fill_n(totals_.begin(), 3, 0.0);
    for_each_contact(update->setupflag != 0 ? 0.0 : update->dt,
                     [this](int i, const SphereContact<double>& contact, const auto& pair, double* history) {
                       auto state = Law::load(history);
                       if constexpr (bridges)
                         if (wet_gap_ >= 0.0) Law::make_wet(state, contact.kinematics.overlap, wet_gap_);
                       const auto step = law_.step(pair, contact.kinematics, state);
                       Law::store(step.active ? step.state : typename Law::State{}, history);
                       const Torques<double> turning = torques<double>(contact, step.force, step.couple);
                       for (int d = 0; d < 3; ++d) {
                         atom->f[i][d] += step.force[d];
                         atom->torque[i][d] += turning.on2[d];
                         totals_[std::size_t(d)] -= step.force[d];
                       }
                       totals_[3] += step.friction_work;
                       totals_[4] += step.dashpot_work;
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
  double compute_vector(int k) override { return over_ranks(totals_[std::size_t(k)]); }

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
    const double rest[3] = {0.0, 0.0, 0.0};
    for (int i = 0; i < atom->nlocal; ++i) {
      if ((atom->mask[i] & groupbit) == 0) continue;
      const double *x = atom->x[i], radius = atom->radius[i];
      const double mass = body != nullptr && body[i] >= 0 ? of_bodies[body[i]] : atom->rmass[i];
      for (int side = 0; side < sides_; ++side) {
        double wall[3] = {x[0], x[1], x[2]};  // its point nearest to the centre
        PairProperties<double> pair = plane_sphere_pair<double>(moduli_, radius, mass);
        double distance;
        if (sides_ == 1) {
          const double from_axis = std::hypot(x[0], x[1]);
          for (int d = 0; d < 2; ++d) wall[d] *= cylinder_ / from_axis;
          distance = std::abs(cylinder_ - from_axis);
          // Curved in one direction, by half of its curvature in the mean.
          pair.effective_radius = 1.0 / (1.0 / radius + (from_axis < cylinder_ ? -0.5 : 0.5) / cylinder_);
        } else {
          wall[axis_] = plane_[side];
          distance = std::abs(x[axis_] - plane_[side]);
        }
        double* const history = histories_[i] + side * size;
        if (distance > 0.0 && distance < radius + law_.interaction_range(pair)) {
          visit(i, sphere_contact<double>(wall, rest, rest, 0.0, x, atom->v[i], atom->omega[i], radius, dt), pair,
                history);
        } else {
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
  double wet_gap_ = -1.0;
  double** histories_ = nullptr;    ///< of each atom: side by side
  std::array<double, 5> totals_{};  ///< of this rank: force on the wall, heat of friction, of dashpots
  LAMMPS_NS::Fix* rigid_ = nullptr;
};

}  // namespace contactlaws
