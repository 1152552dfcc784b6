// The rows of fields (base/field.hpp) of declarations: what a deck gives by name, beside sets and bodies.
#pragma once
#include "base/field.hpp"
#include "model/declarations.hpp"

namespace fabricsh::model {

const std::vector<field::FieldOf<StrengthGiven>>& strength_rows();
const std::vector<field::FieldOf<CreaseGiven>>& crease_rows();
const std::vector<field::FieldOf<Seam>>& seam_rows();
const std::vector<field::FieldOf<GasGiven>>& gas_rows();
const std::vector<field::FieldOf<ContactGiven>>& contact_rows();  // friction has several forms, and none here

}  // namespace fabricsh::model
