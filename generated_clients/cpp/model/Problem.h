/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Problem.h
 *
 * RFC 9457, with what a client needs to decide on a retry.
 */

#ifndef PROCTOR_MODEL_Problem_MODEL_H_
#define PROCTOR_MODEL_Problem_MODEL_H_

#include "SessionEnd.h"
#include <string>
#include "RunState.h"
#include <map>
#include <vector>
#include "SideEffects.h"
#include "AnyType.h"
#include "ProblemItem.h"
#include <utility>
#include <memory>
#include <boost/json.hpp>
#include "NullableField.h"

namespace proctor {
namespace model {



/// <summary>
/// RFC 9457, with what a client needs to decide on a retry.
/// </summary>
class Problem
{
public:
    Problem() = default;
    explicit Problem(boost::json::value const& value);
    virtual ~Problem() = default;

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
    /// Problem members

    /// <summary>
    ///
    /// </summary>
    std::string getType() const;
    void setType(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::string getTitle() const;
    void setTitle(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getStatus() const;
    void setStatus(std::int32_t value);

    /// <summary>
    /// What happened and what to do about it.
    /// </summary>
    std::string getDetail() const;
    void setDetail(std::string value);

    /// <summary>
    /// One of x-problems.
    /// </summary>
    std::string getCode() const;
    void setCode(std::string value);

    /// <summary>
    /// Whether the same request can succeed later.
    /// </summary>
    bool isRetryable() const;
    void setRetryable(bool value);

    /// <summary>
    ///
    /// </summary>
    SideEffects getSideEffects() const;
    void setSideEffects(SideEffects value);

    /// <summary>
    ///
    /// </summary>
    std::vector<ProblemItem> getErrors() const;
    void setErrors(std::vector<ProblemItem> value);

    /// <summary>
    /// Id of the rule that was enforced.
    /// </summary>
    std::string getRequirement() const;
    void setRequirement(std::string value);

    /// <summary>
    ///
    /// </summary>
    RunState getState() const;
    void setState(RunState value);

    /// <summary>
    ///
    /// </summary>
    std::int64_t getExpectedSeq() const;
    void setExpectedSeq(std::int64_t value);

    /// <summary>
    ///
    /// </summary>
    SessionEnd getEndedBy() const;
    void setEndedBy(SessionEnd value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Type = "";
    std::string m_Title = "";
    std::int32_t m_Status = 0;
    std::string m_Detail = "";
    std::string m_Code = "";
    bool m_Retryable = false;
    SideEffects m_Side_effects;
    std::vector<ProblemItem> m_Errors;
    bool m_ErrorsIsSet = false;
    std::string m_Requirement = "";
    bool m_RequirementIsSet = false;
    RunState m_State;
    bool m_StateIsSet = false;
    std::int64_t m_Expected_seq = 0L;
    bool m_Expected_seqIsSet = false;
    SessionEnd m_Ended_by;
    bool m_Ended_byIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Problem>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Problem>>& vec, const std::string& json);

Problem fromJsonValue_Problem(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Problem_MODEL_H_ */
