! SPDX-License-Identifier: Apache-2.0
!
! A secondary controller in Fortran, made to be copied: a minimum pitch angle that depends on the
! wind speed (it limits the thrust around rated wind), laid over the pitch demands of the feedback
! controller called before. The wind speed comes from the record named in the input file, e.g. 27
! (anemometer) or 3303 (rotor-effective wind speed of the lidar), through a low-pass.
!
! Two libraries write the pitch demands 42-45 then: the master's input file must say that this is
! meant (SharedRecords). The controller before does not know of the limit: keep it below the pitch
! it would choose itself, except where the limit is wanted.
!
! State is static (module variables): the LAC master loads one private copy of such a library for
! each turbine.
module minimum_pitch
  use, intrinsic :: iso_c_binding, only: c_char, c_float, c_int, c_null_char
  use, intrinsic :: iso_fortran_env, only: real64
  use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
  implicit none
  private
  public :: discon

  ! Records
  integer, parameter :: status = 1, time_step = 3, pitch_demands(4) = [42, 43, 44, 45]
  integer, parameter :: message_capacity = 49, in_file_length = 50
  integer, parameter :: extended_start = 66, array_size = 129

  integer, parameter :: most_points = 100, text_length = 1024
  character(8), parameter :: file_kind = 'MINPIT1 '
  real(real64), parameter :: pi = acos(-1.0_real64)

  ! Everything that a checkpoint must bring back, the parameters included: a restarted process is
  ! told the name of the checkpoint, not that of the input file.
  type :: limiter
    integer :: points, wind_record, signal_record
    real(real64) :: wind_mps(most_points), pitch_rad(most_points)
    real(real64) :: weight        ! of the new value in the low-pass
    real(real64) :: filtered_mps
  end type
  type(limiter), save :: now

contains

  subroutine discon(swap, fail, in_file, out_name, message) bind(C, name='DISCON')
    !DEC$ ATTRIBUTES DLLEXPORT :: discon
    real(c_float), intent(inout) :: swap(*)
    integer(c_int), intent(inout) :: fail
    character(kind=c_char), intent(in) :: in_file(*)
    character(kind=c_char), intent(inout) :: out_name(*)
    character(kind=c_char), intent(inout) :: message(*)
    character(text_length) :: file, text
    if (.false.) out_name(1) = out_name(1)  ! this library writes no file of its own

    text = ''
    select case (nint(swap(status)))
    case (1)
      call step(swap)
    case (0, -8, -9)
      call copy_name(in_file, nint(swap(in_file_length)), file)
      if (nint(swap(status)) == 0) call start(swap, trim(file), text)
      if (nint(swap(status)) == -8) call save_state(trim(file), text)
      if (nint(swap(status)) == -9) call load_state(trim(file), text)
    case default  ! -1: nothing to give back; all others: not known, nothing is done
    end select

    fail = 0
    if (text /= '') then
      fail = -1  ! ends the run
      call put_message('minimum_pitch: '//trim(text), nint(swap(message_capacity)), message)
    end if
  end subroutine

  ! Each step: no memory, no files.
  subroutine step(swap)
    real(c_float), intent(inout) :: swap(*)
    real(real64) :: wind_mps, limit_rad
    integer :: i
    wind_mps = real(swap(now%wind_record), real64)
    if (ieee_is_finite(wind_mps)) then  ! a lidar value that is not there yet is not a number
      now%filtered_mps = now%filtered_mps + now%weight*(wind_mps - now%filtered_mps)
    end if
    limit_rad = limit_at(now%filtered_mps)
    do i = 1, size(pitch_demands)
      swap(pitch_demands(i)) = max(swap(pitch_demands(i)), real(limit_rad, c_float))
    end do
    if (now%signal_record > 0) swap(now%signal_record) = real(limit_rad, c_float)
  end subroutine

  ! Linear between the points, constant outside.
  pure function limit_at(wind_mps) result(pitch_rad)
    real(real64), intent(in) :: wind_mps
    real(real64) :: pitch_rad, share
    integer :: i
    pitch_rad = now%pitch_rad(1)
    do i = 2, now%points
      share = (wind_mps - now%wind_mps(i - 1))/(now%wind_mps(i) - now%wind_mps(i - 1))
      if (share <= 0.0_real64) exit
      share = min(share, 1.0_real64)
      pitch_rad = (1.0_real64 - share)*now%pitch_rad(i - 1) + share*now%pitch_rad(i)
    end do
  end function

  subroutine start(swap, file, text)
    real(c_float), intent(inout) :: swap(*)
    character(*), intent(in) :: file
    character(*), intent(inout) :: text
    real(real64) :: points(1), records(2), corner(1), pitch_deg(most_points)
    integer :: unit, status_io
    open (newunit=unit, file=file, status='old', action='read', iostat=status_io)
    if (status_io /= 0) then
      text = file//' cannot be opened'
      return
    end if
    call read_numbers(unit, 'Points', points, text)
    call read_numbers(unit, 'WindSpeedRecord', records(1:1), text)
    call read_numbers(unit, 'SignalRecord', records(2:2), text)
    call read_numbers(unit, 'CornerFrequency', corner, text)
    now%points = nint(points(1))
    if (text == '' .and. (now%points < 2 .or. now%points > most_points)) then
      text = 'Points: expected 2 to 100'
    end if
    if (text == '') then
      call read_numbers(unit, 'WindSpeed', now%wind_mps(1:now%points), text)
      call read_numbers(unit, 'MinimumPitch', pitch_deg(1:now%points), text)
    end if
    close (unit)
    if (text == '') call check(swap, nint(records), corner(1), text)
    if (text /= '') then
      text = file//': '//text
      return
    end if
    now%wind_record = nint(records(1))
    now%signal_record = nint(records(2))
    now%pitch_rad(1:now%points) = pitch_deg(1:now%points)*pi/180.0_real64
    now%weight = 1.0_real64 - exp(-2.0_real64*pi*corner(1)*real(swap(time_step), real64))
    now%filtered_mps = real(swap(now%wind_record), real64)
    if (.not. ieee_is_finite(now%filtered_mps)) now%filtered_mps = now%wind_mps(1)
    call step(swap)
  end subroutine

  subroutine check(swap, records, corner_Hz, text)
    real(c_float), intent(in) :: swap(*)
    integer, intent(in) :: records(2)
    real(real64), intent(in) :: corner_Hz
    character(*), intent(inout) :: text
    if (any(now%wind_mps(2:now%points) <= now%wind_mps(1:now%points - 1))) then
      text = 'WindSpeed: expected rising values'
    else if (corner_Hz <= 0.0_real64) then
      text = 'CornerFrequency: expected more than 0'
    else if (records(1) < 1 .or. any(records > known_records(swap)) .or. records(2) < 0) then
      text = 'WindSpeedRecord, SignalRecord: expected numbers of records of this array'
    end if
  end subroutine

  ! Records that may be touched: 164 with every host, more where the host says so.
  integer function known_records(swap)
    real(c_float), intent(in) :: swap(*)
    known_records = 164
    if (nint(swap(extended_start)) == 1001) known_records = max(164, nint(swap(array_size)))
  end function

  ! The line "value value ... ! key".
  subroutine read_numbers(unit, key, values, text)
    integer, intent(in) :: unit
    character(*), intent(in) :: key
    real(real64), intent(out) :: values(:)
    character(*), intent(inout) :: text
    character(text_length) :: line
    integer :: mark, status_io
    values = 0.0_real64
    rewind (unit)
    do
      read (unit, '(A)', iostat=status_io) line
      if (status_io /= 0) exit
      mark = index(line, '! '//key//' ')
      if (mark == 0) cycle
      read (line(:mark - 1), *, iostat=status_io) values
      if (status_io /= 0) text = key//': too few numbers in front of "!"'
      return
    end do
    text = key//' is missing'
  end subroutine

  ! -8 and -9: save or load, and touch nothing else.
  subroutine save_state(file, text)
    character(*), intent(in) :: file
    character(*), intent(inout) :: text
    integer :: unit, status_io
    open (newunit=unit, file=file, access='stream', form='unformatted', action='write', &
          status='replace', iostat=status_io)
    if (status_io == 0) write (unit, iostat=status_io) file_kind, now
    if (status_io == 0) close (unit, iostat=status_io)
    if (status_io /= 0) text = file//' cannot be written'
  end subroutine

  subroutine load_state(file, text)
    character(*), intent(in) :: file
    character(*), intent(inout) :: text
    character(8) :: kind_found
    integer :: unit, status_io
    kind_found = ''
    open (newunit=unit, file=file, access='stream', form='unformatted', action='read', &
          status='old', iostat=status_io)
    if (status_io == 0) then
      read (unit, iostat=status_io) kind_found, now
      close (unit)
    end if
    if (status_io /= 0 .or. kind_found /= file_kind) then
      text = file//' is not a checkpoint of this library'
    end if
  end subroutine

  ! The host counts the terminator in record 50 or not, and may send none.
  subroutine copy_name(from, length, to)
    character(kind=c_char), intent(in) :: from(*)
    integer, intent(in) :: length
    character(*), intent(out) :: to
    integer :: i
    to = ''
    do i = 1, min(length, len(to))
      if (from(i) == c_null_char) exit
      to(i:i) = from(i)
    end do
  end subroutine

  ! At most record 49 characters, the terminator included.
  subroutine put_message(text, capacity, message)
    character(*), intent(in) :: text
    integer, intent(in) :: capacity
    character(kind=c_char), intent(inout) :: message(*)
    integer :: i, n
    n = min(len(text), capacity - 1)
    do i = 1, n
      message(i) = text(i:i)
    end do
    if (n >= 0) message(n + 1) = c_null_char
  end subroutine

end module
