/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Dtype.h
 *
 *
 */

#ifndef PROCTOR_MODEL_Dtype_MODEL_H_
#define PROCTOR_MODEL_Dtype_MODEL_H_

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
using Dtype = std::string;

boost::json::value toJsonValue_Dtype(Dtype const& value);
Dtype fromJsonValue_Dtype(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_Dtype_MODEL_H_ */
