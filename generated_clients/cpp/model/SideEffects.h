/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * SideEffects.h
 *
 *
 */

#ifndef PROCTOR_MODEL_SideEffects_MODEL_H_
#define PROCTOR_MODEL_SideEffects_MODEL_H_

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
using SideEffects = std::string;

boost::json::value toJsonValue_SideEffects(SideEffects const& value);
SideEffects fromJsonValue_SideEffects(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_SideEffects_MODEL_H_ */
