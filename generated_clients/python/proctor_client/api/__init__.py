# flake8: noqa

# import apis into api package
from proctor_client.api.control_api import ControlApi
from proctor_client.api.data_api import DataApi
