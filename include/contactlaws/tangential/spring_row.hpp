// SPDX-License-Identifier: MIT
// The row of springs of partial slip, as a chain of straight lines: what mindlin_deresiewicz.hpp computes with.
//
//   e(h) from (0, 0) at the edge through the points of the chain, constant beyond the inmost;  h = o (1 - x^2)
//   int e dx of a line from (u, e_u) to (w, e_w):    (u - w) (e_u + (e_w - e_u) (2 u + w) / (3 (u + w)))
//   and of e.e, with the square of the way:          (8 u^2 + 9 u w + 3 w^2) / (15 (u + w)^2)
#pragma once

#include <limits>

#include "contactlaws/core/scalar.hpp"

namespace contactlaws::detail {

template <class T, int corners>
struct SpringRow {
  using Lane = typename ScalarTraits<T>::Lane;
  struct Point {
    T depth;
    Vec3<T> slip;
  };
  /// What the springs hold, from the edge inwards: the spring that touches last, one in the midst of the outmost line, which
  /// may take a direction of its own, and the corners.
  static constexpr int points = corners + 2, inmost = points - 1;
  struct Chain {
    Point point[points];
  };
  struct Limited {
    Mask<T> slips, slides;  ///< springs at the edge, all springs
  };
  struct Sums {
    Vec3<T> mean;  ///< int e dx [m]
    T square;      ///< int e.e dx [m^2]
  };
  /// Of a line of the chain between x = u and x = w <= u.
  struct Line {
    T width;   ///< u - w
    T share;   ///< mean over x of the way from u to w in depth
    T square;  ///< mean of its square
  };

  CONTACTLAWS_HD static Point edge() noexcept { return {T(0), Vec3<T>(T(0), T(0), T(0))}; }
  CONTACTLAWS_HD static Point select_point(const Mask<T>& first, const Point& a, const Point& b) noexcept {
    return {select<T>(first, a.depth, b.depth),
            Vec3<T>(select<T>(first, a.slip.x(), b.slip.x()), select<T>(first, a.slip.y(), b.slip.y()),
                    select<T>(first, a.slip.z(), b.slip.z()))};
  }
  /// x of a spring [1].
  CONTACTLAWS_HD static T place(const Point& of, const T& overlap) noexcept {
    return sqrt_of_positive<T>(T(T(overlap - of.depth) / overlap));
  }
  CONTACTLAWS_HD static Line line(const Point& from, const Point& to, const T& overlap) noexcept {
    const T u = place(from, overlap), w = place(to, overlap), sum = u + w;
    const T divisor = select<T>(sum > T(0), sum, T(1));
    return {T(T(T(to.depth - from.depth) / overlap) / divisor), T(T(T(2) * u + w) / T(T(3) * divisor)),
            T(T(T(8) * u * u + T(9) * u * w + T(3) * w * w) / T(T(15) * divisor * divisor))};
  }

  /// Springs beyond the cone |e| <= m h slip onto it, each in its own direction. A point is added where slipping ends, for
  /// which the spring that touches last goes: it lies on the cone too.
  CONTACTLAWS_HD static Limited slip_at_edge(Chain& chain, const T& slope, const T& overlap) noexcept {
    Limited limited{Mask<T>(false), Mask<T>(false)};
    Mask<T> sticks(true);
    Point inner{overlap, chain.point[inmost].slip};
    for (int i = inmost; i >= 0; --i) {
      const Point p = chain.point[i];
      const T length = norm<T>(p.slip), reach = slope * p.depth;
      const Mask<T> inside = sticks && p.depth >= T(0) && length <= reach * tolerance();
      const Mask<T> leaves = sticks && negate<T>(inside);
      Point next = p;
      if (any<T>(leaves)) {
        Point leaving;
        if (i == inmost) {
          const T most = slope * overlap;
          limited.slides = leaves && negate<T>(length <= most);  // also where a NaN is
          const T shorter = select<T>(limited.slides, T(most / select<T>(limited.slides, length, T(1))), T(1));
          const T depth = length / select<T>(slope > T(0), slope, T(1));
          leaving = {select<T>(limited.slides, overlap, depth), p.slip * shorter};
        } else {
          leaving = crossing(inner, p, slope);
        }
        next = select_point(leaves, leaving, next);
      }
      if (!all<T>(sticks)) next = select_point(sticks, next, on_cone(inner, slope));
      chain.point[i] = next;
      inner = p;
      limited.slips = limited.slips || leaves;
      sticks = inside;
    }
    return limited;
  }
  CONTACTLAWS_HD static Point on_cone(const Point& p, const T& slope) noexcept {
    const T depth = positive_part<T>(p.depth);
    const T length = norm<T>(p.slip);
    return {depth, p.slip * T(slope * depth / select<T>(length > T(0), length, T(1)))};
  }
  CONTACTLAWS_HD static Point in_cone(const Point& p, const T& slope) noexcept {
    const Mask<T> inside = norm<T>(p.slip) <= slope * p.depth * tolerance();
    return all<T>(inside) ? p : select_point(inside, p, on_cone(p, slope));
  }
  /// A corner on the cone may lie outside by its roundings: a few to place it, four of m.
  CONTACTLAWS_HD static T tolerance() noexcept { return T(Lane(1) + Lane(16) * std::numeric_limits<Lane>::epsilon()); }
  /// Where the line from a point inside the cone to one outside meets it.
  CONTACTLAWS_HD static Point crossing(const Point& in, const Point& out, const T& slope) noexcept {
    const T reach = slope * in.depth;
    const T unit = select<T>(reach > T(0), reach, T(1));
    const Vec3<T> e = in.slip / unit, f = out.slip / unit;
    const T h = slope * out.depth / unit;  // m h of the two: 1 and h
    // |(1 - t) e + t f| = (1 - t) + t h; the discriminant by Lagrange's identity, in which no digit cancels near the edge.
    const Vec3<T> sheared = f - e * h, turned = e.cross(f);
    const T root = sqrt_of_positive<T>(T(dot<T>(sheared, sheared) - dot<T>(turned, turned)));
    const T inwards = positive_part<T>(T(dot<T>(e, f) - h + root)), outwards = positive_part<T>(T(T(1) - dot<T>(e, e)));
    const T sum = inwards + outwards, divisor = select<T>(sum > T(0), sum, T(1));
    const T stay = inwards / divisor, go = outwards / divisor;
    // Along a line that nearly touches the cone a rounding moves the point far, but not off the cone.
    return on_cone({in.depth * stay + out.depth * go, in.slip * stay + out.slip * go}, slope);
  }

  CONTACTLAWS_HD static Sums sums(const Chain& chain, const T& overlap) noexcept {
    const Point& core = chain.point[inmost];
    const T stuck = place(core, overlap);
    Sums all{core.slip * stuck, dot<T>(core.slip, core.slip) * stuck};
    const auto add = [&](const Point& from, const Point& to) {
      const Line l = line(from, to, overlap);
      const Vec3<T> change = to.slip - from.slip;
      all.mean = all.mean + (from.slip + change * l.share) * l.width;
      all.square = all.square + (dot<T>(from.slip, from.slip) + T(2) * dot<T>(from.slip, change) * l.share +
                                 dot<T>(change, change) * l.square) *
                                    l.width;
    };
    // The first point lies outside the edge where the overlap has fallen: then both are at rest.
    if (any<T>(chain.point[0].depth > T(0))) add(edge(), chain.point[0]);
    for (int i = 0; i < inmost; ++i) add(chain.point[i], chain.point[i + 1]);
    return all;
  }

  /// Mean over the row of a bend of one at a point between two others [1].
  CONTACTLAWS_HD static T weight_of_bend(const Point& outer, const Point& at, const Point& inner,
                                         const T& overlap) noexcept {
    const Line before = line(outer, at, overlap), behind = line(at, inner, overlap);
    return before.width * before.share + behind.width * T(T(1) - behind.share);
  }
  /// Drops the point that bears least of the inmost `count`; what it bore, the springs inside it bear.
  template <int count>
  CONTACTLAWS_HD static void drop(Chain& chain, const T& slope, const T& overlap) noexcept {
    constexpr int first = points - count;
    const T roundings = T(Lane(64) * std::numeric_limits<Lane>::epsilon());  // of the chain's own few operations a step
    Chain best = chain;
    T least = T(0);
    for (int i = first; i <= inmost; ++i) {
      const Point outer = i > first ? chain.point[i - 1] : edge();
      const Point& at = chain.point[i];
      Point inner = chain.point[i < inmost ? i + 1 : i];
      if (i == inmost) inner.depth = overlap;
      const T span = inner.depth - outer.depth;
      const T way = i == inmost ? T(0) : T(T(at.depth - outer.depth) / select<T>(span > T(0), span, T(1)));
      const Vec3<T> off = at.slip - (outer.slip + (inner.slip - outer.slip) * way);
      const T weight = weight_of_bend(outer, at, inner, overlap);
      // What only roundings put off the line is on it: of equal points the outmost goes, whatever the precision.
      const T length = norm<T>(off);
      const T rounding = roundings * (norm<T>(at.slip) + norm<T>(outer.slip) + norm<T>(inner.slip));
      const Mask<T> bends = negate<T>(length <= rounding);
      T cost = select<T>(bends, T(length * weight), T(0));
      if (i == first) {
        // A new point near the edge bears nothing yet, and small steps would each drop theirs again: it counts as the same bend in
        // the middle of its line.
        const Mask<T> near = bends && way > T(0) && way < T(T(1) / T(2));
        const T bend = length / (T(4) * select<T>(near, T(way * (T(1) - way)), T(1)));
        const Point middle{T(outer.depth + span / T(2)), at.slip};
        cost = select<T>(near, T(bend * weight_of_bend(outer, middle, inner, overlap)), cost);
      }
      // The inmost goes only where it is like the one before it.
      const Mask<T> better = i == first    ? Mask<T>(true)
                             : i == inmost ? Mask<T>(least > T(0) && cost <= T(0))
                                           : Mask<T>(cost < least);
      if (!any<T>(better)) continue;
      least = select<T>(better, cost, least);
      const Line whole = line(outer, inner, overlap);
      const T inside = whole.width * whole.share + place(inner, overlap);
      const Vec3<T> more = off * T(weight / select<T>(inside > T(0), inside, T(1)));
      for (int k = first + 1; k <= inmost; ++k) {
        Point p = chain.point[k <= i ? k - 1 : k];
        if (k > i) p = in_cone({p.depth, p.slip + more}, slope);
        best.point[k] = select_point(better, p, best.point[k]);
      }
    }
    best.point[first] = edge();
    chain = best;
  }
  /// Scales all deflections where dropped points raised the energy.
  CONTACTLAWS_HD static void keep_energy(Chain& chain, const T& before, const T& overlap) noexcept {
    const T square = sums(chain, overlap).square;
    // Not by roundings, some ten in each sum: a contact at rest keeps its force.
    const Mask<T> rises = square > before * T(Lane(1) + Lane(16) * std::numeric_limits<Lane>::epsilon());
    if (!any<T>(rises)) return;
    const T scale = sqrt_of_positive<T>(T(before / select<T>(rises, square, T(1))));
    for (Point& p : chain.point) p.slip = p.slip * select<T>(rises, scale, T(1));
  }
};

}  // namespace contactlaws::detail
