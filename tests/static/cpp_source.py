# SPDX-License-Identifier: MIT
"""Finds the declarations of C++ sources: enough of the grammar for this repository's style, and no more.

    declarations(text)      all declarations at namespace and class scope, in order
    without_comments(text)  the text with comments as blanks, so that offsets and lines stay

Bodies of functions are not looked into; a lambda or a class in one is part of the function.
"""
import bisect
import dataclasses
import re

# What begins where: a comment, a string, a character, a preprocessor line.
TOKEN = re.compile(
    r"""(?P<comment>//[^\n]*|/\*.*?\*/)
      | (?P<raw>\bR"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)")
      | (?P<number>\b\d(?:'?[\w.])*)
      | (?P<string>"(?:\\.|[^"\\\n])*")
      | (?P<character>'(?:\\.|[^'\\\n])*')
      | (?P<directive>(?:(?<=\n)|\A)[ \t]*\#(?:\\\n|[^\n])*)""",
    re.VERBOSE | re.DOTALL)
CLOSING = {"(": ")", "[": "]", "{": "}"}
NO_NAMES = {"requires", "decltype", "noexcept", "alignas", "explicit", "if", "sizeof", "static_assert", "__attribute__"}


def blanked(text, *kinds):
    """Returns the text with tokens of these kinds as blanks of the same length; line ends stay."""
    def blank(match):
        return re.sub(r"[^\n]", " ", match.group()) if match.lastgroup in kinds or (match.group("raw") and "string" in kinds) else match.group()
    return TOKEN.sub(blank, text)


def without_comments(text):
    """Returns the text with its comments as blanks."""
    return blanked(text, "comment")


def code_of(text):
    """Returns the text with comments, strings, characters and preprocessor lines as blanks."""
    return blanked(text, "comment", "string", "character", "directive")


@dataclasses.dataclass
class Declaration:
    """What is declared, and where. Offsets count from the beginning of the text, `end` is one beyond the last character."""
    kind: str     # namespace, class, enum, function, variable, alias, concept, friend, using, assertion, other
    name: str     # without what encloses it; "" where there is none
    scope: tuple  # names of the namespaces and classes around it, outermost first
    access: str   # public, protected or private; of all that encloses it
    start: int    # where it begins: its template head, if it has one
    head_end: int # where its body or initialiser begins, or its end
    end: int
    depth: str    # kind of the scope that it stands in: namespace or class
    defined: bool # has a body, or an initialiser
    template: bool = False

    def qualified(self):
        """Returns the name with all that encloses it."""
        return "::".join([*(part for part in self.scope if part), self.name])


class Lines:
    """Line numbers of offsets."""

    def __init__(self, text):
        self.starts = [0] + [match.end() for match in re.finditer("\n", text)]

    def of(self, offset):
        """Returns the line of an offset; the first line is 1."""
        return bisect.bisect_right(self.starts, offset)


def closing(code, at):
    """Returns where the bracket that opens at `at` is closed."""
    stack = []
    for match in re.compile(r"[()\[\]{}]").finditer(code, at):
        sign = match.group()
        if sign in CLOSING:
            stack.append(CLOSING[sign])
        elif not stack or stack.pop() != sign:
            raise ValueError(f"brackets do not match at offset {match.start()}")
        if not stack:
            return match.start()
    raise ValueError(f"no bracket closes that at offset {at}")


def past_angles(code, at):
    """Returns the offset behind the template argument list that opens at `at`."""
    depth = 0
    while at < len(code):
        sign = code[at]
        if sign in CLOSING:
            at = closing(code, at)
        elif sign == "<":
            depth += 1
        elif sign == ">" and code[at - 1] != "-":
            depth -= 1
            if depth == 0:
                return at + 1
        at += 1
    raise ValueError("a template argument list has no end")


def core_of(head):
    """Returns a declaration's head without template heads, leading requires clauses and attributes, and whether it is a template."""
    template = False
    while True:
        head = head.lstrip()
        if found := re.match(r"template\s*(?=<)", head):
            template = True
            head = head[past_angles(head, found.end()):]
        elif head.startswith("[["):
            head = head[closing(head, 0) + 1:]
        elif found := re.match(r"requires\s*(?=\()", head):
            head = head[closing(head, found.end()) + 1:].lstrip()
            while head.startswith(("&&", "||")):
                head = past_constraint(head[2:].lstrip())
        elif found := re.match(r"requires\s+(?=[\w!])", head):
            head = past_constraint(head[found.end():])
            while head.startswith(("&&", "||")):
                head = past_constraint(head[2:].lstrip())
        else:
            return head, template


def past_constraint(text):
    """Returns what follows one operand of a constraint: (..), name<..>, requires(..) {..}."""
    text = text.lstrip("! ")
    if text.startswith("("):
        return text[closing(text, 0) + 1:].lstrip()
    if found := re.match(r"requires\s*", text):
        text = text[found.end():]
        if text.startswith("("):
            text = text[closing(text, 0) + 1:].lstrip()
        return text[closing(text, 0) + 1:].lstrip()
    found = re.match(r"[\w:]+", text)
    text = text[found.end():]
    return (text[past_angles(text, 0):] if text.startswith("<") else text).lstrip()


def parameter_list(head):
    """Returns (name, offset of the bracket that opens) of a head's parameter list, or None where it declares no function."""
    if found := re.search(r"\boperator\s*(\(\s*\)|\[\s*\]|[^\s\w(]+|\s[\w: ]+[&*]*)\s*\(", head):
        return "operator" + re.sub(r"\s", "", found.group(1)), found.end() - 1
    at = 0
    while at < len(head):
        sign = head[at]
        if sign == "<" and at > 0 and re.search(r"[\w]\s*$", head[:at]):
            try:
                at = past_angles(head, at)
                continue
            except ValueError:
                pass
        elif sign == "=":
            return None
        elif sign == "(":
            found = re.search(r"(~?\w+)\s*$", head[:at])
            if found and found.group(1) not in NO_NAMES:
                return found.group(1), at
            at = closing(head, at)
        elif sign in "[{":
            at = closing(head, at)
        at += 1
    return None


def kind_of(head):
    """Returns (kind, name, template) of a declaration by its head."""
    core, template = core_of(head)
    if found := re.match(r"(?:inline\s+)?namespace\b\s*([\w:]*)", core):
        return "namespace", found.group(1), template
    if core.startswith("extern") and re.fullmatch(r"extern\s*", core.split("{")[0]):
        return "linkage", "", template
    if core.startswith("using namespace"):
        return "using", "", template
    if found := re.match(r"using\s+(\w+)\s*=", core):
        return "alias", found.group(1), template
    if core.startswith("using enum") or core.startswith("using"):
        return "using", "", template
    if core.startswith("static_assert"):
        return "assertion", "", template
    if found := re.match(r"concept\s+(\w+)", core):
        return "concept", found.group(1), template
    if found := re.match(r"enum(?:\s+(?:class|struct))?\s+(\w+)", core):
        return "enum", found.group(1), template
    friend = core.startswith("friend")
    if found := re.match(r"(?:friend\s+)?(?:class|struct|union)\b\s*(?:\[\[.*?\]\]\s*)?(?:alignas\s*\([^)]*\)\s*)?([\w:]*)(\s*<)?", core):
        if found.group(2):
            return "specialisation", found.group(1), template
        rest = core[found.end():].lstrip()
        if not rest or rest.startswith((":", "final")):
            return ("friend" if friend else "class"), found.group(1), template
    if found := parameter_list(core):
        return ("friend" if friend else "function"), found[0], template
    core = re.sub(r"\[[^\]]*\]\s*$", "", re.split(r"[={]", core)[0].rstrip()).rstrip()
    found = re.search(r"(\w+)\s*(?::\s*\d+)?(?:\[[^\]]*\]\s*)*$", core)
    return "variable", found.group(1) if found else "", template


def opens_expression(head):
    """Returns whether a brace after this head opens a requires-expression or an initialiser, not a body."""
    if re.search(r"(?:\brequires|&&|\|\||=|[(,!])\s*requires\s*(?:\([^{}]*\)\s*)?$", head):
        return True
    core, _ = core_of(head)
    if re.match(r"(?:inline\s+)?namespace\b|enum\b|extern\s*$", core):
        return False
    if re.match(r"(?:friend\s+)?(?:class|struct|union)\b", core) and kind_of(head)[0] in ("class", "specialisation", "friend"):
        return False
    found = parameter_list(core)
    if not found:
        return True
    rest = core[closing(core, found[1]) + 1:]
    initialisers = re.match(r"[^:{]*?(?<!:):(?!:)", rest)
    return bool(initialisers) and bool(re.search(r"[\w>]\s*$", rest)) and not rest[:initialisers.end()].strip().startswith("->")


def declarations(text):
    """Returns all declarations at namespace and class scope, in order of their beginning."""
    code = code_of(text)
    found = []

    def scan(at, end, scope, access, depth):
        start = at
        own = access
        while at < end:
            sign = code[at]
            if sign in "([":
                at = closing(code, at) + 1
            elif sign == ";":
                add(start, at, at + 1, scope, own, depth, False)
                at = start = at + 1
            elif sign == ":" and depth == "class" and (label := re.fullmatch(r"\s*(public|protected|private)\s*", code[start:at])):
                own = label.group(1) if access == "public" else access
                at = start = at + 1
            elif sign == "{":
                head, close = code[start:at], closing(code, at)
                if opens_expression(head):
                    at = close + 1
                    continue
                kind, name, _ = kind_of(head)
                if kind in ("namespace", "linkage"):
                    scan(at + 1, close, scope + ((name,) if kind == "namespace" else ()), own, "namespace")
                    at = start = close + 1
                    continue
                stop = close + 1
                if kind in ("class", "enum", "specialisation", "friend") and (behind := re.compile(r"[^;{}]*;").match(code, stop)):
                    if kind != "friend" or not parameter_list(core_of(head)[0]):
                        stop = behind.end()
                add(start, at, stop, scope, own, depth, True)
                if kind in ("class", "specialisation"):
                    inner = "private" if re.match(r"class\b", core_of(head)[0]) else "public"
                    scan_class(at + 1, close, scope + (name,), own, inner)
                at = start = stop
            else:
                at += 1

    def scan_class(at, end, scope, outer, first):
        # Nothing in a private class is public; `first` holds until the first label.
        if outer != "public":
            scan(at, end, scope, outer, "class")
            return
        label = re.compile(r"\b(?:public|protected|private)\s*:(?!:)")
        stop = end
        level = at
        while level < end:  # the first label of this class itself
            if code[level] in CLOSING:
                level = closing(code, level) + 1
                continue
            if label.match(code, level) and not code[level - 1].isalnum():
                stop = level
                break
            level += 1
        scan(at, stop, scope, first, "class")
        scan(stop, end, scope, "public", "class")

    def add(start, head_end, end, scope, access, depth, body):
        start += len(code[start:end]) - len(code[start:end].lstrip())
        head = code[start:head_end]
        if not head.strip() and not body:
            return
        kind, name, template = kind_of(head)
        defined = body or (kind in ("variable", "alias", "concept") and re.search(r"[={]", core_of(head)[0]) is not None)
        found.append(Declaration(kind, name, scope, access, start, head_end, end, depth, defined, template))

    scan(0, len(code), (), "public", "namespace")
    return sorted(found, key=lambda d: (d.start, -d.end))
