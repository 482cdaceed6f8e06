/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * EpisodeResult.h
 *
 *
 */

#ifndef PROCTOR_MODEL_EpisodeResult_MODEL_H_
#define PROCTOR_MODEL_EpisodeResult_MODEL_H_

#include <string>
#include "Outcome.h"
#include <map>
#include <vector>
#include "AnyType.h"
#include <utility>
#include <memory>
#include <boost/json.hpp>
#include "NullableField.h"

namespace proctor {
namespace model {



/// <summary>
///
/// </summary>
class EpisodeResult
{
public:
    EpisodeResult() = default;
    explicit EpisodeResult(boost::json::value const& value);
    virtual ~EpisodeResult() = default;

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
    /// EpisodeResult members

    /// <summary>
    ///
    /// </summary>
    std::string getEpisodeId() const;
    void setEpisodeId(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getIndex() const;
    void setIndex(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::string getTask() const;
    void setTask(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::string getSplit() const;
    void setSplit(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::int64_t getSeed() const;
    void setSeed(std::int64_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getAttempt() const;
    void setAttempt(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getFaults() const;
    void setFaults(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    Outcome getOutcome() const;
    void setOutcome(Outcome value);

    /// <summary>
    ///
    /// </summary>
    double getScore() const;
    void setScore(double value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getSteps() const;
    void setSteps(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    bool isTerminated() const;
    void setTerminated(bool value);

    /// <summary>
    ///
    /// </summary>
    bool isTruncated() const;
    void setTruncated(bool value);

    /// <summary>
    /// Time between turns that the policy took.
    /// </summary>
    double getThinkS() const;
    void setThinkS(double value);

    /// <summary>
    ///
    /// </summary>
    std::string getFinishedAt() const;
    void setFinishedAt(std::string value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Episode_id = "";
    std::int32_t m_Index = 0;
    std::string m_Task = "";
    std::string m_Split = "";
    std::int64_t m_Seed = 0L;
    std::int32_t m_Attempt = 0;
    std::int32_t m_Faults = 0;
    Outcome m_Outcome;
    double m_Score = 0.0;
    std::int32_t m_Steps = 0;
    bool m_Terminated = false;
    bool m_Truncated = false;
    double m_Think_s = 0.0;
    std::string m_Finished_at = "";
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<EpisodeResult>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<EpisodeResult>>& vec, const std::string& json);

EpisodeResult fromJsonValue_EpisodeResult(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_EpisodeResult_MODEL_H_ */
