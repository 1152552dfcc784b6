// The tracker against photographs of a known field.
#include <cmath>
#include <numbers>
#include <optional>

#include "draws.hpp"
#include "message_of.hpp"
#include "photograph/tracker.hpp"

using namespace fabricsh;
using namespace fabricsh::photograph;

namespace {

// Pulled by E along y, contracting by half of it, and turned by the angle.
std::array<double, 4> pulled(double E, double angle) {
  const double along = std::sqrt(1 + 2 * E), across = std::sqrt(1 - E), c = std::cos(angle),
               s = std::sin(angle);
  return {c * across, -s * along, s * across, c * along};
}

// 100 pixels a centimetre, dots of 2 mm every centimetre.
DotGrid scene() {
  DotGrid s;
  s.width = 900;
  s.height = 1000;
  s.rows = 6;
  s.columns = 4;
  s.pitch = 100;
  s.radius = 10;
  return s;
}

}  // namespace

TEST_CASE("a dot's middle as well as the noise lets it be known", "[lab]") {
  for (const double blur : {0.7, 1.0, 2.0}) {
    DotGrid s = scene();
    s.blur = blur;
    double squares = 0, count = 0;
    for (int k = 0; k < 6; ++k) {
      s.F = pulled(0.05 * k, 0.06 * k);
      s.seed = static_cast<std::uint64_t>(k + 1);
      const auto dots = find_dots(draw(s), {});
      const auto reference = true_positions(s);
      REQUIRE(dots.size() == 24);
      for (const Dot& d : dots) {
        double best = 1e9;
        for (std::size_t m = 0; m < 24; ++m)
          best = std::min(best, std::hypot(d.x - reference[2 * m], d.y - reference[2 * m + 1]));
        squares += best * best;
        count += 1;
        CHECK(std::abs(d.contrast - 0.7) < 0.02);
      }
    }
    // Cramer and Rao: along one axis the sum of (dI/dx)^2 over a round rim is contrast^2 pi R / (2 sqrt(pi)
    // blur).
    const double pi = std::numbers::pi, contrast = s.ground - s.ink;
    const double bound =
        s.noise / std::sqrt(contrast * contrast * pi * s.radius / (2 * std::sqrt(pi) * blur));
    const double rms = std::sqrt(squares / count / 2);
    INFO("blur " << blur << ": rms " << rms << " px along an axis, at best " << bound);
    CHECK(rms < 1.25 * bound);  // the rim of 0.7 px falls between pixels; 8 bits; scatter of 288 values 4 %
    CHECK(rms > 0.8 * bound);
  }
}

TEST_CASE("a blot that is no ellipse keeps its centroid", "[lab]") {
  Image image{60, 60, std::vector<float>(3600, 0.9F)};
  double x = 0, y = 0, n = 0;
  for (int r = 20; r < 40; ++r)
    for (int c = 20; c < 40; ++c) {
      if (c >= 30 && r >= 30) continue;  // an L
      image.at(c, r) = 0.1F;
      x += c, y += r, n += 1;
    }
  const auto dots = find_dots(image, {});
  REQUIRE(dots.size() == 1);
  CHECK(std::abs(dots[0].x - x / n) < 1e-6);  // float pixels
  CHECK(std::abs(dots[0].y - y / n) < 1e-6);
}

TEST_CASE("strain to 2e-4 through 50 % and 30 degrees", "[lab]") {
  constexpr int frames = 16;
  std::optional<Tracker> tracker;
  std::vector<std::array<double, 4>> reference;
  for (int f = 0; f < frames; ++f) {
    DotGrid s = scene();
    const double part = f / (frames - 1.0);
    reference.push_back(pulled(0.5 * part, 0.5235987755982988 * part));
    s.F = reference.back();
    s.seed = static_cast<std::uint64_t>(f + 1);
    const auto dots = find_dots(draw(s), {});
    if (!tracker)
      tracker.emplace(s.rows, s.columns, dots);
    else
      tracker->add(dots);
  }
  CHECK(tracker->doubts().empty());
  const Tracks& t = tracker->tracks();
  double squares = 0, worst = 0, mean_worst = 0, n = 0;
  for (std::size_t f = 1; f < t.frames; ++f) {
    std::array<double, 3> mean{};
    for (std::size_t b = 0; b < t.boxes(); ++b) {
      const auto F = box_gradient(t, b, f);
      const auto& G = reference[f];
      const std::array<double, 3> miss{(F[0] * F[0] + F[2] * F[2] - G[0] * G[0] - G[2] * G[2]) / 2,
                                       (F[1] * F[1] + F[3] * F[3] - G[1] * G[1] - G[3] * G[3]) / 2,
                                       (F[0] * F[1] + F[2] * F[3] - G[0] * G[1] - G[2] * G[3]) / 2};
      for (std::size_t k = 0; k < 3; ++k) {
        squares += miss[k] * miss[k];
        worst = std::max(worst, std::abs(miss[k]));
        mean[k] += miss[k] / static_cast<double>(t.boxes());
        n += 1;
      }
    }
    for (const double m : mean) mean_worst = std::max(mean_worst, std::abs(m));
  }
  INFO("strain error of a box: rms " << std::sqrt(squares / n) << ", largest " << worst
                                     << "; of the grid's mean: largest " << mean_worst);
  CHECK(std::sqrt(squares / n) < 2e-4);
  CHECK(mean_worst < 2e-4);
}

TEST_CASE("a grid is known on a first photograph that is turned", "[lab]") {
  DotGrid s = scene();
  s.width = s.height = 1100;
  for (const double strain : {0.0, 0.3})
    for (int degrees = -40; degrees <= 40; degrees += 80 / test::draws(10)) {
      INFO("turned by " << degrees << " degrees, strain " << strain);
      s.F = pulled(strain, degrees * std::numbers::pi / 180);
      const Tracker tracker(s.rows, s.columns, find_dots(draw(s), {}));
      const auto reference = true_positions(s);  // rows downwards
      double worst = 0;
      for (std::size_t r = 0; r < s.rows; ++r)
        for (std::size_t c = 0; c < s.columns; ++c) {
          const std::size_t m = r * s.columns + c, k = 2 * ((s.rows - 1 - r) * s.columns + c);
          worst = std::max(worst, std::hypot(tracker.tracks().x[m] - reference[k],
                                             -tracker.tracks().y[m] - reference[k + 1]));
        }
      CHECK(worst < 0.05);  // noise of the camera, half a hundredth of a pixel
    }
}

TEST_CASE("dots that are no grid are refused", "[lab]") {
  DotGrid s = scene();
  s.width = s.height = 1100;
  const std::string wanted = "dots on the first photograph are no grid of 6 rows and 4 columns";
  s.F = pulled(0, 55 * std::numbers::pi / 180);
  const auto turned = find_dots(draw(s), {});
  says(message_of([&] { Tracker(s.rows, s.columns, turned); }), wanted);
  s.F = {1, 0, 0, 1};
  auto dots = find_dots(draw(s), {});
  Tracker(s.rows, s.columns, dots);
  dots[5].x += 50;  // a stain between two dots, and a dot that is missing
  says(message_of([&] { Tracker(s.rows, s.columns, dots); }), wanted);
}

TEST_CASE("lost and changed dots are told, and found again", "[lab]") {
  const DotGrid s = scene();
  const auto dots = find_dots(draw(s), {});
  Tracker tracker(s.rows, s.columns, dots);
  auto fewer = dots;
  fewer.erase(fewer.begin() + 7);
  tracker.add(fewer);
  auto larger = dots;
  larger[3].area *= 2;
  tracker.add(larger);
  REQUIRE(tracker.doubts().size() == 2);
  CHECK(tracker.doubts()[0].lost);
  CHECK(tracker.doubts()[0].frame == 1);
  CHECK_FALSE(tracker.doubts()[1].lost);
  const Tracks& t = tracker.tracks();
  const std::size_t m = tracker.doubts()[0].marker;
  CHECK(std::isnan(t.x[t.markers() + m]));
  CHECK(t.x[2 * t.markers() + m] == t.x[m]);
  says(message_of([&] { Tracker(s.rows, s.columns, fewer); }),
       "expected 24 dots on the first photograph, found 23");
}

TEST_CASE("light dots on dark cloth, and what is no dot", "[lab]") {
  DotGrid s = scene();
  s.ground = 0.1;
  s.ink = 0.9;
  const auto image = draw(s);
  CHECK(find_dots(image, {false, 12, 1e5, 0.1}).size() == 24);
  CHECK(find_dots(image, {false, 1000, 1e5, 0.1}).empty());
  CHECK(find_dots(image, {false, 12, 100, 0.1}).empty());
  CHECK(find_dots(image, {false, 12, 1e5, 0.95}).empty());
}
