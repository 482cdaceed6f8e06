/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Turn.h
 *
 * The answer to attach (seq 0) and to predict.
 */

#ifndef PROCTOR_MODEL_Turn_MODEL_H_
#define PROCTOR_MODEL_Turn_MODEL_H_

#include "Observation.h"
#include "Lease.h"
#include "EpisodeResult.h"
#include "Fault.h"
#include "Timing.h"
#include "EpisodeView.h"
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
/// The answer to attach (seq 0) and to predict.
/// </summary>
class Turn
{
public:
    Turn() = default;
    explicit Turn(boost::json::value const& value);
    virtual ~Turn() = default;

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
    /// Turn members

    /// <summary>
    ///
    /// </summary>
    std::string getSessionId() const;
    void setSessionId(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::int64_t getSeq() const;
    void setSeq(std::int64_t value);

    /// <summary>
    ///
    /// </summary>
    EpisodeView getEpisode() const;
    void setEpisode(EpisodeView value);

    /// <summary>
    ///
    /// </summary>
    Observation getObservation() const;
    void setObservation(Observation value);

    /// <summary>
    /// With &#x60;observe&#x60; all, one per executed action.
    /// </summary>
    std::vector<Observation> getObservations() const;
    void setObservations(std::vector<Observation> value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getExecutedSteps() const;
    void setExecutedSteps(std::int32_t value);

    /// <summary>
    /// The episode ended before the chunk did.
    /// </summary>
    bool isStoppedEarly() const;
    void setStoppedEarly(bool value);

    /// <summary>
    /// One per executed action.
    /// </summary>
    std::vector<double> getRewards() const;
    void setRewards(std::vector<double> value);

    /// <summary>
    /// The task ended by itself in this turn.
    /// </summary>
    bool isTerminated() const;
    void setTerminated(bool value);

    /// <summary>
    /// The step limit ended the episode in this turn.
    /// </summary>
    bool isTruncated() const;
    void setTruncated(bool value);

    /// <summary>
    ///
    /// </summary>
    EpisodeResult getEpisodeResult() const;
    void setEpisodeResult(EpisodeResult value);

    /// <summary>
    ///
    /// </summary>
    Fault getFault() const;
    void setFault(Fault value);

    /// <summary>
    /// No episode is left for this session. It holds no slot any more; its last turn can be repeated until its lease ends.
    /// </summary>
    bool isDone() const;
    void setDone(bool value);

    /// <summary>
    ///
    /// </summary>
    Lease getLease() const;
    void setLease(Lease value);

    /// <summary>
    ///
    /// </summary>
    Timing getTiming() const;
    void setTiming(Timing value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Session_id = "";
    std::int64_t m_Seq = 0L;
    EpisodeView m_Episode;
    bool m_EpisodeIsSet = false;
    Observation m_Observation;
    bool m_ObservationIsSet = false;
    std::vector<Observation> m_Observations;
    bool m_ObservationsIsSet = false;
    std::int32_t m_Executed_steps = 0;
    bool m_Stopped_early = false;
    std::vector<double> m_Rewards;
    bool m_Terminated = false;
    bool m_Truncated = false;
    EpisodeResult m_Episode_result;
    bool m_Episode_resultIsSet = false;
    Fault m_Fault;
    bool m_FaultIsSet = false;
    bool m_Done = false;
    Lease m_Lease;
    Timing m_Timing;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Turn>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Turn>>& vec, const std::string& json);

Turn fromJsonValue_Turn(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Turn_MODEL_H_ */
