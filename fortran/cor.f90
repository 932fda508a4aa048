! SPDX-License-Identifier: MIT
! The functions of cor under their names in C. Written from the headers by python/bindings/fortran_source.py.
!
! Functions that return a number are elemental and pure. Functions of type character have the length of their text.
! The names with _array are the loops of C; they are faster. struct cor_body is type(cor_body_t), and so on. An argument
! that may be NULL in C is optional. The comments of the headers in include/cor hold for all of them.
module cor
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_float, c_funptr, c_int, &
    c_null_char, c_ptr, c_size_t
  implicit none
  private
  integer(c_int), parameter, public :: COR_VERSION_MAJOR = 1, COR_VERSION_MINOR = 0, COR_VERSION_PATCH = 0, &
    COR_CONTACT_MAX_STACK = 24576, COR_DISK_MAX_STACK = 65536, COR_DISK_MODES_MAX_N = 4095, COR_DISK_MODES_MAX_COUNT &
    = 1000000, COR_DISK_COLLISION_MIN_ALPHA = 40, COR_DISK_COLLISION_MAX_PHI_POINTS = 16384, &
    COR_DISK_COLLISION_MAX_STEPS = 1000000, COR_DISK_HARD_WALL_MAX_LEVELS = 13, COR_LAW_MAX_STACK = 24576, &
    COR_SPHERE_INLINE_FAST_MATH_ULP = 4, COR_SPHERE_INLINE_NATIVE_ULP = 4, COR_SPHERE_MAX_STACK = 24576, &
    COR_DISK_DATUM_CENTRE_OF_MASS = 0, COR_DISK_DATUM_DIAMETER = 1, COR_DISK_DATUM_PRINTED = 2, COR_LAW_VISCOELASTIC &
    = 0, COR_LAW_LINEAR = 1, COR_LAW_TSUJI = 2, COR_LAW_HUNT_CROSSLEY = 3, COR_LAW_HERTZ_DASHPOT = 4, COR_LAW_PLATE = &
    5, COR_LAW_ELASTIC_PLASTIC = 6, COR_LAW_LINEAR_ROOT = 7, COR_LAW_IMPULSE = 8, COR_LAWS = 9, COR_END_ZERO_OVERLAP &
    = 0, COR_END_ZERO_FORCE = 1, COR_END_LIMITED = 2, COR_END_APPROACH_ONLY = 3, COR_END_INSTANT = 4, COR_ENDS = 5, &
    COR_BOTH_ENDS = -1, COR_EPS = 0, COR_LOSS = 1, COR_DAMPING_OF_EPS = 2, COR_DAMPING_OF_LOSS = 3, COR_DURATION = 4, &
    COR_MAX_OVERLAP = 5, COR_TIME_OF_MAX_OVERLAP = 6, COR_QUANTITIES = 7, COR_OK = 0, COR_ERROR_NULL = 1, &
    COR_ERROR_YOUNG_MODULUS = 2, COR_ERROR_POISSON_RATIO = 3, COR_ERROR_DISSIPATION_TIME = 4, COR_ERROR_RADIUS = 5, &
    COR_ERROR_MASS = 6, COR_ERROR_BOTH_FLAT = 7, COR_ERROR_BOTH_FIXED = 8, COR_ERROR_BOTH_RIGID = 9, COR_ERROR_G_STAR &
    = 10, COR_ERROR_RANGE = 11, COR_ERROR_DISK_POISSON_RATIO = 12, COR_ERROR_DATUM = 13, COR_ERROR_SPEED = 14, &
    COR_ERROR_MODES = 15, COR_ERROR_TOLERANCE = 16, COR_ERROR_FILE = 17, COR_ERROR_FILE_VERSION = 18, &
    COR_ERROR_FILE_DAMAGED = 19, COR_ERROR_CAPACITY = 20, COR_BEYOND_THEORY = 21, COR_TOLERANCE_NOT_REACHED = 22, &
    COR_WALL_NOT_TOUCHED = 23, COR_CONTACT_NOT_ENDED = 24, COR_ERROR_ALPHA = 25, COR_ERROR_PHI_POINTS = 26, &
    COR_ERROR_WORKSPACE = 27, COR_ERROR_MEMORY = 28, COR_ERROR_DENSITY = 29, COR_ERROR_THICKNESS = 30
  character(len=*), parameter, public :: COR_VERSION_STRING = "1.0.0"
  real(c_double), parameter, public :: COR_SI_LEAST = 1e-250_c_double, COR_SI_MOST = 1e250_c_double, &
    COR_CONTACT_MAX_ULP = 12.0_c_double, COR_WAVE_MAX_ERROR = 1e-15_c_double, COR_DISK_LAW_MAX_ULP = 4.0_c_double, &
    COR_DISK_CONTACT_TIME_MAX_ERROR = 1e-15_c_double, COR_DISK_RAYLEIGH_MAX_ERROR = 1e-10_c_double, &
    COR_DISK_RAYLEIGH_MAX_ABSOLUTE = 1e-14_c_double, COR_DISK_RAYLEIGH_TAIL_MAX_ERROR = 1e-5_c_double, &
    COR_DISK_RAYLEIGH_TAIL_MAX_ERROR_ANY_SPEED = 4e-5_c_double, COR_DISK_RAYLEIGH_MAX_SPEED = 0.03_c_double, &
    COR_DISK_MODES_OMEGA_MAX_ERROR = 2e-14_c_double, COR_DISK_MODES_AMPLITUDE_MAX_ERROR = 1e-10_c_double, &
    COR_DISK_MODES_MAX_OMEGA = 2000.0_c_double, COR_DISK_COLLISION_MAX_SPEED = 0.5_c_double, &
    COR_DISK_COLLISION_MAX_ALPHA = 1e5_c_double, COR_DISK_COLLISION_MIN_TOLERANCE = 1e-13_c_double, &
    COR_DISK_COLLISION_MAX_WORKSPACE = 1.3e9_c_double, COR_DISK_HARD_WALL_MAX_SPEED = 0.5_c_double, &
    COR_DISK_HARD_WALL_POINT_SPEED = 1e-7_c_double, COR_DISK_HARD_WALL_MIN_TOLERANCE = 1e-7_c_double, &
    COR_DISK_HARD_WALL_FIRST_OMEGA = 15.0_c_double, COR_DISK_EPS_MIN_SPEED = 1e-5_c_double, COR_DISK_EPS_MAX_SPEED = &
    0.3_c_double, COR_DISK_EPS_CALM_SPEED = 0.15_c_double, COR_DISK_EPS_MIN_NU = -0.2_c_double, COR_DISK_EPS_MAX_NU = &
    0.4875_c_double, COR_DISK_EPS_MAX_UNCERTAINTY = 3.4e-5_c_double, COR_DISK_EPS_MAX_UNCERTAINTY_FAST = &
    1e-4_c_double, COR_DISK_EPS_MAX_JUMP = 1e-12_c_double, COR_HERTZ_DASHPOT_BETA_C = 1.12798813552016922_c_double, &
    COR_HUNT_CROSSLEY_MAX_ULP = 2.0_c_double, COR_HUNT_CROSSLEY_TIME_MAX_ERROR = 1e-14_c_double, &
    COR_HUNT_CROSSLEY_MAX_EXPONENT = 100.0_c_double, COR_NO_SLIP_MAX_ULP = 0.51_c_double, COR_NO_SLIP_MAX_KAPPA = &
    1e6_c_double, COR_NO_SLIP_MIN_EXPONENT = 1e-6_c_double, COR_NO_SLIP_MAX_EXPONENT = 100.0_c_double, &
    COR_SPHERE_EPS_MAX_ULP = 1.0_c_double, COR_SPHERE_LOSS_MAX_ULP = 1.0_c_double, COR_SPHERE_MAX_OVERLAP_MAX_ULP = &
    1.0_c_double, COR_SPHERE_TIME_MAX_ULP = 2.0_c_double, COR_SPHERE_BETA_MAX_ULP = 2.0_c_double, COR_SPHERE_C1 = &
    -1.15344885809528879913_c_double, COR_SPHERE_FLOAT_MAX_ULP = 0.75_c_double, COR_SPHERE_APPROACH_MAX_ULP = &
    2.0_c_double, COR_SPHERE_SIMPLE_D = 0.504454894269828315974_c_double, COR_SPHERE_EPS_SIMPLE_MAX_ULP = &
    12.0_c_double
  type, public, bind(c) :: cor_body_t
    real(c_double) :: young_modulus_pa, poisson_ratio, dissipation_time_s, radius_m, mass_kg
  end type
  type, public, bind(c) :: cor_sphere_contact_t
    real(c_double) :: effective_mass_kg, effective_radius_m, elastic_constant_n_m15, dissipation_time_s, &
      beta_per_root, scale, beta5_per_speed
  end type
  type, public, bind(c) :: cor_plate_t
    real(c_double) :: young_modulus_pa, poisson_ratio, density_kg_m3, thickness_m
  end type
  type, public, bind(c) :: cor_half_space_t
    real(c_double) :: young_modulus_pa, poisson_ratio, density_kg_m3
  end type
  type, public, bind(c) :: cor_disk_mode_t
    integer(c_int) :: n, l
    real(c_double) :: omega, c, s
  end type
  type, public, bind(c) :: cor_disk_modes_t
    real(c_double) :: nu
    integer(c_size_t) :: count
    type(c_ptr) :: mode
  end type
  type, public, bind(c) :: cor_disk_rayleigh_t
    real(c_double) :: fraction, tail, error_estimate, contact_time
  end type
  type, public, bind(c) :: cor_disk_collision_options_t
    real(c_double) :: alpha, tolerance
    integer(c_size_t) :: phi_points, max_steps
  end type
  type, public, bind(c) :: cor_disk_collision_t
    real(c_double) :: eps, one_minus_eps2, contact_time, max_compression, energy_drift
    integer(c_size_t) :: steps
    real(c_double) :: error_estimate
  end type
  type, public, bind(c) :: cor_disk_moment_t
    real(c_double) :: time, position, velocity, load, wall_energy
  end type
  type, public, bind(c) :: cor_disk_collision_detail_t
    type(c_ptr) :: energy_after, energy_average
    type(c_funptr) :: observe
    type(c_ptr) :: context, q, q_dot
  end type
  type, public, bind(c) :: cor_disk_hard_wall_options_t
    real(c_double) :: tolerance
    integer(c_size_t) :: max_steps
  end type
  type, public, bind(c) :: cor_disk_hard_wall_t
    real(c_double) :: one_minus_eps2, eps, contact_time, max_compression, error_estimate
    integer(c_size_t) :: omega_levels
  end type
  type, public, bind(c) :: cor_disk_hard_wall_moment_t
    real(c_double) :: time, position, velocity, load, contact_angle
  end type
  type, public, bind(c) :: cor_disk_hard_wall_detail_t
    type(c_ptr) :: energy_after, energy_average
    type(c_funptr) :: observe
    type(c_ptr) :: context, q, q_dot
  end type
  type, public, bind(c) :: cor_exponents_t
    integer(c_int) :: elastic, damping, denominator
  end type
  type, public, bind(c) :: cor_law_function_t
    type(c_ptr) :: name
    type(c_funptr) :: value, array, arrayf
    real(c_double) :: least, largest, max_ulp
  end type
  type(cor_disk_modes_t), protected, public, bind(c, name="cor_disk_modes_nu033") :: cor_disk_modes_nu033
  type(cor_disk_modes_t), protected, public, bind(c, name="cor_disk_modes_nu090") :: cor_disk_modes_nu090
  interface
    pure real(c_double) function c_cor_sphere_mass_kg(radius_m, density_kg_m3) bind(c, name="cor_sphere_mass_kg")
      import; real(c_double), value :: radius_m, density_kg_m3; end function
    integer(c_int) function cor_sphere_contact_init(contact, body_1, body_2) bind(c); import
      type(cor_sphere_contact_t), intent(inout) :: contact; type(cor_body_t), intent(in) :: body_1, body_2; end &
      function
    integer(c_int) function cor_sphere_contact_init_g_star(contact, g_star_m_s) bind(c); import
      type(cor_sphere_contact_t), intent(inout) :: contact; real(c_double), value :: g_star_m_s; end function
    pure real(c_double) function c_cor_contact_g_star_m_s(contact) bind(c, name="cor_contact_g_star_m_s"); import
      type(cor_sphere_contact_t), intent(in) :: contact; end function
    pure real(c_double) function c_cor_contact_beta(contact, speed_m_s) bind(c, name="cor_contact_beta"); import
      type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), value :: speed_m_s; end function
    pure real(c_double) function c_cor_contact_eps_zero_overlap(contact, speed_m_s) bind(c, &
      name="cor_contact_eps_zero_overlap")
      import; type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), value :: speed_m_s; end function
    pure real(c_double) function c_cor_contact_eps_zero_force(contact, speed_m_s) bind(c, &
      name="cor_contact_eps_zero_force")
      import; type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), value :: speed_m_s; end function
    pure real(c_double) function c_cor_contact_duration_s_zero_overlap(contact, speed_m_s) bind(c, &
      name="cor_contact_duration_s_zero_overlap")
      import; type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), value :: speed_m_s; end function
    pure real(c_double) function c_cor_contact_duration_s_zero_force(contact, speed_m_s) bind(c, &
      name="cor_contact_duration_s_zero_force")
      import; type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), value :: speed_m_s; end function
    pure real(c_double) function c_cor_contact_max_overlap_m(contact, speed_m_s) bind(c, &
      name="cor_contact_max_overlap_m")
      import; type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), value :: speed_m_s; end function
    pure real(c_double) function c_cor_contact_dissipation_time_s_zero_overlap(contact, speed_m_s, eps) bind(c, &
      name="cor_contact_dissipation_time_s_zero_overlap")
      import; type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), value :: speed_m_s, eps; end function
    pure real(c_double) function c_cor_contact_dissipation_time_s_zero_force(contact, speed_m_s, eps) bind(c, &
      name="cor_contact_dissipation_time_s_zero_force")
      import; type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), value :: speed_m_s, eps; end function
    subroutine cor_contact_beta_array(contact, speed_m_s, y, n) bind(c); import
      type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    subroutine cor_contact_eps_zero_overlap_array(contact, speed_m_s, y, n) bind(c); import
      type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    subroutine cor_contact_eps_zero_force_array(contact, speed_m_s, y, n) bind(c); import
      type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    subroutine cor_contact_duration_s_zero_overlap_array(contact, speed_m_s, y, n) bind(c); import
      type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    subroutine cor_contact_duration_s_zero_force_array(contact, speed_m_s, y, n) bind(c); import
      type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    subroutine cor_contact_max_overlap_m_array(contact, speed_m_s, y, n) bind(c); import
      type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    subroutine cor_contact_dissipation_time_s_zero_overlap_array(contact, speed_m_s, eps, y, n) bind(c); import
      type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s(*), eps(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    subroutine cor_contact_dissipation_time_s_zero_force_array(contact, speed_m_s, eps, y, n) bind(c); import
      type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s(*), eps(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_dissipation_time_viscous_s(eta1_pa_s, eta2_pa_s, young_modulus_pa, &
      poisson_ratio) bind(c, name="cor_dissipation_time_viscous_s")
      import; real(c_double), value :: eta1_pa_s, eta2_pa_s, young_modulus_pa, poisson_ratio; end function
    pure real(c_double) function c_cor_dissipation_time_s(eta1_pa_s, eta2_pa_s, young_modulus_pa, poisson_ratio) &
      bind(c, name="cor_dissipation_time_s")
      import; real(c_double), value :: eta1_pa_s, eta2_pa_s, young_modulus_pa, poisson_ratio; end function
    pure real(c_double) function c_cor_tangential_kappa(young_modulus_1_pa, poisson_ratio_1, young_modulus_2_pa, &
      poisson_ratio_2) bind(c, name="cor_tangential_kappa")
      import; real(c_double), value :: young_modulus_1_pa, poisson_ratio_1, young_modulus_2_pa, poisson_ratio_2
      end function
    pure real(c_double) function c_cor_tangential_stick_angle(kappa, friction) bind(c, &
      name="cor_tangential_stick_angle")
      import; real(c_double), value :: kappa, friction; end function
    integer(c_int) function cor_plate_contact_init(contact, sphere, plate) bind(c); import
      type(cor_sphere_contact_t), intent(inout) :: contact; type(cor_body_t), intent(in) :: sphere
      type(cor_plate_t), intent(in) :: plate; end function
    pure real(c_double) function c_cor_plate_lambda(contact, speed_m_s) bind(c, name="cor_plate_lambda"); import
      type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), value :: speed_m_s; end function
    pure real(c_double) function c_cor_plate_contact_radius_ratio(contact, plate, speed_m_s) bind(c, &
      name="cor_plate_contact_radius_ratio")
      import; type(cor_sphere_contact_t), intent(in) :: contact; type(cor_plate_t), intent(in) :: plate
      real(c_double), value :: speed_m_s; end function
    pure real(c_double) function c_cor_plate_shear_crossings(contact, plate, speed_m_s) bind(c, &
      name="cor_plate_shear_crossings")
      import; type(cor_sphere_contact_t), intent(in) :: contact; type(cor_plate_t), intent(in) :: plate
      real(c_double), value :: speed_m_s; end function
    pure real(c_double) function c_cor_plate_sphere_crossings(contact, sphere, speed_m_s) bind(c, &
      name="cor_plate_sphere_crossings")
      import; type(cor_sphere_contact_t), intent(in) :: contact; type(cor_body_t), intent(in) :: sphere
      real(c_double), value :: speed_m_s; end function
    pure real(c_double) function c_cor_plate_least_half_width_m(contact, plate, speed_m_s) bind(c, &
      name="cor_plate_least_half_width_m")
      import; type(cor_sphere_contact_t), intent(in) :: contact; type(cor_plate_t), intent(in) :: plate
      real(c_double), value :: speed_m_s; end function
    pure real(c_double) function c_cor_half_space_wave_factor(poisson_ratio) bind(c, &
      name="cor_half_space_wave_factor")
      import; real(c_double), value :: poisson_ratio; end function
    pure real(c_double) function c_cor_half_space_wave_coefficient(poisson_ratio) bind(c, &
      name="cor_half_space_wave_coefficient")
      import; real(c_double), value :: poisson_ratio; end function
    pure real(c_double) function c_cor_contact_wave_loss(contact, half_space, speed_m_s) bind(c, &
      name="cor_contact_wave_loss")
      import; type(cor_sphere_contact_t), intent(in) :: contact; type(cor_half_space_t), intent(in) :: half_space
      real(c_double), value :: speed_m_s; end function
    integer(c_int) function cor_disk_modes_read(path, mode, capacity, modes, line) bind(c); import
      character(kind=c_char), intent(in) :: path(*); type(cor_disk_mode_t), intent(inout) :: mode(*)
      integer(c_size_t), value :: capacity; type(cor_disk_modes_t), intent(inout) :: modes
      integer(c_size_t), intent(inout), optional :: line; end function
    integer(c_int) function cor_disk_modes_compute(nu, count, mode, modes) bind(c); import
      real(c_double), value :: nu; integer(c_size_t), value :: count; type(cor_disk_mode_t), intent(inout) :: mode(*)
      type(cor_disk_modes_t), intent(inout) :: modes; end function
    pure integer(c_size_t) function c_cor_disk_modes_below(nu, omega) bind(c, name="cor_disk_modes_below"); import
      real(c_double), value :: nu, omega; end function
    pure real(c_double) function c_cor_disk_load_limit(nu, datum) bind(c, name="cor_disk_load_limit"); import
      real(c_double), value :: nu; integer(c_int), value :: datum; end function
    pure real(c_double) function c_cor_disk_compression_limit(nu, datum) bind(c, name="cor_disk_compression_limit")
      import; real(c_double), value :: nu; integer(c_int), value :: datum; end function
    pure real(c_double) function c_cor_disk_energy_limit(nu, datum) bind(c, name="cor_disk_energy_limit"); import
      real(c_double), value :: nu; integer(c_int), value :: datum; end function
    pure real(c_double) function c_cor_disk_speed_limit(nu, datum) bind(c, name="cor_disk_speed_limit"); import
      real(c_double), value :: nu; integer(c_int), value :: datum; end function
    pure real(c_double) function c_cor_disk_load(compression, nu, datum) bind(c, name="cor_disk_load"); import
      real(c_double), value :: compression, nu; integer(c_int), value :: datum; end function
    subroutine cor_disk_load_array(compression, nu, datum, load, n) bind(c); import
      real(c_double), intent(in) :: compression(*); real(c_double), value :: nu; integer(c_int), value :: datum
      real(c_double), intent(inout) :: load(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_disk_compression(load, nu, datum) bind(c, name="cor_disk_compression"); import
      real(c_double), value :: load, nu; integer(c_int), value :: datum; end function
    pure real(c_double) function c_cor_disk_energy(load, nu, datum) bind(c, name="cor_disk_energy"); import
      real(c_double), value :: load, nu; integer(c_int), value :: datum; end function
    pure real(c_double) function c_cor_disk_load_of_energy(energy, nu, datum) bind(c, name="cor_disk_load_of_energy")
      import; real(c_double), value :: energy, nu; integer(c_int), value :: datum; end function
    pure real(c_double) function c_cor_disk_max_load(speed, nu, datum) bind(c, name="cor_disk_max_load"); import
      real(c_double), value :: speed, nu; integer(c_int), value :: datum; end function
    pure real(c_double) function c_cor_disk_max_compression(speed, nu, datum) bind(c, name="cor_disk_max_compression")
      import; real(c_double), value :: speed, nu; integer(c_int), value :: datum; end function
    pure real(c_double) function c_cor_disk_contact_time(speed, nu, datum) bind(c, name="cor_disk_contact_time")
      import; real(c_double), value :: speed, nu; integer(c_int), value :: datum; end function
    subroutine cor_disk_contact_time_array(speed, nu, datum, time, n) bind(c); import
      real(c_double), intent(in) :: speed(*); real(c_double), value :: nu; integer(c_int), value :: datum
      real(c_double), intent(inout) :: time(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_disk_compression_leading_log(load) bind(c, &
      name="cor_disk_compression_leading_log")
      import; real(c_double), value :: load; end function
    pure real(c_double) function c_cor_disk_load_leading_log(compression) bind(c, name="cor_disk_load_leading_log")
      import; real(c_double), value :: compression; end function
    pure real(c_double) function c_cor_disk_energy_leading_log(compression) bind(c, &
      name="cor_disk_energy_leading_log")
      import; real(c_double), value :: compression; end function
    pure real(c_double) function c_cor_disk_max_compression_leading_log(speed) bind(c, &
      name="cor_disk_max_compression_leading_log")
      import; real(c_double), value :: speed; end function
    pure real(c_double) function c_cor_disk_contact_time_leading_log(speed) bind(c, &
      name="cor_disk_contact_time_leading_log")
      import; real(c_double), value :: speed; end function
    integer(c_int) function cor_disk_rayleigh(modes, n_modes, datum, speed, out, mode_fraction) bind(c); import
      type(cor_disk_modes_t), intent(in) :: modes; integer(c_size_t), value :: n_modes; integer(c_int), value :: datum
      real(c_double), value :: speed; type(cor_disk_rayleigh_t), intent(inout) :: out
      real(c_double), intent(inout), optional :: mode_fraction(*); end function
    integer(c_int) function cor_disk_rayleigh_array(modes, n_modes, datum, speed, n, out, mode_fraction, status) &
      bind(c)
      import; type(cor_disk_modes_t), intent(in) :: modes; integer(c_size_t), value :: n_modes, n
      integer(c_int), value :: datum; real(c_double), intent(in) :: speed(*)
      type(cor_disk_rayleigh_t), intent(inout) :: out(*); real(c_double), intent(inout), optional :: mode_fraction(*)
      integer(c_int), intent(inout), optional :: status(*); end function
    integer(c_int) function cor_disk_rayleigh_tolerance(modes, datum, speed, tolerance, out, n_modes) bind(c); import
      type(cor_disk_modes_t), intent(in) :: modes; integer(c_int), value :: datum
      real(c_double), value :: speed, tolerance; type(cor_disk_rayleigh_t), intent(inout) :: out
      integer(c_size_t), intent(inout), optional :: n_modes; end function
    integer(c_int) function cor_disk_collision(modes, n_modes, options, speed, out) bind(c); import
      type(cor_disk_modes_t), intent(in) :: modes; integer(c_size_t), value :: n_modes
      type(cor_disk_collision_options_t), intent(in) :: options; real(c_double), value :: speed
      type(cor_disk_collision_t), intent(inout) :: out; end function
    integer(c_int) function cor_disk_collision_array(modes, n_modes, options, speed, n, out, status) bind(c); import
      type(cor_disk_modes_t), intent(in) :: modes; integer(c_size_t), value :: n_modes, n
      type(cor_disk_collision_options_t), intent(in) :: options; real(c_double), intent(in) :: speed(*)
      type(cor_disk_collision_t), intent(inout) :: out(*); integer(c_int), intent(inout), optional :: status(*)
      end function
    pure integer(c_size_t) function c_cor_disk_collision_workspace(modes, n_modes, options) bind(c, &
      name="cor_disk_collision_workspace")
      import; type(cor_disk_modes_t), intent(in) :: modes; integer(c_size_t), value :: n_modes
      type(cor_disk_collision_options_t), intent(in) :: options; end function
    integer(c_int) function cor_disk_collision_in(workspace, bytes, modes, n_modes, options, speed, out, detail) &
      bind(c)
      import; type(c_ptr), value :: workspace; integer(c_size_t), value :: bytes, n_modes
      type(cor_disk_modes_t), intent(in) :: modes; type(cor_disk_collision_options_t), intent(in) :: options
      real(c_double), value :: speed; type(cor_disk_collision_t), intent(inout) :: out
      type(cor_disk_collision_detail_t), intent(in), optional :: detail; end function
    integer(c_int) function cor_disk_hard_wall(modes, n_modes, options, speed, out) bind(c); import
      type(cor_disk_modes_t), intent(in) :: modes; integer(c_size_t), value :: n_modes
      type(cor_disk_hard_wall_options_t), intent(in) :: options; real(c_double), value :: speed
      type(cor_disk_hard_wall_t), intent(inout) :: out; end function
    integer(c_int) function cor_disk_hard_wall_nu(nu, options, speed, out) bind(c); import
      real(c_double), value :: nu, speed; type(cor_disk_hard_wall_options_t), intent(in) :: options
      type(cor_disk_hard_wall_t), intent(inout) :: out; end function
    pure integer(c_size_t) function c_cor_disk_hard_wall_workspace(modes, n_modes, options, speed) bind(c, &
      name="cor_disk_hard_wall_workspace")
      import; type(cor_disk_modes_t), intent(in) :: modes; integer(c_size_t), value :: n_modes
      type(cor_disk_hard_wall_options_t), intent(in) :: options; real(c_double), value :: speed; end function
    integer(c_int) function cor_disk_hard_wall_in(workspace, bytes, modes, n_modes, options, speed, out, detail) &
      bind(c)
      import; type(c_ptr), value :: workspace; integer(c_size_t), value :: bytes, n_modes
      type(cor_disk_modes_t), intent(in) :: modes; type(cor_disk_hard_wall_options_t), intent(in) :: options
      real(c_double), value :: speed; type(cor_disk_hard_wall_t), intent(inout) :: out
      type(cor_disk_hard_wall_detail_t), intent(in), optional :: detail; end function
    pure real(c_double) function c_cor_disk_eps(speed, nu) bind(c, name="cor_disk_eps"); import
      real(c_double), value :: speed, nu; end function
    subroutine cor_disk_eps_array(speed, nu, eps, n) bind(c); import; real(c_double), intent(in) :: speed(*)
      real(c_double), value :: nu; real(c_double), intent(inout) :: eps(*); integer(c_size_t), value :: n
      end subroutine
    pure real(c_double) function c_cor_disk_eps_uncertainty(speed, nu) bind(c, name="cor_disk_eps_uncertainty")
      import; real(c_double), value :: speed, nu; end function
    pure real(c_double) function c_cor_disk_one_minus_eps2(speed, nu) bind(c, name="cor_disk_one_minus_eps2"); import
      real(c_double), value :: speed, nu; end function
    pure real(c_double) function c_cor_disk_one_minus_eps2_uncertainty(speed, nu) bind(c, &
      name="cor_disk_one_minus_eps2_uncertainty")
      import; real(c_double), value :: speed, nu; end function
    type(c_ptr) function cor_law_function(law, end, quantity) bind(c); import
      integer(c_int), value :: law, end, quantity; end function
    pure real(c_double) function c_cor_law_value(law, end, quantity, x) bind(c, name="cor_law_value"); import
      integer(c_int), value :: law, end, quantity; real(c_double), value :: x; end function
    subroutine cor_law_array(law, end, quantity, in, out, n) bind(c); import
      integer(c_int), value :: law, end, quantity; real(c_double), intent(in) :: in(*)
      real(c_double), intent(inout) :: out(*); integer(c_size_t), value :: n; end subroutine
    subroutine cor_law_arrayf(law, end, quantity, in, out, n) bind(c); import
      integer(c_int), value :: law, end, quantity; real(c_float), intent(in) :: in(*)
      real(c_float), intent(inout) :: out(*); integer(c_size_t), value :: n; end subroutine
    type(c_ptr) function c_cor_law_name(law) bind(c, name="cor_law_name"); import; integer(c_int), value :: law
      end function
    type(c_ptr) function c_cor_end_name(end) bind(c, name="cor_end_name"); import; integer(c_int), value :: end
      end function
    type(c_ptr) function c_cor_quantity_name(quantity) bind(c, name="cor_quantity_name"); import
      integer(c_int), value :: quantity; end function
    pure real(c_double) function c_cor_hunt_crossley_max_overlap(beta, elastic_exponent) bind(c, &
      name="cor_hunt_crossley_max_overlap")
      import; real(c_double), value :: beta, elastic_exponent; end function
    subroutine cor_hunt_crossley_max_overlap_array(beta, elastic_exponent, y, n) bind(c); import
      real(c_double), intent(in) :: beta(*); real(c_double), value :: elastic_exponent
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_hunt_crossley_duration(beta, elastic_exponent) bind(c, &
      name="cor_hunt_crossley_duration")
      import; real(c_double), value :: beta, elastic_exponent; end function
    subroutine cor_hunt_crossley_duration_array(beta, elastic_exponent, y, n) bind(c); import
      real(c_double), intent(in) :: beta(*); real(c_double), value :: elastic_exponent
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_hunt_crossley_duration_approach_only(beta, elastic_exponent) bind(c, &
      name="cor_hunt_crossley_duration_approach_only")
      import; real(c_double), value :: beta, elastic_exponent; end function
    subroutine cor_hunt_crossley_duration_approach_only_array(beta, elastic_exponent, y, n) bind(c); import
      real(c_double), intent(in) :: beta(*); real(c_double), value :: elastic_exponent
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_hunt_crossley_time_of_max_overlap(beta, elastic_exponent) bind(c, &
      name="cor_hunt_crossley_time_of_max_overlap")
      import; real(c_double), value :: beta, elastic_exponent; end function
    subroutine cor_hunt_crossley_time_of_max_overlap_array(beta, elastic_exponent, y, n) bind(c); import
      real(c_double), intent(in) :: beta(*); real(c_double), value :: elastic_exponent
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_tangential_no_slip(kappa, elastic_exponent) bind(c, &
      name="cor_tangential_no_slip")
      import; real(c_double), value :: kappa, elastic_exponent; end function
    subroutine cor_tangential_no_slip_array(kappa, elastic_exponent, y, n) bind(c); import
      real(c_double), intent(in) :: kappa(*); real(c_double), value :: elastic_exponent
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_sphere_eps_zero_overlap(beta) bind(c, name="cor_sphere_eps_zero_overlap")
      import; real(c_double), value :: beta; end function
    subroutine cor_sphere_eps_zero_overlap_array(beta, y, n) bind(c); import; real(c_double), intent(in) :: beta(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_sphere_eps_zero_force(beta) bind(c, name="cor_sphere_eps_zero_force"); import
      real(c_double), value :: beta; end function
    subroutine cor_sphere_eps_zero_force_array(beta, y, n) bind(c); import; real(c_double), intent(in) :: beta(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_sphere_loss_zero_overlap(beta) bind(c, name="cor_sphere_loss_zero_overlap")
      import; real(c_double), value :: beta; end function
    subroutine cor_sphere_loss_zero_overlap_array(beta, y, n) bind(c); import; real(c_double), intent(in) :: beta(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_sphere_loss_zero_force(beta) bind(c, name="cor_sphere_loss_zero_force"); import
      real(c_double), value :: beta; end function
    subroutine cor_sphere_loss_zero_force_array(beta, y, n) bind(c); import; real(c_double), intent(in) :: beta(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_sphere_beta_zero_overlap(eps) bind(c, name="cor_sphere_beta_zero_overlap")
      import; real(c_double), value :: eps; end function
    subroutine cor_sphere_beta_zero_overlap_array(eps, y, n) bind(c); import; real(c_double), intent(in) :: eps(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_sphere_beta_zero_force(eps) bind(c, name="cor_sphere_beta_zero_force"); import
      real(c_double), value :: eps; end function
    subroutine cor_sphere_beta_zero_force_array(eps, y, n) bind(c); import; real(c_double), intent(in) :: eps(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_sphere_duration_zero_overlap(beta) bind(c, &
      name="cor_sphere_duration_zero_overlap")
      import; real(c_double), value :: beta; end function
    subroutine cor_sphere_duration_zero_overlap_array(beta, y, n) bind(c); import
      real(c_double), intent(in) :: beta(*); real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n
      end subroutine
    pure real(c_double) function c_cor_sphere_duration_zero_force(beta) bind(c, name="cor_sphere_duration_zero_force")
      import; real(c_double), value :: beta; end function
    subroutine cor_sphere_duration_zero_force_array(beta, y, n) bind(c); import; real(c_double), intent(in) :: beta(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_sphere_max_overlap(beta) bind(c, name="cor_sphere_max_overlap"); import
      real(c_double), value :: beta; end function
    subroutine cor_sphere_max_overlap_array(beta, y, n) bind(c); import; real(c_double), intent(in) :: beta(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_sphere_time_of_max_overlap(beta) bind(c, name="cor_sphere_time_of_max_overlap")
      import; real(c_double), value :: beta; end function
    subroutine cor_sphere_time_of_max_overlap_array(beta, y, n) bind(c); import; real(c_double), intent(in) :: beta(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    subroutine cor_sphere_eps_zero_overlap_arrayf(beta, y, n) bind(c); import; real(c_float), intent(in) :: beta(*)
      real(c_float), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    subroutine cor_sphere_eps_zero_force_arrayf(beta, y, n) bind(c); import; real(c_float), intent(in) :: beta(*)
      real(c_float), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    subroutine cor_sphere_loss_zero_overlap_arrayf(beta, y, n) bind(c); import; real(c_float), intent(in) :: beta(*)
      real(c_float), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    subroutine cor_sphere_loss_zero_force_arrayf(beta, y, n) bind(c); import; real(c_float), intent(in) :: beta(*)
      real(c_float), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_sphere_eps_approach_only(beta) bind(c, name="cor_sphere_eps_approach_only")
      import; real(c_double), value :: beta; end function
    subroutine cor_sphere_eps_approach_only_array(beta, y, n) bind(c); import; real(c_double), intent(in) :: beta(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_sphere_loss_approach_only(beta) bind(c, name="cor_sphere_loss_approach_only")
      import; real(c_double), value :: beta; end function
    subroutine cor_sphere_loss_approach_only_array(beta, y, n) bind(c); import; real(c_double), intent(in) :: beta(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_sphere_beta_approach_only(eps) bind(c, name="cor_sphere_beta_approach_only")
      import; real(c_double), value :: eps; end function
    subroutine cor_sphere_beta_approach_only_array(eps, y, n) bind(c); import; real(c_double), intent(in) :: eps(*)
      real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n; end subroutine
    pure real(c_double) function c_cor_sphere_beta_of_loss_approach_only(loss) bind(c, &
      name="cor_sphere_beta_of_loss_approach_only")
      import; real(c_double), value :: loss; end function
    subroutine cor_sphere_beta_of_loss_approach_only_array(loss, y, n) bind(c); import
      real(c_double), intent(in) :: loss(*); real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n
      end subroutine
    pure real(c_double) function c_cor_sphere_duration_approach_only(beta) bind(c, &
      name="cor_sphere_duration_approach_only")
      import; real(c_double), value :: beta; end function
    subroutine cor_sphere_duration_approach_only_array(beta, y, n) bind(c); import
      real(c_double), intent(in) :: beta(*); real(c_double), intent(inout) :: y(*); integer(c_size_t), value :: n
      end subroutine
    pure real(c_double) function c_cor_sphere_eps_simple(beta) bind(c, name="cor_sphere_eps_simple"); import
      real(c_double), value :: beta; end function
    pure real(c_double) function c_cor_sphere_eps_simple_fraction(beta, depth) bind(c, &
      name="cor_sphere_eps_simple_fraction")
      import; real(c_double), value :: beta; integer(c_int), value :: depth; end function
    pure real(c_double) function c_cor_sphere_eps_published_pade(beta) bind(c, name="cor_sphere_eps_published_pade")
      import; real(c_double), value :: beta; end function
    type(c_ptr) function c_cor_status_text(status) bind(c, name="cor_status_text"); import
      integer(c_int), value :: status; end function
  end interface
  public :: cor_sphere_mass_kg, cor_sphere_contact_init, cor_sphere_contact_init_g_star, cor_contact_g_star_m_s, &
    cor_contact_beta, cor_contact_eps_zero_overlap, cor_contact_eps_zero_force, cor_contact_duration_s_zero_overlap, &
    cor_contact_duration_s_zero_force, cor_contact_max_overlap_m, cor_contact_dissipation_time_s_zero_overlap, &
    cor_contact_dissipation_time_s_zero_force, cor_contact_beta_array, cor_contact_eps_zero_overlap_array, &
    cor_contact_eps_zero_force_array, cor_contact_duration_s_zero_overlap_array, &
    cor_contact_duration_s_zero_force_array, cor_contact_max_overlap_m_array, &
    cor_contact_dissipation_time_s_zero_overlap_array, cor_contact_dissipation_time_s_zero_force_array, &
    cor_dissipation_time_viscous_s, cor_dissipation_time_s, cor_tangential_kappa, cor_tangential_stick_angle, &
    cor_plate_contact_init, cor_plate_lambda, cor_plate_contact_radius_ratio, cor_plate_shear_crossings, &
    cor_plate_sphere_crossings, cor_plate_least_half_width_m, cor_half_space_wave_factor, &
    cor_half_space_wave_coefficient, cor_contact_wave_loss, cor_disk_modes_read, cor_disk_modes_compute, &
    cor_disk_modes_below, cor_disk_load_limit, cor_disk_compression_limit, cor_disk_energy_limit, &
    cor_disk_speed_limit, cor_disk_load, cor_disk_load_array, cor_disk_compression, cor_disk_energy, &
    cor_disk_load_of_energy, cor_disk_max_load, cor_disk_max_compression, cor_disk_contact_time, &
    cor_disk_contact_time_array, cor_disk_compression_leading_log, cor_disk_load_leading_log, &
    cor_disk_energy_leading_log, cor_disk_max_compression_leading_log, cor_disk_contact_time_leading_log, &
    cor_disk_rayleigh, cor_disk_rayleigh_array, cor_disk_rayleigh_tolerance, cor_disk_collision, &
    cor_disk_collision_array, cor_disk_collision_workspace, cor_disk_collision_in, cor_disk_hard_wall, &
    cor_disk_hard_wall_nu, cor_disk_hard_wall_workspace, cor_disk_hard_wall_in, cor_disk_eps, cor_disk_eps_array, &
    cor_disk_eps_uncertainty, cor_disk_one_minus_eps2, cor_disk_one_minus_eps2_uncertainty, cor_law_function, &
    cor_law_value, cor_law_array, cor_law_arrayf, cor_law_name, cor_end_name, cor_quantity_name, &
    cor_hunt_crossley_max_overlap, cor_hunt_crossley_max_overlap_array, cor_hunt_crossley_duration, &
    cor_hunt_crossley_duration_array, cor_hunt_crossley_duration_approach_only, &
    cor_hunt_crossley_duration_approach_only_array, cor_hunt_crossley_time_of_max_overlap, &
    cor_hunt_crossley_time_of_max_overlap_array, cor_tangential_no_slip, cor_tangential_no_slip_array, &
    cor_sphere_eps_zero_overlap, cor_sphere_eps_zero_overlap_array, cor_sphere_eps_zero_force, &
    cor_sphere_eps_zero_force_array, cor_sphere_loss_zero_overlap, cor_sphere_loss_zero_overlap_array, &
    cor_sphere_loss_zero_force, cor_sphere_loss_zero_force_array, cor_sphere_beta_zero_overlap, &
    cor_sphere_beta_zero_overlap_array, cor_sphere_beta_zero_force, cor_sphere_beta_zero_force_array, &
    cor_sphere_duration_zero_overlap, cor_sphere_duration_zero_overlap_array, cor_sphere_duration_zero_force, &
    cor_sphere_duration_zero_force_array, cor_sphere_max_overlap, cor_sphere_max_overlap_array, &
    cor_sphere_time_of_max_overlap, cor_sphere_time_of_max_overlap_array, cor_sphere_eps_zero_overlap_arrayf, &
    cor_sphere_eps_zero_force_arrayf, cor_sphere_loss_zero_overlap_arrayf, cor_sphere_loss_zero_force_arrayf, &
    cor_sphere_eps_approach_only, cor_sphere_eps_approach_only_array, cor_sphere_loss_approach_only, &
    cor_sphere_loss_approach_only_array, cor_sphere_beta_approach_only, cor_sphere_beta_approach_only_array, &
    cor_sphere_beta_of_loss_approach_only, cor_sphere_beta_of_loss_approach_only_array, &
    cor_sphere_duration_approach_only, cor_sphere_duration_approach_only_array, cor_sphere_eps_simple, &
    cor_sphere_eps_simple_fraction, cor_sphere_eps_published_pade, cor_status_text

contains
  elemental real(c_double) function cor_sphere_mass_kg(radius_m, density_kg_m3) result(value)
    real(c_double), intent(in) :: radius_m, density_kg_m3; value = c_cor_sphere_mass_kg(radius_m, density_kg_m3)
    end function
  elemental real(c_double) function cor_contact_g_star_m_s(contact) result(value)
    type(cor_sphere_contact_t), intent(in) :: contact; value = c_cor_contact_g_star_m_s(contact); end function
  elemental real(c_double) function cor_contact_beta(contact, speed_m_s) result(value)
    type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s
    value = c_cor_contact_beta(contact, speed_m_s); end function
  elemental real(c_double) function cor_contact_eps_zero_overlap(contact, speed_m_s) result(value)
    type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s
    value = c_cor_contact_eps_zero_overlap(contact, speed_m_s); end function
  elemental real(c_double) function cor_contact_eps_zero_force(contact, speed_m_s) result(value)
    type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s
    value = c_cor_contact_eps_zero_force(contact, speed_m_s); end function
  elemental real(c_double) function cor_contact_duration_s_zero_overlap(contact, speed_m_s) result(value)
    type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s
    value = c_cor_contact_duration_s_zero_overlap(contact, speed_m_s); end function
  elemental real(c_double) function cor_contact_duration_s_zero_force(contact, speed_m_s) result(value)
    type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s
    value = c_cor_contact_duration_s_zero_force(contact, speed_m_s); end function
  elemental real(c_double) function cor_contact_max_overlap_m(contact, speed_m_s) result(value)
    type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s
    value = c_cor_contact_max_overlap_m(contact, speed_m_s); end function
  elemental real(c_double) function cor_contact_dissipation_time_s_zero_overlap(contact, speed_m_s, eps) result(value)
    type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s, eps
    value = c_cor_contact_dissipation_time_s_zero_overlap(contact, speed_m_s, eps); end function
  elemental real(c_double) function cor_contact_dissipation_time_s_zero_force(contact, speed_m_s, eps) result(value)
    type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s, eps
    value = c_cor_contact_dissipation_time_s_zero_force(contact, speed_m_s, eps); end function
  elemental real(c_double) function cor_dissipation_time_viscous_s(eta1_pa_s, eta2_pa_s, young_modulus_pa, &
    poisson_ratio) result(value)
    real(c_double), intent(in) :: eta1_pa_s, eta2_pa_s, young_modulus_pa, poisson_ratio
    value = c_cor_dissipation_time_viscous_s(eta1_pa_s, eta2_pa_s, young_modulus_pa, poisson_ratio); end function
  elemental real(c_double) function cor_dissipation_time_s(eta1_pa_s, eta2_pa_s, young_modulus_pa, poisson_ratio) &
    result(value)
    real(c_double), intent(in) :: eta1_pa_s, eta2_pa_s, young_modulus_pa, poisson_ratio
    value = c_cor_dissipation_time_s(eta1_pa_s, eta2_pa_s, young_modulus_pa, poisson_ratio); end function
  elemental real(c_double) function cor_tangential_kappa(young_modulus_1_pa, poisson_ratio_1, young_modulus_2_pa, &
    poisson_ratio_2) result(value)
    real(c_double), intent(in) :: young_modulus_1_pa, poisson_ratio_1, young_modulus_2_pa, poisson_ratio_2
    value = c_cor_tangential_kappa(young_modulus_1_pa, poisson_ratio_1, young_modulus_2_pa, poisson_ratio_2)
    end function
  elemental real(c_double) function cor_tangential_stick_angle(kappa, friction) result(value)
    real(c_double), intent(in) :: kappa, friction; value = c_cor_tangential_stick_angle(kappa, friction); end function
  elemental real(c_double) function cor_plate_lambda(contact, speed_m_s) result(value)
    type(cor_sphere_contact_t), intent(in) :: contact; real(c_double), intent(in) :: speed_m_s
    value = c_cor_plate_lambda(contact, speed_m_s); end function
  elemental real(c_double) function cor_plate_contact_radius_ratio(contact, plate, speed_m_s) result(value)
    type(cor_sphere_contact_t), intent(in) :: contact; type(cor_plate_t), intent(in) :: plate
    real(c_double), intent(in) :: speed_m_s; value = c_cor_plate_contact_radius_ratio(contact, plate, speed_m_s)
    end function
  elemental real(c_double) function cor_plate_shear_crossings(contact, plate, speed_m_s) result(value)
    type(cor_sphere_contact_t), intent(in) :: contact; type(cor_plate_t), intent(in) :: plate
    real(c_double), intent(in) :: speed_m_s; value = c_cor_plate_shear_crossings(contact, plate, speed_m_s)
    end function
  elemental real(c_double) function cor_plate_sphere_crossings(contact, sphere, speed_m_s) result(value)
    type(cor_sphere_contact_t), intent(in) :: contact; type(cor_body_t), intent(in) :: sphere
    real(c_double), intent(in) :: speed_m_s; value = c_cor_plate_sphere_crossings(contact, sphere, speed_m_s)
    end function
  elemental real(c_double) function cor_plate_least_half_width_m(contact, plate, speed_m_s) result(value)
    type(cor_sphere_contact_t), intent(in) :: contact; type(cor_plate_t), intent(in) :: plate
    real(c_double), intent(in) :: speed_m_s; value = c_cor_plate_least_half_width_m(contact, plate, speed_m_s)
    end function
  elemental real(c_double) function cor_half_space_wave_factor(poisson_ratio) result(value)
    real(c_double), intent(in) :: poisson_ratio; value = c_cor_half_space_wave_factor(poisson_ratio); end function
  elemental real(c_double) function cor_half_space_wave_coefficient(poisson_ratio) result(value)
    real(c_double), intent(in) :: poisson_ratio; value = c_cor_half_space_wave_coefficient(poisson_ratio); end &
    function
  elemental real(c_double) function cor_contact_wave_loss(contact, half_space, speed_m_s) result(value)
    type(cor_sphere_contact_t), intent(in) :: contact; type(cor_half_space_t), intent(in) :: half_space
    real(c_double), intent(in) :: speed_m_s; value = c_cor_contact_wave_loss(contact, half_space, speed_m_s)
    end function
  elemental integer(c_size_t) function cor_disk_modes_below(nu, omega) result(value)
    real(c_double), intent(in) :: nu, omega; value = c_cor_disk_modes_below(nu, omega); end function
  elemental real(c_double) function cor_disk_load_limit(nu, datum) result(value); real(c_double), intent(in) :: nu
    integer(c_int), intent(in) :: datum; value = c_cor_disk_load_limit(nu, datum); end function
  elemental real(c_double) function cor_disk_compression_limit(nu, datum) result(value)
    real(c_double), intent(in) :: nu; integer(c_int), intent(in) :: datum
    value = c_cor_disk_compression_limit(nu, datum); end function
  elemental real(c_double) function cor_disk_energy_limit(nu, datum) result(value); real(c_double), intent(in) :: nu
    integer(c_int), intent(in) :: datum; value = c_cor_disk_energy_limit(nu, datum); end function
  elemental real(c_double) function cor_disk_speed_limit(nu, datum) result(value); real(c_double), intent(in) :: nu
    integer(c_int), intent(in) :: datum; value = c_cor_disk_speed_limit(nu, datum); end function
  elemental real(c_double) function cor_disk_load(compression, nu, datum) result(value)
    real(c_double), intent(in) :: compression, nu; integer(c_int), intent(in) :: datum
    value = c_cor_disk_load(compression, nu, datum); end function
  elemental real(c_double) function cor_disk_compression(load, nu, datum) result(value)
    real(c_double), intent(in) :: load, nu; integer(c_int), intent(in) :: datum
    value = c_cor_disk_compression(load, nu, datum); end function
  elemental real(c_double) function cor_disk_energy(load, nu, datum) result(value)
    real(c_double), intent(in) :: load, nu; integer(c_int), intent(in) :: datum
    value = c_cor_disk_energy(load, nu, datum); end function
  elemental real(c_double) function cor_disk_load_of_energy(energy, nu, datum) result(value)
    real(c_double), intent(in) :: energy, nu; integer(c_int), intent(in) :: datum
    value = c_cor_disk_load_of_energy(energy, nu, datum); end function
  elemental real(c_double) function cor_disk_max_load(speed, nu, datum) result(value)
    real(c_double), intent(in) :: speed, nu; integer(c_int), intent(in) :: datum
    value = c_cor_disk_max_load(speed, nu, datum); end function
  elemental real(c_double) function cor_disk_max_compression(speed, nu, datum) result(value)
    real(c_double), intent(in) :: speed, nu; integer(c_int), intent(in) :: datum
    value = c_cor_disk_max_compression(speed, nu, datum); end function
  elemental real(c_double) function cor_disk_contact_time(speed, nu, datum) result(value)
    real(c_double), intent(in) :: speed, nu; integer(c_int), intent(in) :: datum
    value = c_cor_disk_contact_time(speed, nu, datum); end function
  elemental real(c_double) function cor_disk_compression_leading_log(load) result(value)
    real(c_double), intent(in) :: load; value = c_cor_disk_compression_leading_log(load); end function
  elemental real(c_double) function cor_disk_load_leading_log(compression) result(value)
    real(c_double), intent(in) :: compression; value = c_cor_disk_load_leading_log(compression); end function
  elemental real(c_double) function cor_disk_energy_leading_log(compression) result(value)
    real(c_double), intent(in) :: compression; value = c_cor_disk_energy_leading_log(compression); end function
  elemental real(c_double) function cor_disk_max_compression_leading_log(speed) result(value)
    real(c_double), intent(in) :: speed; value = c_cor_disk_max_compression_leading_log(speed); end function
  elemental real(c_double) function cor_disk_contact_time_leading_log(speed) result(value)
    real(c_double), intent(in) :: speed; value = c_cor_disk_contact_time_leading_log(speed); end function
  elemental integer(c_size_t) function cor_disk_collision_workspace(modes, n_modes, options) result(value)
    type(cor_disk_modes_t), intent(in) :: modes; integer(c_size_t), intent(in) :: n_modes
    type(cor_disk_collision_options_t), intent(in) :: options
    value = c_cor_disk_collision_workspace(modes, n_modes, options); end function
  elemental integer(c_size_t) function cor_disk_hard_wall_workspace(modes, n_modes, options, speed) result(value)
    type(cor_disk_modes_t), intent(in) :: modes; integer(c_size_t), intent(in) :: n_modes
    type(cor_disk_hard_wall_options_t), intent(in) :: options; real(c_double), intent(in) :: speed
    value = c_cor_disk_hard_wall_workspace(modes, n_modes, options, speed); end function
  elemental real(c_double) function cor_disk_eps(speed, nu) result(value); real(c_double), intent(in) :: speed, nu
    value = c_cor_disk_eps(speed, nu); end function
  elemental real(c_double) function cor_disk_eps_uncertainty(speed, nu) result(value)
    real(c_double), intent(in) :: speed, nu; value = c_cor_disk_eps_uncertainty(speed, nu); end function
  elemental real(c_double) function cor_disk_one_minus_eps2(speed, nu) result(value)
    real(c_double), intent(in) :: speed, nu; value = c_cor_disk_one_minus_eps2(speed, nu); end function
  elemental real(c_double) function cor_disk_one_minus_eps2_uncertainty(speed, nu) result(value)
    real(c_double), intent(in) :: speed, nu; value = c_cor_disk_one_minus_eps2_uncertainty(speed, nu); end function
  elemental real(c_double) function cor_law_value(law, end, quantity, x) result(value)
    integer(c_int), intent(in) :: law, end, quantity; real(c_double), intent(in) :: x
    value = c_cor_law_value(law, end, quantity, x); end function
  function cor_law_name(law) result(text)
    integer(c_int), intent(in) :: law
    character(len=:), allocatable :: text
    text = text_of(c_cor_law_name(law))
  end function
  function cor_end_name(end) result(text)
    integer(c_int), intent(in) :: end
    character(len=:), allocatable :: text
    text = text_of(c_cor_end_name(end))
  end function
  function cor_quantity_name(quantity) result(text)
    integer(c_int), intent(in) :: quantity
    character(len=:), allocatable :: text
    text = text_of(c_cor_quantity_name(quantity))
  end function
  elemental real(c_double) function cor_hunt_crossley_max_overlap(beta, elastic_exponent) result(value)
    real(c_double), intent(in) :: beta, elastic_exponent
    value = c_cor_hunt_crossley_max_overlap(beta, elastic_exponent); end function
  elemental real(c_double) function cor_hunt_crossley_duration(beta, elastic_exponent) result(value)
    real(c_double), intent(in) :: beta, elastic_exponent; value = c_cor_hunt_crossley_duration(beta, elastic_exponent)
    end function
  elemental real(c_double) function cor_hunt_crossley_duration_approach_only(beta, elastic_exponent) result(value)
    real(c_double), intent(in) :: beta, elastic_exponent
    value = c_cor_hunt_crossley_duration_approach_only(beta, elastic_exponent); end function
  elemental real(c_double) function cor_hunt_crossley_time_of_max_overlap(beta, elastic_exponent) result(value)
    real(c_double), intent(in) :: beta, elastic_exponent
    value = c_cor_hunt_crossley_time_of_max_overlap(beta, elastic_exponent); end function
  elemental real(c_double) function cor_tangential_no_slip(kappa, elastic_exponent) result(value)
    real(c_double), intent(in) :: kappa, elastic_exponent; value = c_cor_tangential_no_slip(kappa, elastic_exponent)
    end function
  elemental real(c_double) function cor_sphere_eps_zero_overlap(beta) result(value)
    real(c_double), intent(in) :: beta; value = c_cor_sphere_eps_zero_overlap(beta); end function
  elemental real(c_double) function cor_sphere_eps_zero_force(beta) result(value); real(c_double), intent(in) :: beta
    value = c_cor_sphere_eps_zero_force(beta); end function
  elemental real(c_double) function cor_sphere_loss_zero_overlap(beta) result(value)
    real(c_double), intent(in) :: beta; value = c_cor_sphere_loss_zero_overlap(beta); end function
  elemental real(c_double) function cor_sphere_loss_zero_force(beta) result(value); real(c_double), intent(in) :: beta
    value = c_cor_sphere_loss_zero_force(beta); end function
  elemental real(c_double) function cor_sphere_beta_zero_overlap(eps) result(value); real(c_double), intent(in) :: eps
    value = c_cor_sphere_beta_zero_overlap(eps); end function
  elemental real(c_double) function cor_sphere_beta_zero_force(eps) result(value); real(c_double), intent(in) :: eps
    value = c_cor_sphere_beta_zero_force(eps); end function
  elemental real(c_double) function cor_sphere_duration_zero_overlap(beta) result(value)
    real(c_double), intent(in) :: beta; value = c_cor_sphere_duration_zero_overlap(beta); end function
  elemental real(c_double) function cor_sphere_duration_zero_force(beta) result(value)
    real(c_double), intent(in) :: beta; value = c_cor_sphere_duration_zero_force(beta); end function
  elemental real(c_double) function cor_sphere_max_overlap(beta) result(value); real(c_double), intent(in) :: beta
    value = c_cor_sphere_max_overlap(beta); end function
  elemental real(c_double) function cor_sphere_time_of_max_overlap(beta) result(value)
    real(c_double), intent(in) :: beta; value = c_cor_sphere_time_of_max_overlap(beta); end function
  elemental real(c_double) function cor_sphere_eps_approach_only(beta) result(value)
    real(c_double), intent(in) :: beta; value = c_cor_sphere_eps_approach_only(beta); end function
  elemental real(c_double) function cor_sphere_loss_approach_only(beta) result(value)
    real(c_double), intent(in) :: beta; value = c_cor_sphere_loss_approach_only(beta); end function
  elemental real(c_double) function cor_sphere_beta_approach_only(eps) result(value)
    real(c_double), intent(in) :: eps; value = c_cor_sphere_beta_approach_only(eps); end function
  elemental real(c_double) function cor_sphere_beta_of_loss_approach_only(loss) result(value)
    real(c_double), intent(in) :: loss; value = c_cor_sphere_beta_of_loss_approach_only(loss); end function
  elemental real(c_double) function cor_sphere_duration_approach_only(beta) result(value)
    real(c_double), intent(in) :: beta; value = c_cor_sphere_duration_approach_only(beta); end function
  elemental real(c_double) function cor_sphere_eps_simple(beta) result(value); real(c_double), intent(in) :: beta
    value = c_cor_sphere_eps_simple(beta); end function
  elemental real(c_double) function cor_sphere_eps_simple_fraction(beta, depth) result(value)
    real(c_double), intent(in) :: beta; integer(c_int), intent(in) :: depth
    value = c_cor_sphere_eps_simple_fraction(beta, depth); end function
  elemental real(c_double) function cor_sphere_eps_published_pade(beta) result(value)
    real(c_double), intent(in) :: beta; value = c_cor_sphere_eps_published_pade(beta); end function
  function cor_status_text(status) result(text)
    integer(c_int), intent(in) :: status
    character(len=:), allocatable :: text
    text = text_of(c_cor_status_text(status))
  end function
  function text_of(address) result(text)
    type(c_ptr), intent(in) :: address
    character(len=:), allocatable :: text
    character(kind=c_char), pointer :: letters(:)
    integer :: i
    text = ''
    if (.not. c_associated(address)) return
    call c_f_pointer(address, letters, [1000])
    do i = 1, size(letters)
      if (letters(i) == c_null_char) exit
      text = text // letters(i)
    end do
  end function
end module
