/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include "Player.h"
#include <vector>
#include "Assumptions.h"
#include "../members.h"

namespace proctor {


struct AttachWorker {
    static constexpr char const* schema_name = "AttachWorker";

    std::string attach_key{}; // New for every attachment; repeated only to repeat a lost request.
    std::optional<bool> takeover{}; // Fence out a live session; false when absent. For the profile `sessions`.
    std::optional<Assumptions> assumes{};
    std::optional<Player> player{};
    std::optional<std::int32_t> first_episodes{}; // How many of the first episodes of the run are wanted; the session begins none behind them (SUB-005). All when absent. For the profile `subsets`.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("attach_key", self.attach_key);
        visitor.optional("takeover", self.takeover);
        visitor.optional("assumes", self.assumes);
        visitor.optional("player", self.player);
        visitor.optional("first_episodes", self.first_episodes);
    }
};

} // namespace proctor
