"""What crashes, exceptions and the compiler's refusals mean, in plain words."""
import re

# What the standard library says of an index that is not there: operator[], front(), back(), at().
OUTSIDE = r"Assertion '(__n < this->size\(\)|!this->empty\(\))'|_M_range_check|array::at"
ARRAY = re.compile(r"std::array<.*_Tp = ([\w:]+)[;,].*_Nm = (\d+)")  # type and number of elements
SWAPPED = r"Assertion '!\(__hi < __lo\)'"  # of std::clamp
HEAP = r"^((free|malloc\w*|realloc|munmap_chunk)\(\): |corrupted (size|double)|double free or)"
# The first that fits is said.
MEANINGS = [(re.compile(pattern, re.M), words) for pattern, words in {
    SWAPPED: "std::clamp(a, low, high) was given a high that is below low: are the ends exchanged, "
             "has a bound the wrong sign, or was it never set?",
    OUTSIDE: "an index outside a vector or an array: places run from 0 to size() - 1",
    r"Assertion '.*_M_is_engaged\(\)'|bad_optional_access":
        "an empty optional was read",
    r"Assertion `(.+)' failed": r"assert(\1) does not hold",
    r"larger than max_size\(\)|vector::(_M_default_append|reserve)|array_new_length":
        "a vector was given an impossible size: is it negative?",
    r"bad_alloc": "more memory was requested than a test may have: a vector that grows without "
                  "end?",
    r"stack smashing": "something was written behind the end of an array of the function: is it "
                       "too small?",
    r"terminate called .*'(.+)'\s*what\(\):\s*(.*)":
        r"the program was ended by an exception that nothing catches, \1: \2",
    r"terminate called": "the program was ended by an exception that nothing catches",
    r"SIGFPE": "a whole number was divided by zero: a / b or a % b with an int b that is 0",
    r"stack is full": "a function that calls itself without end: the stack is full",
    r"SIGSEGV|SIGBUS": "the program crashed: it reached for memory that is not its own. A pointer "
                       "or number that was never set, or an index gone astray (a std::vector<bool> "
                       "does not check its own)?",
    HEAP: "something was written over the memory beside a vector. An index gone astray (a "
          "std::vector<bool> does not check its own)?",
    r"SIGABRT": "the program was ended by abort()",
    r"SIGILL": "the program ran into an instruction that no processor has: a function whose end is "
               "reached without a return?",
    r"solver: was prepared for|blocks have come or gone": "Likely mistake: the solver did not get "
        "the blocks of this step: solver.prepare(world.bodies, world.blocks, 0, h) is missing, has "
        "another number than 0, or does not stand between append() and warm_start().",
    r"^Unknown exception": "an exception was thrown that is not a std::exception"}.items()]
# Lines that the library prints before it ends a program: no words of the reader's.
LIBRARY = re.compile(rf".*Assertion ['`].*failed\.?$|terminate called |\*\*\* stack smashing |"
                     rf"the stack is full$|  what\(\):  |{HEAP}")
# What the beginning of such words tells of the function they come from: its head and its lines.
CLUES = {r"an index outside an array of \d+ rows": r"\bJacobian\b",
         r"an index outside an array of \d+ numbers": r"\bVector\b",
         "an index": r"\w\[|\.at\(|\.back\(|\.front\(", "std::clamp": r"\bclamp\(",
         "a whole number": r"[/%]", "assert": r"\bassert\("}

REFUSED = {  # of the compiler's words
    "LanesFor": "lanes have only + - * with other lanes: no if, no comparison, no division, "
                "and a plain number is allowed only to the left of a *.",
    r"-W(error=)?(maybe-|sometimes-)?uninitialized":
        "a variable is read before it is set: give it a value where it is declared.",
    r"-W(error=)?return-type":
        "the function ends without a return: its result is not returned.",
    r"unable to deduce .auto&&|invalid use of member function": "a function is called with "
        "brackets, also one without arguments: world.joints().",
    r"todo.{1,3} was not declared": "todo is written todo(\"1.1\"); with the exercise's number.",
    r"operator[*/].*(‘int’|'int'|N = (int|double|float);)|deleted operator|"
    r"binary expression \('int' and .*vec": "a whole number stands "
        "with a vector: write real(2) * v and real(1) / v, not 2 * v and 1 / v.",
    r"cannot be used as a function|called object type .* is not a function": "a name that "
        "is called like a function is a number here: within a rod `length` is the rod's own, the "
        "length of a vector is glm::length(u).",
    r"no matching function for call to .(max|min|clamp)\(": "both numbers must be of one kind: "
        "real(0), not 0.",
    r"initializer list.*joints::Row": "a Row is four vectors: {v1, w1, v2, w2}, and nothing is "
        "vec3(0), not 0.",
    r"-W(error=)?infinite-recursion": "the function calls itself without end.",
    r"expected .,. or .;. before .(\w+)": "a semicolon is missing before \\1, often at the end of "
        "the line above.",
    r"expected .;": "a statement ends with a semicolon: it is missing in this line, or a bracket "
        "in it is one too many.",
    r"expected .([)\]}]).": "a closing \\1 is missing in this line, or something before it.",
    r"Body. has no member named .(\w+)|no member named .(\w+). in .joints::Body": "a Body has no "
        "\\1\\2. It has x, q, v, w, inverse_mass, inverse_inertia_local, force and torque.",
    r"has no member named .(\w+)|no member named .(\w+). in ": "what stands before the point has "
        "no \\1\\2. Its members are in the table under Code in the chapter's text, and in its "
        "header.",
    r".(body[12]). was not declared|undeclared identifier .(body[12])": "no line above declares "
        "\\1\\2. A link or a block has the number of the body: Body& \\1\\2 = "
        "bodies[link.\\1\\2];",
    r".([xvwq])([12]). was not declared|undeclared identifier .([xvwq])([12])": "the letter of a "
        "formula is a member here: \\1\\3\\2\\4 is body\\2\\4.\\1\\3.",
    r".(\w+). (?:was not|has not been) declared[^\n]*did you mean .([\w:]+).\?|"
    r"undeclared identifier .(\w+).; did you mean .([\w:]+).\?": "no line above declares \\1\\3. "
        "Is \\2\\4 meant? A function knows its arguments, the members of its part, which the "
        "chapter's header lists, and what it declares itself.",
    r".(\w+). (?:was not|has not been) declared|undeclared identifier .(\w+)": "no line above "
        "declares \\1\\2. A function knows its arguments, what it declares itself, and what the "
        "table under Code in the chapter's text lists.",
    r"arguments to function .*?(\w+)\(|no matching function for call to .(\w+)": "\\1\\2 is called "
        "with other arguments than it takes: compare them with the table under Code in the "
        "chapter's text.",
    r"no match for .operator|no viable |invalid operands|cannot convert|invalid .static_cast": "a "
        "number, a vec3, a mat3 or a Row stands where another of them is meant: is a factor "
        "missing? dot(a, b) makes a number of two vectors, a mat3 times a vec3 is a vec3."}


def plainly(words):
    """What was thrown, or said by a crash, in plain words."""
    if (array := ARRAY.search(words)) and re.search(OUTSIDE, words):
        kind = {"joints::Row": " rows", "double": " numbers"}.get(array[1], "")
        return (f"an index outside an array of {array[2]}{kind}: its places run from 0 to "
                f"{int(array[2]) - 1}")
    for pattern, meaning in MEANINGS:
        if match := pattern.search(words):
            return match.expand(meaning) if "\\1" in meaning else meaning
    return words


def refused(words):
    """What the compiler's first error means, or "": the others often follow from it. What stands
    before the first place in a file is a command line."""
    place = re.search(r"^\S+:\d+:", words, re.M)
    words = words[place.start():] if place else words
    first = re.split(r"^(?=\S+:\d+:\d+: error: )", words, flags=re.M)[:2]
    found = ((re.search(pattern, "".join(first)), meaning) for pattern, meaning in REFUSED.items())
    return next((match.expand(meaning) for match, meaning in found if match), "")
