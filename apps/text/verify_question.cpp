// SPDX-License-Identifier: MIT
#include "asterism/apps/text/verify_question.hpp"

namespace asterism::apps {

std::string name_of(asked_by who) {
  if (who == asked_by::nobody) return "";
  return who == asked_by::option ? "option" : "certificate";
}

std::string by_text(asked_by who) {
  return who == asked_by::certificate ? ", by the certificate" : "";
}

}  // namespace asterism::apps
