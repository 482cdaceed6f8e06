/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * ResetPolicy.h
 *
 * An attempt begins; whatever the policy remembers of this session is over.
 */

#ifndef PROCTOR_MODEL_ResetPolicy_MODEL_H_
#define PROCTOR_MODEL_ResetPolicy_MODEL_H_

#include "EpisodeView.h"
#include <string>
#include "Benchmark.h"
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
/// An attempt begins; whatever the policy remembers of this session is over.
/// </summary>
class ResetPolicy
{
public:
    ResetPolicy() = default;
    explicit ResetPolicy(boost::json::value const& value);
    virtual ~ResetPolicy() = default;

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
    /// ResetPolicy members

    /// <summary>
    ///
    /// </summary>
    std::string getSessionId() const;
    void setSessionId(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::string getRunId() const;
    void setRunId(std::string value);

    /// <summary>
    ///
    /// </summary>
    Benchmark getBenchmark() const;
    void setBenchmark(Benchmark value);

    /// <summary>
    ///
    /// </summary>
    EpisodeView getEpisode() const;
    void setEpisode(EpisodeView value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Session_id = "";
    std::string m_Run_id = "";
    bool m_Run_idIsSet = false;
    Benchmark m_Benchmark;
    EpisodeView m_Episode;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<ResetPolicy>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<ResetPolicy>>& vec, const std::string& json);

ResetPolicy fromJsonValue_ResetPolicy(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_ResetPolicy_MODEL_H_ */
