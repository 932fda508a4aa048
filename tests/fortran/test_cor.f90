! SPDX-License-Identifier: MIT Tests the Fortran module: values of each kind of function against independently known
! numbers and the loops of C.
program test_cor
  use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_float, c_int, c_loc, &
    c_null_char, c_null_funptr, c_null_ptr, c_ptr, c_size_t
  use, intrinsic :: ieee_arithmetic, only: ieee_is_nan, ieee_positive_inf, ieee_value
  use cor
  implicit none
  integer, parameter :: n = 1000
  integer :: failed = 0

  call elemental_functions()
  call arrays()
  call laws()
  call contacts()
  call disks()
  call optional_arguments()
  call statuses()
  if (failed > 0) stop 1
  print '(a)', 'all agree'

contains

  subroutine expect(name, is_true)
    character(len=*), intent(in) :: name
    logical, intent(in) :: is_true
    if (is_true) return
    failed = failed + 1
    print '(2a)', 'wrong: ', name
  end subroutine

  subroutine elemental_functions()
    real(c_double) :: beta(2, 2), eps(2, 2), infinity
    beta = reshape([0.0_c_double, 0.5_c_double, 1.0_c_double, -1.0_c_double], [2, 2])
    eps = cor_sphere_eps_zero_force(beta)
    infinity = ieee_value(infinity, ieee_positive_inf)
    call expect('eps(0) = 1', eps(1, 1) >= 1 .and. eps(1, 1) <= 1)
    call expect('eps(1), 20 digits by corgen', abs(eps(1, 2) - 0.3939306032298731930511811_c_double) < 1e-16_c_double)
    call expect('eps(-1)', ieee_is_nan(eps(2, 2)))
    call expect('eps(inf)', abs(cor_sphere_eps_zero_force(infinity)) <= 0)
    call expect('exponent', &
      abs(cor_hunt_crossley_duration(0.0_c_double, 1.0_c_double) - acos(-1.0_c_double)) < 1e-15_c_double)
    call expect('depth', abs(cor_sphere_eps_simple_fraction(0.5_c_double, 0_c_int) - 1) <= 0)
    call expect('constant', COR_SPHERE_C1 > -1.1534488581_c_double .and. COR_SPHERE_C1 < -1.1534488580_c_double)
  end subroutine

  subroutine arrays()
    real(c_double) :: x(n), y(n)
    integer :: i
    x = [(0.01_c_double * i, i = 0, n - 1)]
    call cor_sphere_eps_zero_force_array(x, y, int(n, c_size_t))
    call expect('array', all(abs(y - cor_sphere_eps_zero_force(x)) <= 0))
    call cor_hunt_crossley_max_overlap_array(x, 1.5_c_double, y, int(n, c_size_t))
    call expect('array with an exponent', all(abs(y - cor_hunt_crossley_max_overlap(x, 1.5_c_double)) <= 0))
    y = -1
    call cor_sphere_eps_zero_force_array(x, y, 0_c_size_t)
    call expect('no element', all(y < 0))
  end subroutine

  ! Calls every function of the table with a number, with an array, in float and by its pointer.
  subroutine laws()
    real(c_double) :: x(3), y(3), z(3)
    real(c_float) :: yf(3)
    type(cor_law_function_t), pointer :: found
    type(c_ptr) :: at
    integer(c_int) :: law, end_of, quantity
    integer :: functions
    x = [0.1_c_double, 0.5_c_double, 1.0_c_double]
    functions = 0
    do law = 0, COR_LAWS - 1
      do end_of = 0, COR_ENDS - 1
        do quantity = 0, COR_QUANTITIES - 1
          at = cor_law_function(law, end_of, quantity)
          y = cor_law_value(law, end_of, quantity, x)
          call cor_law_array(law, end_of, quantity, x, z, 3_c_size_t)
          call cor_law_arrayf(law, end_of, quantity, real(x, c_float), yf, 3_c_size_t)
          if (.not. c_associated(at)) then
            call expect('absent', all(ieee_is_nan(y)) .and. all(ieee_is_nan(z)) .and. all(ieee_is_nan(yf)))
            cycle
          end if
          call c_f_pointer(at, found)
          call expect('law', found%least < 1 .and. found%largest >= 1 .and. .not. any(ieee_is_nan(y) .or. ieee_is_nan(z)) &
            .and. .not. any(abs(y - z) > 0 .or. abs(yf - y) > 1e-5_c_double * abs(y)))
          functions = functions + 1
        end do
      end do
    end do
    call expect('functions', functions > 70)
    call expect('tsuji', abs(cor_law_value(COR_LAW_TSUJI, COR_END_ZERO_OVERLAP, COR_EPS, 0.0_c_double) - 1) <= 0)
    call expect('names', cor_law_name(COR_LAW_HUNT_CROSSLEY) == 'hunt-crossley' .and. cor_law_name(COR_LAWS) == '' &
      .and. cor_end_name(COR_END_LIMITED) == 'limited' .and. cor_quantity_name(COR_DURATION) == 'duration')
  end subroutine

  subroutine contacts()
    type(cor_body_t) :: body
    type(cor_sphere_contact_t) :: contact
    real(c_double) :: speed(3), eps(3)
    body = cor_body_t(70e9_c_double, 0.22_c_double, 4e-7_c_double, 5e-3_c_double, 1e-3_c_double)
    call expect('init', cor_sphere_contact_init(contact, body, body) == COR_OK)
    call expect('mass', abs(contact%effective_mass_kg - 5e-4_c_double) < 1e-18_c_double)
    speed = [0.01_c_double, 0.1_c_double, 1.0_c_double]
    call cor_contact_eps_zero_overlap_array(contact, speed, eps, 3_c_size_t)
    call expect('contact array', all(abs(eps - cor_contact_eps_zero_overlap(contact, speed)) <= 0))
    call expect('contact', &
      all(abs(eps - cor_sphere_eps_zero_overlap(cor_contact_beta(contact, speed))) < 1e-15_c_double))
    body%radius_m = -1
    call expect('radius', cor_sphere_contact_init(contact, body, body) == COR_ERROR_RADIUS)
    call expect('eps after an error', ieee_is_nan(cor_contact_eps_zero_force(contact, 1.0_c_double)))
  end subroutine

  subroutine disks()
    type(cor_disk_modes_t) :: modes
    type(cor_disk_mode_t), target :: mode(50)
    type(cor_disk_rayleigh_t) :: energy, others(2)
    type(cor_disk_hard_wall_t) :: wall
    real(c_double) :: fraction(50)
    call expect('modes of the library', &
      cor_disk_modes_nu033%count == 1800 .and. cor_disk_modes_nu033%nu > 0.3299_c_double)
    call expect('compute', cor_disk_modes_compute(0.33_c_double, 50_c_size_t, mode, modes) == COR_OK)
    call expect('omega', abs(mode(1)%omega - 1.43853033_c_double) < 1e-8_c_double .and. modes%count == 50)
    call expect('rayleigh', cor_disk_rayleigh(cor_disk_modes_nu033, 50_c_size_t, COR_DISK_DATUM_CENTRE_OF_MASS, &
      1e-3_c_double, energy, fraction) == COR_OK)
    call expect('fractions', &
      abs(sum(fraction) - energy%fraction) < 1e-15_c_double .and. energy%fraction > 0.03_c_double)
    call expect('optional', cor_disk_rayleigh(modes, 50_c_size_t, COR_DISK_DATUM_CENTRE_OF_MASS, 1e-3_c_double, &
      energy) == COR_OK)
    call expect('rayleigh_array', cor_disk_rayleigh_array(modes, 50_c_size_t, COR_DISK_DATUM_CENTRE_OF_MASS, &
      [1e-3_c_double, 2e-3_c_double], 2_c_size_t, others) == COR_OK)
    call expect('its first', abs(others(1)%fraction - energy%fraction) < 1e-9_c_double)
    call expect('hard wall', cor_disk_hard_wall_nu(0.3_c_double, &
      cor_disk_hard_wall_options_t(0.02_c_double, 0_c_size_t), 0.1_c_double, wall) == COR_OK)
    call expect('its eps', abs(wall%eps - cor_disk_eps(0.1_c_double, 0.3_c_double)) < 0.02_c_double)
    call expect('datum', all(cor_disk_load(0.1_c_double, 0.33_c_double, [0_c_int, 1_c_int, 2_c_int]) > 0.07_c_double))
  end subroutine

  ! Calls with and without each optional argument; tests/fortran/run counts the optional arguments of the module.
  subroutine optional_arguments()
    character(kind=c_char), target, save :: room(2**22)
    type(c_ptr) :: at
    type(cor_disk_modes_t) :: modes, none
    type(cor_disk_mode_t), target :: mode(330)
    type(cor_disk_rayleigh_t) :: energy, many(2)
    type(cor_disk_collision_t) :: hit(2)
    type(cor_disk_hard_wall_t) :: wall(2)
    type(cor_disk_collision_options_t) :: soft
    type(cor_disk_hard_wall_options_t) :: hard
    type(cor_disk_collision_detail_t) :: detail
    type(cor_disk_hard_wall_detail_t) :: of_wall
    real(c_double), target :: after(330)
    real(c_double) :: fraction(660), speed(2), v
    integer(c_int) :: status(2), code(2)
    integer(c_size_t) :: n_modes, line, bytes
    character(kind=c_char, len=*), parameter :: path = 'no such file' // c_null_char
    call random_number(v)
    v = 0.01_c_double + 0.09_c_double * v
    print '(a, es23.16)', 'optional arguments at v = ', v
    at = c_loc(room)
    bytes = size(room, kind=c_size_t)
    speed = [v / 100, -1.0_c_double]
    soft = cor_disk_collision_options_t(500.0_c_double, 1e-2_c_double, 0_c_size_t, 0_c_size_t)
    hard = cor_disk_hard_wall_options_t(0.1_c_double, 0_c_size_t)
    detail = cor_disk_collision_detail_t(c_loc(after), c_null_ptr, c_null_funptr, c_null_ptr, c_null_ptr, c_null_ptr)
    of_wall = cor_disk_hard_wall_detail_t(c_loc(after), c_null_ptr, c_null_funptr, c_null_ptr, c_null_ptr, c_null_ptr)
    code = cor_disk_modes_compute(0.33_c_double, 330_c_size_t, mode, modes)
    line = 7
    code(1) = cor_disk_modes_read(path, mode, 1_c_size_t, none)
    code(2) = cor_disk_modes_read(path, mode, 1_c_size_t, none, line)
    call expect('line', all(code == COR_ERROR_FILE) .and. line == 0)
    fraction = -1
    code(1) = cor_disk_rayleigh(modes, 9_c_size_t, 0_c_int, v / 100, energy)
    code(2) = cor_disk_rayleigh(modes, 9_c_size_t, 0_c_int, v / 100, energy, fraction)
    call expect('mode_fraction', all(code == COR_OK) .and. all(fraction(:9) >= 0))
    fraction = -1
    code(1) = cor_disk_rayleigh_array(modes, 9_c_size_t, 0_c_int, speed, 2_c_size_t, many)
    code(2) = cor_disk_rayleigh_array(modes, 9_c_size_t, 0_c_int, speed, 2_c_size_t, many, fraction, status)
    call expect('status', all(code == COR_ERROR_SPEED) .and. all(fraction(:9) >= 0) .and. &
      status(1) == COR_OK .and. status(2) == COR_ERROR_SPEED)
    n_modes = 0
    code(1) = cor_disk_rayleigh_tolerance(modes, 0_c_int, v, 0.5_c_double, energy)
    code(2) = cor_disk_rayleigh_tolerance(modes, 0_c_int, v, 0.5_c_double, energy, n_modes)
    call expect('n_modes', code(1) == code(2) .and. n_modes > 0)
    status = -1
    code(1) = cor_disk_collision_array(modes, 9_c_size_t, soft, speed, 1_c_size_t, hit)
    code(2) = cor_disk_collision_array(modes, 9_c_size_t, soft, speed, 1_c_size_t, hit, status)
    call expect('status of collisions', code(1) == code(2) .and. status(1) == code(2))
    after = -1
    code(1) = cor_disk_collision_in(at, bytes, modes, 9_c_size_t, soft, v, hit(1))
    code(2) = cor_disk_collision_in(at, bytes, modes, 9_c_size_t, soft, v, hit(2), detail)
    call expect('detail', code(1) == code(2) .and. all(after(:9) >= 0) .and. abs(hit(1)%eps - hit(2)%eps) <= 0)
    after = -1
    code(1) = cor_disk_hard_wall_in(at, bytes, modes, 330_c_size_t, hard, v, wall(1))
    code(2) = cor_disk_hard_wall_in(at, bytes, modes, 330_c_size_t, hard, v, wall(2), of_wall)
    call expect('detail of a wall', code(1) == code(2) .and. any(after >= 0) .and. abs(wall(1)%eps - wall(2)%eps) <= 0)
  end subroutine

  subroutine statuses()
    type(cor_disk_modes_t) :: modes
    type(cor_disk_mode_t) :: mode(1)
    integer(c_size_t) :: line
    character(kind=c_char, len=*), parameter :: path = 'no such file' // c_null_char
    call expect('file', cor_disk_modes_read(path, mode, 1_c_size_t, modes, line) == COR_ERROR_FILE)
    call expect('text', index(cor_status_text(COR_ERROR_RADIUS), 'radius') > 0)
    call expect('text ends', len(cor_status_text(COR_OK)) < 100 .and. index(cor_status_text(COR_OK), c_null_char) == 0)
  end subroutine
end program
