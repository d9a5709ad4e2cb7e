// What can be read, too.
#pragma once

#include "Print.h"

namespace arduino {

class Stream : public Print {
 public:
  virtual int available() = 0;
  virtual int read() = 0;
  virtual int peek() = 0;

 protected:
  ~Stream() = default;
};

}  // namespace arduino
