// Each ready-made law on a GPU: batches, and a kernel of a host's own in which one thread steps one contact.
#include "contactlaws/contactlaws.hpp"
#include "contactlaws/scalars/cuda.hpp"

using namespace contactlaws;

template <class Law, class T = typename Law::Scalar>
__global__ void step_in_own_kernel(Law law, PairProperties<T> pair, const ContactKinematics<T>* kinematics, T* history,
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
cudaError_t compile(const Law& law) {
  step_in_own_kernel<<<1, 1>>>(law, PairProperties<T>{}, static_cast<const ContactKinematics<T>*>(nullptr),
                               static_cast<T*>(nullptr), static_cast<Vec3<T>*>(nullptr), static_cast<T*>(nullptr),
                               static_cast<T*>(nullptr));
  return evaluate(law, ContactBatch<Law>{}, nullptr);
}
/// With parameters that differ from contact to contact.
template <class Law, class T = typename Law::Scalar>
cudaError_t compile_with_columns(const Law& law) {
  return evaluate(law.template cast<Column<T>>(), ContactBatch<Law>{}, nullptr);
}

template <class T>
void compile_all() {
  compile(SmoothHertz<T>{});
  compile(DryHill<T>{});
  compile(DryHill<T, Tension::clipped>{});
  compile(Hill<T>{});
  compile(LinearFriction<T>{});
  compile(LinearSpringDashpot<T>{});
  compile(RoughBallast<T>{});
  compile_with_columns(Hill<T>{});
}
template void compile_all<double>();
template void compile_all<float>();
