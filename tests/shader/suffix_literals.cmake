# cmake -DOUTPUT=... -DFILES=a;b;c -P suffix_literals.cmake: joins the files, and makes 1.0 and
# 1.0e-3 in them 1.0f and 1.0e-3f.
set(joined "")
foreach(file IN LISTS FILES)
  file(READ ${file} text)
  string(APPEND joined "#line 1 \"${file}\"\n${text}")
endforeach()
string(REGEX REPLACE "([0-9]\\.[0-9]+(e[-+]?[0-9]+)?)" "\\1f" joined "${joined}")
file(WRITE ${OUTPUT} "${joined}")
