! interface.f90 - the whole interface, used as documented; floating-point traps on.
!
! Bit-for-bit where contact_elements.h says so (same input, same bits), else to the tolerance stated at the
! check. interface.c is the twin: both print the same lines.
! Compile with -ffpe-trap=invalid,zero,overflow.
program interface_client
  use client_support, only: client_failures
  use interface_layout, only: interface_layout_run
  use interface_constants, only: interface_constants_run
  use interface_walk, only: interface_walk_run
  use interface_evaluate, only: interface_evaluate_run
  use interface_entries, only: interface_entries_run
  use interface_batch, only: interface_batch_run
  use interface_friction, only: interface_friction_run
  use interface_transfer, only: interface_transfer_run
  use interface_multipliers, only: interface_multipliers_run
  use interface_multiplier_batch, only: interface_multiplier_batch_run
  use interface_augmented, only: interface_augmented_run
  use interface_project, only: interface_project_run
  use interface_patch, only: interface_patch_run
  use interface_edges, only: interface_edges_run
  implicit none
  call interface_layout_run()
  call interface_constants_run()
  call interface_walk_run()
  call interface_evaluate_run()
  call interface_entries_run()
  call interface_batch_run()
  call interface_friction_run()
  call interface_transfer_run()
  call interface_multipliers_run()
  call interface_multiplier_batch_run()
  call interface_augmented_run()
  call interface_project_run()
  call interface_patch_run()
  call interface_edges_run()
  print '(2a,i0,a)', merge('PASS', 'FAIL', client_failures == 0), ' interface, ', client_failures, ' failures'
  if (client_failures /= 0) stop 1
end program interface_client
