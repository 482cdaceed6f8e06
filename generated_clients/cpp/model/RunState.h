/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * RunState.h
 *
 *
 */

#ifndef PROCTOR_MODEL_RunState_MODEL_H_
#define PROCTOR_MODEL_RunState_MODEL_H_

#include <string>
#include <map>
#include <vector>
#include <utility>
#include <boost/json.hpp>
#include "ValidationTypes.h"

namespace proctor {
namespace model {

/// <summary>
///
/// </summary>
using RunState = std::string;

boost::json::value toJsonValue_RunState(RunState const& value);
RunState fromJsonValue_RunState(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_RunState_MODEL_H_ */
