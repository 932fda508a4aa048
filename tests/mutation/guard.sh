# SPDX-License-Identifier: MIT
# Tests for tests/mutation/run that are not programs of ctest: guard.sh NAME, in a copy of the sources.
case $1 in
# Gappa proves these quickly: a goal of each kind, and the sums that are compared with the bounds of cor/contact.h
proof) goals=('loss_zero_overlap_0004*' eps_zero_overlap_0006 pair_times log_0003 contact_beta) ;;
disk_goals) goals=(disk_far_0500 disk_step_03 disk_newton_03 disk_one_plus_series) ;;
disk_bounds)
    arb=(-lflint)
    printf '#include <flint/arb.h>\n' | cc -E - >/dev/null 2>&1 && arb+=(-DCOR_FLINT_HAS_ARB) || arb=(-lflint-arb -lflint)
    c++ -std=c++17 -O0 -ffp-contract=off -Igen -Iinclude -I. -Itests/proof -o guard tests/proof/disk_bounds.cpp \
        "${arb[@]}" -lmpfr -lgmp -lm && exec ./guard
    exit 1
    ;;
fortran_source) exec python3 -B python/bindings/fortran_source.py --check ;;
*) exec "tests/hygiene/$1" ;;
esac
command -v gappa >/dev/null || exit 0
c++ -std=c++17 -O0 -w -Iinclude -I. -Itests/proof -o write_goals tests/proof/goals.cpp -lgmpxx -lgmp || exit
rm -rf goals && mkdir goals && ./write_goals goals generated/sphere_rows.h 0 1 "${goals[@]}" || exit
for goal in goals/*.g; do
    gappa -Eprecision=128 -Eno-auto-dichotomy "$goal" 2>&1 || exit
done
