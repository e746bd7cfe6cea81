// SPDX-License-Identifier: MIT
#include "query/contacts_instances.hpp"

namespace graze::test {

template std::optional<Contact<2, float>> contact_of<2, float>(const AnyShape<2, float>&, const AnyShape<2, float>&);
template std::optional<detail::Penetration<2>> penetration_of<2, float>(const AnyShape<2, float>&,
                                                                        const AnyShape<2, float>&);

}  // namespace graze::test

namespace graze {
template std::optional<detail::Penetration<2>> detail::penetration(const AnyShape<2, float>&,
                                                                   const AnyShape<2, float>&);
}  // namespace graze
