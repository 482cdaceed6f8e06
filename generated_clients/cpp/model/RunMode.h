/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * RunMode.h
 *
 * &#x60;pull&#x60; when absent: workers attach and predict. &#x60;push&#x60;: the server calls the policy itself, and workers of the run are its own.
 */

#ifndef PROCTOR_MODEL_RunMode_MODEL_H_
#define PROCTOR_MODEL_RunMode_MODEL_H_

#include <string>
#include <map>
#include <vector>
#include <utility>
#include <boost/json.hpp>
#include "ValidationTypes.h"

namespace proctor {
namespace model {

/// <summary>
/// &#x60;pull&#x60; when absent: workers attach and predict. &#x60;push&#x60;: the server calls the policy itself, and workers of the run are its own.
/// </summary>
using RunMode = std::string;

boost::json::value toJsonValue_RunMode(RunMode const& value);
RunMode fromJsonValue_RunMode(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_RunMode_MODEL_H_ */
