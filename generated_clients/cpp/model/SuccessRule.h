/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * SuccessRule.h
 *
 *
 */

#ifndef PROCTOR_MODEL_SuccessRule_MODEL_H_
#define PROCTOR_MODEL_SuccessRule_MODEL_H_

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
using SuccessRule = std::string;

boost::json::value toJsonValue_SuccessRule(SuccessRule const& value);
SuccessRule fromJsonValue_SuccessRule(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_SuccessRule_MODEL_H_ */
