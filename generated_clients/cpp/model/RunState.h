/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <string>

namespace proctor {

/// One of queued, ready, running, stopping, stopped, failed, completed.
using RunState = std::string;

} // namespace proctor
