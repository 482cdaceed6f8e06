/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Outcome.h
 *
 *
 */

#ifndef PROCTOR_MODEL_Outcome_MODEL_H_
#define PROCTOR_MODEL_Outcome_MODEL_H_

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
using Outcome = std::string;

boost::json::value toJsonValue_Outcome(Outcome const& value);
Outcome fromJsonValue_Outcome(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_Outcome_MODEL_H_ */
