/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Image.h
 *
 * RGB or grey, row 0 on top; raw is height \303\227 width \303\227 channels bytes.
 */

#ifndef PROCTOR_MODEL_Image_MODEL_H_
#define PROCTOR_MODEL_Image_MODEL_H_

#include "ImageCodec.h"
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
/// RGB or grey, row 0 on top; raw is height \303\227 width \303\227 channels bytes.
/// </summary>
class Image
{
public:
    Image() = default;
    explicit Image(boost::json::value const& value);
    virtual ~Image() = default;

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
    /// Image members

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

    /// <summary>
    ///
    /// </summary>
    std::int32_t getChannels() const;
    void setChannels(std::int32_t value);

    /// <summary>
    /// Base64 with padding in JSON; &#x60;bin&#x60; in MessagePack.
    /// </summary>
    std::string getData() const;
    void setData(std::string value);

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
    std::int32_t m_Channels = 0;
    std::string m_Data = "";
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Image>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Image>>& vec, const std::string& json);

Image fromJsonValue_Image(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Image_MODEL_H_ */
