/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Service.h
 *
 * What a server says of itself before anyone authenticates.
 */

#ifndef PROCTOR_MODEL_Service_MODEL_H_
#define PROCTOR_MODEL_Service_MODEL_H_

#include "Limits.h"
#include "Profile.h"
#include "ImageCodec.h"
#include "ProtocolRange.h"
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
/// What a server says of itself before anyone authenticates.
/// </summary>
class Service
{
public:
    Service() = default;
    explicit Service(boost::json::value const& value);
    virtual ~Service() = default;

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
    /// Service members

    /// <summary>
    ///
    /// </summary>
    std::string getName() const;
    void setName(std::string value);

    /// <summary>
    /// Version of the server software.
    /// </summary>
    std::string getVersion() const;
    void setVersion(std::string value);

    /// <summary>
    ///
    /// </summary>
    ProtocolRange getProtocol() const;
    void setProtocol(ProtocolRange value);

    /// <summary>
    /// Parts of the protocol offered; &#x60;core&#x60; may be left out, for it always is. An operation with &#x60;x-profile&#x60; is there when its profile is announced. The rules of the profile &#x60;crash&#x60; are not announced. The kit judges them where it may kill and restart the server; a server whose runs do not outlive its process is certified without them, and its report says that they were not verified.
    /// </summary>
    std::vector<Profile> getProfiles() const;
    void setProfiles(std::vector<Profile> value);

    /// <summary>
    ///
    /// </summary>
    Limits getLimits() const;
    void setLimits(Limits value);

    /// <summary>
    /// Media types of the data plane.
    /// </summary>
    std::vector<std::string> getEncodings() const;
    void setEncodings(std::vector<std::string> value);

    /// <summary>
    ///
    /// </summary>
    std::vector<ImageCodec> getImageCodecs() const;
    void setImageCodecs(std::vector<ImageCodec> value);

    /// <summary>
    /// The server&#39;s clock, UTC.
    /// </summary>
    std::string getServerTime() const;
    void setServerTime(std::string value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Name = "";
    std::string m_Version = "";
    ProtocolRange m_Protocol;
    std::vector<Profile> m_Profiles;
    Limits m_Limits;
    std::vector<std::string> m_Encodings;
    std::vector<ImageCodec> m_Image_codecs;
    std::string m_Server_time = "";
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Service>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Service>>& vec, const std::string& json);

Service fromJsonValue_Service(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Service_MODEL_H_ */
