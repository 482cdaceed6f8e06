/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Rotation.h
 *
 *
 */

#ifndef PROCTOR_MODEL_Rotation_MODEL_H_
#define PROCTOR_MODEL_Rotation_MODEL_H_

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
using Rotation = std::string;

boost::json::value toJsonValue_Rotation(Rotation const& value);
Rotation fromJsonValue_Rotation(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_Rotation_MODEL_H_ */
