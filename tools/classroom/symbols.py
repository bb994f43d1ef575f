"""What the object of an exercise file calls and defines that no exercise needs: what could write a
report of its own, end the program or take the place of a test. The compiler has written it, so a
call is there however the text hides it, for example behind macros."""
import re
import subprocess

# What the standard library of C++ holds that reaches out of the program, or decides how it ends.
OUT_OF_STD = re.compile(r"filebuf|fstream|filesystem|thread|future|async|random_device|_handler|"
                        r"set_(terminate|unexpected)|exit|getenv|__basic_file")
OWN = re.compile(r"Catch|joints::testing")  # of the tests
# What C has that computes, or prints to the terminal.
OF_C = set("""abort abs __assert_fail bcmp calloc clock div __errno_location fflush fprintf fputc
fputs free fwrite labs llabs __libc_single_threaded malloc memchr memcmp memcpy memmove memset
printf putchar puts qsort rand realloc snprintf srand stderr stdout strchr strcmp strlen strncmp
strtod time vfprintf vprintf vsnprintf""".split())
OF_MATHS = set("""acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh erf exp exp2
expm1 fabs fdim floor fma fmax fmin fmod frexp hypot ilogb ldexp lgamma llrint llround log log10
log1p log2 logb lrint lround modf nan nearbyint nextafter pow remainder remquo rint round scalbn
sin sincos sinh sqrt tan tanh tgamma trunc""".split())
OF_COMPILER = re.compile(r"_Unwind_Resume|__cxa_\w+|__gxx_personality_\w+|__stack_chk_fail|"
                         r"_GLOBAL_OFFSET_TABLE_|__dso_handle|__tls_get_addr|__gthrw_\w+|"
                         r"__pthread_key_create|typeinfo for \w[\w ]*\**")
CPLUSPLUS = re.compile(r"(?:(?:vtable|typeinfo|VTT|typeinfo name|guard variable|construction vtable"
                       r"|(?:non-)?virtual thunk|TLS \w+ function) (?:for|to) )?(?:\w+ )*?"
                       r"(std|__gnu_cxx|__cxxabiv1|glm|joints)::|operator (new|delete)")
SYSTEM_CALL = r"\b(syscall|sysenter|int +\$0x80|svc)\b"  # an instruction that calls the system


def is_needed(name):
    """True of what an exercise may call."""
    plain = re.sub(r"^__(\w+)_chk$", r"\1", name)
    if plain in OF_C or plain in OF_MATHS or re.sub("[fl]$", "", plain) in OF_MATHS:
        return True
    return bool(OF_COMPILER.fullmatch(name)) or bool(CPLUSPLUS.match(name)) and not (
        OWN.search(name) or re.search(r"\bstd::", name) and OUT_OF_STD.search(name))


def may_define(kind, name):
    """True of what an exercise file may define: kind is nm's letter."""
    if OWN.search(name):
        return False
    if re.match(r"std::|__gnu_cxx::|__cxxabiv1::|operator (new|delete)", name):
        return kind in "WVu"  # what a header defines
    return not (kind in "TWi" and re.fullmatch(r"\w+", name))  # as C does: main, exit, write


def unneeded(path, around):
    """A sentence on an object, "" where there is nothing to say. \\param around puts a command
    within a fence"""
    command = ["sh", "-c", 'nm -gC "$1" && echo && objdump -d "$1"', "sh", path]
    said = subprocess.run(around(command), capture_output=True, text=True, errors="replace")
    if said.returncode:
        return "the object that the compiler makes of it cannot be read"
    table, _, code = said.stdout.partition("\n\n")
    calls, defines = [], []
    for kind, name in re.findall(r"^[0-9a-f]* +(\w) (.*)$", table, re.M):
        if kind in "Uwv":
            calls += [] if is_needed(name) else [short(name)]
        elif kind.isupper() or kind in "ui":
            defines += [] if may_define(kind, name) else [short(name)]
    if re.search(rf"\t{SYSTEM_CALL}", code):
        calls.append("the system")
    return " and ".join(f"{verb} {listed(names)}" for verb, names in (
        ("calls", calls), ("defines", defines)) if names)


def listed(names):
    """The first three of them, each once, those of C before."""
    names = sorted(dict.fromkeys(names), key=lambda name: ":" in name)
    return ", ".join(names[:3]) + f" and {len(names) - 3} more" * (len(names) > 3)


def short(name):
    """Without arguments and templates; of a class of the library its name."""
    name = re.sub(r"\[abi:\w+\]", "", name)
    while (shorter := re.sub(r"<[^<>]*>|\([^()]*\)( const)?", "", name)) != name:
        name = shorter
    name = re.sub(r"^(?:typeinfo|vtable|VTT)(?: name)? for |^.* (?=std::)", "", name)
    return re.sub(r"^(std::(?:basic_|__)\w+)::.*", r"\1", name)
