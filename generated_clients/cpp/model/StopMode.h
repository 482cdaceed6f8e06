/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <string>

namespace proctor {

/// One of abort, drain.
using StopMode = std::string;

} // namespace proctor
