/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Profile.h
 *
 *
 */

#ifndef PROCTOR_MODEL_Profile_MODEL_H_
#define PROCTOR_MODEL_Profile_MODEL_H_

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
using Profile = std::string;

boost::json::value toJsonValue_Profile(Profile const& value);
Profile fromJsonValue_Profile(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_Profile_MODEL_H_ */
