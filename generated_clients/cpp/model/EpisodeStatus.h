/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <string>

namespace proctor {

/// One of pending, in_progress, scored.
using EpisodeStatus = std::string;

} // namespace proctor
