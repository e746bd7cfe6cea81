// SPDX-License-Identifier: MIT
#include "query/contacts_instances.hpp"

namespace graze::test {

template std::optional<Contact<3, double>> contact_of<3, double>(const AnyShape<3, double>&,
                                                                 const AnyShape<3, double>&);
template std::optional<detail::Penetration<3>> penetration_of<3, double>(const AnyShape<3, double>&,
                                                                         const AnyShape<3, double>&);

}  // namespace graze::test

namespace graze {
template std::optional<detail::Penetration<3>> detail::penetration(const AnyShape<3, double>&,
                                                                   const AnyShape<3, double>&);
}  // namespace graze
