// Numbers in messages.
#pragma once
#include <string>

namespace fabricsh::law {

std::string number(double x);       // "0.3414": four digits
std::string pressure(double pa);    // "12 MPa", "8 Pa"
std::string percent(double ratio);  // "59 %"

}  // namespace fabricsh::law
