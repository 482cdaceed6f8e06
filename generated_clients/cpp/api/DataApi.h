/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * DataApi.h
 *
 *
 */

#ifndef PROCTOR_API_DataApi_H_
#define PROCTOR_API_DataApi_H_

#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <boost/beast/core.hpp>
#include <boost/optional.hpp>

#include "HttpClient.h"
#include "../model/ValidationTypes.h"

#include "../model/AttachWorker.h"
#include "../model/Heartbeat.h"
#include "../model/Lease.h"
#include "../model/Predict.h"
#include "../model/Problem.h"
#include "../model/Turn.h"
#include <string>

namespace proctor {
namespace api {

using namespace proctor::model;

///
/// Exception to flag problems in the api's
///
class DataApiException: public std::exception
{
public:
    DataApiException(boost::beast::http::status statusCode, std::string what, std::string responseBody);

    boost::beast::http::status getStatus() const;
    const std::string& getResponseBody() const noexcept;
    const char* what() const noexcept override;

private:
    boost::beast::http::status m_status;
    std::string m_what;
    std::string m_responseBody;
};


class DataApi {

public:
    DataApi(
        std::shared_ptr<HttpClient> client,
        const std::string& context = "")
      : m_client(std::move(client)),
        m_context(context)
    {}

    virtual ~DataApi() = default;

    /// <summary>
    /// Open a session for a worker and get its turn 0
    /// </summary>
    /// <remarks>
    ///
    /// </remarks>
    virtual std::shared_ptr<Turn>
    attachWorker(
        const std::string& runId, const std::string& workerId, const std::shared_ptr<AttachWorker>& attachWorker, const std::string& proctorVersion);

    /// <summary>
    /// Close a session and free its slot at once
    /// </summary>
    /// <remarks>
    ///
    /// </remarks>
    virtual void
    detachWorker(
        const std::string& runId, const std::string& workerId, const std::string& sessionId, const std::string& proctorVersion);
    /// <summary>
    /// Extend the lease while the policy thinks
    /// </summary>
    /// <remarks>
    ///
    /// </remarks>
    virtual std::shared_ptr<Lease>
    heartbeat(
        const std::string& runId, const std::string& workerId, const std::shared_ptr<Heartbeat>& heartbeat, const std::string& proctorVersion);

    /// <summary>
    /// A chunk of actions in, the next observation out
    /// </summary>
    /// <remarks>
    ///
    /// </remarks>
    virtual std::shared_ptr<Turn>
    predict(
        const std::string& runId, const std::string& workerId, const std::shared_ptr<Predict>& predict, const std::string& proctorVersion);


    /// Credential hook invoked before each operation with its effective security
    /// requirements. Operation requirements override root requirements and an
    /// empty list clears them. Override this no-op to attach credentials;
    /// `target` is mutable for apiKey-in-query placement.
    virtual void applyOperationSecurity(
        const std::string& operationId,
        const std::vector<SecurityRequirementGroup>& requirements,
        std::string& target,
        std::map<std::string, std::string>& headers) {
        (void)operationId; (void)requirements; (void)target; (void)headers;
    }

protected:
    virtual std::string base64encode(const std::string& str);

    virtual void setPreferredMediaTypeHeader(
        std::map<std::string, std::string>& headers, const std::string& headerName, const std::vector<std::string>& contentTypes);

    virtual void handleStdException(
        const std::exception& e);
    virtual void handleUncaughtException();

    private:
    std::shared_ptr<HttpClient> m_client;
    std::string m_context;
};


}
}


#endif /* PROCTOR_API_DataApi_H_ */
