/* What `spec/calibration.md` says of actions. */
#pragma once

#include <vector>

#include "models.h"

namespace worker {

using proctor::Action;

/// One action of `calibration`; its success is a score above one half.
inline Action act(double score) {
    return {{{"score", {score}}, {"success", {score > 0.5 ? 1.0 : 0.0}}, {"end", {0}}, {"delay_s", {0}}, {"fault", {0}},
             {"vector", std::vector<double>(8)}, {"clipped", {0, 0}}}};
}

} // namespace worker
