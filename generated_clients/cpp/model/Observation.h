/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Observation.h
 *
 *
 */

#ifndef PROCTOR_MODEL_Observation_MODEL_H_
#define PROCTOR_MODEL_Observation_MODEL_H_

#include "Tensor.h"
#include <string>
#include <map>
#include "Image.h"
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
class Observation
{
public:
    Observation() = default;
    explicit Observation(boost::json::value const& value);
    virtual ~Observation() = default;

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
    /// Observation members

    /// <summary>
    ///
    /// </summary>
    std::map<std::string, std::vector<double>> getState() const;
    void setState(std::map<std::string, std::vector<double>> value);

    /// <summary>
    ///
    /// </summary>
    std::map<std::string, Image> getImages() const;
    void setImages(std::map<std::string, Image> value);

    /// <summary>
    ///
    /// </summary>
    std::map<std::string, Tensor> getTensors() const;
    void setTensors(std::map<std::string, Tensor> value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::map<std::string, std::vector<double>> m_State;
    std::map<std::string, Image> m_Images;
    std::map<std::string, Tensor> m_Tensors;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Observation>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Observation>>& vec, const std::string& json);

Observation fromJsonValue_Observation(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Observation_MODEL_H_ */
