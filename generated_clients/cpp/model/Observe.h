/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Observe.h
 *
 * &#x60;last&#x60; when absent; &#x60;all&#x60; adds the observation after every executed action.
 */

#ifndef PROCTOR_MODEL_Observe_MODEL_H_
#define PROCTOR_MODEL_Observe_MODEL_H_

#include <string>
#include <map>
#include <vector>
#include <utility>
#include <boost/json.hpp>
#include "ValidationTypes.h"

namespace proctor {
namespace model {

/// <summary>
/// &#x60;last&#x60; when absent; &#x60;all&#x60; adds the observation after every executed action.
/// </summary>
using Observe = std::string;

boost::json::value toJsonValue_Observe(Observe const& value);
Observe fromJsonValue_Observe(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_Observe_MODEL_H_ */
