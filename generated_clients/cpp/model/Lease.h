/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Lease.h
 *
 *
 */

#ifndef PROCTOR_MODEL_Lease_MODEL_H_
#define PROCTOR_MODEL_Lease_MODEL_H_

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
class Lease
{
public:
    Lease() = default;
    explicit Lease(boost::json::value const& value);
    virtual ~Lease() = default;

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
    /// Lease members

    /// <summary>
    ///
    /// </summary>
    std::string getExpiresAt() const;
    void setExpiresAt(std::string value);

    /// <summary>
    ///
    /// </summary>
    double getIdleTimeoutS() const;
    void setIdleTimeoutS(double value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::string m_Expires_at = "";
    double m_Idle_timeout_s = 0.0;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Lease>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Lease>>& vec, const std::string& json);

Lease fromJsonValue_Lease(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Lease_MODEL_H_ */
