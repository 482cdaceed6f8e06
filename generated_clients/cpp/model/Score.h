/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Score.h
 *
 * See scoring.md for every number here.
 */

#ifndef PROCTOR_MODEL_Score_MODEL_H_
#define PROCTOR_MODEL_Score_MODEL_H_

#include "GroupScore.h"
#include <string>
#include "RunState.h"
#include "Interval.h"
#include <map>
#include <vector>
#include "AnyType.h"
#include "OutcomeCounts.h"
#include <utility>
#include <memory>
#include <boost/json.hpp>
#include "NullableField.h"

namespace proctor {
namespace model {



/// <summary>
/// See scoring.md for every number here.
/// </summary>
class Score
{
public:
    Score() = default;
    explicit Score(boost::json::value const& value);
    virtual ~Score() = default;

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
    /// Score members

    /// <summary>
    ///
    /// </summary>
    std::string getRunId() const;
    void setRunId(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::string getBenchmarkId() const;
    void setBenchmarkId(std::string value);

    /// <summary>
    /// The digest of a manifest, which is all of a benchmark that can change a score, written in a form that the server chooses and keeps. Only equality means anything, and only among digests of the same server software.
    /// </summary>
    std::string getManifestSha256() const;
    void setManifestSha256(std::string value);

    /// <summary>
    ///
    /// </summary>
    RunState getState() const;
    void setState(RunState value);

    /// <summary>
    ///
    /// </summary>
    bool isComplete() const;
    void setComplete(bool value);

    /// <summary>
    /// Null until complete.
    /// </summary>
    std::optional<double> getScore() const;
    void setScore(std::optional<double> value);

    /// <summary>
    ///
    /// </summary>
    double getScoreLow() const;
    void setScoreLow(double value);

    /// <summary>
    ///
    /// </summary>
    double getScoreHigh() const;
    void setScoreHigh(double value);

    /// <summary>
    ///
    /// </summary>
    OutcomeCounts getCounts() const;
    void setCounts(OutcomeCounts value);

    /// <summary>
    ///
    /// </summary>
    std::optional<double> getSuccessRate() const;
    void setSuccessRate(std::optional<double> value);

    /// <summary>
    ///
    /// </summary>
    Interval getSuccessInterval() const;
    void setSuccessInterval(Interval value);

    /// <summary>
    /// Mean over the scored episodes.
    /// </summary>
    std::optional<double> getMean() const;
    void setMean(std::optional<double> value);

    /// <summary>
    ///
    /// </summary>
    Interval getMeanInterval() const;
    void setMeanInterval(Interval value);

    /// <summary>
    ///
    /// </summary>
    std::map<std::string, GroupScore> getByTask() const;
    void setByTask(std::map<std::string, GroupScore> value);

    /// <summary>
    ///
    /// </summary>
    std::map<std::string, GroupScore> getBySplit() const;
    void setBySplit(std::map<std::string, GroupScore> value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Run_id = "";
    std::string m_Benchmark_id = "";
    std::string m_Manifest_sha256 = "";
    RunState m_State;
    bool m_Complete = false;
    std::optional<double> m_Score;
    double m_Score_low = 0.0;
    double m_Score_high = 0.0;
    OutcomeCounts m_Counts;
    std::optional<double> m_Success_rate;
    Interval m_Success_interval;
    std::optional<double> m_Mean;
    Interval m_Mean_interval;
    std::map<std::string, GroupScore> m_By_task;
    std::map<std::string, GroupScore> m_By_split;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Score>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Score>>& vec, const std::string& json);

Score fromJsonValue_Score(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Score_MODEL_H_ */
