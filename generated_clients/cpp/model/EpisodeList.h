/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * EpisodeList.h
 *
 *
 */

#ifndef PROCTOR_MODEL_EpisodeList_MODEL_H_
#define PROCTOR_MODEL_EpisodeList_MODEL_H_

#include <string>
#include <map>
#include <vector>
#include "Episode.h"
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
class EpisodeList
{
public:
    EpisodeList() = default;
    explicit EpisodeList(boost::json::value const& value);
    virtual ~EpisodeList() = default;

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
    /// EpisodeList members

    /// <summary>
    ///
    /// </summary>
    std::vector<Episode> getEpisodes() const;
    void setEpisodes(std::vector<Episode> value);

    /// <summary>
    ///
    /// </summary>
    std::optional<std::string> getNextCursor() const;
    void setNextCursor(std::optional<std::string> value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::vector<Episode> m_Episodes;
    std::optional<std::string> m_Next_cursor;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<EpisodeList>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<EpisodeList>>& vec, const std::string& json);

EpisodeList fromJsonValue_EpisodeList(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_EpisodeList_MODEL_H_ */
