#!/bin/sh
# Runs test programs on an emulated processor with AVX-512: eight-lanes.sh folder program...
# Needs Debian's bochs, isolinux, syslinux-common, xorriso, cpio and busybox-static.
set -eu
work=$1; shift
count=$#
mkdir -p "$work/root/bin" "$work/root/proc" "$work/root/dev" "$work/root/t" "$work/iso/isolinux"
for program; do # with the libraries they ask for
    strip -o "$work/root/t/$(basename "$program")" "$program"
    ldd "$program" | grep -o '/[^ ]*' | xargs -I{} cp -L --parents {} "$work/root"
done
cp /bin/busybox "$work/root/bin"
cat > "$work/root/init" <<'END'
#!/bin/busybox sh
/bin/busybox mount -t proc proc /proc
/bin/busybox mount -t devtmpfs dev /dev
/bin/busybox grep -o 'avx512[a-z]*' /proc/cpuinfo
for t in /t/*; do $t --test-threads=1 --nocapture; echo "EXIT $t $?"; done 2>&1
/bin/busybox sleep 3 # what is left on the serial line
/bin/busybox poweroff -f
END
chmod +x "$work/root/init"
cd "$work"
(cd root && find . | cpio -o -H newc --quiet) > iso/initrd
if [ ! -f iso/vmlinuz ]; then # any Debian kernel: not installed, only unpacked
    apt-get download "$(apt-cache depends linux-image-cloud-amd64 | awk '/Depends: linux-image/ {print $2; exit}')"
    dpkg -x linux-image-*.deb kernel && cp kernel/boot/vmlinuz-* iso/vmlinuz
fi
cp /usr/lib/ISOLINUX/isolinux.bin /usr/lib/syslinux/modules/bios/ldlinux.c32 iso/isolinux
cat > iso/isolinux/isolinux.cfg <<'END'
default test
label test
 kernel /vmlinuz
 append initrd=/initrd console=ttyS0,115200 quiet nokaslr mitigations=off lpj=1000000 tsc=reliable no_timer_check panic=-1 noxsaves clearcpuid=xsavec
END
xorriso -as mkisofs -quiet -o boot.iso -b isolinux/isolinux.bin -c isolinux/boot.cat \
    -no-emul-boot -boot-load-size 4 -boot-info-table iso
cat > bochsrc <<'END'
cpu: model=corei7_skylake_x, ips=50000000, ignore_bad_msrs=1
memory: guest=512, host=512
romimage: file=/usr/share/bochs/BIOS-bochs-latest
vgaromimage: file=/usr/share/bochs/VGABIOS-lgpl-latest
ata0-master: type=cdrom, path=boot.iso, status=inserted
boot: cdrom
com1: enabled=1, mode=file, dev=serial.txt
clock: sync=none
display_library: rfb, options="timeout=0"
sound: waveoutdrv=dummy, waveindrv=dummy, midioutdrv=dummy
log: bochs.log
panic: action=fatal
error: action=ignore
END
rm -f serial.txt; printf 'c\n' > go # Debian's Bochs stops in its debugger first
bochs -q -f bochsrc -rc go > bochs.out 2>&1 < /dev/null || true # it ends with "soft power off"
cat serial.txt
test "$(grep -c '^EXIT .* 0.\?$' serial.txt)" = "$count" # all of them ended, and well
