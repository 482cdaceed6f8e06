/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <cstdint>
#include "VectorSpace.h"
#include "ImageSpace.h"
#include <map>
#include "TensorSpace.h"
#include <vector>
#include "../members.h"

namespace proctor {


struct ObservationSpace {
    static constexpr char const* schema_name = "ObservationSpace";

    std::map<std::string, VectorSpace> state{};
    std::map<std::string, ImageSpace> images{};
    std::map<std::string, TensorSpace> tensors{};

    template <typename Self, typename Visitor> static void visit(Self& self, Visitor& visitor) {
        visitor.required("state", self.state);
        visitor.required("images", self.images);
        visitor.required("tensors", self.tensors);
    }
};

} // namespace proctor
