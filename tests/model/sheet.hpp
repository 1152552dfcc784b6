// A sheet of two by three quadrilaterals, of which models are told things.
#pragma once
#include "model/model.hpp"
#include "test_cards.hpp"

namespace fabricsh::test {

inline model::Model make_model() {
  return {std::make_shared<mesh::Mesh>(mesh::rectangle(0.04, 0.06, 2, 3)), blend(), model::Options{}};
}

}  // namespace fabricsh::test
