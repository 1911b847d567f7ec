#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# inspect_dll.sh <objdump> <x86_64|i686> <library>: what a Windows host finds in a library of ours.
# Machine, exports and needed libraries; in 32 bit also that DISCON leaves its arguments to the
# caller (cdecl: a plain ret) and aligns the stack, which such hosts do not.
set -eu
objdump=$1 machine=$2 library=$3
name=${library##*/}
failed=0

# expect <what> <found> <expected>
expect() {
  if [ "$2" = "$3" ]; then
    echo "$name: $1: $2"
  else
    echo "$name: $1: found $2, expected $3" >&2
    failed=1
  fi
}
one_line() { sort | tr '\n' ' ' | sed 's/ $//'; }

headers=$("$objdump" -p "$library")
case $machine in
  x86_64) format=pei-x86-64 ;;
  i686) format=pei-i386 ;;
esac
expect "format" "$(echo "$headers" | sed -n 's/.*file format //p')" "$format"

exported=$(echo "$headers" | sed -n '/\[Ordinal\/Name Pointer\] Table/,/^$/p' |
  sed -n 's/^\t\[ *[0-9]*\] //p' | one_line)
expect "exports" "$exported" "DISCON LAC_DISCON_REENTRANT"

needed=$(echo "$headers" | sed -n 's/.*DLL Name: //p' | one_line)
expect "needs" "$needed" "KERNEL32.dll msvcrt.dll"

if [ "$machine" = i686 ]; then
  base=0x$(echo "$headers" | sed -n 's/^ImageBase[[:space:]]*//p')
  entry=0x$(echo "$headers" |
    sed -n '/^Export Address Table/,/^$/s/.*+base\[ *1\] \([0-9a-f]*\) Export RVA.*/\1/p')
  function=$("$objdump" -d --no-show-raw-insn --start-address=$((base + entry)) \
    --stop-address=$((base + entry + 256)) "$library" | sed -n 's/^ *[0-9a-f]*:\t//p' | sed '/^ret/q')
  expect "return" "$(echo "$function" | tail -n 1 | sed 's/ *$//')" "ret"
  expect "stack" "$(echo "$function" | head -n 4 | grep '^and' | tr -s ' ')" 'and $0xfffffff0,%esp'
fi
exit $failed
