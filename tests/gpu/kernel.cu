// Each ready-made law on a GPU: one thread steps one contact, its history kept as plain values.
#include "contactlaws/contactlaws.hpp"

using namespace contactlaws;

template <class Law, class T = typename Law::Scalar>
__global__ void step_contacts(Law law, PairProperties<T> pair, const ContactKinematics<T>* kinematics, T* history,
                              Vec3<T>* forces, T* energies, T* stiffnesses) {
  const unsigned i = blockIdx.x * blockDim.x + threadIdx.x;
  T* const values = history + i * Law::state_size;
  const auto step = law.step(pair, kinematics[i], Law::load(values));
  Law::store(step.state, values);
  forces[i] = step.force;
  energies[i] = law.stored_energy(pair, kinematics[i].overlap, step.state);
  stiffnesses[i] = law.stiffness(pair, kinematics[i].overlap, step.state).normal;
}

template <class Law, class T = typename Law::Scalar>
void compile(Law law) {
  step_contacts<<<1, 1>>>(law, PairProperties<T>{}, static_cast<const ContactKinematics<T>*>(nullptr),
                          static_cast<T*>(nullptr), static_cast<Vec3<T>*>(nullptr), static_cast<T*>(nullptr),
                          static_cast<T*>(nullptr));
}

void compile_all() {
  compile(SmoothHertz<double>{});
  compile(DryHill<double>{});
  compile(DryHill<double, Tension::clipped>{});
  compile(Hill<double>{});
  compile(Hill<float>{});
  compile(LinearFriction<double>{});
  compile(LinearSpringDashpot<double>{});
}
