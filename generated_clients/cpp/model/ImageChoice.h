/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * ImageChoice.h
 *
 * Recorded with the result, because it changes the score.
 */

#ifndef PROCTOR_MODEL_ImageChoice_MODEL_H_
#define PROCTOR_MODEL_ImageChoice_MODEL_H_

#include "ImageCodec.h"
#include <string>
#include <map>
#include <vector>
#include <utility>
#include <memory>
#include <boost/json.hpp>
#include "NullableField.h"

namespace proctor {
namespace model {



/// <summary>
/// Recorded with the result, because it changes the score.
/// </summary>
class ImageChoice
{
public:
    ImageChoice() = default;
    explicit ImageChoice(boost::json::value const& value);
    virtual ~ImageChoice() = default;

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
    /// ImageChoice members

    /// <summary>
    ///
    /// </summary>
    ImageCodec getCodec() const;
    void setCodec(ImageCodec value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getWidth() const;
    void setWidth(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::int32_t getHeight() const;
    void setHeight(std::int32_t value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    ImageCodec m_Codec;
    std::int32_t m_Width = 0;
    std::int32_t m_Height = 0;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<ImageChoice>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<ImageChoice>>& vec, const std::string& json);

ImageChoice fromJsonValue_ImageChoice(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_ImageChoice_MODEL_H_ */
