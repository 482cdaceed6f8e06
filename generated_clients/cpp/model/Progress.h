/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Progress.h
 *
 *
 */

#ifndef PROCTOR_MODEL_Progress_MODEL_H_
#define PROCTOR_MODEL_Progress_MODEL_H_

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
class Progress
{
public:
    Progress() = default;
    explicit Progress(boost::json::value const& value);
    virtual ~Progress() = default;

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
    /// Progress members

    /// <summary>
    ///
    /// </summary>
    std::int32_t getEpisodesTotal() const;
    void setEpisodesTotal(std::int32_t value);

    /// <summary>
    /// Abandoned ones included.
    /// </summary>
    std::int32_t getEpisodesScored() const;
    void setEpisodesScored(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getEpisodesInProgress() const;
    void setEpisodesInProgress(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getEpisodesPending() const;
    void setEpisodesPending(std::int32_t value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::int32_t m_Episodes_total = 0;
    std::int32_t m_Episodes_scored = 0;
    std::int32_t m_Episodes_in_progress = 0;
    std::int32_t m_Episodes_pending = 0;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Progress>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Progress>>& vec, const std::string& json);

Progress fromJsonValue_Progress(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Progress_MODEL_H_ */
