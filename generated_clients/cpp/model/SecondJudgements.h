/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include <string>
#include <map>
#include <vector>
#include "../members.h"

namespace proctor {

/// How a second person judged a sample of the episodes of a run; see profiles/physical.md.
struct SecondJudgements {
    static constexpr char const* schema_name = "SecondJudgements";

    std::int32_t drawn{}; // Episodes of the sample with a first judgement.
    std::int32_t judgements{}; // Those of them with a second one.
    std::vector<std::string> judges{}; // Names of the second judges that are not their accounts.
    std::int32_t both{}; // Episodes that both judges called a success.
    std::int32_t first_alone{}; // Those that the first judge alone called one.
    std::int32_t second_alone{}; // Those that the second judge alone called one.
    std::int32_t neither{}; // Those that no judge called one.
    std::optional<double> kappa{}; // Cohen's kappa of these; null where chance alone would make them agree.

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("drawn", self.drawn);
        visitor.required("judgements", self.judgements);
        visitor.required("judges", self.judges);
        visitor.required("both", self.both);
        visitor.required("first_alone", self.first_alone);
        visitor.required("second_alone", self.second_alone);
        visitor.required("neither", self.neither);
        visitor.required("kappa", self.kappa);
    }
};

} // namespace proctor
