#!/bin/sh
# The manual page, made of what the program says of itself.
#
#   app/package/man_page.sh GLIMT > glimt.1
set -eu
glimt=$1

# Help text as it is, with roff's own characters escaped.
verbatim() {
  echo .nf
  sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^\([.']\)/\\\\\&\1/"
  echo .fi
}

commands=$("$glimt" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p')
version=$("$glimt" --version)

echo ".TH GLIMT 1 \"\" \"$version\" \"User Commands\""
cat <<'END'
.SH NAME
glimt \- path tracer over OpenGL ES 2.0
.SH SYNOPSIS
.B glimt
.I COMMAND
[\fIOPTION\fR]... [\fIFILE\fR]...
.br
.B glimt
.I SCENE
.SH DESCRIPTION
Renders realistic pictures of 3D models (glTF, OBJ) on any graphics driver, also on one without a
GPU, into a file or in a window, and says how wrong a picture still is and how long better takes.
.PP
.B glimt
.I SCENE
opens a window. The commands are:
END
for command in $commands; do
  echo ".SS glimt $command"
  "$glimt" "$command" --help | sed '/^Exit status:/,$d' | verbatim
done
cat <<'END'
.SH "EXIT STATUS"
0 done, 1 failed while running, 2 wrong usage, 3 the input cannot be used, 4 no usable GL.
END
