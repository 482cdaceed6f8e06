/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "SecondJudgements.h"
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// How people judged the run; with the profile `physical`.
struct JudgedRun {
    static constexpr char const* schema_name = "JudgedRun";

    std::vector<std::string> judges{}; // Names of the people that are not their accounts, as in records.
    std::int32_t judgements{}; // Episodes with a judgement.
    bool blind{}; // Whether each judge knew nothing of the policy.
    std::map<std::string, std::int32_t> voids{}; // How many trials were void, by reason.
    std::map<std::string, std::string> notes{}; // What judges wrote, by episode_id.
    std::optional<std::map<std::string, std::string>> cells{}; // The cell at which an episode was judged, by episode_id; absent where the benchmark has one cell.
    std::optional<SecondJudgements> second{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("judges", self.judges);
        visitor.required("judgements", self.judgements);
        visitor.required("blind", self.blind);
        visitor.required("voids", self.voids);
        visitor.required("notes", self.notes);
        visitor.optional("cells", self.cells);
        visitor.optional("second", self.second);
    }
};

} // namespace proctor
