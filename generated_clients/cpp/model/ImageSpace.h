/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * ImageSpace.h
 *
 *
 */

#ifndef PROCTOR_MODEL_ImageSpace_MODEL_H_
#define PROCTOR_MODEL_ImageSpace_MODEL_H_

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
class ImageSpace
{
public:
    ImageSpace() = default;
    explicit ImageSpace(boost::json::value const& value);
    virtual ~ImageSpace() = default;

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
    /// ImageSpace members

    /// <summary>
    ///
    /// </summary>
    std::int32_t getChannels() const;
    void setChannels(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::string getDescription() const;
    void setDescription(std::string value);

    /// <summary>
    ///
    /// </summary>
    std::vector<std::string> getTasks() const;
    void setTasks(std::vector<std::string> value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::int32_t m_Channels = 0;
    std::string m_Description = "";
    std::vector<std::string> m_Tasks;
    bool m_TasksIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<ImageSpace>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<ImageSpace>>& vec, const std::string& json);

ImageSpace fromJsonValue_ImageSpace(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_ImageSpace_MODEL_H_ */
