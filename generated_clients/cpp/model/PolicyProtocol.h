/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <string>

namespace proctor {

/// One of proctor, openai_chat, openai_completions.
using PolicyProtocol = std::string;

} // namespace proctor
