# What uv reads of this machine, for `tools/setup.sh` and `make add`: read with `.`.
# As pip does: the certificates of this machine, where it has any, and pip's own index.
export UV_PYTHON_DOWNLOADS=never
if [ "$(uname)" = Darwin ] || [ -n "$(ls /etc/ssl/certs 2> /dev/null)" ]; then
    export UV_SYSTEM_CERTS="${UV_SYSTEM_CERTS-true}"
fi
if [ "${PIP_INDEX_URL-}" ]; then
    export UV_DEFAULT_INDEX="${UV_DEFAULT_INDEX-$PIP_INDEX_URL}"
fi
