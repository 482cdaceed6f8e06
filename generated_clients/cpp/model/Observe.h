/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <string>

namespace proctor {

/// One of last, all.
using Observe = std::string;

} // namespace proctor
