// SPDX-License-Identifier: MIT
#include "query/contacts_instances.hpp"

namespace graze::test {

template std::optional<Contact<2, double>> contact_of<2, double>(const AnyShape<2, double>&,
                                                                 const AnyShape<2, double>&);
template std::optional<detail::Penetration<2>> penetration_of<2, double>(const AnyShape<2, double>&,
                                                                         const AnyShape<2, double>&);

}  // namespace graze::test

namespace graze {
template std::optional<detail::Penetration<2>> detail::penetration(const AnyShape<2, double>&,
                                                                   const AnyShape<2, double>&);
}  // namespace graze
