/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * OutOfRange.h
 *
 *
 */

#ifndef PROCTOR_MODEL_OutOfRange_MODEL_H_
#define PROCTOR_MODEL_OutOfRange_MODEL_H_

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
using OutOfRange = std::string;

boost::json::value toJsonValue_OutOfRange(OutOfRange const& value);
OutOfRange fromJsonValue_OutOfRange(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_OutOfRange_MODEL_H_ */
