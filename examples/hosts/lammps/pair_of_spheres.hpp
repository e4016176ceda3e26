// SPDX-License-Identifier: GPL-2.0-only
// What a pair style of spheres with a history needs of LAMMPS, whatever its law: the list of pairs, the fix that keeps the
// histories, masses and radii, errors. Differences between the releases of LAMMPS are here.
#pragma once

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix.h"
#include "fix_contact_history.hpp"
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

class PairOfSpheres : public LAMMPS_NS::Pair {
 public:
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
          if ((name == "young" || name == "poisson") && (i_low != j_low || i_high != j_high))
            fail(name + " is that of a type: give it where I and J are the same");
          const double value = LAMMPS_NS::utils::numeric(FLERR, words[k + 1], false, lmp);
          or_fail([&] { set(i, j, name, value); }, i, j);
        }
        setflag[i][j] = 1;
        any = true;
      }
    }
    if (!any) fail("pair_coeff names no pair of types: give I <= J");
  }

  int pack_forward_comm(int count, int* atoms, double* buffer, int, int*) override {
    for (int k = 0; k < count; ++k) buffer[k] = body_masses_[std::size_t(atoms[k])];
    return count;
  }
  void unpack_forward_comm(int count, int first, double* buffer) override {
    std::copy_n(buffer, count, body_masses_.begin() + first);
  }

 protected:
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
  struct Contact {
    int i, j;         ///< atoms: bodies 1 and 2
    int* touch;       ///< 1: it has a history
    double* history;  ///< values of the law's state
  };
  struct Masses {
    double m1, m2;
  };

  /// Histories of `history_size` numbers.
  PairOfSpheres(LAMMPS_NS::LAMMPS* lammps, std::size_t history_size) : Pair(lammps), history_size_(int(history_size)) {
    restartinfo = 1;
    single_enable = 1;
    finitecutflag = 1;
    no_virial_fdotr_compute = 1;
    centroidstressflag = LAMMPS_NS::CENTROID_NOTAVAIL;
    nondefault_history_transfer = 1;
    comm_forward = 1;
    FixContactHistory::offer(lammps);
    // The fix must stand before those that move atoms, such as fix pour: a placeholder keeps its place until init_style().
    modify->add_fix(placeholder_id() + " all DUMMY");
  }
  ~PairOfSpheres() override {
    delete[] svector;
    delete[] pvector;
    modify->delete_fix(history_ == nullptr ? placeholder_id() : history_id());
    if (allocated == 0) return;
    memory->destroy(setflag);
    memory->destroy(cutsq);
  }

  [[noreturn]] void fail(const std::string& message) const {
    error->all(FLERR, std::string("Pair style contactlaws: ") + message);
    std::abort();
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

  virtual void allocate() {
    allocated = 1;
    const int n = atom->ntypes + 1;
    memory->create(setflag, n, n, "pair:setflag");
    memory->create(cutsq, n, n, "pair:cutsq");
    for (int i = 1; i < n; ++i)
      for (int j = i; j < n; ++j) setflag[i][j] = 0;
  }
  /// Sets a parameter of two types by its name. @throws std::invalid_argument
  virtual void set(int i, int j, const std::string& name, double value) = 0;

  void check_atoms() const {
    if (atom->radius_flag == 0 || atom->rmass_flag == 0 || atom->omega_flag == 0 || atom->torque_flag == 0)
      fail("atoms need a radius, mass, spin and torque: atom_style sphere");
    if (comm->ghost_velocity == 0) fail("ghost atoms need velocities: comm_modify vel yes");
  }

  /// Asks for a list of spheres that touch, to within the skin, or for one that reaches as far as the cutoff.
  void request_list(bool touching) {
#if CONTACTLAWS_LAMMPS_2023
    using namespace LAMMPS_NS::NeighConst;
    neighbor->add_request(this, touching ? REQ_SIZE | REQ_HISTORY : REQ_DEFAULT);
#else
    const int request = neighbor->request(this, instance_me);
    neighbor->requests[request]->size = touching;
    neighbor->requests[request]->history = touching;
#endif
    if (history_ == nullptr) {
      history_ = static_cast<FixContactHistory*>(modify->replace_fix(
          placeholder_id().c_str(),
          history_id() + " all " + FixContactHistory::style_name + ' ' + std::to_string(history_size_), 1));
      history_->pair = this;
    }
    history_->use_bit_flag = touching;
  }
  /// History of atom j in the list of atom i, or null.
  const double* find_history(int i, int j) const {
    if (i >= atom->nlocal || list == nullptr) return nullptr;
    for (int k = 0; k < list->numneigh[i]; ++k)
      if ((list->firstneigh[i][k] & NEIGHMASK) == j) return &history_->firstvalue[i][k * history_size_];
    return nullptr;
  }

  Atoms atoms() const {
    const auto rows = [](double** array) { return array == nullptr ? nullptr : reinterpret_cast<Row*>(array[0]); };
    return {rows(atom->x), rows(atom->v), rows(atom->omega), rows(atom->f),     rows(atom->torque),
            atom->radius,  masses(),      atom->nlocal,      force->newton_pair};
  }

  /// Largest radius of each type, from 1 on, those included that fixes will insert [m].
  std::vector<double> largest_radii() const {
    std::vector<double> mine(std::size_t(atom->ntypes + 1), 0.0);
    for (int i = 0; i < atom->nlocal; ++i) {
      double& r = mine[std::size_t(atom->type[i])];
      r = std::max(r, atom->radius[i]);
    }
    for (int k = 0; k < modify->nfix; ++k) {
      LAMMPS_NS::Fix* fix = modify->fix[k];
      if (std::strncmp(fix->style, "pour", 4) != 0 && std::strncmp(fix->style, "deposit", 7) != 0) continue;
      for (int type = 1; type <= atom->ntypes; ++type) {
        int changed_by_extract = type;
        const void* radius = fix->extract("radius", changed_by_extract);
        double& r = mine[std::size_t(type)];
        if (radius != nullptr) r = std::max(r, *static_cast<const double*>(radius));
      }
    }
    std::vector<double> all(mine.size());
    MPI_Allreduce(mine.data(), all.data(), int(mine.size()), MPI_DOUBLE, MPI_MAX, world);
    return all;
  }

  void find_frozen_and_rigid() {
    frozen_ = 0;
    rigid_ = nullptr;
    for (int k = 0; k < modify->nfix; ++k) {
      LAMMPS_NS::Fix* fix = modify->fix[k];
      if (std::strcmp(fix->style, "freeze") == 0) frozen_ = fix->groupbit;
      if (fix->rigid_flag != 0) rigid_ = fix;
    }
  }
  /// Mass of each atom, or of the rigid body that it belongs to; ghosts too. After each change of the neighbour list.
  void find_body_masses() {
    if (rigid_ == nullptr || neighbor->ago != 0) return;
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
  const double* masses() const { return rigid_ == nullptr ? atom->rmass : body_masses_.data(); }
  /// Masses of a contact's bodies. Beside a frozen atom both count as twice the other's, so that m* is the other's mass.
  Masses masses_of(double m1, double m2, int i, int j) const {
    if (frozen_ != 0) {
      if ((atom->mask[i] & frozen_) != 0) return {2.0 * m2, 2.0 * m2};
      if ((atom->mask[j] & frozen_) != 0) return {2.0 * m1, 2.0 * m1};
    }
    return {m1, m2};
  }

  /// What this rank counts of a contact's energies: half, where the owner of atom j counts the other half.
  double share_of(const Contact& contact) const {
    return force->newton_pair != 0 || contact.j < atom->nlocal ? 1.0 : 0.5;
  }

  /// From a restart file, which rank 0 reads.
  void read(FILE* file, void* values, std::size_t bytes) const {
    if (comm->me == 0) LAMMPS_NS::utils::sfread(FLERR, values, 1, bytes, file, nullptr, error);
    MPI_Bcast(values, int(bytes), MPI_BYTE, 0, world);
  }

  FixContactHistory* history_ = nullptr;

 private:
  std::string placeholder_id() const { return "CONTACTLAWS_PLACE_" + std::to_string(instance_me); }
  std::string history_id() const { return "CONTACTLAWS_HISTORY_" + std::to_string(instance_me); }

  const int history_size_;
  LAMMPS_NS::Fix* rigid_ = nullptr;
  int frozen_ = 0;                   ///< group bit of fix freeze
  std::vector<double> body_masses_;  ///< of each atom, where there are rigid bodies [kg]
};

}  // namespace contactlaws
