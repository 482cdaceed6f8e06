/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * CalibrationTask.h
 *
 *
 */

#ifndef PROCTOR_MODEL_CalibrationTask_MODEL_H_
#define PROCTOR_MODEL_CalibrationTask_MODEL_H_

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
using CalibrationTask = std::string;

boost::json::value toJsonValue_CalibrationTask(CalibrationTask const& value);
CalibrationTask fromJsonValue_CalibrationTask(boost::json::value const& value);


}
}

#endif /* PROCTOR_MODEL_CalibrationTask_MODEL_H_ */
