/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <string>

namespace proctor {

/// One of none, possible.
using SideEffects = std::string;

} // namespace proctor
