# coding: utf-8

# flake8: noqa
"""Generated from spec/openapi.yaml by `make generate`; never edited by hand."""  # noqa: E501

# import models into model package
from proctor_client.models.action import Action
from proctor_client.models.assumption import Assumption
from proctor_client.models.assumptions import Assumptions
from proctor_client.models.attach_worker import AttachWorker
from proctor_client.models.benchmark import Benchmark
from proctor_client.models.benchmark_list import BenchmarkList
from proctor_client.models.benchmark_summary import BenchmarkSummary
from proctor_client.models.calibration_options import CalibrationOptions
from proctor_client.models.calibration_task import CalibrationTask
from proctor_client.models.compared_run import ComparedRun
from proctor_client.models.compared_task import ComparedTask
from proctor_client.models.comparison import Comparison
from proctor_client.models.episode import Episode
from proctor_client.models.episode_list import EpisodeList
from proctor_client.models.episode_result import EpisodeResult
from proctor_client.models.episode_status import EpisodeStatus
from proctor_client.models.episode_view import EpisodeView
from proctor_client.models.fault import Fault
from proctor_client.models.group_score import GroupScore
from proctor_client.models.heartbeat import Heartbeat
from proctor_client.models.image import Image
from proctor_client.models.image_choice import ImageChoice
from proctor_client.models.image_size import ImageSize
from proctor_client.models.image_space import ImageSpace
from proctor_client.models.interval import Interval
from proctor_client.models.lease import Lease
from proctor_client.models.limits import Limits
from proctor_client.models.observation import Observation
from proctor_client.models.observation_space import ObservationSpace
from proctor_client.models.observe import Observe
from proctor_client.models.outcome import Outcome
from proctor_client.models.outcome_counts import OutcomeCounts
from proctor_client.models.policy_description import PolicyDescription
from proctor_client.models.policy_info import PolicyInfo
from proctor_client.models.policy_protocol import PolicyProtocol
from proctor_client.models.policy_reset import PolicyReset
from proctor_client.models.policy_server import PolicyServer
from proctor_client.models.policy_server_view import PolicyServerView
from proctor_client.models.predict import Predict
from proctor_client.models.problem import Problem
from proctor_client.models.problem_item import ProblemItem
from proctor_client.models.progress import Progress
from proctor_client.models.protocol_range import ProtocolRange
from proctor_client.models.reset_policy import ResetPolicy
from proctor_client.models.run import Run
from proctor_client.models.run_list import RunList
from proctor_client.models.run_mode import RunMode
from proctor_client.models.run_state import RunState
from proctor_client.models.score import Score
from proctor_client.models.service import Service
from proctor_client.models.side_effects import SideEffects
from proctor_client.models.simulator_info import SimulatorInfo
from proctor_client.models.stop_mode import StopMode
from proctor_client.models.stop_run import StopRun
from proctor_client.models.submit_run import SubmitRun
from proctor_client.models.success_rule import SuccessRule
from proctor_client.models.tensor import Tensor
from proctor_client.models.tensor_space import TensorSpace
from proctor_client.models.timing import Timing
from proctor_client.models.turn import Turn
from proctor_client.models.vector_space import VectorSpace
