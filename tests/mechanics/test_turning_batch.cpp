// Directors that turn, a batch at a time: against the exact rotation, over small and large angles.
#include <cmath>

#include "catch.hpp"
#include "geometry/vec.hpp"
#include "mechanics/turning_batch.hpp"

using namespace fabricsh;
using mechanics::TurningBatch;

namespace {

const Vec3 kDirector = Vec3(2, -1, 2) / 3;
const Vec3 kAxis = Vec3(1, 2, 0).normalized();  // normal to the director

void set(TurningBatch& batch, int lane, double angle, double turned) {
  for (int c = 0; c < 3; ++c) batch.d[c][lane] = kDirector[c], batch.b1[c][lane] = kAxis[c];
  batch.q[0][lane] = angle * std::cos(turned), batch.q[1][lane] = angle * std::sin(turned);
}

Vec3 at(const double (&v)[3][lanes], int lane) { return {v[0][lane], v[1][lane], v[2][lane]}; }

}  // namespace

TEST_CASE("turning: directors and their first axes turn as by the rotation, by any angle") {
  CHECK(std::abs(kDirector.dot(kAxis)) < 1e-15);
  // About the end of the series; the first lane does not turn.
  const double end = std::sqrt(0.01), angles[lanes] = {0, 1e-9, 1e-3, 0.9999 * end, 1.0001 * end, 0.7, 2, 3};
  for (const double turned : {0.3, 1.9}) {
    TurningBatch batch;
    for (int lane = 0; lane < lanes; ++lane) set(batch, lane, angles[lane], turned);
    turn(batch);
    // The axis of the rotation is normal to the director, so that the way is a great circle.
    const Vec3 way = std::cos(turned) * kAxis + std::sin(turned) * kDirector.cross(kAxis);
    for (int lane = 0; lane < lanes; ++lane) {
      const Mat3 R = Eigen::AngleAxisd(angles[lane], kDirector.cross(way)).toRotationMatrix();
      INFO("angle " << angles[lane]);
      CHECK((at(batch.d, lane) - R * kDirector).norm() < 1e-14);
      CHECK((at(batch.b1, lane) - R * kAxis).norm() < 1e-14);
    }
  }
}

TEST_CASE("turning: the bits of a director are those of any lane and neighbours") {
  TurningBatch alone, among;
  set(alone, 0, 0.05, 0.4);
  for (int lane = 0; lane < lanes; ++lane) set(among, lane, lane == 5 ? 0.05 : 2, 0.4);
  turn(alone);
  turn(among);
  CHECK(at(alone.d, 0) == at(among.d, 5));
  CHECK(at(alone.b1, 0) == at(among.b1, 5));
}
