#include "photograph/photographs.hpp"

#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "photograph/correlation.hpp"
#include "photograph/dots.hpp"
#include "photograph/tracker.hpp"

namespace fabricsh::photograph {

namespace {

Image image_of(const lab::PhotographSeries& series, std::size_t i) {
  const std::string& name = series.names[i];
  check_ending(name);  // before the file is read
  return parse_image(name, series.read(name));
}

// Dots of a photograph within the region, in pixels of the whole.
std::vector<Dot> dots_of(const lab::PhotographSeries& series, std::size_t i, const DotOptions& options) {
  const Image image = image_of(series, i);
  const PixelRegion r = series.region(image.width, image.height);
  auto dots = find_dots(cropped(image, r), options);
  for (Dot& d : dots) d.x += r.left, d.y += r.top;
  return dots;
}

void append(lab::CorrelatedSubsets& out, const std::vector<Subset>& subsets, bool first) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  double count = 0;
  for (std::size_t r = out.rows; r-- > 0;)
    for (std::size_t c = 0; c < out.columns; ++c) {
      const Subset& s = subsets[r * out.columns + c];
      const bool known =
          first ? s.state != Subset::SubsetState::textureless : s.state == Subset::SubsetState::found;
      count += known ? 1 : 0;
      const auto put = [&](std::vector<double>& list, double at_first, double later) {
        list.push_back(!known ? nan : first ? at_first : later);
      };
      put(out.x, s.x, s.x + s.u);
      put(out.y, -s.y, -s.y - s.v);
      put(out.E11, 0, s.strain[0]);
      put(out.E22, 0, s.strain[1]);
      put(out.E12, 0, -s.strain[2]);  // the picture's y points downwards
      put(out.correlation, 1, s.correlation);
      put(out.deviation, 0, s.deviation);
    }
  out.found.push_back(count / static_cast<double>(subsets.size()));
}

}  // namespace

lab::TrackedDots Photographs::track(const lab::PhotographSeries& series, std::size_t rows,
                                    std::size_t columns, const lab::DotOptions& options) const {
  Tracker tracker(rows, columns, dots_of(series, 0, options));
  for (std::size_t i = 1; i < series.names.size(); ++i) tracker.add(dots_of(series, i, options));
  return {tracker.tracks(), tracker.doubts()};
}

lab::CorrelatedSubsets Photographs::correlate(const lab::PhotographSeries& series,
                                              lab::CorrelationOptions options) const {
  const Image first = image_of(series, 0);
  options.region = series.region(first.width, first.height);
  Correlator correlator(first, options);
  lab::CorrelatedSubsets out;
  out.rows = correlator.rows();
  out.columns = correlator.columns();
  append(out, correlator.subsets(), true);
  double most = 0;
  for (std::size_t i = 1; i < series.names.size(); ++i) {
    append(out, correlator.add(image_of(series, i)), false);
    most = std::max(most, out.found.back());
  }
  if (most == 0)
    throw Error("correlate: no subset is found again on any photograph: nothing moved by less than " +
                std::to_string(options.search) + " pixels looks as it did on '" + series.names[0] +
                "' (field 'search'; a series follows larger ways in steps)");
  return out;
}

std::string Photographs::picture(const lab::DotGrid& scene) const { return png_of(draw(scene)); }

std::string Photographs::picture(const lab::Speckles& speckles) const { return png_of(draw(speckles)); }

}  // namespace fabricsh::photograph
