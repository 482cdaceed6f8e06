/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * ComparedRun.h
 *
 * One run beside the baseline. A pair is an episode that both have scored.
 */

#ifndef PROCTOR_MODEL_ComparedRun_MODEL_H_
#define PROCTOR_MODEL_ComparedRun_MODEL_H_

#include "ComparedTask.h"
#include <string>
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
/// One run beside the baseline. A pair is an episode that both have scored.
/// </summary>
class ComparedRun
{
public:
    ComparedRun() = default;
    explicit ComparedRun(boost::json::value const& value);
    virtual ~ComparedRun() = default;

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
    /// ComparedRun members

    /// <summary>
    ///
    /// </summary>
    std::string getRunId() const;
    void setRunId(std::string value);

    /// <summary>
    /// Both runs have scored every episode.
    /// </summary>
    bool isComplete() const;
    void setComplete(bool value);

    /// <summary>
    /// Complete, and no difference, over all episodes or over those of a task, is beyond the tolerance.
    /// </summary>
    bool isRelease() const;
    void setRelease(bool value);

    /// <summary>
    /// Number of pairs.
    /// </summary>
    std::int32_t getPaired() const;
    void setPaired(std::int32_t value);

    /// <summary>
    /// Mean score of the baseline over the pairs.
    /// </summary>
    std::optional<double> getBaselineMean() const;
    void setBaselineMean(std::optional<double> value);

    /// <summary>
    /// Mean score of the run over the pairs.
    /// </summary>
    std::optional<double> getMean() const;
    void setMean(std::optional<double> value);

    /// <summary>
    /// Baseline minus run: positive when the run is worse.
    /// </summary>
    std::optional<double> getDifference() const;
    void setDifference(std::optional<double> value);

    /// <summary>
    /// Pairs in which the run alone succeeds.
    /// </summary>
    std::int32_t getWins() const;
    void setWins(std::int32_t value);

    /// <summary>
    /// Pairs in which the baseline alone succeeds.
    /// </summary>
    std::int32_t getLosses() const;
    void setLosses(std::int32_t value);

    /// <summary>
    /// Pairs in which both succeed or neither does.
    /// </summary>
    std::int32_t getTies() const;
    void setTies(std::int32_t value);

    /// <summary>
    /// McNemar&#39;s exact test, two-sided.
    /// </summary>
    double getPValue() const;
    void setPValue(double value);

    /// <summary>
    /// Task \342\206\222 the pairs of its episodes.
    /// </summary>
    std::map<std::string, ComparedTask> getByTask() const;
    void setByTask(std::map<std::string, ComparedTask> value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Run_id = "";
    bool m_Complete = false;
    bool m_Release = false;
    std::int32_t m_Paired = 0;
    std::optional<double> m_Baseline_mean;
    std::optional<double> m_Mean;
    std::optional<double> m_Difference;
    std::int32_t m_Wins = 0;
    std::int32_t m_Losses = 0;
    std::int32_t m_Ties = 0;
    double m_P_value = 0.0;
    std::map<std::string, ComparedTask> m_By_task;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<ComparedRun>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<ComparedRun>>& vec, const std::string& json);

ComparedRun fromJsonValue_ComparedRun(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_ComparedRun_MODEL_H_ */
