/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * CalibrationOptions.h
 *
 * Only for the benchmark &#x60;calibration&#x60;, which the submitter shapes.
 */

#ifndef PROCTOR_MODEL_CalibrationOptions_MODEL_H_
#define PROCTOR_MODEL_CalibrationOptions_MODEL_H_

#include "CalibrationTask.h"
#include "SuccessRule.h"
#include <string>
#include <map>
#include <vector>
#include <utility>
#include <memory>
#include <boost/json.hpp>
#include "NullableField.h"

namespace proctor {
namespace model {



/// <summary>
/// Only for the benchmark &#x60;calibration&#x60;, which the submitter shapes.
/// </summary>
class CalibrationOptions
{
public:
    CalibrationOptions() = default;
    explicit CalibrationOptions(boost::json::value const& value);
    virtual ~CalibrationOptions() = default;

    std::string toJsonString(bool prettyJson = false) const;
    void fromJsonString(std::string const& jsonString);
    boost::json::value toJsonValue() const;
    void fromJsonValue(boost::json::value const& value);
    using ExtraJsonProperties = std::map<std::string, boost::json::value>;

    ExtraJsonProperties const& getExtraJsonProperties() const noexcept
    {
        return m_extraJsonProperties;
    }

    void setExtraJsonProperties(ExtraJsonProperties extraJsonProperties)
    {
        m_extraJsonProperties = std::move(extraJsonProperties);
    }

    /////////////////////////////////////////////
    /// CalibrationOptions members

    /// <summary>
    /// One entry per episode, in order; one &#x60;score&#x60; episode when absent.
    /// </summary>
    std::vector<CalibrationTask> getTasks() const;
    void setTasks(std::vector<CalibrationTask> value);

    /// <summary>
    /// 10 when absent.
    /// </summary>
    std::int32_t getMaxSteps() const;
    void setMaxSteps(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    SuccessRule getSuccessRule() const;
    void setSuccessRule(SuccessRule value);

    /// <summary>
    /// 3 when absent.
    /// </summary>
    std::int32_t getMaxAttempts() const;
    void setMaxAttempts(std::int32_t value);

    /// <summary>
    /// 3 when absent.
    /// </summary>
    std::int32_t getMaxFaults() const;
    void setMaxFaults(std::int32_t value);

    /// <summary>
    /// Seconds for which the run stays queued after submit and after resume; 0 when absent.
    /// </summary>
    double getQueueS() const;
    void setQueueS(double value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::vector<CalibrationTask> m_Tasks;
    bool m_TasksIsSet = false;
    std::int32_t m_Max_steps = 0;
    bool m_Max_stepsIsSet = false;
    SuccessRule m_Success_rule;
    bool m_Success_ruleIsSet = false;
    std::int32_t m_Max_attempts = 0;
    bool m_Max_attemptsIsSet = false;
    std::int32_t m_Max_faults = 0;
    bool m_Max_faultsIsSet = false;
    double m_Queue_s = 0.0;
    bool m_Queue_sIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<CalibrationOptions>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<CalibrationOptions>>& vec, const std::string& json);

CalibrationOptions fromJsonValue_CalibrationOptions(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_CalibrationOptions_MODEL_H_ */
