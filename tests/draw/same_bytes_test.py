"""Every picture is the same to the byte: core and compatibility profile, EGL and OSMesa, any number of threads.

same_bytes_test.py DRAW_DIGEST
"""
import os
import subprocess
import sys


def digests(program, back_end, profile, threads):
    environment = dict(os.environ, LP_NUM_THREADS=threads)
    environment.pop("VO_OFFSCREEN", None)
    run = subprocess.run([program, back_end, profile], env=environment, capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{back_end} {profile}, {threads} threads: {run.stderr}")
    return run.stdout


def main():
    program = sys.argv[1]
    expected = digests(program, "egl", "core", "2")
    pictures = expected.split()[1::2]
    if len(pictures) < 7 or len(set(pictures)) != len(pictures):
        sys.exit("the digests do not tell the pictures apart:\n" + expected)
    failed = False
    for back_end, profile, threads in [("egl", "core", "0"), ("egl", "compatibility", "1"),
                                       ("egl", "compatibility", "3"), ("osmesa", "core", "2"),
                                       ("osmesa", "compatibility", "2")]:
        found = digests(program, back_end, profile, threads)
        if found != expected:
            print(f"{back_end} {profile}, LP_NUM_THREADS={threads}:\n{found}instead of\n{expected}")
            failed = True
    sys.exit(failed)


main()
