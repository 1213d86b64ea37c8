// SPDX-License-Identifier: Apache-2.0
// Included before everything in a model: messages of the RTL go to the engine, not to the program's standard
// output.
#pragma once

#ifdef __cplusplus
__attribute__((format(printf, 1, 2))) int gnomon_model_printf(const char* format, ...);
#endif
