// SPDX-License-Identifier: MIT
// A contact law has five slots. This header says what they exchange; start here to write a law of your own.
//
//   normal   using Slot = NormalSlot<T>;
//            respond(State&, pair, overlap)                          -> NormalResponse, or a type that adds to it
//            energy(State, pair, overlap) [J]
//   damping  using Slot = DampingSlot<T>;
//            coefficients(mass, normal secant, shear stiffness)      -> DampingCoefficients
//            normal_force(elastic, coefficient, separating) [N], stiffness_factor() [1], damps_shear
//   shear    using Slot = ShearSlot<T>;
//            respond<damped>(State&, ShearInput)                     -> ShearResponse
//            stiffness(pair, normal response) [N/m], energy(State, stiffness) [J]
//   bridge   using Slot = BridgeSlot<T>;
//            respond(State&, pair, overlap)                          -> BridgeResponse
//            energy(State, pair, overlap) [J], range(pair) [m], is_wet(State), make_wet(State&, overlap, gap),
//            make_dry(State&)
//   rolling  using Slot = RollingSlot<T>;
//            respond(State&, RollingInput)                           -> RollingResponse
//            energy(State, pair, normal stiffness) [J]
//
// Every slot but the normal one has `static constexpr bool acts`: false for the empty slots (NoDashpots, Frictionless, Dry,
// NoRolling), which cost no byte, no operation and no parameter.
//
// A slot holds parameters. Numbers that follow from them at a cost it may keep beside them: cast() calls its prepare().
// What it stores per contact is its nested State: values of T only, new when all are zero, listed
// by state_values(). respond() receives a copy of the state and updates it.
//
// A pushing normal law receives max(overlap, 0); at 0 the response is zero. A normal law that pulls declares
// `static constexpr bool adheres = true`, receives the overlap with its sign, returns an AdhesiveResponse or a
// PullingResponse, and adds
//            touches(State, pair, overlap) -> Mask    whether the contact holds
//            range(pair) [m]                          the largest gap across which it holds
// A normal law that yields adds plastic_dissipation(State, pair) [J], all since the contact was new.
// When a contact opens its history is reset. A normal law whose history must survive declares
// `static constexpr bool outlives_separation = true`; its respond() is then called for open contacts too, with overlap 0.
#pragma once

#include <type_traits>
#include <utility>

#include "contactlaws/kinematics.hpp"
#include "contactlaws/pair.hpp"

namespace contactlaws {

template <class T>
struct NormalSlot {};
template <class T>
struct DampingSlot {};
template <class T>
struct ShearSlot {};
template <class T>
struct BridgeSlot {};
template <class T>
struct RollingSlot {};

/// Beside which springs a coefficient of restitution holds at any speed; a normal law states it as `spring`.
enum class Spring { hertz, linear };

template <class T>
struct NormalResponse {
  T force;      ///< elastic or elastic-plastic force, compression > 0 [N]
  T stiffness;  ///< tangent dF/do of the active branch; positive, since shear and rolling scale with it (Jkr: 2 E* a) [N/m]
  T secant;       ///< force over elastic indentation: what dashpots scale with [N/m]
  T max_tangent;  ///< tangent of the stiffest branch that the next motion may follow, for the time step [N/m]
};

/// Of normal laws that know the contact radius a, which Mindlin's shear stiffness needs.
template <class T>
struct HertzResponse : NormalResponse<T> {
  T contact_radius;  ///< a [m]
};

/// Of normal laws that pull: `force` includes the pull.
template <class T>
struct AdhesiveResponse : HertzResponse<T> {
  T pull_off;  ///< F_c, the largest pull: a clipped dashpot does not pull beyond it [N]
  T adhesion;  ///< friction acts on force + adhesion [N]
};

/// Of normal laws that pull and know no contact radius.
template <class T>
struct PullingResponse : NormalResponse<T> {
  T pull_off;  ///< as AdhesiveResponse [N]
  T adhesion;  ///< as AdhesiveResponse [N]
};

/// What friction multiplies beside a normal law that pulls; two rules are Thornton's (1991), for DMT and for JKR.
enum class AdhesiveFriction {
  none,          ///< max(F, 0): a contact that pulls bears no shear
  thornton_dmt,  ///< F + F_c
  thornton_jkr   ///< F + 2 F_c
};
/// The pull that friction counts [N].
template <AdhesiveFriction rule, class T>
CONTACTLAWS_HD T counted_adhesion(const T& pull_off) noexcept {
  return T(rule == AdhesiveFriction::none ? 0 : rule == AdhesiveFriction::thornton_dmt ? 1 : 2) * pull_off;
}

template <class T>
struct DampingCoefficients {
  T normal;  ///< c_n [kg/s]
  T shear;   ///< c_s [kg/s]
};

template <class T>
struct ShearInput {
  const ContactKinematics<T>& kinematics;
  Vec3<T> slip_velocity;  ///< in the contact plane, body 2 relative to body 1 [m/s]
  T stiffness;            ///< shear stiffness at this overlap, 0 when open [N/m]
  T dashpot;              ///< c_s [kg/s]; read when damped
  T friction_load;        ///< normal force that friction multiplies: without the bridge, never negative [N]
  Mask<T> open;           ///< of the lanes of a pack, those without contact
};

template <class T>
struct ShearResponse {
  Vec3<T> force;    ///< spring and dashpot, in the contact plane, on body 2 [N]
  Vec3<T> spring;   ///< of the spring alone [N]
  Mask<T> sliding;  ///< whether friction limited it
  T friction_work;  ///< heat from sliding in this step [J]
};

template <class T>
struct BridgeResponse {
  T force;         ///< attraction > 0 [N]
  Mask<T> intact;  ///< whether the bridge exists
};

template <class T>
struct RollingInput {
  const PairProperties<T>& pair;
  const ContactKinematics<T>& kinematics;
  T normal_stiffness;  ///< stiffness of the normal law [N/m]
  T load;              ///< as ShearInput::friction_load [N]
};

template <class T>
struct RollingResponse {
  Vec3<T> couple;   ///< on body 2 [N m]
  T friction_work;  ///< heat from rolling against friction in this step [J]
  T dashpot_work;   ///< heat of a dashpot against rolling in this step [J]
};

namespace detail {

/// Energy of a spring from the square of its force, or couple [J]; 0 where it has no stiffness.
template <class T>
CONTACTLAWS_HD T spring_energy(const T& square, const T& stiffness) noexcept {
  const Mask<T> stiff = stiffness > T(0);
  return select<T>(stiff, square, T(0)) / (T(2) * select<T>(stiff, stiffness, T(1)));
}

template <class Normal, class = void>
inline constexpr bool adheres = false;
template <class Normal>
inline constexpr bool adheres<Normal, std::void_t<decltype(Normal::adheres)>> = Normal::adheres;

template <class Normal, class = void>
inline constexpr bool outlives_separation = false;
template <class Normal>
inline constexpr bool outlives_separation<Normal, std::void_t<decltype(Normal::outlives_separation)>> =
    Normal::outlives_separation;

template <class Normal, class = void>
inline constexpr bool yields = false;
template <class Normal>
inline constexpr bool yields<Normal, std::void_t<decltype(&Normal::plastic_dissipation)>> = true;

/// What a slot type says that it is; void for any other type.
template <class Type, class = void>
struct SlotOf {
  using type = void;
};
template <class Type>
struct SlotOf<Type, std::void_t<typename Type::Slot>> {
  using type = typename Type::Slot;
};
template <class Type, class Slot>
inline constexpr bool is_slot = std::is_same_v<typename SlotOf<Type>::type, Slot>;

/// Whether a shear law can take its stiffness from what the normal law returns.
template <class Normal, class Shear, class = void>
inline constexpr bool stiffness_fits = !Shear::acts;
template <class Normal, class Shear>
inline constexpr bool stiffness_fits<
    Normal, Shear,
    std::void_t<decltype(std::declval<const Shear&>().stiffness(
        std::declval<const PairProperties<typename Normal::Scalar>&>(),
        std::declval<const Normal&>().respond(std::declval<typename Normal::State&>(),
                                              std::declval<const PairProperties<typename Normal::Scalar>&>(),
                                              std::declval<const typename Normal::Scalar&>())))>> = true;

}  // namespace detail

}  // namespace contactlaws
