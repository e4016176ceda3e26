// SPDX-License-Identifier: GPL-2.0-only
// `liggghts` with the models of normal_model_contactlaws.h, from an unmodified libliggghts: they are entered into its run-time
// tables of models, pair styles and walls before the program starts.
#include <mpi.h>

// clang-format off: in this order
#include "contact_models.h"
#include "fix_insert_stream.h"
#include "fix_wall_gran_base.h"
#include "input.h"
#include "lammps.h"
#include "pair_gran_base.h"
#include "settings.h"
// clang-format on

namespace {

using namespace LAMMPS_NS;
using namespace LIGGGHTS;
using namespace LIGGGHTS::ContactModels;

template <int model>
void enter(const char* name) {
  using Style = GranStyle<model, TANGENTIAL_OFF, COHESION_OFF, ROLLING_OFF, SURFACE_DEFAULT>;
  using Model = ContactModel<Style>;
  Factory::instance().addNormalModel(name, model);
  PairStyles::Factory::instance().addStyle(
      "gran", Style::HASHCODE, [](LAMMPS* lmp, PairGran* parent, int64_t hash) -> PairStyles::IGranularPairStyle* {
        return new PairStyles::Granular<Model>(lmp, parent, hash);
      });
  Walls::Factory::instance().addStyle("gran", Style::HASHCODE,
                                      [](LAMMPS* lmp, FixWallGran* parent, int64_t hash) -> Walls::IGranularWall* {
                                        return new Walls::Granular<Model>(lmp, parent, hash);
                                      });
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  enter<CONTACTLAWS_DRY_HILL>("contactlaws/dry_hill");
  enter<CONTACTLAWS_DRY_HILL_DISPLACEMENT>("contactlaws/dry_hill_displacement");
  enter<CONTACTLAWS_HILL>("contactlaws/hill");
  enter<CONTACTLAWS_ROUGH_BALLAST>("contactlaws/rough_ballast");
  enter<CONTACTLAWS_COHESIVE_POWDER>("contactlaws/cohesive_powder");
  enter<CONTACTLAWS_WET_GRAINS>("contactlaws/wet_grains");
  {
    LAMMPS lmp(argc, argv, MPI_COMM_WORLD);
    lmp.input->file();
  }
  MPI_Finalize();
}
