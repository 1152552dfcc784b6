// Pairs that touch, a batch at a time: compiled once per instruction set.
#include "contact/batch.hpp"
#include "contact/jet.hpp"
#include "simd/pack3.hpp"
#include "simd/rows.hpp"

namespace fabricsh::contact {
inline namespace FABRICSH_ISA {

namespace {

Pack squared(const Pack3& a) { return dot(a, a); }
Pack norm(const Pack3& a) { return sqrt(squared(a)); }
Pack3 select(PackMask c, const Pack3& a, const Pack3& b) {
  return {fabricsh::select(c, a.x, b.x), fabricsh::select(c, a.y, b.y), fabricsh::select(c, a.z, b.z)};
}
PackMask same(const Pack3& a, const Pack3& b) { return (a.x == b.x) & (a.y == b.y) & (a.z == b.z); }
constexpr double zero = 0, one = 1;  // packs at this place would be made before the processor is known
PackMask all() { return Pack(one) > Pack(zero); }

// --- the closest points

// Where a pair touches, see Touch; count: m2, area times how often it counts.
struct Place {
  Pack weight[4];
  Pack3 normal;
  Pack distance, count;
};

// The vector between the closest points, m.
Pack3 between(const Pack3 x[4], const Pack weight[4]) {
  Pack3 r{zero, zero, zero};
  for (int i = 0; i < 4; ++i) r = r + weight[i] * x[i];
  return r;
}

// Returns whether a lane of `where` may be nearer than `allowed`, m. Otherwise there is no normal.
bool measure(const Pack3 x[4], PackMask where, Pack allowed, Place& at) {
  const Pack3 r = between(x, at.weight);
  const Pack size = squared(r);
  if (!any(where & !(size > (1 + 1e-8) * allowed * allowed))) return false;
  at.distance = sqrt(size);
  at.normal = r / at.distance;
  return true;
}

struct Line {
  Pack s, t, det;
  PackMask inside;
};
Line crossing(const Pack product[5]) {
  const Pack a = product[0], b = product[1], c = product[2], e = product[3], f = product[4];
  const Pack det = a * c - b * b, s = b * f - c * e, t = a * f - b * e;
  return {s, t, det, (det > 1e-14 * a * c) & (s > zero) & (s < det) & (t > zero) & (t < det)};
}

// By how much the weight of crossing edges fades, and how that changes with the corners.
struct Fade {
  Pack value = one;
  PackMask fades;
  Pack3 gradient[4];
  bool any = false;
};

// Where edges cross at a clear angle and far from their ends they count whole. Returns where they cross.
PackMask edges(const Pack3 x[4], Pack allowed, const Pack ends[2], Place& at, Fade& fade_of) {
  const PackMask none = Pack(zero) > Pack(zero);
  const Pack3 u = x[1] - x[0], v = x[3] - x[2], r = x[0] - x[2];
  const Pack product[5] = {dot(u, u), dot(u, v), dot(v, v), dot(u, r), dot(v, r)};
  const Line line = crossing(product);
  if (!any(line.inside)) return none;
  const Pack s = line.s / line.det, t = line.t / line.det;
  const Pack weight[4] = {one - s, s, -(one - t), -t};
  for (int i = 0; i < 4; ++i) at.weight[i] = weight[i];
  if (!measure(x, line.inside, allowed, at)) return none;
  const PackMask whole = (line.det >= parallel * product[0] * product[2]) & (s >= ends[0]) &
                         (s <= one - ends[0]) & (t >= ends[1]) & (t <= one - ends[1]);
  fade_of.fades = line.inside & !whole;
  fade_of.any = any(fade_of.fades & !(at.distance > allowed));
  if (!fade_of.any) return line.inside;
  const Jet<Pack, false> m = fade<false>(product, ends);
  const Pack3 by_u = (2 * m.first[0]) * u + m.first[1] * v + m.first[3] * r,
              by_v = m.first[1] * u + (2 * m.first[2]) * v + m.first[4] * r,
              by_r = m.first[3] * u + m.first[4] * v, nothing{zero, zero, zero};
  const Pack3 gradient[4] = {by_r - by_u, by_u, nothing - by_v - by_r, by_v};
  for (int i = 0; i < 4; ++i) fade_of.gradient[i] = gradient[i];
  fade_of.value = select(fade_of.fades, m.value, one);
  return line.inside;
}

// The weights of the closest point of a side of a facet, or its corner; k: the opposite corner.
void side(const Pack3 x[4], int k, Pack weight[4]) {
  const int a = k % 3 + 1, b = (k + 1) % 3 + 1;
  const Pack3 u = x[b] - x[a];
  const Pack length = squared(u),
             t = select(length > zero, min(max(dot(u, x[0] - x[a]) / length, zero), one), zero);
  weight[0] = one;
  weight[k] = zero;
  weight[a] = -(one - t);
  weight[b] = -t;
}
void corner(const Pack3*, int k, Pack weight[4]) {
  for (int i = 1; i < 4; ++i) weight[i] = i == k ? -one : zero;
  weight[0] = one;
}

// What of the facets is nearest: side or corner k where side[k - 1] or corner[k - 1] are set, else the
// inside.
struct Parts {
  PackMask side[3], corner[3];
};

// As point_triangle(). Returns where the nearest place is within `allowed`; border: where others may be, too.
PackMask facet(const Pack3 x[4], Pack allowed, Place& at, Parts& part, PackMask& border) {
  const Pack3 ab = x[2] - x[1], ac = x[3] - x[1], ap = x[0] - x[1], bp = x[0] - x[2], cp = x[0] - x[3];
  const Pack d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp),
             d6 = dot(ac, cp);
  const Pack vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  part.corner[0] = (d1 <= zero) & (d2 <= zero);
  part.corner[1] = (d3 >= zero) & (d4 <= d3) & !part.corner[0];
  PackMask taken = part.corner[0] | part.corner[1];
  part.corner[2] = (d6 >= zero) & (d5 <= d6) & !taken;
  taken = taken | part.corner[2];
  part.side[2] = (vc <= zero) & (d1 >= zero) & (d3 <= zero) & !taken;
  taken = taken | part.side[2];
  part.side[1] = (vb <= zero) & (d2 >= zero) & (d6 <= zero) & !taken;
  taken = taken | part.side[1];
  part.side[0] = (va <= zero) & (d4 - d3 >= zero) & (d5 - d6 >= zero) & !taken;
  border = taken | part.side[0];
  const Pack sum = va + vb + vc, v = vb / sum, w = vc / sum, u = one - v - w;
  const Pack weight[4] = {one, -u, -v, -w};
  for (int i = 0; i < 4; ++i) at.weight[i] = weight[i];
  const auto put = [&](PackMask where, void (*of)(const Pack3*, int, Pack*), int k) {
    if (!any(where)) return;
    Pack other[4];
    of(x, k, other);
    for (int i = 0; i < 4; ++i) at.weight[i] = select(where, other[i], at.weight[i]);
  };
  if (any(border)) {
    for (int k = 1; k <= 3; ++k) put(part.side[k - 1], side, k);
    for (int k = 3; k >= 1; --k) put(part.corner[k - 1], corner, k);
  }
  if (!measure(x, all(), allowed, at)) return Pack(zero) > Pack(zero);
  // The squares of the distances from the lines through the sides, times those of the sides.
  const Pack3 bc = x[3] - x[2];
  const Pack b2 = squared(ab), c2 = squared(ac), bc2 = squared(bc),
             area = b2 * c2 - dot(ab, ac) * dot(ab, ac);
  const Pack3 off = ap - v * ab - w * ac;
  const Pack left = (1 + 1e-6) * allowed * allowed - squared(off);
  border = border | (w * w * area <= left * b2) | (v * v * area <= left * c2) | (u * u * area <= left * bc2);
  return all();
}

// Where there is no plane the distance is no number, and nothing touches.
void plane(const Pack3 x[4], Place& at) {
  const Pack3 first = x[2] - x[1], second = x[3] - x[1], r = x[0] - x[1], across = cross(first, second);
  const Pack a = dot(first, first), b = dot(first, second), c = dot(second, second), det = a * c - b * b,
             e = dot(first, r), f = dot(second, r), s = (c * e - b * f) / det, t = (a * f - b * e) / det;
  const Pack weight[4] = {one, -(one - s - t), -s, -t};
  for (int i = 0; i < 4; ++i) at.weight[i] = weight[i];
  at.normal = across / norm(across);
  at.distance = dot(at.normal, r);
}

// --- the law

struct Answer {
  Pack energy, pressure, stiffness;
};

Answer answer(const BatchLaw& law, Pack d) {
  Answer out{zero, zero, zero};
  for (int i = 0; i < law.count; ++i) {
    const double* k = law.knots + 4 * i;
    const PackMask beyond = i == 0 ? all() : d < Pack(k[0]);
    if (!any(beyond)) break;  // the gaps descend
    const double rate = i + 1 < law.count ? (k[5] - k[1]) / (k[0] - k[4]) : 0;
    const Pack h = Pack(k[0]) - d, stiffness = Pack(k[1]) + rate * h,
               pressure = Pack(k[2]) + h * (Pack(k[1]) + rate * h / 2),
               energy = Pack(k[3]) + h * (Pack(k[2]) + h * (Pack(k[1] / 2) + rate * h / 6));
    out = {select(beyond, energy, out.energy), select(beyond, pressure, out.pressure),
           select(beyond, stiffness, out.stiffness)};
  }
  return out;
}

// --- friction

// The slip after the step, turned with what it belongs to; see slips.cpp.
Pack3 carried(const Pack3& slip, const Pack3& u0, const Pack3& v0, const Pack3& u, const Pack3& v) {
  const Pack a = dot(u0, u0), b = dot(u0, v0), c = dot(v0, v0), det = a * c - b * b;
  const Pack3 n0 = cross(u0, v0), n = cross(u, v);
  const Pack size = squared(n), e = dot(slip, u0), f = dot(slip, v0);
  const Pack3 turned =
      (c * e - b * f) / det * u + (a * f - b * e) / det * v + dot(slip, n0) / norm(n0) * (n / sqrt(size));
  return select((det > 1e-12 * a * c) & (size > zero), norm(slip) / norm(turned) * turned, slip);
}

Pack3 turned(BatchKind kind, const Pack3& slip, const Pack3 from[4], const Pack3 to[4]) {
  const PackMask none = same(slip, {zero, zero, zero});
  if (kind == BatchKind::edges)
    return select(none, slip,
                  carried(slip, from[1] - from[0], from[3] - from[2], to[1] - to[0], to[3] - to[2]));
  const PackMask rests = same(from[1], to[1]) & same(from[2], to[2]) & same(from[3], to[3]);
  if (!any(!(none | rests))) return slip;
  return select(none | rests, slip,
                carried(slip, from[2] - from[1], from[3] - from[1], to[2] - to[1], to[3] - to[1]));
}

// Of the places of a pair together, see Force.
struct Sums {
  Pack3 on[4] = {{zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}};
  Pack3 pull{zero, zero, zero}, torque{zero, zero, zero};
  Pack resists[4] = {zero, zero, zero, zero};
  Pack contact = zero, stick = zero, work = zero, impact = zero, damped = zero;
};

void choose(PackMask where, const Sums& from, Sums& to) {
  for (int i = 0; i < 4; ++i) to.on[i] = select(where, from.on[i], to.on[i]);
  for (int i = 0; i < 4; ++i) to.resists[i] = select(where, from.resists[i], to.resists[i]);
  to.pull = select(where, from.pull, to.pull);
  to.torque = select(where, from.torque, to.torque);
  to.contact = select(where, from.contact, to.contact);
  to.stick = select(where, from.stick, to.stick);
  to.work = select(where, from.work, to.work);
  to.impact = select(where, from.impact, to.impact);
  to.damped = select(where, from.damped, to.damped);
}

// The pairs of a pack.
struct Pairs {
  const BatchLaw& law;
  const BatchPairs& pairs;
  const BatchStep& step;
  int first;  // lane
  Pack3 x[4], start[4];
  Pack inverse_mass[4], crowd[4];
  Pack area, scale;
  bool counts_once = false;

  Pairs(const BatchLaw& law, const BatchPairs& pairs, const BatchStep& step, int first)
      : law(law),
        pairs(pairs),
        step(step),
        first(first),
        area(load(pairs.area + first)),
        scale(load(pairs.scale + first)) {}
  void load_points(Pack3* place, Pack* number, const double* from) const {
    for (int k = 0; k < 4; ++k) {
      if (k > 0 && law.kind == BatchKind::plane) {  // all meet the same wall
        const double* row = from + sizeof(BatchPoint) / sizeof(double) * pairs.corner[k][0];
        place[k] = {row[0], row[1], row[2]};
        number[k] = row[3];
        continue;
      }
      const double* rows[pack_width];
      for (int i = 0; i < pack_width; ++i)
        rows[i] = from + sizeof(BatchPoint) / sizeof(double) * pairs.corner[k][first + i];
      Pack column[4];
      load_rows(rows, column);
      place[k] = {column[0], column[1], column[2]};
      number[k] = column[3];
    }
  }

  // nearest: the slip of a pair is that of its nearest place, which comes first.
  void press(const Place& at, const Fade* fade_of, bool nearest, Sums& sums) const;
  void damp(const Place& at, const Pack3& moved, Pack damping, bool nearest, Sums& sums) const;
  void rub(const Place& at, Pack pressure, Pack stiffness, bool nearest, Sums& sums) const;
  void store_sums(const Sums& sums, Pack gap) const;
};

void Pairs::press(const Place& at, const Fade* fade_of, bool nearest, Sums& sums) const {
  const Answer here = answer(law, (at.distance - Pack(law.offset)) / scale);
  const Pack energy = here.energy * (scale * scale), pressure = here.pressure * scale;
  sums.contact += at.count * energy;
  const Pack push = at.count * pressure;
  for (int i = 0; i < 4; ++i) sums.on[i] = sums.on[i] + (push * at.weight[i]) * at.normal;
  if (fade_of != nullptr)
    for (int i = 0; i < 4; ++i)
      sums.on[i] = select(fade_of->fades, sums.on[i] - (area * energy) * fade_of->gradient[i], sums.on[i]);
  if (law.rubs) rub(at, pressure, here.stiffness, nearest, sums);
}

void Pairs::damp(const Place& at, const Pack3& moved, Pack damping, bool nearest, Sums& sums) const {
  const Pack press = at.count * damping, closed = -dot(at.normal, moved);
  if (nearest) sums.impact = 0.5 * load(step.held->damped + first) * closed;
  const PackMask closes = !(press == zero);
  for (int i = 0; i < 4; ++i)
    sums.on[i] = select(closes, sums.on[i] + (press * at.weight[i]) * at.normal, sums.on[i]);
  sums.damped = select(closes, sums.damped + press, sums.damped);
  sums.impact = select(closes, sums.impact + 0.5 * press * closed, sums.impact);
}

void Pairs::rub(const Place& at, Pack pressure, Pack stiffness, bool nearest, Sums& sums) const {
  const Pack3 n = at.normal, lever = Pack(law.offset) * n;
  Pack3 moved{zero, zero, zero};
  if (law.offset != 0) {
    const Pack3 by = cross({Pack(law.turn[0]), Pack(law.turn[1]), Pack(law.turn[2])}, lever);
    moved = {-by.x, -by.y, -by.z};
  }
  for (int i = 0; i < 4; ++i) moved = moved + at.weight[i] * (x[i] - start[i]);
  const Pack opened = dot(n, moved);
  const Pack3 slid = moved - opened * n;
  const Pack slope = Pack(-law.loss) * sqrt(min(stiffness, Pack(law.stiffest))) / Pack(law.dt),
             damping = select(opened >= zero, zero, slope * opened);
  damp(at, moved, damping, nearest, sums);
  if (!law.coulomb) {
    for (ByLane& v : step.tried->slip) store(v + first, zero);
    store(step.tried->slides + first, zero);
    return;
  }
  // The spring, and what gives way.
  const Pack3 held = load3(step.held->slip, first);
  const Pack3 trial = slid + held - dot(n, held) * n;
  const Pack length = norm(trial), spring = Pack(law.spring) * abs(at.count),
             against = abs(at.count) * (pressure + damping);
  const Pack before = select(dot(slid, held) > zero, load(step.held->slides + first), zero);
  const PackMask goes_on = before >= one;
  const Pack most = select(goes_on, Pack(law.friction), Pack(law.holding)) * against;
  const PackMask sticks = spring * length <= most;
  const Pack kept = select(sticks, one, most / (spring * length));
  // The resistance of an explicit step.
  const Pack times = counts_once ? Pack(one) : at.count / area;
  Pack lightness = zero, alone = zero;
  for (int i = 0; i < 4; ++i) {
    const Pack share = at.weight[i] * at.weight[i] * inverse_mass[i];
    lightness += share;
    alone += any(!(crowd[i] == one)) ? select(crowd[i] == one, share, share / crowd[i]) : share;
  }
  const PackMask gives_way = lightness > zero;
  for (int i = 0; i < 4; ++i)
    if (any(inverse_mass[i] > zero))
      sums.resists[i] = select(
          gives_way, sums.resists[i] + times * abs(at.weight[i]) * inverse_mass[i] / (crowd[i] * alone),
          sums.resists[i]);
  const Pack resists = select(gives_way, 0.2 * abs(times) / (lightness * Pack(law.dt) * Pack(law.dt)), zero);
  Pack3 pull = spring * trial + resists * slid;
  const Pack size = norm(pull);
  pull = select(size > most, (most / size) * pull, pull);
  pull = select(at.count < zero, Pack3{-pull.x, -pull.y, -pull.z}, pull);
  for (int i = 0; i < 4; ++i) sums.on[i] = sums.on[i] - at.weight[i] * pull;
  if (law.offset != 0) sums.torque = sums.torque + cross(lever, pull);
  sums.pull = sums.pull + pull;
  sums.stick += select(at.count < zero, -spring, spring) * kept * kept * squared(trial) / 2;
  sums.work += 0.5 * dot(pull, slid);
  if (!nearest) return;
  sums.work += 0.5 * dot(load3(step.held->pull, first), slid);
  const Pack slides = select(most > zero, min(one, before + (spring * length - most) / most), one);
  store(step.tried->slides + first, select(sticks, before, slides));
  store3(step.tried->slip, first, turned(law.kind, kept * trial, start, x));
}

void Pairs::store_sums(const Sums& sums, Pack gap) const {
  double* rows[pack_width];
  for (int i = 0; i < pack_width; ++i) rows[i] = step.forces[pairs.slot[first + i]].on[0];
  const auto four = [&](Pack a, Pack b, Pack c, Pack d) {
    const Pack column[4] = {a, b, c, d};
    store_rows(rows, column);
    for (double*& row : rows) row += 4;
  };
  for (int k = 0; k < 4; ++k) four(sums.on[k].x, sums.on[k].y, sums.on[k].z, sums.resists[k]);
  four(sums.contact, sums.stick, sums.work, sums.impact);
  four(gap, sums.torque.x, sums.torque.y, sums.torque.z);
  if (!law.rubs) return;
  store3(step.tried->pull, first, sums.pull);
  store(step.tried->damped + first, sums.damped);
  store(step.tried->gap + first, gap);
}

// How often what is nearest of the facets counts, and their sides and corners beside it: see each_counted().
struct Counts {
  Pack nearest = one, side[3] = {zero, zero, zero}, corner[3] = {zero, zero, zero};
  PackMask others() const {
    PackMask any = !(side[0] == zero);
    for (int k = 1; k < 3; ++k) any = any | !(side[k] == zero);
    for (int k = 0; k < 3; ++k) any = any | !(corner[k] == zero);
    return any;
  }
};

Counts counts_of(const Pairs& pairs, const Parts& nearest) {
  const auto load = [&](const std::int8_t* of_lanes) {
    Pack out;
    for (int i = 0; i < pack_width; ++i) out.set(i, of_lanes[pairs.first + i]);
    return out;
  };
  Counts out;
  for (int k = 0; k < 3; ++k) {
    const Pack at_corner = load(pairs.pairs.at_corner[k]), at_side = load(pairs.pairs.at_edge[k]);
    out.corner[k] += at_corner;
    if (!any(!(at_side == zero))) continue;
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    Pack weight[4];
    side(pairs.x, k + 1, weight);
    const PackMask first = weight[b + 1] == zero, second = (weight[a + 1] == zero) & !first;
    out.corner[a] += select(first, at_side, zero);
    out.corner[b] += select(second, at_side, zero);
    out.side[k] += select(first | second, zero, at_side);
  }
  const auto join = [&](PackMask where, Pack& part) {
    out.nearest += select(where, part, zero);
    part = select(where, zero, part);
  };
  for (int k = 0; k < 3; ++k) {
    join(nearest.side[k], out.side[k]);
    join(nearest.corner[k], out.corner[k]);
  }
  return out;
}

void add_others(const Pairs& pairs, PackMask where, const Counts& counts, Pack reach, Sums& sums) {
  const Pack allowed = reach + Pack(pairs.law.offset);
  const auto add = [&](void (*of)(const Pack3*, int, Pack*), int k, Pack times) {
    const PackMask there = where & !(times == zero);
    if (!any(there)) return;
    Place at;
    of(pairs.x, k, at.weight);
    if (!measure(pairs.x, there, allowed, at)) return;
    const PackMask here = there & (at.distance - Pack(pairs.law.offset) < reach);
    if (!any(here)) return;
    at.count = pairs.area * times;
    Sums with = sums;
    pairs.press(at, nullptr, false, with);
    choose(here, with, sums);
  };
  for (int k = 1; k <= 3; ++k) add(side, k, counts.side[k - 1]);
  for (int k = 1; k <= 3; ++k) add(corner, k, counts.corner[k - 1]);
}

// --- the kernel

[[gnu::flatten]] void press_part(const BatchLaw& law, const BatchPairs& pairs, const BatchStep& step,
                                 int first, BatchTouch& out) {
  Pairs at(law, pairs, step, first);
  at.load_points(at.x, at.inverse_mass, step.points->x);
  const Pack reach = Pack(law.gap) * at.scale, allowed = reach + Pack(law.offset),
             ends[2] = {load(pairs.zone[0] + first), load(pairs.zone[1] + first)};
  Place nearest;
  Fade fade_of;
  Parts parts;
  PackMask border = Pack(zero) > Pack(zero), here = all();
  if (law.kind == BatchKind::plane)
    plane(at.x, nearest);
  else if (law.kind == BatchKind::facet)
    here = facet(at.x, allowed, nearest, parts, border);
  else
    here = edges(at.x, allowed, ends, nearest, fade_of);
  if (!any(here)) return;
  const Pack gap = nearest.distance - Pack(law.offset);
  const PackMask in_reach = here & (gap < reach);
  Counts counts;
  if (any(border & in_reach)) counts = counts_of(at, parts);
  const PackMask first_counts = !(counts.nearest == zero), others = border & counts.others(),
                 counted = in_reach & (first_counts | others),
                 special = counted & !((gap / at.scale >= Pack(law.guard)) & first_counts),
                 touches = counted & !special;
  out.special |= bits(special) << first;
  const unsigned touching = bits(touches) << first;
  if (touching == 0) return;
  out.touching |= touching;
  if (law.rubs) {
    if (const unsigned begin = touching & ~step.used; begin != 0) step.find(step.who, begin);
    at.load_points(at.start, at.crowd, step.points->start);
  }
  nearest.count = at.area * fade_of.value * counts.nearest;
  at.counts_once = !fade_of.any && !any(!(counts.nearest == one));
  Sums sums;
  at.press(nearest, fade_of.any ? &fade_of : nullptr, true, sums);
  at.counts_once = false;
  if (any(others & touches)) add_others(at, others & touches, counts, reach, sums);
  at.store_sums(sums, gap - Pack(law.floor) * at.scale);
}

BatchTouch press(const BatchLaw& law, const BatchPairs& pairs, const BatchStep& step) {
  BatchTouch out;
  for (int first = 0; first < lanes; first += pack_width) press_part(law, pairs, step, first, out);
  return out;
}

}  // namespace

BatchPress batch_press_of_isa();
BatchPress batch_press_of_isa() { return press; }

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::contact
