/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <string>

namespace proctor {

/// One of score, count, echo, delay, fault.
using CalibrationTask = std::string;

} // namespace proctor
