/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * ObservationSpace.h
 *
 *
 */

#ifndef PROCTOR_MODEL_ObservationSpace_MODEL_H_
#define PROCTOR_MODEL_ObservationSpace_MODEL_H_

#include "VectorSpace.h"
#include <string>
#include "ImageSpace.h"
#include <map>
#include "TensorSpace.h"
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
class ObservationSpace
{
public:
    ObservationSpace() = default;
    explicit ObservationSpace(boost::json::value const& value);
    virtual ~ObservationSpace() = default;

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
    /// ObservationSpace members

    /// <summary>
    ///
    /// </summary>
    std::map<std::string, VectorSpace> getState() const;
    void setState(std::map<std::string, VectorSpace> value);

    /// <summary>
    ///
    /// </summary>
    std::map<std::string, ImageSpace> getImages() const;
    void setImages(std::map<std::string, ImageSpace> value);

    /// <summary>
    ///
    /// </summary>
    std::map<std::string, TensorSpace> getTensors() const;
    void setTensors(std::map<std::string, TensorSpace> value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::map<std::string, VectorSpace> m_State;
    std::map<std::string, ImageSpace> m_Images;
    std::map<std::string, TensorSpace> m_Tensors;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<ObservationSpace>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<ObservationSpace>>& vec, const std::string& json);

ObservationSpace fromJsonValue_ObservationSpace(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_ObservationSpace_MODEL_H_ */
