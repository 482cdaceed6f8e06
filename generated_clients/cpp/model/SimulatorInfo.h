/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {


struct SimulatorInfo {
    static constexpr char const* schema_name = "SimulatorInfo";

    std::string name{};
    std::string version{};
    std::optional<std::string> quality{}; // Named rendering quality, where there is one.
    std::optional<std::map<std::string, std::string>> sources{}; // File that the simulator [loads](simulator.md) → its SHA-256: an edit of it makes another manifest. Absent where none is announced.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("name", self.name);
        visitor.required("version", self.version);
        visitor.optional("quality", self.quality);
        visitor.optional("sources", self.sources);
    }
};

} // namespace proctor
