/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <string>

namespace proctor {

/// One of success, failure, abandoned.
using Outcome = std::string;

} // namespace proctor
