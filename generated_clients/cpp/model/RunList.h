/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * RunList.h
 *
 *
 */

#ifndef PROCTOR_MODEL_RunList_MODEL_H_
#define PROCTOR_MODEL_RunList_MODEL_H_

#include <string>
#include <map>
#include "Run.h"
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
class RunList
{
public:
    RunList() = default;
    explicit RunList(boost::json::value const& value);
    virtual ~RunList() = default;

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
    /// RunList members

    /// <summary>
    ///
    /// </summary>
    std::vector<Run> getRuns() const;
    void setRuns(std::vector<Run> value);

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
    std::vector<Run> m_Runs;
    std::optional<std::string> m_Next_cursor;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<RunList>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<RunList>>& vec, const std::string& json);

RunList fromJsonValue_RunList(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_RunList_MODEL_H_ */
