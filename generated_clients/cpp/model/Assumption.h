/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * Assumption.h
 *
 *
 */

#ifndef PROCTOR_MODEL_Assumption_MODEL_H_
#define PROCTOR_MODEL_Assumption_MODEL_H_

#include <string>
#include "Rotation.h"
#include <map>
#include <vector>
#include <utility>
#include <memory>
#include <boost/json.hpp>
#include "NullableField.h"

namespace proctor {
namespace model {



/// <summary>
///
/// </summary>
class Assumption
{
public:
    Assumption() = default;
    explicit Assumption(boost::json::value const& value);
    virtual ~Assumption() = default;

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
    /// Assumption members

    /// <summary>
    ///
    /// </summary>
    std::int32_t getSize() const;
    void setSize(std::int32_t value);

    /// <summary>
    ///
    /// </summary>
    std::string getUnit() const;
    void setUnit(std::string value);

    /// <summary>
    ///
    /// </summary>
    Rotation getRotation() const;
    void setRotation(Rotation value);

    /// <summary>
    ///
    /// </summary>
    std::string getFrame() const;
    void setFrame(std::string value);

    /// <summary>
    ///
    /// </summary>
    bool isRelative() const;
    void setRelative(bool value);

    /// <summary>
    ///
    /// </summary>
    double getGripperOpen() const;
    void setGripperOpen(double value);

protected:
    //////////////////////////////////////
    // Override these for customization //
    //////////////////////////////////////

    virtual boost::json::object toJsonObject_internal() const;
    virtual void fromJsonObject_internal(boost::json::object const& object);
    virtual bool isKnownJsonProperty(boost::json::string_view name) const;


protected:
    std::int32_t m_Size = 0;
    bool m_SizeIsSet = false;
    std::string m_Unit = "";
    bool m_UnitIsSet = false;
    Rotation m_Rotation;
    bool m_RotationIsSet = false;
    std::string m_Frame = "";
    bool m_FrameIsSet = false;
    bool m_Relative = false;
    bool m_RelativeIsSet = false;
    double m_Gripper_open = 0.0;
    bool m_Gripper_openIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<Assumption>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<Assumption>>& vec, const std::string& json);

Assumption fromJsonValue_Assumption(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_Assumption_MODEL_H_ */
