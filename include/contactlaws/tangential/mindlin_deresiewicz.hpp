// SPDX-License-Identifier: MIT
// Partial slip (Mindlin & Deresiewicz 1953): friction lets the edge of a contact slip while its centre sticks. k the shear
// stiffness, P >= 0 the friction load, o the overlap:
//
//   The contact is a row of independent springs at depth h from its edge, 0 <= h <= o, each with a deflection e(h):
//
//   step       h := h + do,   e := e + ds       ds the slip of the step; springs that touch anew start from (0, 0)
//   friction   |e(h)| <= m h                    m = 3 mu P / (2 k o); beside Hertz mu E*/(4 G*), whatever the load
//   F = -k int_0^1 e dx,  energy = k/2 int_0^1 e.e dx,   h = o (1 - x^2)
//
// This is the method of dimensionality reduction (Popov & Hess 2014, Facta Universitatis 12, Sec. 4). In one direction it is
// exact, for every history, under the assumption of Cattaneo and Mindlin that normal and shear tractions do not interact; as
// Jaeger (1993), Arch. Appl. Mech. 63, found. With P constant it gives the curves of Mindlin & Deresiewicz:
//
//   loading    F = mu P (1 - (1 - s/s_max)^(3/2))              s_max = m o = 3 mu P / (2 k) = 3 mu P / (16 G* a)
//   unloading  F = F* - 2 mu P (1 - (1 - (s* - s)/(2 s_max))^(3/2))                    from (s*, F*); reloading likewise
//
// e(h) is kept as a chain of straight lines between `corners` points (h, e), inmost last, constant from there to h = o. In one
// direction the chain is exact while the corners suffice: a reversal adds one, and so does a step that raises the load faster than
// friction can follow. Two rules are ours:
//
//   1. Where a corner more is needed, the one that bears least is dropped; a new one counts as if it had grown to the middle of
//      its line, so that small steps do not each drop their own. The springs inside it take over its force; where that raises the
//      energy, all deflections are scaled back to it. So no closed loop gains energy. (The work of a step in which a corner is
//      dropped is not linear in the slip: on loops of few large steps the trapezoidal rule shows up to 0.2 % of the shear energy.)
//   2. In three dimensions a corner that slips keeps the direction of its own deflection, and one is added where slipping ends.
//
// Four corners are off a row of 1000 separate springs by 1e-6 of mu P in one direction until one is dropped, then by 0.8 %,
// and by 5 % in the plane, at most on random walks of 12 moves; 48 corners by 0.4 % in the plane. Where load and slip change together
// along smooth curves, every step would add a corner: four are then off by 1.6 % of the largest mu P, twelve by 0.1 %, at any step.
//
// Domain: laws that push, any step. Exact beside Hertz without dashpots; beside other laws the springs keep Hertz's places,
// and m changes with P. A contact that touches and slips in the same step has sheared its springs by 0 to ds: F = 2/3 k ds.
// `sliding` says that all springs slip in one direction. History: 17 values. Error of a path of 100 steps: 1e-14 of mu P
// (tests/laws/test_mindlin_deresiewicz.cpp).
#pragma once

#include <array>

#include "contactlaws/tangential/incremental_shear.hpp"
#include "contactlaws/tangential/spring_row.hpp"

namespace contactlaws {

template <class T, class Rotation = rotation::ProjectRestore<T>, int corners = 4>
struct MindlinDeresiewicz : Mindlin<T>, Coulomb<T> {
  static_assert(corners >= 2, "a reversal needs a second corner");
  using Slot = ShearSlot<T>;
  template <class U>
  using Rebind = MindlinDeresiewicz<U, typename Rotation::template Rebind<U>, corners>;
  static constexpr bool acts = true;

  /// A corner of the chain e(h).
  struct Corner {
    T depth = T(0);                              ///< h [m]
    std::array<T, 3> slip = {T(0), T(0), T(0)};  ///< e [m]
  };
  /// The history without that of the rotation.
  struct Own {
    std::array<Corner, corners> corner{};  ///< from the edge inwards; equal ones where fewer are needed
    T last_overlap = T(0);                 ///< of the step before [m]
  };
  struct CONTACTLAWS_EMPTY_BASES State : Own, Rotation::State {};

  static constexpr const char* name = "MindlinDeresiewicz";
  static constexpr auto parameters() { return inherited<MindlinDeresiewicz, T>(Coulomb<T>::parameters()); }
  static constexpr auto state_values() {
    constexpr const char* names[5][4] = {{"depth_1", "slip_1_x", "slip_1_y", "slip_1_z"},
                                         {"depth_2", "slip_2_x", "slip_2_y", "slip_2_z"},
                                         {"depth_3", "slip_3_x", "slip_3_y", "slip_3_z"},
                                         {"depth_4", "slip_4_x", "slip_4_y", "slip_4_z"},
                                         {"depth", "slip_x", "slip_y", "slip_z"}};  // of any beyond
    std::array<StateValue, 4 * corners + 1> own{};
    for (int i = 0; i < corners; ++i) {
      const auto& of = names[i < 4 ? i : 4];
      const std::size_t at = 4 * static_cast<std::size_t>(i);
      own[at] = {of[0], "m", +1};
      for (std::size_t k = 1; k < 4; ++k) own[at + k] = {of[k], "m", -1, ValueKind::vector};
    }
    own[4 * corners] = {"last_overlap", "m", +1};
    return concatenate(own, Rotation::state_values());
  }

  using Mindlin<T>::stiffness;
  T stiffness(const PairProperties<T>&, const AdhesiveResponse<T>&) const = delete;  // no row of springs beyond touch

  template <bool damped>
  CONTACTLAWS_HD ShearResponse<T> respond(State& state, const ShearInput<T>& in) const noexcept {
    const T overlap = select<T>(in.kinematics.overlap > T(0), in.kinematics.overlap, T(1));  // open lanes: any number
    const T limit = this->friction * in.friction_load;
    const T stiffness = select<T>(in.stiffness > T(0), in.stiffness, T(1));
    const T slope = limit * T(T(3) / T(2)) / T(stiffness * overlap);  // m
    const T twist = in.kinematics.normal_spin * in.kinematics.dt;
    const Vec3<T> slip = Rotation::slip(Vec3<T>(in.slip_velocity * in.kinematics.dt), in.kinematics.normal, twist);
    const T deeper = in.kinematics.overlap - state.last_overlap;

    Chain before = chain(state, in.kinematics.normal, twist, deeper);
    Chain after = before;
    for (Point& p : after.point) p.slip = p.slip + slip;
    const typename Row::Limited limited = Row::slip_at_edge(after, slope, overlap);

    const T most = Row::sums(after, overlap).square;
    Row::template drop<Row::points>(after, slope, overlap);
    Row::template drop<Row::points - 1>(after, slope, overlap);
    Row::keep_energy(after, most, overlap);

    ShearResponse<T> response{};
    const typename Row::Sums held = Row::sums(before, overlap), now = Row::sums(after, overlap);
    const T heat = dot<T>(Vec3<T>(held.mean + now.mean), slip) - (now.square - held.square);
    response.friction_work = select<T>(limited.slips, positive_part<T>(T(heat * stiffness / T(2))), T(0));
    response.spring = now.mean * T(-in.stiffness);
    // Springs that all slip add up to mu P once their directions agree.
    const T length = norm<T>(response.spring);
    response.sliding =
        limited.slides && negate<T>(length < limit * T(Lane(1) - Lane(16) * std::numeric_limits<Lane>::epsilon()));
    const Mask<T> limits = response.sliding || negate<T>(length <= limit);
    const T divisor = select<T>(length > T(0), length, T(1));
    response.spring = response.spring * select<T>(limits, T(limit / divisor), T(1));
    response.force = response.spring;
    if constexpr (damped) {
      const Vec3<T> total = response.spring - in.slip_velocity * in.dashpot;
      const detail::LengthLimit<T> second = detail::length_limit<T>(total, limit, limit);
      response.force = total * second.factor;
      response.sliding = response.sliding || second.exceeded;
    }
    for (int i = 0; i < corners; ++i) {
      const Point& p = after.point[i + 2];
      state.corner[static_cast<std::size_t>(i)] = {p.depth, {p.slip.x(), p.slip.y(), p.slip.z()}};
    }
    state.last_overlap = in.kinematics.overlap;
    return response;
  }

  /// Energy stored in the springs [J]; `stiffness` at the overlap of the state.
  CONTACTLAWS_HD T energy(const State& state, const T& stiffness) const noexcept {
    Chain all;
    for (int i = 0; i < corners; ++i) all.point[i + 2] = point(state.corner[static_cast<std::size_t>(i)]);
    all.point[0] = all.point[1] = Row::edge();
    const T overlap = select<T>(state.last_overlap > T(0), state.last_overlap, T(1));
    return stiffness / T(2) * Row::sums(all, overlap).square;
  }

 private:
  using Lane = typename ScalarTraits<T>::Lane;
  using Row = detail::SpringRow<T, corners>;
  using Chain = typename Row::Chain;
  using Point = typename Row::Point;

  CONTACTLAWS_HD static Point point(const Corner& of) noexcept {
    return {of.depth, Vec3<T>(of.slip[0], of.slip[1], of.slip[2])};
  }
  /// The chain of the step before, turned into the contact plane, at the depths of now.
  CONTACTLAWS_HD static Chain chain(State& state, const Vec3<T>& normal, const T& twist, const T& deeper) noexcept {
    Chain all;
    const typename Rotation::State turn = state;
    for (int i = 0; i < corners; ++i) {
      static_cast<typename Rotation::State&>(state) = turn;
      const Point p = point(state.corner[static_cast<std::size_t>(i)]);
      all.point[i + 2] = {p.depth + deeper, Rotation::apply(state, p.slip, normal, twist)};
    }
    all.point[0] = {deeper, Row::edge().slip};
    all.point[1] = {T(deeper + all.point[2].depth) / T(2), all.point[2].slip / T(2)};
    // A NaN of the last overlap makes all depths NaN, which the slips have to know.
    Point& last = all.point[Row::inmost];
    last.slip = last.slip * T(T(1) + (last.depth - last.depth));
    return all;
  }
};

}  // namespace contactlaws
