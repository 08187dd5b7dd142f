// All pictures of a batch on one page, the variants side by side.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "renderer/core/image.h"

namespace glimt {

struct ContactSheetPicture {
  std::string column;  // the variant
  std::string row;     // the view and the size
  std::string file;    // beside the page
  std::string note;    // what there is to say of it, one line
  std::string png;     // small; empty where there is no picture
};

// A .png as it is shown, its alpha included. Errors: input, without the file's name.
Image shownImage(std::string_view png);

// A picture that is at most `side` pixels wide and high, each pixel the mean of those it stands
// for; smaller ones are left as they are.
Image reduced(const Image& image, int side);

// HTML that needs no other file but for links to the pictures. Columns and rows are in the order in
// which they first appear.
std::string contactSheet(const std::string& title,
                         const std::vector<ContactSheetPicture>& pictures);

}  // namespace glimt
