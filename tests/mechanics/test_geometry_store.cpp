#include <algorithm>
#include <cmath>
#include <memory>

#include "catch.hpp"
#include "mechanics/assembly.hpp"
#include "mechanics/geometry_store.hpp"
#include "mechanics/terms/cloth.hpp"
#include "mesh/generators.hpp"
#include "model/model.hpp"
#include "test_cards.hpp"

using fabricsh::LineVector;
using fabricsh::element::Sharing;
using fabricsh::mechanics::Batch;
using fabricsh::mechanics::BatchKind;
using fabricsh::mechanics::GeometryStore;

TEST_CASE("batches with the same bits of geometry share one copy, all others have their own") {
  GeometryStore store;
  const BatchKind quadrilaterals{}, triangles{};
  Batch batch;
  batch.kind = &quadrilaterals;
  int found = 0;
  const auto keep = [&](const LineVector& numbers) {
    return store.keep(batch, numbers, [&] {
      ++found;
      return Sharing::element;
    });
  };
  LineVector numbers(4 * fabricsh::lanes, 1.5);
  numbers[3] = 0.0;
  const auto first = keep(numbers);
  CHECK(first.numbers != numbers.data());
  CHECK(std::equal(numbers.begin(), numbers.end(), first.numbers));
  CHECK(keep(LineVector(numbers)).numbers == first.numbers);
  CHECK(found == 1);
  LineVector other = numbers;
  other[3] = -0.0;  // equal, but not the same bits
  const auto second = keep(other);
  CHECK(second.numbers != first.numbers);
  CHECK(std::signbit(second.numbers[3]));
  other[31] = 1.5 * (1 + 1e-15);
  CHECK(keep(other).numbers != second.numbers);
  batch.kind = &triangles;
  CHECK(keep(numbers).numbers != first.numbers);
  CHECK(found == 4);
}

TEST_CASE("a regular sheet keeps the geometry of few batches, an irregular one that of all") {
  using namespace fabricsh;
  for (const bool regular : {true, false}) {
    auto mesh = std::make_shared<mesh::Mesh>(mesh::rectangle(1, 1, 64, 64));  // sides of 2^-6 m: no rounding
    if (!regular)
      mesh->map([](const Vec3& X) {
        return Vec3(X.x() + 1e-3 * std::sin(7.3 * X.x() * (1 + X.y() * X.y())), X.y(), 0);
      });
    model::Options options;
    options.warp = [](const Vec3&) { return model::Direction(0.0); };
    const model::Model model(mesh, test::blend(), options);
    const mechanics::Assembly assembly(model);
    std::vector<const double*> kept;
    for (const Batch& b : assembly.cloth().batches()) kept.push_back(b.geometry);
    std::sort(kept.begin(), kept.end());
    const auto different = std::unique(kept.begin(), kept.end()) - kept.begin();
    CHECK(different == (regular ? 1 : static_cast<long>(kept.size())));
  }
}
