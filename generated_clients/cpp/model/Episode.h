/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Episode.h
 *
 *
 */

#ifndef PROCTOR_MODEL_Episode_MODEL_H_
#define PROCTOR_MODEL_Episode_MODEL_H_

#include "EpisodeResult.h"
#include "EpisodeStatus.h"
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
///
/// </summary>
class Episode
{
public:
    Episode() = default;
    explicit Episode(boost::json::value const& value);
    virtual ~Episode() = default;

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
    /// Episode members

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
    EpisodeStatus getStatus() const;
    void setStatus(EpisodeStatus value);

    /// <summary>
    /// The current or next attempt.
    /// </summary>
    std::int32_t getAttempt() const;
    void setAttempt(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getFaults() const;
    void setFaults(std::int32_t value);

    /// <summary>
    /// In a run with mode &#x60;push&#x60;: what the policy did wrong when it last ended an attempt of this episode.
    /// </summary>
    std::string getPolicyFault() const;
    void setPolicyFault(std::string value);

    /// <summary>
    ///
    /// </summary>
    EpisodeResult getResult() const;
    void setResult(EpisodeResult value);

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
    EpisodeStatus m_Status;
    std::int32_t m_Attempt = 0;
    std::int32_t m_Faults = 0;
    std::string m_Policy_fault = "";
    bool m_Policy_faultIsSet = false;
    EpisodeResult m_Result;
    bool m_ResultIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Episode>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Episode>>& vec, const std::string& json);

Episode fromJsonValue_Episode(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Episode_MODEL_H_ */
