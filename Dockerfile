# SPDX-License-Identifier: MIT
# For contributors: Debian with all that the build and the tests need.
#   docker build -t bankshot . && docker run -it -v "$PWD:/bankshot" bankshot
FROM debian:12
COPY cmake/packages.sh /tmp/packages.sh
RUN bash -c '. /tmp/packages.sh && need git ca-certificates clang clang-format clang-tidy $toolchain $python catch2 libbenchmark-dev gnuplot-nox chromium jq python3-jsonschema nodejs npm' \
  && rm -rf /var/lib/apt/lists/*
WORKDIR /bankshot
CMD ["bash"]
