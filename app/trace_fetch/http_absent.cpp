// SPDX-FileCopyrightText: 2026 The Rivulet authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "trace_fetch/http.h"

namespace rivulet::trace_fetch {

base::Result<std::unique_ptr<HttpReader>> makeHttpReader(const HttpLimits& /*limits*/) {
  return base::fail(FetchError::NoHttp,
                    "This program was built without HTTP. Save what the agent answers as a file, "
                    "or build it with libcurl4-openssl-dev.");
}

}  // namespace rivulet::trace_fetch
