# All that the workbook needs, on Debian 13; the workbook itself is mounted:
#   docker build -t workbook .
#   docker run --rm -it -v "$PWD":/workbook -u "$(id -u)" workbook ./wb tour
FROM debian:trixie
WORKDIR /workbook
COPY wb ./
RUN ./wb setup \
 && apt-get install -y --no-install-recommends ca-certificates clangd gdb git less sudo \
 && rm -rf /var/lib/apt/lists/* \
 && useradd --create-home --shell /bin/bash reader \
 && echo 'reader ALL=(ALL) NOPASSWD: ALL' >/etc/sudoers.d/reader
ENV LANG=C.UTF-8 MPLCONFIGDIR=/tmp/matplotlib
USER reader
