/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <string>

namespace proctor {

/// One of published, withdrawn.
using EntryState = std::string;

} // namespace proctor
