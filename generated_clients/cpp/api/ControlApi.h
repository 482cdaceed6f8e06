/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/*
 * ControlApi.h
 *
 *
 */

#ifndef PROCTOR_API_ControlApi_H_
#define PROCTOR_API_ControlApi_H_

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

#include "../model/Benchmark.h"
#include "../model/BenchmarkList.h"
#include "../model/Comparison.h"
#include "../model/EpisodeList.h"
#include "../model/Problem.h"
#include "../model/Run.h"
#include "../model/RunList.h"
#include "../model/Score.h"
#include "../model/Service.h"
#include "../model/StopRun.h"
#include "../model/SubmitRun.h"
#include <string>

namespace proctor {
namespace api {

using namespace proctor::model;

///
/// Exception to flag problems in the api's
///
class ControlApiException: public std::exception
{
public:
    ControlApiException(boost::beast::http::status statusCode, std::string what, std::string responseBody);

    boost::beast::http::status getStatus() const;
    const std::string& getResponseBody() const noexcept;
    const char* what() const noexcept override;

private:
    boost::beast::http::status m_status;
    std::string m_what;
    std::string m_responseBody;
};


class ControlApi {

public:
    ControlApi(
        std::shared_ptr<HttpClient> client,
        const std::string& context = "")
      : m_client(std::move(client)),
        m_context(context)
    {}

    virtual ~ControlApi() = default;

    /// <summary>
    /// Runs beside a baseline, episode by episode
    /// </summary>
    /// <remarks>
    /// Pairs the episodes of runs of one manifest. Offered with the profile &#x60;compare&#x60;; scoring.md has the arithmetic.
    /// </remarks>
    virtual std::shared_ptr<Comparison>
    compareRuns(
        const std::string& baseline, const std::string& runs, const boost::optional<double>& tolerance, const std::string& proctorVersion);

    /// <summary>
    /// What this server is, speaks and allows
    /// </summary>
    /// <remarks>
    ///
    /// </remarks>
    virtual std::shared_ptr<Service>
    describeService(
        const std::string& proctorVersion);

    /// <summary>
    /// One benchmark with its spaces, conventions and rules
    /// </summary>
    /// <remarks>
    ///
    /// </remarks>
    virtual std::shared_ptr<Benchmark>
    getBenchmark(
        const std::string& benchmarkId, const std::string& proctorVersion);

    /// <summary>
    /// State, progress and the reason for both; can wait for a change
    /// </summary>
    /// <remarks>
    ///
    /// </remarks>
    virtual std::shared_ptr<Run>
    getRun(
        const std::string& runId, const std::string& ifNoneMatch, const std::string& prefer, const std::string& proctorVersion);

    /// <summary>
    /// The score, or its bounds while episodes are missing
    /// </summary>
    /// <remarks>
    ///
    /// </remarks>
    virtual std::shared_ptr<Score>
    getScore(
        const std::string& runId, const std::string& proctorVersion);

    /// <summary>
    /// The benchmarks offered here
    /// </summary>
    /// <remarks>
    ///
    /// </remarks>
    virtual std::shared_ptr<BenchmarkList>
    listBenchmarks(
        const std::string& proctorVersion);

    /// <summary>
    /// Every episode with its result so far, in manifest order
    /// </summary>
    /// <remarks>
    ///
    /// </remarks>
    virtual std::shared_ptr<EpisodeList>
    listEpisodes(
        const std::string& runId, const boost::optional<std::string>& cursor, const boost::optional<std::int32_t>& limit, const std::string& proctorVersion);

    /// <summary>
    /// The caller&#39;s runs, newest first
    /// </summary>
    /// <remarks>
    ///
    /// </remarks>
    virtual std::shared_ptr<RunList>
    listRuns(
        const boost::optional<std::string>& cursor, const boost::optional<std::int32_t>& limit, const std::string& proctorVersion);

    /// <summary>
    /// Ask for one evaluation of one policy on one benchmark
    /// </summary>
    /// <remarks>
    ///
    /// </remarks>
    virtual std::shared_ptr<Run>
    submitRun(
        const std::shared_ptr<SubmitRun>& submitRun, const std::string& idempotencyKey, const std::string& proctorVersion);
    /// <summary>
    /// Go on with the episodes that have no score yet
    /// </summary>
    /// <remarks>
    ///
    /// </remarks>
    virtual std::shared_ptr<Run>
    resumeRun(
        const std::string& runId, const std::string& proctorVersion);

    /// <summary>
    /// Stop now (abort) or after the episodes in play (drain)
    /// </summary>
    /// <remarks>
    ///
    /// </remarks>
    virtual std::shared_ptr<Run>
    stopRun(
        const std::string& runId, const std::shared_ptr<StopRun>& stopRun, const std::string& proctorVersion);


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


#endif /* PROCTOR_API_ControlApi_H_ */
