/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Tensor.h
 *
 * C order, little-endian; a bool is one byte, 0 or 1.
 */

#ifndef PROCTOR_MODEL_Tensor_MODEL_H_
#define PROCTOR_MODEL_Tensor_MODEL_H_

#include "Dtype.h"
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
/// C order, little-endian; a bool is one byte, 0 or 1.
/// </summary>
class Tensor
{
public:
    Tensor() = default;
    explicit Tensor(boost::json::value const& value);
    virtual ~Tensor() = default;

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
    /// Tensor members

    /// <summary>
    ///
    /// </summary>
    Dtype getDtype() const;
    void setDtype(Dtype value);

    /// <summary>
    ///
    /// </summary>
    std::vector<std::int64_t> getShape() const;
    void setShape(std::vector<std::int64_t> value);

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
    Dtype m_Dtype;
    std::vector<std::int64_t> m_Shape;
    std::string m_Data = "";
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Tensor>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Tensor>>& vec, const std::string& json);

Tensor fromJsonValue_Tensor(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Tensor_MODEL_H_ */
