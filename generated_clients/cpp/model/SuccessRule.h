/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <string>

namespace proctor {

/// One of any_step, last_step.
using SuccessRule = std::string;

} // namespace proctor
