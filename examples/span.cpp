// SPDX-License-Identifier: MIT
// C++20 uses the headers of C directly: a vector of speeds, and eps through spans.
//     c++ -std=c++20 span.cpp $(pkg-config --cflags --libs cor)
#include <cor/cor.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <span>
#include <stdexcept>
#include <vector>

// Returns the contact of two bodies. Throws cor's error message for a wrong input.
cor_sphere_contact contact_of(const cor_body &body_1, const cor_body &body_2)
{
    cor_sphere_contact contact;
    if (const int status = cor_sphere_contact_init(&contact, &body_1, &body_2); status != COR_OK)
        throw std::invalid_argument(cor_status_text(status));
    return contact;
}

// eps[i] of speed_m_s[i]; both spans have the same size.
void eps_zero_force(const cor_sphere_contact &contact, std::span<const double> speed_m_s, std::span<double> eps)
{
    if (speed_m_s.size() != eps.size())
        throw std::invalid_argument("eps and speed_m_s differ in size");
    cor_contact_eps_zero_force_array(&contact, speed_m_s.data(), eps.data(), eps.size());
}

int main()
{
    const double mass_kg = cor_sphere_mass_kg(5e-3, 2500);
    const cor_body glass{.young_modulus_pa = 70e9,
                         .poisson_ratio = 0.22,
                         .dissipation_time_s = 4e-7,
                         .radius_m = 5e-3,
                         .mass_kg = mass_kg};
    const auto contact = contact_of(glass, glass);

    const std::vector<double> speed_m_s{0.01, 0.1, 1.0};
    std::vector<double> eps(speed_m_s.size());
    eps_zero_force(contact, speed_m_s, eps);
    for (std::size_t i = 0; i < eps.size(); i++)
        std::printf("%5.2f m/s: eps = %.6f\n", speed_m_s[i], eps[i]);

    // algorithms accept scalar functions
    std::vector<double> loss;
    const std::span all(speed_m_s);
    std::transform(all.begin(), all.end(), std::back_inserter(loss),
                   [&](double speed) { return cor_sphere_loss_zero_force(cor_contact_beta(&contact, speed)); });
    std::printf("1 - eps = %.3e at the lowest speed\n", loss.front());
}
