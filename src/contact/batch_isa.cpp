// Pairs that touch in a plain way, a batch at a time: compiled once per instruction set.
#include "contact/batch.hpp"
#include "simd/pack.hpp"

namespace fabricsh::contact {
inline namespace FABRICSH_ISA {

namespace {

struct Pack3 {
  Pack x, y, z;
  friend Pack3 operator+(const Pack3& a, const Pack3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Pack3 operator-(const Pack3& a, const Pack3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Pack3 operator*(Pack s, const Pack3& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend Pack3 operator/(const Pack3& a, Pack s) { return {a.x / s, a.y / s, a.z / s}; }
};
Pack dot(const Pack3& a, const Pack3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Pack squared(const Pack3& a) { return dot(a, a); }
Pack norm(const Pack3& a) { return sqrt(squared(a)); }
Pack3 cross(const Pack3& a, const Pack3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Pack3 select(PackMask c, const Pack3& a, const Pack3& b) {
  return {fabricsh::select(c, a.x, b.x), fabricsh::select(c, a.y, b.y), fabricsh::select(c, a.z, b.z)};
}
PackMask same(const Pack3& a, const Pack3& b) { return (a.x == b.x) & (a.y == b.y) & (a.z == b.z); }
Pack3 load3(const ByLane* v, int first) {
  return {load(v[0] + first), load(v[1] + first), load(v[2] + first)};
}
void store3(ByLane* v, int first, const Pack3& a) {
  store(v[0] + first, a.x);
  store(v[1] + first, a.y);
  store(v[2] + first, a.z);
}
constexpr double zero = 0, one = 1;  // packs at this place would be made before the processor is known
PackMask all() { return Pack(one) > Pack(zero); }

// --- the closest points

struct Found {
  Pack weight[4];
  PackMask here, special;
};

struct Line {
  Pack s, t, det, a, c;
  PackMask inside;
};
Line crossing(const Pack3& u, const Pack3& v, const Pack3& r) {
  const Pack a = dot(u, u), b = dot(u, v), c = dot(v, v), e = dot(u, r), f = dot(v, r);
  const Pack det = a * c - b * b, s = b * f - c * e, t = a * f - b * e;
  return {s, t, det, a, c, (det > 1e-14 * a * c) & (s > zero) & (s < det) & (t > zero) & (t < det)};
}

// Where edges cross at a clear angle and far from their ends they count whole.
Found edges(const Pack3 x[4], Pack first, Pack second) {
  const Line at = crossing(x[1] - x[0], x[3] - x[2], x[0] - x[2]);
  const Pack s = at.s / at.det, t = at.t / at.det;
  const PackMask whole = (at.det >= 0.02 * at.a * at.c) & (s >= first) & (s <= one - first) & (t >= second) &
                         (t <= one - second);
  return {{one - s, s, -(one - t), -t}, at.inside, at.inside & !whole};
}

// Above the inside of a facet, and farther than allowed from its sides.
Found facet(const Pack3 x[4], Pack allowed) {
  const Pack3 ab = x[2] - x[1], ac = x[3] - x[1], ap = x[0] - x[1], bp = x[0] - x[2], cp = x[0] - x[3];
  const Pack d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp),
             d6 = dot(ac, cp);
  const Pack vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  const PackMask border = ((d1 <= zero) & (d2 <= zero)) | ((d3 >= zero) & (d4 <= d3)) |
                          ((d6 >= zero) & (d5 <= d6)) | ((vc <= zero) & (d1 >= zero) & (d3 <= zero)) |
                          ((vb <= zero) & (d2 >= zero) & (d6 <= zero)) |
                          ((va <= zero) & (d4 - d3 >= zero) & (d5 - d6 >= zero));
  const Pack sum = va + vb + vc, v = vb / sum, w = vc / sum, u = one - v - w;
  // The squares of the distances from the lines through the sides, times those of the sides.
  const Pack3 bc = x[3] - x[2];
  const Pack b2 = squared(ab), c2 = squared(ac), bc2 = squared(bc),
             area = b2 * c2 - dot(ab, ac) * dot(ab, ac);
  const Pack3 off = ap - v * ab - w * ac;
  const Pack left = (1 + 1e-6) * allowed * allowed - squared(off);
  const PackMask beside =
      (w * w * area <= left * b2) | (v * v * area <= left * c2) | (u * u * area <= left * bc2);
  return {{one, -u, -v, -w}, all(), border | beside};
}

Found plane(const Pack3 x[4], Pack3& normal, Pack& distance) {
  const Pack3 first = x[2] - x[1], second = x[3] - x[1], r = x[0] - x[1], across = cross(first, second);
  const Pack a = dot(first, first), b = dot(first, second), c = dot(second, second), det = a * c - b * b,
             e = dot(first, r), f = dot(second, r), s = (c * e - b * f) / det, t = (a * f - b * e) / det;
  normal = across / norm(across);
  distance = dot(normal, r);
  return {{one, -(one - s - t), -s, -t}, all(), !(det > zero)};
}

// --- the law

struct Answer {
  Pack energy, pressure, stiffness;
};

Answer answer(const BatchLaw& law, Pack d) {
  Answer out{zero, zero, zero};
  for (int i = 0; i < law.count; ++i) {
    const double* k = law.knots + 4 * i;
    const double rate = i + 1 < law.count ? (k[5] - k[1]) / (k[0] - k[4]) : 0;
    const Pack h = Pack(k[0]) - d, stiffness = Pack(k[1]) + rate * h,
               pressure = Pack(k[2]) + h * (Pack(k[1]) + rate * h / 2),
               energy = Pack(k[3]) + h * (Pack(k[2]) + h * (Pack(k[1] / 2) + rate * h / 6));
    const PackMask beyond = i == 0 ? all() : d < Pack(k[0]);
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
  return select((det > 1e-12 * a * c) & (size > zero), turned, slip);
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

struct Rubbing {
  const BatchLaw& law;
  const BatchPairs& pairs;
  int first;
  const Pack3 *x, *start;
  const Pack* weight;
  Pack3 normal;
  Pack count, distance, pressure, stiffness;
};

void rub(const Rubbing& at, BatchForces& out, Pack3 on[4]) {
  const BatchLaw& law = at.law;
  const BatchPairs& pairs = at.pairs;
  const int first = at.first;
  const Pack3 n = at.normal, lever = Pack(law.offset) * n;
  Pack3 moved{zero, zero, zero};
  if (law.offset != 0) {
    const Pack3 by = cross({Pack(law.turn[0]), Pack(law.turn[1]), Pack(law.turn[2])}, lever);
    moved = {-by.x, -by.y, -by.z};
  }
  for (int i = 0; i < 4; ++i) moved = moved + at.weight[i] * (at.x[i] - at.start[i]);
  const Pack opened = dot(n, moved);
  const Pack3 slid = moved - opened * n;
  // The damping of approach.
  const Pack slope = Pack(-law.loss) * sqrt(min(at.stiffness, Pack(law.stiffest))) / Pack(law.dt),
             damping = select(opened >= zero, zero, slope * opened), press = at.count * damping,
             closed = -opened;
  Pack impact = 0.5 * load(pairs.damped + first) * closed;
  const PackMask closes = !(press == zero);
  for (int i = 0; i < 4; ++i) on[i] = select(closes, on[i] + (press * at.weight[i]) * n, on[i]);
  store(out.damped + first, select(closes, press, zero));
  store(out.impact + first, select(closes, zero + impact + 0.5 * press * closed, zero + impact));
  if (!law.coulomb) {
    const Pack3 none{zero, zero, zero};
    store3(out.slip, first, none);
    store3(out.pull, first, none);
    store3(out.torque, first, none);
    store(out.stick + first, zero);
    store(out.work + first, zero);
    store(out.slides + first, zero);
    for (ByLane& v : out.resists) store(v + first, zero);
    return;
  }
  // The spring, and what gives way.
  const Pack3 held = load3(pairs.held, first);
  const Pack3 trial = slid + held - dot(n, held) * n;
  const Pack length = norm(trial), spring = Pack(law.spring) * abs(at.count),
             against = abs(at.count) * (at.pressure + damping), most = Pack(law.friction) * against;
  const PackMask goes_on = (load(pairs.slides + first) > zero) & (dot(slid, held) > zero);
  const Pack holds = select(goes_on, most, Pack(law.holding) * against);
  const PackMask sticks = spring * length <= holds;
  const Pack bound = select(sticks, holds, most), kept = select(sticks, one, most / (spring * length));
  // The resistance of an explicit step.
  Pack lightness = zero, alone = zero, light[4], crowd[4];
  for (int i = 0; i < 4; ++i) {
    light[i] = load(pairs.inverse_mass[i] + first);
    crowd[i] = load(pairs.crowd[i] + first);
    const Pack share = at.weight[i] * at.weight[i] * light[i];
    lightness += share;
    alone += select(crowd[i] == one, share, share / crowd[i]);
  }
  const PackMask gives_way = lightness > zero;
  for (int i = 0; i < 4; ++i)
    store(out.resists[i] + first,
          select(gives_way, zero + abs(at.weight[i]) * light[i] / (crowd[i] * alone), zero));
  const Pack resists = select(gives_way, 0.2 / (lightness * Pack(law.dt) * Pack(law.dt)), zero);
  Pack3 pull = spring * trial + resists * slid;
  const Pack size = norm(pull);
  pull = select(size > bound, (bound / size) * pull, pull);
  for (int i = 0; i < 4; ++i) on[i] = on[i] - at.weight[i] * pull;
  store3(out.torque, first, law.offset != 0 ? cross(lever, pull) : Pack3{zero, zero, zero});
  store3(out.pull, first, pull);
  store(out.stick + first, spring * kept * kept * squared(trial) / 2);
  store(out.work + first, zero + 0.5 * dot(pull, slid) + 0.5 * dot(load3(pairs.pull, first), slid));
  store(out.slides + first, select(goes_on | !sticks, one, zero));
  store3(out.slip, first, turned(law.kind, kept * trial, at.start, at.x));
}

// --- the kernels

void press_part(const BatchLaw& law, const BatchPairs& pairs, int first, BatchForces& out) {
  Pack3 x[4], start[4];
  for (int i = 0; i < 4; ++i) {
    x[i] = load3(pairs.x[i], first);
    start[i] = load3(pairs.start[i], first);
  }
  const Pack scale = load(pairs.scale + first), reach = Pack(law.gap) * scale;
  Pack3 normal{zero, zero, zero};
  Pack distance = zero;
  Found found;
  if (law.kind == BatchKind::plane) {
    found = plane(x, normal, distance);
  } else {
    found = law.kind == BatchKind::edges ? edges(x, load(pairs.zone[0] + first), load(pairs.zone[1] + first))
                                         : facet(x, reach + Pack(law.offset));
    Pack3 r{zero, zero, zero};
    for (int i = 0; i < 4; ++i) r = r + found.weight[i] * x[i];
    distance = norm(r);
    normal = r / distance;
  }
  const Pack gap = distance - Pack(law.offset), d = gap / scale;
  const PackMask touches = found.here & (gap < reach);
  const PackMask special = touches & (found.special | !(d >= Pack(law.guard)));
  const PackMask border = found.here & found.special;  // of facets: nearer than the point inside
  out.touching |= bits(touches & !special) << first;
  out.special |= bits(law.kind == BatchKind::facet ? special | border : special) << first;
  const Answer law_here = answer(law, d);
  const Pack count = load(pairs.area + first), pressure = law_here.pressure * scale;
  store(out.contact + first, zero + count * (law_here.energy * (scale * scale)));
  store(out.gap + first, gap - Pack(law.floor) * scale);
  const Pack push = count * pressure;
  Pack3 on[4];
  for (int i = 0; i < 4; ++i) on[i] = Pack3{zero, zero, zero} + (push * found.weight[i]) * normal;
  if (law.rubs)
    rub({law, pairs, first, x, start, found.weight, normal, count, distance, pressure, law_here.stiffness},
        out, on);
  for (int i = 0; i < 4; ++i) store3(out.on[i], first, on[i]);
}

void press(const BatchLaw& law, const BatchPairs& pairs, BatchForces& out) {
  out.touching = out.special = 0;
  for (int first = 0; first < lanes; first += pack_width) press_part(law, pairs, first, out);
}

// m2: from a point to a segment.
Pack to_segment(const Pack3& p, const Pack3& u) {
  const Pack t = min(max(dot(u, p) / max(dot(u, u), Pack(1e-300)), zero), one);
  return squared(p - t * u);
}

PackMask near_facet(const Pack3 x[4], Pack far) {
  const Pack3 ab = x[2] - x[1], ac = x[3] - x[1], bc = x[3] - x[2], ap = x[0] - x[1], bp = x[0] - x[2];
  const Pack sides = min(min(to_segment(ap, ab), to_segment(ap, ac)), to_segment(bp, bc));
  // Above the inside the height counts; beside it the sides do.
  const Pack3 n = cross(ab, ac);
  const Pack height = dot(n, ap);
  const PackMask inside =
      (dot(cross(ab, ap), n) >= zero) & (dot(cross(ap, ac), n) >= zero) & (dot(cross(bc, bp), n) >= zero);
  return (!(sides > far)) | (inside & !(height * height > far * squared(n)));
}

unsigned near(BatchKind kind, const ByCorner& corners, const ByLane& far) {
  unsigned out = 0;
  for (int first = 0; first < lanes; first += pack_width) {
    Pack3 x[4];
    for (int i = 0; i < 4; ++i) x[i] = load3(corners[i], first);
    const Pack most = load(far + first);
    PackMask is;
    if (kind == BatchKind::edges) {
      const Pack3 u = x[1] - x[0], v = x[3] - x[2], r = x[0] - x[2];
      const Line at = crossing(u, v, r);
      is = at.inside & !(squared(r + at.s / at.det * u - at.t / at.det * v) > most);
    } else {
      is = near_facet(x, most);
    }
    out |= bits(is) << first;
  }
  return out;
}

}  // namespace

BatchKernels batch_kernels_of_isa();
BatchKernels batch_kernels_of_isa() { return {near, press}; }

}  // namespace FABRICSH_ISA
}  // namespace fabricsh::contact
