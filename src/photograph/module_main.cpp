// photographs.so: the room as a module, by the interface of lab/photographs.hpp.

#include "base/version.hpp"
#include "photograph/photographs.hpp"

extern "C" __attribute__((visibility("default"))) const fabricsh::lab::Photographs* fabricsh_photographs(
    const char* version) {
  static const fabricsh::photograph::Photographs part;
  return fabricsh::version() == version ? &part : nullptr;
}
