// SPDX-License-Identifier: MIT
#include "query/contacts_instances.hpp"

namespace graze::test {

template std::optional<Contact<3, float>> contact_of<3, float>(const AnyShape<3, float>&, const AnyShape<3, float>&);
template std::optional<detail::Penetration<3>> penetration_of<3, float>(const AnyShape<3, float>&,
                                                                        const AnyShape<3, float>&);

}  // namespace graze::test

namespace graze {
template std::optional<detail::Penetration<3>> detail::penetration(const AnyShape<3, float>&,
                                                                   const AnyShape<3, float>&);
}  // namespace graze
