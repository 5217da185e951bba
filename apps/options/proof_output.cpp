// SPDX-License-Identifier: MIT
#include "asterism/apps/options/proof_output.hpp"

#include <utility>

#include "asterism/apps/base/complain.hpp"
#include "asterism/mesh/domain/plain_form.hpp"
#include "asterism/mesh/proof/make_proof.hpp"
#include "asterism/mesh/proof/proof_bytes.hpp"

namespace asterism::apps {
using namespace internal;

namespace {

// Makes the proof with the plain form of a domain with polygons: checkers read that form, whose
// points the proof places.
result<mesh_proof> proof_of(const mesh& subject, const domain* shape) {
  if (shape == nullptr) return make_proof(subject, nullptr);
  const auto plain = plain_form(*shape);
  if (!plain) return plain.failure();
  return make_proof(subject, &plain.value());
}

}  // namespace

void add_proof_option(CLI::App& app, std::filesystem::path& proof) {
  app.add_option("--proof", proof,
                 "Write a proof of the mesh, for 'asterism check' and tools/check_mesh.py")
      ->type_name("FILE");
}

int proof_output::conclude(int status) const {
  if (!missing) return status;
  return complain({"no proof is written: " + missing->message}, not_reached);
}

proof_output find_proof(const std::filesystem::path& path, const mesh& subject, const domain* shape,
                        bool is_certified) {
  proof_output output;
  if (path.empty()) return output;
  if (!is_certified) {
    output.missing = error{"the mesh is not certified"};
    return output;
  }
  auto found = proof_of(subject, shape);
  if (found)
    output.proof = std::move(found).value();
  else
    output.missing = found.failure();
  return output;
}

output_file proof_file(const std::filesystem::path& path, const mesh& subject,
                       const mesh_proof& proof) {
  output_file file{path};
  file.rest = [&](const byte_sink& put) { write_proof(subject, proof, put); };
  return file;
}

}  // namespace asterism::apps
