/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * VectorSpace.h
 *
 * One named vector of numbers, with every convention a policy could get wrong.
 */

#ifndef PROCTOR_MODEL_VectorSpace_MODEL_H_
#define PROCTOR_MODEL_VectorSpace_MODEL_H_

#include <string>
#include "Rotation.h"
#include "OutOfRange.h"
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
/// One named vector of numbers, with every convention a policy could get wrong.
/// </summary>
class VectorSpace
{
public:
    VectorSpace() = default;
    explicit VectorSpace(boost::json::value const& value);
    virtual ~VectorSpace() = default;

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
    /// VectorSpace members

    /// <summary>
    ///
    /// </summary>
    std::int32_t getSize() const;
    void setSize(std::int32_t value);

    /// <summary>
    /// &#x60;rad&#x60;, &#x60;m&#x60;, &#x60;1&#x60;, or several joined by commas.
    /// </summary>
    std::string getUnit() const;
    void setUnit(std::string value);

    /// <summary>
    ///
    /// </summary>
    Rotation getRotation() const;
    void setRotation(Rotation value);

    /// <summary>
    /// &#x60;world&#x60;, &#x60;base&#x60;, &#x60;tool&#x60;, &#x60;joint&#x60;, or &#x60;none&#x60;.
    /// </summary>
    std::string getFrame() const;
    void setFrame(std::string value);

    /// <summary>
    /// True when the values are increments.
    /// </summary>
    bool isRelative() const;
    void setRelative(bool value);

    /// <summary>
    /// The value that means fully open.
    /// </summary>
    double getGripperOpen() const;
    void setGripperOpen(double value);

    /// <summary>
    ///
    /// </summary>
    std::vector<double> getMinimum() const;
    void setMinimum(std::vector<double> value);

    /// <summary>
    ///
    /// </summary>
    std::vector<double> getMaximum() const;
    void setMaximum(std::vector<double> value);

    /// <summary>
    ///
    /// </summary>
    OutOfRange getOutOfRange() const;
    void setOutOfRange(OutOfRange value);

    /// <summary>
    /// What the numbers are.
    /// </summary>
    std::string getDescription() const;
    void setDescription(std::string value);

    /// <summary>
    /// The tasks that have this entry; all of them when absent.
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
    std::int32_t m_Size = 0;
    std::string m_Unit = "";
    Rotation m_Rotation;
    std::string m_Frame = "";
    bool m_Relative = false;
    double m_Gripper_open = 0.0;
    bool m_Gripper_openIsSet = false;
    std::vector<double> m_Minimum;
    bool m_MinimumIsSet = false;
    std::vector<double> m_Maximum;
    bool m_MaximumIsSet = false;
    OutOfRange m_Out_of_range;
    std::string m_Description = "";
    bool m_DescriptionIsSet = false;
    std::vector<std::string> m_Tasks;
    bool m_TasksIsSet = false;
    ExtraJsonProperties m_extraJsonProperties;
};

std::string createJsonStringFromModelVector(const std::vector<std::shared_ptr<VectorSpace>>& data);

void createModelVectorFromJsonString(std::vector<std::shared_ptr<VectorSpace>>& vec, const std::string& json);

VectorSpace fromJsonValue_VectorSpace(boost::json::value const& value);

}
}
#endif /* PROCTOR_MODEL_VectorSpace_MODEL_H_ */
