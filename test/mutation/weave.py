# SPDX-License-Identifier: GPL-3.0-or-later
"""Finds the mutants of headers, by libclang, and weaves all of them into copies of the headers,
where mutants.h chooses one when the program starts. So a program of tests is compiled once for all of
them."""

import re
from dataclasses import dataclass, field

import clang.cindex
from clang.cindex import CursorKind, TypeKind

# operator: (function in mutants.h, mutants)
RELATIONS = {
    "<": ("less", ["<=", ">="]),
    "<=": ("less_equal", ["<", ">"]),
    ">": ("greater", [">=", "<="]),
    ">=": ("greater_equal", [">", "<"]),
    "==": ("equal", ["!="]),
    "!=": ("not_equal", ["=="]),
}
ARITHMETIC = {
    "+": ("plus", ["-"]),
    "-": ("difference", ["+"]),
    "*": ("times", ["/"]),
    "/": ("divided_by", ["*"]),
    "%": ("modulo", ["*"]),
}
ASSIGNMENTS = {
    "+=": ("add", ["-="]),
    "-=": ("subtract", ["+="]),
    "*=": ("multiply_by", ["/="]),
    "/=": ("divide_by", ["*="]),
}
STEPS_BEFORE = {"++": ("next", ["--"]), "--": ("previous", ["++"])}
STEPS_AFTER = {"++": ("next_after", ["--"]), "--": ("previous_after", ["++"])}
LOGICAL = {"&&": "||", "||": "&&"}

# body last; what stands before it are no statements
LOOPS = (CursorKind.FOR_STMT, CursorKind.WHILE_STMT, CursorKind.CXX_FOR_RANGE_STMT)
INTEGERS = (TypeKind.INT, TypeKind.UINT, TypeKind.LONG, TypeKind.ULONG, TypeKind.LONGLONG,
            TypeKind.ULONGLONG, TypeKind.SHORT, TypeKind.USHORT, TypeKind.SCHAR, TypeKind.UCHAR,
            TypeKind.CHAR_S, TypeKind.BOOL)
NUMBERS = INTEGERS + (TypeKind.DOUBLE, TypeKind.FLOAT)


@dataclass(frozen=True)
class Mutant:
    number: int
    header: str  # as in an #include, without the package's folder
    line: int
    source: str  # what stands in the line
    change: str  # "'<' becomes '<='"
    place: int  # 1: the first of those with this change in such a line

    def __str__(self):
        place = f" [{self.place}]" if self.place > 1 else ""
        return f"{self.header}: {self.source}: {self.change}{place}"


@dataclass
class Edits:
    """Texts that are put around parts of a file, and in the place of parts."""

    wraps: list = field(default_factory=list)
    replacements: list = field(default_factory=list)

    def wrap(self, start, end, before, after):
        self.wraps.append((start, end, before, after))

    def replace(self, start, end, text):
        self.replacements.append((start, end, text))

    def apply(self, text):
        events = []  # where, closing before opening, inner before outer when closing
        for rank, (start, end, before, after) in enumerate(self.wraps):
            length = end - start
            events.append(((start, 2, -length, rank), start, before))
            events.append(((end, 0, length, -rank), end, after))
        for start, end, new in self.replacements:
            events.append(((start, 1, 0, 0), end, new))
        result, done = [], 0
        for (start, *_), end, new in sorted(events):
            result += [text[done:start], new]
            done = max(done, end)
        return "".join(result + [text[done:]])


def bare(cursor):
    """An expression without parentheses and implicit conversions."""
    while cursor.kind in (CursorKind.UNEXPOSED_EXPR, CursorKind.PAREN_EXPR):
        children = list(cursor.get_children())
        if len(children) != 1:
            break
        cursor = children[0]
    return cursor


def kind_of_type(cursor):
    return cursor.type.get_canonical().kind


class Header:
    """One header, with its mutants numbered from `first`. Those in `excluded` are not woven in."""

    def __init__(self, name, text, first, excluded):
        self.name, self.text = name, text
        self.mutants, self.edits = [], Edits()
        self._first, self._excluded = first, excluded
        self._seen = set()
        # assertions are for our own mistakes: what they say is no behavior
        self._untouched = [(m.start(), m.end()) for m in
                           re.finditer(r"\b(CGAL_\w+|static_assert)\([^;]*\);", text)]
        for match in re.finditer(r"\bconstexpr(?= )", text):  # what depends on a mutant is computed
            is_member = "static" in text[max(0, match.start() - 7):match.start()]
            is_variable = re.match(r"constexpr \w+ \w+ =", text[match.start():])
            if not (is_member and is_variable):
                self.edits.replace(*match.span(), "const" if is_variable else "inline")

    def woven(self):
        return self.edits.apply(self.text)

    def add(self, start, changes):
        """Numbers the mutants of one place; returns the first number, or None if excluded."""
        line = self.text.count("\n", 0, start) + 1
        source = self.text.splitlines()[line - 1].strip()
        number = self._first + len(self.mutants)
        for change in changes:
            place = 1 + sum((m.source, m.change) == (source, change) for m in self.mutants)
            self.mutants.append(
                Mutant(self._first + len(self.mutants), self.name, line, source, change, place))
        is_excluded = any(number + i in self._excluded for i in range(len(changes)))
        return None if is_excluded else number

    def wrap(self, cursor_or_extent, function, changes, after=")", edit_too=lambda: None):
        start, end = cursor_or_extent
        number = self.add(start, changes)
        if number is not None:
            self.edits.wrap(start, end, f"smf_mutation::{function}({number}, ", after)
            edit_too()

    def extent(self, cursor):
        return cursor.extent.start.offset, cursor.extent.end.offset

    def between(self, a, b):
        return self.text[self.extent(a)[1]:self.extent(b)[0]].strip()

    # ===  The walk

    def visit(self, cursor):
        start, end = self.extent(cursor)
        kind = cursor.kind
        if kind == CursorKind.ENUM_DECL or self.is_constant_of_class(cursor):
            return
        if self.is_untouched(start) or (kind, start, end) in self._seen:
            return
        if kind != CursorKind.UNEXPOSED_EXPR:  # conversions of one expression are many
            self._seen.add((kind, start, end))
        children = list(cursor.get_children())
        if kind == CursorKind.BINARY_OPERATOR and len(children) == 2:
            self.visit_binary(cursor, *children)
        elif kind == CursorKind.CALL_EXPR and cursor.spelling.startswith("operator"):
            if len(children) == 3:
                self.visit_binary(cursor, children[0], children[2])
        elif kind == CursorKind.COMPOUND_ASSIGNMENT_OPERATOR:
            self.visit_assignment(cursor, *children)
        elif kind == CursorKind.UNARY_OPERATOR:
            self.visit_unary(cursor, *children)
        elif kind in (CursorKind.INTEGER_LITERAL, CursorKind.FLOATING_LITERAL):
            self.visit_number(cursor)
        elif kind == CursorKind.CXX_BOOL_LITERAL_EXPR:
            value = self.text[start:end]
            self.wrap((start, end), "flip", [f"'{value}' becomes its opposite"])
        elif kind in (CursorKind.CONDITIONAL_OPERATOR, CursorKind.WHILE_STMT):
            self.negate(children[0])
        elif kind == CursorKind.IF_STMT:
            self.negate_condition_of_if(cursor, children)
        elif kind == CursorKind.RETURN_STMT and children:
            if kind_of_type(children[0]) == TypeKind.BOOL:
                self.negate(children[0])
        self.drop_statements(cursor, children)
        for child in children:
            # what stands before the name of a variable is its type
            if not (kind.is_declaration() and kind != CursorKind.CLASS_DECL
                    and self.extent(child)[1] <= cursor.location.offset):
                self.visit(child)

    def is_untouched(self, start):
        return any(first <= start < last for first, last in self._untouched)

    def is_constant_of_class(self, cursor):
        parent = cursor.semantic_parent
        return (cursor.kind == CursorKind.VAR_DECL and parent is not None
                and parent.kind in (CursorKind.CLASS_DECL, CursorKind.STRUCT_DECL))

    def visit_binary(self, cursor, left, right):
        op = self.between(left, right)
        if op in RELATIONS:
            self.weave_operator(cursor, left, right, *RELATIONS[op])
        elif op in ARITHMETIC and kind_of_type(right) in NUMBERS:
            if op != "%" or kind_of_type(left) in INTEGERS:
                self.weave_operator(cursor, left, right, *ARITHMETIC[op])
        elif op in LOGICAL:
            self.weave_logical(cursor, left, right, op)
            self.negate(left)
            self.negate(right)

    def visit_assignment(self, cursor, left, right):
        op = self.between(left, right)
        if op in ASSIGNMENTS and kind_of_type(left) in NUMBERS:
            self.weave_operator(cursor, left, right, *ASSIGNMENTS[op])

    def weave_operator(self, cursor, left, right, function, mutants):
        gap = self.extent(left)[1], self.extent(right)[0]
        op = self.text[gap[0]:gap[1]].strip()
        self.wrap(self.extent(cursor), function, [f"'{op}' becomes '{m}'" for m in mutants],
                  edit_too=lambda: self.edits.replace(*gap, ", "))

    def weave_logical(self, cursor, left, right, op):
        """a || b is !(!a && !b), so that what is not reached is never computed."""
        number = self.add(self.extent(cursor)[0], [f"'{op}' becomes '{LOGICAL[op]}'"])
        if number is not None:
            for part in (cursor, left, right):
                self.edits.wrap(*self.extent(part), f"smf_mutation::flip({number}, ", ")")

    def visit_unary(self, cursor, operand):
        start, end = self.extent(cursor)
        first, last = self.extent(operand)
        before, after = self.text[start:first].strip(), self.text[last:end].strip()
        if before == "!":
            self.wrap((start, end), "flip", ["'!' is dropped"])
        elif before == "-":
            self.wrap((start, end), "minus", ["'-' is dropped"],
                      edit_too=lambda: self.edits.replace(start, first, ""))
        elif before in STEPS_BEFORE:
            self.weave_step(cursor, (start, first), before, *STEPS_BEFORE[before])
        elif after in STEPS_AFTER:
            self.weave_step(cursor, (last, end), after, *STEPS_AFTER[after])

    def weave_step(self, cursor, place, op, function, mutants):
        if kind_of_type(cursor) in NUMBERS:
            self.wrap(self.extent(cursor), function, [f"'{op}' becomes '{mutants[0]}'"],
                      edit_too=lambda: self.edits.replace(*place, ""))

    def visit_number(self, cursor):
        start, end = self.extent(cursor)
        value = self.text[start:end]
        if re.fullmatch(r"\d+", value):
            n = int(value)
            self.wrap((start, end), "whole", [f"{n} becomes {n + 1}", f"{n} becomes {n - 1}"])
        elif cursor.kind == CursorKind.FLOATING_LITERAL:
            self.wrap((start, end), "real", [f"{value} becomes {value} + 1", f"{value} becomes 0"])

    # ===  Conditions and statements

    def negate(self, condition):
        """Negates what has no mutant that does so already."""
        inner = bare(condition)
        children = list(inner.get_children())
        if inner.kind == CursorKind.CXX_BOOL_LITERAL_EXPR:
            return
        if inner.kind == CursorKind.BINARY_OPERATOR and len(children) == 2:
            if self.between(*children) in {**RELATIONS, **LOGICAL}:
                return
        if inner.kind == CursorKind.CALL_EXPR and inner.spelling[8:] in RELATIONS:
            return
        if inner.kind == CursorKind.UNARY_OPERATOR and self.text[self.extent(inner)[0]] == "!":
            return
        start, end = self.extent(condition)
        self.wrap((start, end), "flip", [f"'{self.text[start:end]}' is negated"])

    def negate_condition_of_if(self, cursor, children):
        for child in children:
            start = self.extent(child)[0]
            head = self.text[self.extent(cursor)[0]:start]
            if head.count("(") - head.count(")") != 1:
                return  # it declares a variable
            if child.kind.is_expression():
                return self.negate(child)

    def drop_statements(self, cursor, children):
        if cursor.kind == CursorKind.COMPOUND_STMT:
            statements = children
        elif cursor.kind in LOOPS:
            statements = children[-1:]
        elif cursor.kind == CursorKind.IF_STMT:
            statements = [c for c in children if self.is_behind_condition(cursor, c)]
        else:
            return
        for statement in statements:
            self.drop(statement)

    def is_behind_condition(self, cursor, child):
        head = self.text[self.extent(cursor)[0]:self.extent(child)[0]]
        return head.count("(") == head.count(")")

    def drop(self, statement):
        kind = statement.kind
        start, end = self.extent(statement)
        if kind == CursorKind.RETURN_STMT:
            values = list(statement.get_children())
            if values and kind_of_type(values[0]) != TypeKind.VOID:
                return
        elif not (kind.is_expression()
                  or kind in (CursorKind.CONTINUE_STMT, CursorKind.BREAK_STMT)):
            return
        if self.is_untouched(start):
            return
        semicolon = self.text.index(";", end)
        if self.text[end:semicolon].strip():
            return
        text = " ".join(self.text[start:end].split())
        number = self.add(start, [f"'{text}' is dropped"])
        if number is not None:
            self.edits.wrap(start, semicolon + 1, f"{{ if (smf_mutation::keep({number})) ", " }")


def woven_headers(include_folder, names, arguments, excluded):
    """The headers of the package with these names, with all mutants but the excluded ones."""
    folder = include_folder / "CGAL" / "Surface_mesh_foliation"
    unit = "".join(f"#include <CGAL/Surface_mesh_foliation/{name}>\n" for name in names)
    index = clang.cindex.Index.create()
    translation = index.parse("unit.cpp", args=arguments, unsaved_files=[("unit.cpp", unit)])
    errors = [d.spelling for d in translation.diagnostics if d.severity >= 3]
    if errors:
        raise RuntimeError("libclang cannot read the headers: " + errors[0])
    cursors = {}
    for cursor in translation.cursor.get_children():
        if cursor.location.file is not None:
            cursors.setdefault(cursor.location.file.name, []).append(cursor)
    result, first = [], 1
    for name in names:
        path = str(folder / name)
        # offsets are in bytes
        text = (folder / name).read_bytes().decode("latin-1")
        header = Header(name, text, first, excluded)
        for cursor in cursors[path]:
            header.visit(cursor)
        first += len(header.mutants)
        result.append(header)
    return result
