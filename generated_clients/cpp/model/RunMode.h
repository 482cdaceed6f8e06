/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <string>

namespace proctor {

/// One of pull, push.
using RunMode = std::string;

} // namespace proctor
