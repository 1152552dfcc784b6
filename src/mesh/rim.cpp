#include "mesh/rim.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/error.hpp"
#include "base/number.hpp"
#include "mesh/lattice.hpp"

namespace fabricsh::mesh {

void refuse_panel(const std::string& field, const std::string& words) {
  throw Error("panel: field '" + field + "': " + words);
}

std::string place_text(const Vec2& x) { return "(" + number(x.x()) + ", " + number(x.y()) + ")"; }

double doubled_area(const std::vector<Vec2>& line) {
  double sum = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 a = line[i] - line[0], b = line[(i + 1) % line.size()] - line[0];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum;
}

std::vector<Vec2> sampled(const Loop& loop) {
  std::vector<Vec2> line;
  for (const OutlinePiece& piece : loop) {
    const int parts = piece.curve.straight() ? 1 : 64;
    for (int i = 0; i < parts; ++i) line.push_back(piece.curve.at(piece.curve.length() * i / parts));
  }
  return line;
}

bool encloses(const std::vector<Vec2>& line, const Vec2& x) {
  bool inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 &a = line[i], &b = line[(i + 1) % line.size()];
    if ((a.y() > x.y()) == (b.y() > x.y())) continue;
    if (x.x() < a.x() + (x.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

namespace {

// Points nearer to each other than this share of the panel's extent are one place.
constexpr double near = 1e-6;

// How far from the outline a point may be that is meant to lie on it, m: then its nearest place is taken.
double reach(const Panel& shape) { return shape.size / 100; }

double extent_of(const Loop& outline) {
  Vec2 low = outline.front().curve.start(), high = low;
  for (const Vec2& x : sampled(outline)) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).maxCoeff();
}

std::string piece_words(const std::string& loop, std::size_t number, const std::string& edge) {
  const std::string piece = edge.empty() ? "piece " + std::to_string(number + 1) : "edge '" + edge + "'";
  return loop.empty() ? piece : loop + ", " + piece;
}

// Refuses a line that is open or has a piece without length.
void check_closed(const Loop& loop, const std::string& field, const std::string& words, double extent) {
  const std::string of = words.empty() ? "" : words + ": ";
  if (loop.empty()) refuse_panel(field, of + "expected at least one piece, got none");
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const PlaneCurve& curve = loop[i].curve;
    if (!curve.start().allFinite() || !curve.end().allFinite() || !std::isfinite(curve.length()))
      refuse_panel(field, of + piece_words("", i, loop[i].edge) + ": expected finite coordinates, m");
    if (curve.length() <= near * extent)
      refuse_panel(field,
                   of + piece_words("", i, loop[i].edge) + " has no length, at " + place_text(curve.start()));
    const PlaneCurve& next = loop[(i + 1) % loop.size()].curve;
    if (const double gap = (next.start() - curve.end()).norm(); gap > 1e-9 * extent)
      refuse_panel(field, of + "open: it ends at " + place_text(curve.end()) + ", " + number(gap) +
                              " m from where it goes on, " + place_text(next.start()));
  }
}

std::vector<Side> sides_of(const Loop& loop, double size, const std::string& field, const std::string& words,
                           bool counter_clockwise) {
  std::vector<Side> sides;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const OutlinePiece& piece = loop[i];
    const double step =
        piece.elements > 0 ? piece.curve.length() / static_cast<double>(piece.elements) : size;
    sides.push_back(
        {piece.curve, piece.edge, step, piece.elements > 0, field, piece_words(words, i, piece.edge), {}});
  }
  if ((doubled_area(sampled(loop)) > 0) == counter_clockwise) return sides;
  std::reverse(sides.begin(), sides.end());
  for (Side& side : sides) side.curve = side.curve.reversed();
  return sides;
}

// A place on one of the sides of a line.
struct Spot {
  std::size_t loop = 0, side = 0;
  double place = 0;
  double distance = 0;  // of the point asked for, m
};

// The nearest place on the sides of an edge; of an empty name, on all sides.
Spot nearest_spot(const Border& border, const std::string& edge, const Vec2& x) {
  Spot best{0, 0, 0, std::numeric_limits<double>::infinity()};
  for (std::size_t l = 0; l < border.size(); ++l)
    for (std::size_t s = 0; s < border[l].size(); ++s) {
      const Side& side = border[l][s];
      if (!edge.empty() && side.edge != edge) continue;
      const double place = side.curve.nearest(x), distance = (side.curve.at(place) - x).norm();
      if (distance < best.distance) best = {l, s, place, distance};
    }
  return best;
}

// The pieces of an edge in the order in which they were drawn.
std::vector<const PlaneCurve*> pieces_of(const Panel& shape, const std::string& edge) {
  std::vector<const PlaneCurve*> curves;
  const auto look = [&](const Loop& loop) {
    for (const OutlinePiece& piece : loop)
      if (piece.edge == edge) curves.push_back(&piece.curve);
  };
  look(shape.outline);
  for (const Loop& hole : shape.holes) look(hole);
  return curves;
}

std::string notch_words(const Notch& notch) { return "notch '" + notch.name + "'"; }

// The place of a notch that is given by a length or a share of an edge.
Vec2 along_edge(const Panel& shape, const Notch& notch) {
  const auto curves = pieces_of(shape, notch.edge);
  if (curves.empty())
    refuse_panel("notches", notch_words(notch) + ": no edge has the name '" + notch.edge + "'");
  double length = 0;
  for (const PlaneCurve* curve : curves) length += curve->length();
  double rest = notch.at ? *notch.at : *notch.share * length;
  if (!(rest >= 0 && rest <= length))
    refuse_panel("notches", notch_words(notch) + ": expected a place from 0 to " + number(length) +
                                " m along edge '" + notch.edge + "', got " + number(rest));
  for (const PlaneCurve* curve : curves) {
    if (rest <= curve->length() || curve == curves.back()) return curve->at(std::min(rest, curve->length()));
    rest -= curve->length();
  }
  return curves.back()->end();
}

Vec2 notch_place(const Panel& shape, const Border& border, const Notch& notch) {
  const int given = (notch.at ? 1 : 0) + (notch.share ? 1 : 0) + (notch.point ? 1 : 0);
  if (given != 1 || (!notch.point && notch.edge.empty()))
    refuse_panel("notches",
                 notch_words(notch) + ": expected a point, or an edge and one of at= (m) and share=");
  if (!notch.point) return along_edge(shape, notch);
  const Spot spot = nearest_spot(border, notch.edge, *notch.point);
  if (!std::isfinite(spot.distance))
    refuse_panel("notches", notch_words(notch) + ": no edge has the name '" + notch.edge + "'");
  if (spot.distance > reach(shape))
    refuse_panel("notches",
                 notch_words(notch) + ": " + place_text(*notch.point) + " lies " + number(spot.distance) +
                     " m off " +
                     (notch.edge.empty() ? std::string("the outline") : "edge '" + notch.edge + "'"));
  return border[spot.loop][spot.side].curve.at(spot.place);
}

// Replaces the part of the outline between two spots, from the first on, by sides to the tip and back.
void cut_dart(std::vector<Side>& sides, Spot from, Spot to, const Dart& dart, double size, double extent) {
  const auto part = [&sides](std::size_t s, double a, double b) {
    Side side = sides[s];
    side.curve = side.curve.part(a, b);
    return side;
  };
  const auto leg = [&](const Vec2& a, const Vec2& b, const char* which) {
    return Side{
        PlaneCurve::line(a, b), dart.name + which, size, false, "darts", "dart '" + dart.name + "'", {}};
  };
  std::vector<Side> left;  // what stays, from `to` around to `from`
  const std::size_t n = sides.size();
  const auto keep = [&](std::size_t s, double a, double b) {
    if (b - a > near * extent) left.push_back(part(s, a, b));
  };
  const auto whole = [&](std::size_t s) { return sides[s].curve.length(); };
  const Vec2 a = sides[from.side].curve.at(from.place), b = sides[to.side].curve.at(to.place);
  if (from.side == to.side && to.place < from.place) {
    keep(to.side, to.place, from.place);
  } else {
    keep(to.side, to.place, whole(to.side));
    for (std::size_t s = (to.side + 1) % n; s != from.side; s = (s + 1) % n) keep(s, 0, whole(s));
    keep(from.side, 0, from.place);
  }
  left.push_back(leg(a, dart.tip, "_in"));
  left.push_back(leg(dart.tip, b, "_out"));
  sides = std::move(left);
}

double length_between(const std::vector<Side>& sides, const Spot& from, const Spot& to) {
  if (from.side == to.side && to.place >= from.place) return to.place - from.place;
  double length = sides[from.side].curve.length() - from.place + to.place;
  for (std::size_t s = (from.side + 1) % sides.size(); s != to.side; s = (s + 1) % sides.size())
    length += sides[s].curve.length();
  return length;
}

void add_dart(Border& border, const Dart& dart, const Panel& shape, double extent) {
  const Border outline{border.front()};
  const std::string words = "dart '" + dart.name + "': ";
  Spot ends[2];
  const Vec2 given[] = {dart.from, dart.to};
  for (int i = 0; i < 2; ++i) {
    ends[i] = nearest_spot(outline, "", given[i]);
    if (!(ends[i].distance <= reach(shape)))
      refuse_panel("darts", words + "expected 'from' and 'to' on the outline, got " + place_text(given[i]) +
                                ", " + number(ends[i].distance) + " m off it");
    if (outline[0][ends[i].side].field == "darts")
      refuse_panel("darts", words + place_text(given[i]) + " lies on " + outline[0][ends[i].side].words);
  }
  if ((dart.from - dart.to).norm() <= near * extent)
    refuse_panel("darts", words + "expected 'from' and 'to' at different places of the outline");
  if (!encloses(sampled(shape.outline), dart.tip))
    refuse_panel("darts", words + "its tip " + place_text(dart.tip) + " is not inside the outline");
  if (length_between(outline[0], ends[0], ends[1]) > length_between(outline[0], ends[1], ends[0]))
    std::swap(ends[0], ends[1]);
  const Vec2 start = border[0].front().curve.start();
  cut_dart(border[0], ends[0], ends[1], dart, shape.size, extent);
  // The line goes on starting where it was drawn to start, unless the dart has removed that point.
  const auto first = std::find_if(border[0].begin(), border[0].end(),
                                  [&](const Side& side) { return side.curve.start() == start; });
  if (first != border[0].end()) std::rotate(border[0].begin(), first, border[0].end());
}

void stop_at(Border& border, const Notch& notch, const Vec2& x, double extent) {
  Spot spot = nearest_spot(border, notch.edge, x);
  if (!(spot.distance <= near * extent))
    refuse_panel("notches", notch_words(notch) + ": " + place_text(x) + " lies in the mouth of a dart");
  Side& side = border[spot.loop][spot.side];
  const double end = side.curve.length();
  if (spot.place <= near * extent || spot.place >= end - near * extent) return;  // a corner, which has a node
  side.stops.push_back(spot.place);
  std::sort(side.stops.begin(), side.stops.end());
  const auto same = [&](double a, double b) { return b - a <= near * extent; };
  side.stops.erase(std::unique(side.stops.begin(), side.stops.end(), same), side.stops.end());
}

void check_names(const Panel& shape) {
  std::set<std::string> edges, others;
  const auto add_loop = [&edges](const Loop& loop) {
    for (const OutlinePiece& piece : loop) edges.insert(piece.edge);
  };
  add_loop(shape.outline);
  for (const Loop& hole : shape.holes) add_loop(hole);
  const auto take = [&](const std::string& name, const char* field) {
    if (name.empty()) refuse_panel(field, "expected a name");
    if (edges.contains(name) || !others.insert(name).second)
      refuse_panel(field, "expected a name of its own, got '" + name + "' twice");
  };
  for (const Dart& dart : shape.darts) {
    take(dart.name + "_in", "darts");
    take(dart.name + "_out", "darts");
  }
  for (const Notch& notch : shape.notches) take(notch.name, "notches");
  for (const auto* names : {&edges, &others})
    for (const char* taken : {"all", "boundary"})
      if (names->contains(taken))
        refuse_panel(names == &edges ? "outline" : "notches",
                     "'" + std::string(taken) + "' is a set of every mesh: expected another name");
}

}  // namespace

Border border_of(const Panel& shape, std::vector<Vec2>& notches) {
  if (shape.outline.empty()) refuse_panel("outline", "expected at least one piece, got none");
  const double extent = extent_of(shape.outline);
  check_closed(shape.outline, "outline", "", extent);
  check_names(shape);
  Border border{sides_of(shape.outline, shape.size, "outline", "", true)};
  for (std::size_t h = 0; h < shape.holes.size(); ++h) {
    const std::string words = "hole " + std::to_string(h + 1);
    check_closed(shape.holes[h], "holes", words, extent);
    border.push_back(sides_of(shape.holes[h], shape.size, "holes", words, false));
  }
  for (const Notch& notch : shape.notches) notches.push_back(notch_place(shape, border, notch));
  for (const Dart& dart : shape.darts) add_dart(border, dart, shape, extent);
  for (std::size_t i = 0; i < notches.size(); ++i) stop_at(border, shape.notches[i], notches[i], extent);
  return border;
}

Weave weave_of(const Panel& shape, const Border& border) {
  const Vec3 along = direction(shape.rows.value_or(shape.grain));
  Weave weave{{along.x(), along.y()}, {-along.y(), along.x()}};
  Vec2 low = weave.local(border[0].front().curve.start()), high = low;
  for (const Side& side : border[0]) {
    const int parts = side.curve.straight() ? 1 : 256;
    for (int i = 0; i <= parts; ++i) {
      const Vec2 x = weave.local(side.curve.at(side.curve.length() * i / parts));
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
  }
  weave.low = low;
  weave.size = high - low;
  // Rows of equilateral triangles are closer than these are wide.
  const Vec2 wanted(shape.size, shape.triangles ? shape.size * std::sqrt(0.75) : shape.size);
  constexpr double most = 4e6;
  if (!(weave.size.x() / wanted.x() * (weave.size.y() / wanted.y()) <= most))
    refuse_panel("size", "expected a size that gives at most 4000000 elements, got " + number(shape.size) +
                             " m for a panel of " + number(weave.size.x()) + " by " + number(weave.size.y()) +
                             " m");
  for (int k = 0; k < 2; ++k) {
    const auto at = static_cast<std::size_t>(k);
    weave.cells[at] = std::max<Index>(1, std::llround(weave.size[k] / wanted[k]));
    weave.step[k] = weave.size[k] / static_cast<double>(weave.cells[at]);
  }
  return weave;
}

namespace {

// Places of nodes between two stops of a side, without these: where lines of the lattice meet it if it is
// along one of the axes, and evenly otherwise. A curve turns by at most this angle from node to node.
std::vector<double> places_between(const Side& side, double from, double to, const Weave& weave,
                                   double most_turn) {
  const double length = to - from;
  std::vector<double> places;
  const Vec2 a = weave.local(side.curve.at(from)), b = weave.local(side.curve.at(to));
  for (int k = 0; k < 2 && side.curve.straight() && !side.even; ++k) {
    if (std::abs(a[1 - k] - b[1 - k]) > 1e-9 * length) continue;
    const double step = weave.step[k], start = std::min(a[k], b[k]), end = std::max(a[k], b[k]);
    for (double i = std::ceil((start - weave.low[k]) / step + 0.5 - 1e-6);
         weave.low[k] + i * step <= end - (0.5 - 1e-6) * step; ++i)
      places.push_back(from + std::abs(weave.low[k] + i * step - a[k]));
    std::sort(places.begin(), places.end());
    return places;
  }
  const double turns = side.curve.part(from, to).turning() / most_turn;
  const auto parts =
      std::max<Index>({1, std::llround(length / side.step), static_cast<Index>(std::ceil(turns - 1e-6))});
  for (Index i = 1; i < parts; ++i)
    places.push_back(from + length * static_cast<double>(i) / static_cast<double>(parts));
  return places;
}

// All places of nodes on a side but its end.
std::vector<double> places_on(const Side& side, const Weave& weave, bool halved) {
  const double most_turn = halved ? std::numbers::pi / 2 : std::numbers::pi / 4;
  std::vector<double> places, stops = side.stops;
  stops.push_back(side.curve.length());
  double from = 0;
  for (const double stop : stops) {
    places.push_back(from);
    const auto between = places_between(side, from, stop, weave, most_turn);
    places.insert(places.end(), between.begin(), between.end());
    from = stop;
  }
  if (!halved) return places;
  std::vector<double> with_middles;
  places.push_back(side.curve.length());
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    with_middles.push_back(places[i]);
    with_middles.push_back((places[i] + places[i + 1]) / 2);
  }
  return with_middles;
}

// The nodes of an edge, run by run: where a dart interrupts it a new run begins.
void name_edges(const std::vector<Side>& sides, const std::vector<NodeSet>& nodes,
                std::map<std::string, std::vector<NodeSet>>& runs) {
  const std::size_t n = sides.size();
  for (std::size_t s = 0; s < n; ++s) {
    if (sides[s].edge.empty()) continue;
    auto& of_edge = runs[sides[s].edge];
    const bool goes_on = s > 0 && sides[s - 1].edge == sides[s].edge;
    if (!goes_on) of_edge.emplace_back();
    of_edge.back().insert(of_edge.back().end(), nodes[s].begin(), nodes[s].end());
  }
  // An edge over the start of the line is one run.
  auto& last = runs[sides.back().edge];
  if (sides.front().edge == sides.back().edge && !sides.back().edge.empty() && last.size() > 1) {
    last.front().insert(last.front().end(), last.back().begin(), last.back().end());
    last.pop_back();
  }
  if (last.empty()) runs.erase(sides.back().edge);
}

void lay_loop(Rim& rim, const std::vector<Side>& sides, std::size_t loop, const Weave& weave, bool halved,
              std::map<std::string, std::vector<NodeSet>>& runs) {
  const auto first = static_cast<Index>(rim.nodes.size());
  std::vector<NodeSet> of_side(sides.size());
  for (std::size_t s = 0; s < sides.size(); ++s)
    for (const double place : places_on(sides[s], weave, halved)) {
      const auto node = static_cast<Index>(rim.nodes.size());
      of_side[s].push_back(node);
      rim.links.push_back({node, node + 1, loop, s});
      rim.nodes.push_back(sides[s].curve.at(place));
    }
  rim.links.back().second = first;
  for (std::size_t s = 0; s < sides.size(); ++s)
    of_side[s].push_back(of_side[(s + 1) % sides.size()].front());
  name_edges(sides, of_side, runs);
}

// Refuses lines with more nodes than a panel may have elements, before the first is laid: of a circle that
// was meant in other units, of a number of elements.
void check_nodes(const Border& border) {
  constexpr double most = 4e6;
  double all = 0;
  for (const auto& sides : border)
    for (const Side& side : sides) {
      const double length = side.curve.length();
      all += length / side.step + static_cast<double>(side.stops.size()) + 1;
      if (all <= most) continue;
      refuse_panel(side.field, side.words + ": expected at most 4000000 nodes on all lines, got " +
                                   number(all) + " up to here (" + number(length) + " m in steps of " +
                                   number(side.step) + " m)");
    }
}

}  // namespace

Rim lay_nodes(const Border& border, const Weave& weave, bool halved) {
  check_nodes(border);
  Rim rim;
  for (std::size_t l = 0; l < border.size(); ++l) {
    std::map<std::string, std::vector<NodeSet>> runs;
    lay_loop(rim, border[l], l, weave, halved, runs);
    for (const auto& [edge, parts] : runs)
      for (std::size_t i = 0; i < parts.size(); ++i) {
        auto& all = rim.sets[edge];
        all.insert(all.end(), parts[i].begin(), parts[i].end());
        if (parts.size() > 1) rim.sets[edge + "_" + std::to_string(i + 1)] = parts[i];
      }
  }
  return rim;
}

}  // namespace fabricsh::mesh
