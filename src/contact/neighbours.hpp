// Which points of the cloth count as neighbours, beside those of one element: they touch later, or never.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

namespace fabricsh::contact {

class Neighbours {
 public:
  // The first point of the sheet of a point: sheets are what elements connect.
  std::int32_t sheet(std::int32_t point) const { return sheet_[std::size_t(point)]; }
  bool same_sheet(std::int32_t a, std::int32_t b) const { return sheet(a) == sheet(b); }

  // Crack faces: points that were one with others of their place until a joint opened. For each point how far
  // it has been from all that it was near to, m; -1: it is no crack face. Between crack faces the law's
  // lengths are at most 0.9 of the least of these, so that nothing is pressed when they part, and nothing
  // gets through later. Empty: there are no crack faces.
  void set_apart(std::vector<double> apart) {
    const bool any = std::any_of(apart.begin(), apart.end(), [](double a) { return a >= 0; });
    apart_ = any ? std::move(apart) : std::vector<double>();
  }
  const std::vector<double>& apart() const { return apart_; }
  double apart(std::int32_t point) const { return apart_.empty() ? -1 : apart_[std::size_t(point)]; }

  // Points that seams hold together: of each point those that it is sewn to, ascending. Pairs of such points
  // do not touch, wherever they are in the reference, unless both are crack faces. Empty: there are no seams.
  void sew(std::vector<std::vector<std::int32_t>> partners) { partners_ = std::move(partners); }
  bool is_sewn(std::int32_t point) const {
    return std::size_t(point) < partners_.size() && !partners_[std::size_t(point)].empty();
  }
  bool are_sewn(std::int32_t a, std::int32_t b) const {
    return is_sewn(a) &&
           std::binary_search(partners_[std::size_t(a)].begin(), partners_[std::size_t(a)].end(), b);
  }

 private:
  friend class Scene;                // which finds the sheets
  std::vector<std::int32_t> sheet_;  // of each point
  std::vector<double> apart_;
  std::vector<std::vector<std::int32_t>> partners_;
};

}  // namespace fabricsh::contact
