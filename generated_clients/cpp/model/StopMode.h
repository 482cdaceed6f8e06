/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * StopMode.h
 *
 * &#x60;abort&#x60; when absent.
 */

#ifndef PROCTOR_MODEL_StopMode_MODEL_H_
#define PROCTOR_MODEL_StopMode_MODEL_H_

#include <string>
#include <map>
#include <vector>
#include <utility>
#include <boost/json.hpp>
#include "ValidationTypes.h"

namespace proctor {
namespace model {

/// <summary>
/// &#x60;abort&#x60; when absent.
/// </summary>
using StopMode = std::string;

boost::json::value toJsonValue_StopMode(StopMode const& value);
StopMode fromJsonValue_StopMode(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_StopMode_MODEL_H_ */
