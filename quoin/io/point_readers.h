// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "quoin/base/context.h"
#include "quoin/io/point_file.h"

namespace quoin::io {

/// One reader per format, told already. @throws InputError
PointFile read_point_table(std::string_view bytes, const std::string& name, PointFormat format, bool weights,
                           const Context& context);
PointFile read_point_ply(std::string_view bytes, const std::string& name, bool weights, const Context& context);
PointFile read_point_obj(std::string_view bytes, const std::string& name, bool weights, const Context& context);
PointFile read_point_off(std::string_view bytes, const std::string& name, bool weights, const Context& context);
PointFile read_point_pcd(std::string_view bytes, const std::string& name, bool weights, const Context& context);

/// Whether the content is that of a PCD file: its first words are VERSION, or FIELDS, or a comment with its name.
bool begins_like_pcd(std::string_view bytes);
/// Whether the first line is that of a table: numbers, or names of columns with x and y among them. Tells which.
std::optional<PointFormat> table_format(std::string_view bytes);

}  // namespace quoin::io
