# SPDX-FileCopyrightText: 2026 The Rivulet authors
# SPDX-License-Identifier: GPL-3.0-or-later

# rivulet_embed_texts(<target> <namespace> <files…>)
# Compiles text files into <target>: the generated header "<namespace>_texts.h" declares
#   namespace rivulet::<namespace> { std::span<const EmbeddedText> embeddedTexts(); }
function(rivulet_embed_texts target namespace)
  set(header ${CMAKE_CURRENT_BINARY_DIR}/embedded/${namespace}_texts.h)
  set(entries "")
  foreach(file ${ARGN})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    get_filename_component(name ${file} NAME_WE)
    file(READ ${file} text)
    string(APPEND entries "    {\"${name}\", R\"__text__(${text})__text__\"},\n")
  endforeach()
  file(CONFIGURE OUTPUT ${header} @ONLY CONTENT
"// Generated from text files. Do not edit.
#pragma once
#include <array>
#include <string_view>
namespace rivulet::${namespace} {
struct EmbeddedText { std::string_view name; std::string_view text; };
inline constexpr EmbeddedText kEmbeddedTexts[] = {
${entries}};
}
")
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/embedded)
endfunction()
