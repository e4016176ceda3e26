! SPDX-License-Identifier: MIT
! The path of two_spheres.py: two spheres overlap by 0.1 mm and shear by 99 um along the arc of constant overlap.
module contactlaws
  use iso_c_binding
  type, bind(c) :: body
    real(c_double) :: x(3) = 0, v(3) = 0, w(3) = 0, radius = 0, mass = 0
  end type
  interface
    type(c_ptr) function make(law, count, names, values) bind(c, name='contactlaws_make')
      import :: c_ptr, c_char, c_size_t, c_double
      character(c_char), intent(in) :: law(*)
      integer(c_size_t), value :: count
      type(c_ptr), intent(in) :: names(*)
      real(c_double), intent(in) :: values(*)
    end function
    integer(c_int) function step(law, dt, count, body1, body2, state, force, torque1, torque2) bind(c, name='contactlaws_step')
      import :: c_ptr, c_int, c_size_t, c_double, body
      type(c_ptr), value :: law
      real(c_double), value :: dt
      integer(c_size_t), value :: count
      type(body), intent(in) :: body1(*), body2(*)
      real(c_double) :: state(*), force(3, *), torque1(3, *), torque2(3, *)
    end function
    subroutine discard(law) bind(c, name='contactlaws_free')
      import :: c_ptr
      type(c_ptr), value :: law
    end subroutine
  end interface
end module

program two_spheres
  use contactlaws
  real(c_double), parameter :: r1 = 7.5d-3, r2 = 5d-3, distance = r1 + r2 - 0.1d-3, shear = 99d-6, dt = 1d-6
  integer, parameter :: steps = 9900
  character(len=9, kind=c_char), target :: names(3) = [character(len=9) :: 'young'//c_null_char, 'poisson'//c_null_char, &
    'friction'//c_null_char]
  real(c_double) :: friction(2) = [10d0, 0.4d0], state(3), force(3, 1), torque1(3, 1), torque2(3, 1), n(3), t(3)
  type(body) :: below(1), above(1)
  type(c_ptr) :: law
  integer :: i, k
  below%radius = r1
  above%radius = r2
  do i = 1, 2
    law = make('dry_hill'//c_null_char, 3_c_size_t, [(c_loc(names(k)), k = 1, 3)], [29d9, 0.15d0, friction(i)])
    if (.not. c_associated(law)) stop 1
    state = 0
    do k = 0, steps  ! k = 0, dt = 0: set-up
      n = [sin(k*shear/steps/distance), 0d0, cos(k*shear/steps/distance)]
      t = [n(3), 0d0, -n(1)]
      above(1)%x = distance*n
      above(1)%v = shear/steps/dt*t
      if (step(law, merge(dt, 0d0, k > 0), 1_c_size_t, below, above, state, force, torque1, torque2) /= 0) stop 1
    end do
    print '(a, f4.1, a, f12.6, a, f13.7, a, 2f13.9, a)', 'friction ', friction(i), ': normal ', dot_product(force(:, 1), n), &
      ' N, shear ', dot_product(force(:, 1), t), ' N, torques ', torque1(2, 1), torque2(2, 1), ' N m'
    call discard(law)
  end do
end program
